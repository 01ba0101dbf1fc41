"""How far two pictures are apart, on their 8-bit sRGB codes.

``within2``     share of pixels whose largest channel difference is at most 2
``flip``        mean of NVIDIA's FLIP for low dynamic range, 67 pixels per degree (Andersson et al. 2020)
``mean_error``  mean difference of a channel, of 255
``ssim``        mean structural similarity over blocks of 8x8 pixels of grey (Wang et al. 2004)
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import flip_evaluator
import numpy as np
import OpenImageIO as oiio
from numpy.typing import NDArray

from minipov.gamma import encode
from minipov.image_output import GREY_WEIGHTS

Picture = NDArray[np.uint8]
"""(height, width, 3) sRGB codes."""

_LINEAR_SUFFIXES = frozenset({".exr", ".hdr"})
_PIXELS_PER_DEGREE = 67.0
_BLOCK = 8


@dataclass(frozen=True, slots=True)
class Metrics:
    """The four measures described above; equal pictures give 1, 0, 0 and 1."""

    within2: float
    flip: float
    mean_error: float
    ssim: float


def read_picture(path: Path) -> Picture:
    """Return a picture as sRGB codes, on black where it is transparent. Raises OSError."""
    opened = oiio.ImageInput.open(str(path))
    if opened is None:
        raise OSError(f"cannot read {path}: {_first_line(oiio.geterror())}")
    try:
        spec = opened.spec()
        pixels = opened.read_image(0, 0, 0, min(spec.nchannels, 3), "float")
        if pixels is None:
            raise OSError(f"cannot read {path}: {_first_line(opened.geterror())}")
    finally:
        opened.close()
    values = np.asarray(pixels, np.float64).reshape(spec.height, spec.width, -1)
    if path.suffix.lower() in _LINEAR_SUFFIXES:
        values = encode(values, "srgb")
    color = np.broadcast_to(values[..., :1], (*values.shape[:2], 3)) if values.shape[2] < 3 else values
    return np.floor(np.clip(color, 0, 1) * 255 + 0.5).astype(np.uint8)


def _first_line(said: str) -> str:
    return said.partition("\n")[0]


def measure(picture: Picture, reference: Picture) -> Metrics:
    """Compare two pictures of the same size. Raises ValueError where the sizes differ."""
    if picture.shape != reference.shape:
        sizes = " and ".join(f"{p.shape[1]}x{p.shape[0]}" for p in (picture, reference))
        raise ValueError(f"the pictures have different sizes: {sizes}")
    difference = np.abs(picture.astype(np.int16) - reference)
    return Metrics(
        within2=float(np.mean(difference.max(axis=2) <= 2)),
        flip=float(flip_map(picture, reference).mean()),
        mean_error=float(difference.mean()),
        ssim=block_ssim(picture, reference),
    )


def flip_map(picture: Picture, reference: Picture) -> NDArray[np.float32]:
    """Return FLIP's error for each pixel, 0 to 1, shape (height, width)."""
    scaled = [np.ascontiguousarray(side, np.float32) / np.float32(255) for side in (reference, picture)]
    parameters = {"ppd": _PIXELS_PER_DEGREE}
    errors, _, _ = flip_evaluator.evaluate(*scaled, "LDR", applyMagma=False, parameters=parameters)
    return np.asarray(errors, np.float32)[..., 0]


def block_ssim(picture: Picture, reference: Picture) -> float:
    """Return the mean structural similarity; blocks at the right and lower edge are filled up by repetition."""
    a, b = (_blocks(side @ GREY_WEIGHTS) for side in (picture, reference))
    mean_a, mean_b = a.mean(axis=1), b.mean(axis=1)
    covariance = ((a - mean_a[:, None]) * (b - mean_b[:, None])).mean(axis=1)
    c1, c2 = (0.01 * 255) ** 2, (0.03 * 255) ** 2
    luminance = (2 * mean_a * mean_b + c1) / (mean_a**2 + mean_b**2 + c1)
    structure = (2 * covariance + c2) / (a.var(axis=1) + b.var(axis=1) + c2)
    return float(np.mean(luminance * structure))


def _blocks(grey: NDArray[np.float64]) -> NDArray[np.float64]:
    """Cut into blocks: (number of blocks, pixels of a block)."""
    padded = np.pad(grey, [(0, -size % _BLOCK) for size in grey.shape], mode="edge")
    rows, columns = (size // _BLOCK for size in padded.shape)
    return padded.reshape(rows, _BLOCK, columns, _BLOCK).swapaxes(1, 2).reshape(rows * columns, -1)
