"""The image files that can be written, and how a picture is to be stored in one."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, TypeAlias

from minipov.tracer.settings import Gamma

FileKind: TypeAlias = Literal["png", "tga", "tga_rle", "ppm", "bmp", "jpeg", "exr", "hdr"]

EXTENSIONS: dict[FileKind, str] = {
    "png": ".png",
    "tga": ".tga",
    "tga_rle": ".tga",
    "ppm": ".ppm",
    "bmp": ".bmp",
    "jpeg": ".jpg",
    "exr": ".exr",
    "hdr": ".hdr",
}
_ALPHA_KINDS = frozenset({"png", "tga", "tga_rle", "bmp", "exr"})


@dataclass(frozen=True, slots=True)
class FileFormat:
    """How a picture is stored. ``bits`` counts for PNG and PPM; ``quality`` (2 to 100) for JPEG.

    ``dither`` is a method of `minipov.dither`, or "".
    """

    kind: FileKind = "png"
    bits: int = 8
    gamma: Gamma = "srgb"
    alpha: bool = False
    gray: bool = False
    quality: int = 85
    dither: str = ""

    @property
    def stores_alpha(self) -> bool:
        """Whether the file will hold an alpha channel."""
        return self.alpha and self.kind in _ALPHA_KINDS
