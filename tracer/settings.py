"""SDL: ``global_settings { ... }``; and what the command line, not the scene, decides about a render."""

from __future__ import annotations

from typing import Literal, TypeAlias, get_args

from minipov.tracer.node import node
from minipov.tracer.values import WHITE, Rgb

Gamma: TypeAlias = float | Literal["srgb"] | None
"""A working space: a power law, sRGB's curve, or None for scenes without any gamma handling (``#version`` < 3.7)."""


Accelerator: TypeAlias = Literal["linear", "spheres", "hierarchy", "grid", "octree"]
"""How rays find objects: one after the other, by their spheres, or in a tree of boxes, a grid or an octree."""

ACCELERATORS: tuple[Accelerator, ...] = get_args(Accelerator)


@node
class Radiosity:
    """``radiosity { ... }`` of ``global_settings``."""

    adc_bailout: float = 0.01
    always_sample: bool = False
    brightness: float = 1.0
    count: tuple[int, int] = (35, 1600)
    error_bound: float = 1.8
    gray_threshold: float = 0.0
    low_error_factor: float = 0.5
    max_sample: float = -1.0
    maximum_reuse: float = 0.2
    minimum_reuse: float = 0.015
    nearest_count: tuple[int, int] = (5, 0)
    normal: bool = False
    media: bool = False
    subsurface: bool = False
    brilliance: bool = False
    pretrace_start: float = 0.08
    pretrace_end: float = 0.04
    recursion_limit: int = 2


@node
class Photons:
    """``photons { ... }`` of ``global_settings``; None in ``radius`` means automatic."""

    spacing: float | None = 1.0
    count: int | None = None
    gather: tuple[int, int] = (20, 100)
    media: tuple[int, float] = (0, 1.0)
    jitter: float = 0.4
    max_trace_level: int | None = None
    adc_bailout: float | None = None
    autostop: float = 0.5
    expand_thresholds: tuple[float, int] = (0.2, 35)
    radius: tuple[float | None, float, float | None, float] = (None, 1.0, None, 1.0)
    save_file: str | None = None
    load_file: str | None = None


@node
class SubsurfaceSettings:
    """``subsurface { samples I, I radiosity B }`` of ``global_settings``."""

    samples: tuple[int, int] = (50, 50)
    radiosity: bool = False


@node
class GlobalSettings:
    """``global_settings { ... }``; the defaults are those of ``#version 3.7``."""

    adc_bailout: float = 1 / 255
    ambient_light: Rgb = WHITE
    assumed_gamma: Gamma = 1.0
    irid_wavelength: Rgb = (0.70, 0.52, 0.48)
    max_trace_level: int = 5
    mm_per_unit: float = 10.0
    noise_generator: int = 2
    number_of_waves: int = 10
    radiosity: Radiosity | None = None
    photons: Photons | None = None
    subsurface: SubsurfaceSettings | None = None


@node
class Antialiasing:
    """``+A threshold +AM method +R depth +J jitter +AG gamma``; ``method`` 1 grid, 2 recursive."""

    method: int = 1
    threshold: float = 0.3
    depth: int = 3
    jitter: float = 1.0
    gamma: float = 2.5


@node
class RenderSettings:
    """What the caller decides. Rows and columns are 0-based, ends exclusive, and None means the whole picture.

    ``threads`` 0 uses every core. ``alpha`` says that the background stays transparent in the result.
    """

    width: int = 320
    height: int = 240
    rows: tuple[int, int] | None = None
    columns: tuple[int, int] | None = None
    antialiasing: Antialiasing | None = None
    quality: int = 9
    threads: int = 0
    alpha: bool = False
    accelerator: Accelerator = "octree"
