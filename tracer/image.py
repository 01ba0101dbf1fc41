"""SDL: ``image_map { png "a.png" map_type 1 interpolate 2 once }`` and the other users of image files.

Reading files is not the tracer's work: an `Image` arrives as arrays, its colours already in the working space.
"""

from __future__ import annotations

from typing import Literal, TypeAlias

import numpy as np
from minipov.tracer.node import node
from minipov.tracer.values import Vec2
from numpy.typing import NDArray

ImagePurpose: TypeAlias = Literal["color", "pattern", "heights"]
"""What a picture is read for: to be seen, as the values of a pattern, or as a height field."""


@node(eq=False)
class Image:
    """Pixels of one file, row 0 at the top.

    ``color`` has shape (height, width, 3), float32, not premultiplied; ``alpha`` (height, width), float32, or None
    where the file has none. A palette file also has ``index`` (height, width), uint16, and its ``palette_size``.
    ``gray`` says that the file stores one channel of grey.
    """

    color: NDArray[np.float32]
    alpha: NDArray[np.float32] | None = None
    index: NDArray[np.uint16] | None = None
    palette_size: int = 0
    gray: bool = False


@node
class ImageMapping:
    """How a picture lies in space; the unit square of the xy-plane shows it once.

    ``map_type`` 0 planar, 1 spherical, 2 cylindrical, 5 toroidal, 7 angular; ``interpolate`` 0 none, 2 bilinear,
    3 bicubic, 4 normalised distance. ``repeat`` and ``offset`` are POV-Ray's undocumented modifiers of the same name.
    """

    image: Image
    map_type: int = 0
    once: bool = False
    interpolate: int = 0
    use: Literal["default", "index", "color", "alpha"] = "default"
    repeat: Vec2 = (1.0, 1.0)
    offset: Vec2 = (0.0, 0.0)
