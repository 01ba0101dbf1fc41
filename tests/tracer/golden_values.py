"""Asks POV-Ray for the values that the core's tests compare with: `python tests/tracer/golden_values.py`.

Writes `tracer/tests/golden_values/<group>.txt`: first the points (three numbers a line), then for each case a line with
its name, a colon and one value per point. The Rust tests rebuild the cases by name.
"""

from __future__ import annotations

import random
import subprocess
import tempfile
from pathlib import Path

DATA = Path(__file__).parents[2] / "tracer/tests/golden_values"

Point = tuple[float, float, float]
"""A place to ask for the value at."""


def ask(declarations: str, expressions: list[str], points: list[Point], settings: str = "") -> list[list[str]]:
    """The value of each SDL expression (of X, Y, Z) at each point, one row per expression."""
    with tempfile.TemporaryDirectory() as folder:
        scene, output = Path(folder, "probe.pov"), Path(folder, "values.txt")
        written = ',",",'.join(f"str({e},0,14)" for e in expressions)
        calls = "\n".join(f"P({x!r},{y!r},{z!r})" for x, y, z in points)
        scene.write_text(
            f"#version 3.7;\nglobal_settings{{ assumed_gamma 1 {settings} }}\n{declarations}\n"
            f'#fopen F "{output}" write\n#macro P(X,Y,Z) #write(F,{written},"\\n") #end\n{calls}\n#fclose F\n'
        )
        command = ["povray", f"+I{scene}", "-F", "+W1", "+H1", "-D", "-GA", "+WT1"]
        log = subprocess.run(command, capture_output=True, text=True, timeout=300, cwd=folder, check=False).stderr
        lines = output.read_text().splitlines() if output.exists() else []
        if len(lines) != len(points):
            raise RuntimeError(log)
        return [list(column) for column in zip(*(line.split(",") for line in lines), strict=True)]


def write(group: str, points: list[Point], cases: dict[str, list[str]]) -> None:
    """One data file."""
    lines = [" ".join(repr(c) for c in p) for p in points]
    lines += [f"{name}: {' '.join(f'{float(v):.12g}' for v in values)}" for name, values in cases.items()]
    DATA.mkdir(parents=True, exist_ok=True)
    (DATA / f"{group}.txt").write_text("\n".join(lines) + "\n")


def scattered(count: int, reach: float, seed: int = 1) -> list[Point]:
    """Random points of a cube around the origin, short in decimals."""
    rng = random.Random(seed)
    return [tuple(round(rng.uniform(-reach, reach), 4) for _ in range(3)) for _ in range(count)]  # type: ignore[misc]


SPECIAL: list[Point] = [
    (0.0, 0.0, 0.0),
    (1.0, 0.0, 0.0),
    (0.0, 1.0, 0.0),
    (0.0, 0.0, 1.0),
    (-1.0, -2.0, -3.0),
    (0.5, 0.5, 0.5),
    (-0.5, 0.25, -0.75),
    (2.0, -1.0, 0.0),
]
"""Lattice points, axes and the origin."""


def noise() -> None:
    """The three noise generators and vector turbulence."""
    points = scattered(150, 20) + scattered(50, 90000, 2) + SPECIAL + [(0.0, 0.3, -5.0), (4096.0, -4096.5, 12.25)]
    cases = {f"noise {n}": f"N(X,Y,Z,{n})" for n in (1, 2, 3)}
    for name, arguments in {"octave": "2,.5,1", "default": "2,.5,6", "odd": "1.7,.8,9"}.items():
        cases |= {f"turbulence {name} {c}": f"vturbulence({arguments},<X,Y,Z>).{c}" for c in "xyz"}
    declared = "#declare N=function{internal(78)};"
    write("noise", points, dict(zip(cases, ask(declared, list(cases.values()), points), strict=True)))


TURBULENT = ["agate", "marble", "wood", "spiral1 3", "spiral2 2", "onion", "bozo", "granite", "leopard", "radial"]
"""Patterns asked for with turbulence too; the first five treat it in a way of their own."""

PLAIN = [
    *TURBULENT,
    "agate agate_turb 0.3",
    "boxed",
    "bumps",
    "cells",
    "cylindrical",
    "dents",
    "gradient x",
    "gradient <1,2,-3>",
    "planar",
    "quilted",
    "quilted control0 0.2 control1 1.7",
    "ripples",
    "spherical",
    "spiral1 -2",
    "spotted",
    "waves",
    "wrinkles",
]
"""Continuous patterns with a plain value."""

BLOCKS = [
    "brick",
    "brick brick_size <1,0.5,0.75> mortar 0.1",
    "checker",
    "cubic",
    "hexagon",
]
"""Patterns that number their blocks."""

CRACKLE = [
    "crackle",
    "crackle form <1,0,0>",
    "crackle form <0,1,0>",
    "crackle form <0,0,1>",
    "crackle metric 1",
    "crackle metric 3.5",
    "crackle offset 0.4",
    "crackle solid",
    "crackle solid form <1,0,0> metric 4",
]
"""Cell patterns."""

WAVES = [
    "triangle_wave",
    "sine_wave",
    "scallop_wave",
    "cubic_wave",
    "poly_wave 2.5",
    "frequency 2.5 phase .3",
    "frequency -1.3",
    "phase -0.6",
    "frequency 0 phase 0.4",
    "frequency 3 sine_wave",
]
"""Modifiers of a pattern's value."""

TURBULENCES = [
    "turbulence 0.7",
    "turbulence <0.3,1,-2> octaves 4 omega 0.6 lambda 2.3",
    "turbulence 0.5 scale 2",
    "scale <1,2,3> turbulence 0.5 translate x",
    "noise_generator 1 turbulence 0.4",
    "noise_generator 3 turbulence 0.4",
]
"""Classic turbulence."""

WARPS = [
    "warp{turbulence 0.5}",
    "scale 2 warp{turbulence 0.5} rotate 30*y turbulence 0.3",
    "warp{repeat 1.5*x}",
    "warp{repeat -2*y offset <.1,0,.3> flip <1,0,1>}",
    "warp{repeat 0.7*z flip y} translate 0.2",
    "warp{black_hole <.5,.2,0>,2}",
    "warp{black_hole <.5,.2,0>,2 inverse strength 0.7 falloff 1.4}",
    "warp{black_hole <.5,.5,.5>,.4 strength 1.5 repeat <1,1,1>}",
    "warp{black_hole <.5,.5,.5>,.3 repeat <1,2,1.5> turbulence <.1,.2,.1>}",
    "warp{cylindrical}",
    "warp{cylindrical orientation x dist_exp 1}",
    "warp{cylindrical orientation y dist_exp 0.5}",
    "warp{spherical}",
    "warp{spherical orientation y dist_exp 2}",
    "warp{spherical orientation x}",
    "warp{spherical orientation <1,1,1> dist_exp 1}",
    "warp{cylindrical orientation <1,2,3>}",
    "warp{toroidal}",
    "warp{toroidal orientation x dist_exp 1 major_radius 2}",
    "warp{toroidal orientation y major_radius 0.5}",
    "warp{planar}",
    "warp{planar y,0.3}",
    "warp{planar <1,1,2>,-0.3}",
    "warp{cubic}",
    "matrix <1,.2,0,.1,1,.3,0,0,2,.5,.6,.7>",
]
"""Ways to bend space, seen through patterns of x, y and z."""


def pattern_cases() -> dict[str, str]:
    """All patterns asked for, by the SDL that stands between `pattern {` and `}`."""
    cases = [*PLAIN, *BLOCKS, *CRACKLE]
    cases += [f"{p} noise_generator {g}" for p in ("agate", "bozo", "dents", "granite", "wrinkles") for g in (1, 3)]
    cases += [f"{p} {w}" for p in ("gradient x", "marble", "wood", "ripples", "spiral2 2") for w in WAVES]
    cases += [f"{p} {w}" for p in ("checker", "brick", "waves") for w in WAVES[5:7]]
    cases += [f"{p} {t}" for p in TURBULENT for t in TURBULENCES]
    cases += [f"gradient {a} {w}" for w in WARPS for a in ("x", "y", "z")]
    return {c: c for c in cases}


def patterns() -> None:
    """Every pattern on scattered points."""
    points = scattered(60, 4) + scattered(6, 300, 3) + SPECIAL
    cases = pattern_cases()
    declared = "\n".join(f"#declare F{i}=function{{pattern{{{c}}}}};" for i, c in enumerate(cases.values()))
    rows = ask(declared, [f"F{i}(X,Y,Z)" for i in range(len(cases))], points)
    write("patterns", points, dict(zip(cases, rows, strict=True)))


STRIPES = "gradient x color_map{[0.1 rgb 0][0.9 rgbft <1,0.5,2,0.25,0.125>]}"
"""A pigment to put into others."""

PIGMENTS = [
    *["agate", "bozo", "brick", "bumps", "checker", "cubic", "granite", "hexagon", "marble", "radial", "wood"],
    "square",
    "triangular",
    "square rgb 0, rgb 0.25, rgb 0.5, rgb 0.75",
    "triangular rgb 0, rgb 0.1, rgb 0.2, rgb 0.3, rgb 0.4, rgb 0.5",
    "cubic rgb 0.3",
    "brick rgb 0.2, rgb 0.7 brick_size <1,0.5,0.75> mortar 0.1",
    STRIPES,
    STRIPES + " turbulence 0.5 scale 2",
    "gradient x color_map{[0.2 rgb 0.1][0.2 rgb 0.5][0.6 rgb 0.6][0.6 rgb 0.2][0.6 rgb 0.9][0.7 rgb 0]}",
    "gradient x color_map{[0.5 rgb 0.1][0.2 rgb 0.5][0.8 rgb 1]}",
    "gradient x color_map{[0.3 rgb 0.7]}",
    "gradient x color_map{[0.3 rgb 0.7][1.5 rgb 0.3]} frequency 2 phase 0.25 sine_wave",
    f"gradient y pigment_map{{[0 {STRIPES}][1 {STRIPES} translate 0.3*x]}}",
    f"gradient y pigment_map{{[0.3 {STRIPES}][0.6 rgb 0.5]}} scale 2 turbulence 0.5",
    f"marble pigment_map{{[0 {STRIPES}][1 {STRIPES} translate 0.3*x]}} turbulence 0.5 rotate 30*z",
    f"wood pigment_map{{[0 {STRIPES}][1 {STRIPES} translate 0.3*x]}} turbulence 0.5",
    f"spiral1 3 pigment_map{{[0 {STRIPES}][1 {STRIPES} translate 0.3*x]}} turbulence 0.5",
    f"checker pigment{{{STRIPES}}} pigment{{{STRIPES} rotate 90*z}} turbulence 0.5 scale 2",
    f"hexagon pigment{{{STRIPES}}} warp{{repeat 1.5*x}} translate 0.2",
    f"average pigment_map{{[1 {STRIPES}][3 {STRIPES} translate 0.3*x][0.5 rgb 0.2]}} turbulence 0.5 scale 2",
]
"""Pigments with every kind of map."""

COMPONENTS = ["red", "green", "blue", "filter", "transmit"]
"""Of a pigment function's value."""


def pigments() -> None:
    """Pigments through `function { pigment { ... } }`; a case's last word is the component."""
    points = scattered(40, 4, 5) + SPECIAL
    declared = "\n".join(f"#declare F{i}=function{{pigment{{{p}}}}};" for i, p in enumerate(PIGMENTS))
    cases = {f"{p} | {c}": f"F{i}(X,Y,Z).{c}" for i, p in enumerate(PIGMENTS) for c in COMPONENTS}
    rows = ask(declared, list(cases.values()), points)
    write("pigments", points, dict(zip(cases, rows, strict=True)))


INTERNAL: dict[int, list[str]] = {
    0: ["1 100 0 0 0", "0.7 0.3 1 0.4 25", "1 100 1 0.4 25"],
    1: ["1 100 0 0 0", "0.7 0.3 1 0.4 25", "1 100 1 0.4 25"],
    2: ["1 100 0 0 0", "0.7 0.3 1 0.4 25", "1 100 1 0.4 25"],
    3: ["1 100 0 0 0", "0.7 0.3 1 0.4 25", "1 100 1 0.4 25"],
    4: ["1 1", "0.3 0.7"],
    5: ["1 1", "0.3 2.7"],
    6: ["1 1 1 1 1", "0.7 1.2 3 -0.8 2"],
    7: ["1 1 1 0", "0.7 1.2 3 0.4"],
    8: ["1 1", "0.001 0.7"],
    9: ["1", "0.6"],
    10: ["0.5 1 1 0", "1.7 0.8 0.6 0.3"],
    11: ["1", "0.3"],
    12: ["1", "0.3"],
    13: ["1", "0.03"],
    14: ["1", "0.03"],
    15: ["1 1 1 0 0 0", "0.3 0.7 1.4 0 0 0", "0.3 0.7 1.4 1 0.4 25"],
    16: ["0.001 1 0.3 0.2 0.1 2", "0.002 0.6 0.2 0.3 0.4 1.2", "1 1 0.3 0.2 0.1 2"],
    17: ["1 2 3", "0.5 0.7 1.1"],
    18: ["0.001", "1"],
    19: ["0.5 1 1 0", "0.1 0.8 1.6 0.3"],
    20: ["1 1 1", "0.3 0.7 1.4"],
    21: ["1 1 1 0 0 0", "0.3 0.7 1.4 0 0 0", "0.3 0.7 1.4 1 0.4 25"],
    22: ["1", "0.3"],
    23: ["1", "0.1"],
    25: ["2 5 0.3 0.6 1 1 0", "3 4 0.2 0.7 2 0.5 30", "1 -3 0.4 0.9 0.7 3 0", "2 5 0.3 0.6 1 2 20", "2 5 .3 .6 1 0 10"],
    26: [
        "0 5 0.3 0.6 0 1 0",
        "0 4 0.2 0.7 0 0.5 30",
        "0 -3 0.4 0.9 0 3 45",
        "0 3 0.1 1.2 0 2 20",
        "0 3 0.1 1.2 0 0 20",
    ],
    27: ["0"],
    28: ["0"],
    29: ["0.5 2 5 0.8 0.4 0", "0.8 2.3 4.5 0.3 0.8 3", "0.8 2.3 2 0.3 0.2 2", "0 2 3 0.5 0.5 1"],
    30: ["0.001", "1"],
    31: ["1 1 0.3", "0.3 0.6 0.4"],
    32: ["0.5 1 1 0", "1.7 0.8 0.6 0.3"],
    33: ["1 1 1", "0.3 0.2 0.4"],
    34: ["1 1 1 0 0 0", "0.3 0.2 0.4 0 0 0", "0.3 0.2 0.4 1 0.4 25"],
    35: ["1", "0.003"],
    36: ["1", "0.3"],
    37: ["1 -0.5 -0.5 0", "0.3 -0.2 -0.7 0.4"],
    38: ["1", "0.3"],
    39: ["1 1 1 0 0 0", "0.3 0.7 1.4 0 0 0", "0.3 0.7 1.4 1 0.4 25"],
    40: ["1 1 0.1 0.2 1", "0.4 0.7 0.3 0.1 1.6"],
    41: ["1", "0.3"],
    42: ["1", "0.3"],
    43: ["1", "0.01"],
    44: ["1 1 0.3 1", "0.1 0.6 0.7 2"],
    45: ["1", "0.3"],
    46: ["1 1 0.3", "0.3 0.6 0.4"],
    47: [""],
    48: ["1", "0.3"],
    49: ["1", "0.3"],
    50: ["1 1 1 1 0 0 0", "0.3 0.7 1.4 2 0 0 0", "0.3 0.7 1.4 3 1 0.4 25"],
    51: ["1 2 3 4 5", "0.1 -0.2 0.3 -0.4 0.5"],
    52: ["5 0.4 0.5 0.3 1 0", "3 0.4 0.5 0.3 2 30", "0 0.4 0.5 0.3 0.7 10", "2 .4 .5 .3 0 15", "2.5 .4 .5 .3 3 15"],
    53: ["0.1", "1"],
    54: ["1", "0.3"],
    55: ["1", "0.3"],
    56: ["1 1 0.3", "0.3 0.6 0.4"],
    57: [""],
    58: ["2 4 0.5 0.3 0.2 0", "2.3 6 0.7 0.1 2 3", "1.7 3.5 0.4 0.8 1 1"],
    59: ["0.1 3 7 0.7 0.7 2", "0.9 2.1 5 1 2 0", "0.5 2 3.5 0.9 1.3 1", "1 2 8 1 1.5 3"],
    60: ["0.1 1 1 1", "0.3 0.5 1.2 0.9"],
    61: ["1", "0.3"],
    62: ["1 1 1 1 1", "5 0.3 0.7 2 1.4"],
    63: ["0.5 3 4 1", "0.3 2 5 1.7"],
    64: ["0.3 0.1 2 0 0 0", "0.5 0.2 1.5 10 0.4 1", "0.4 0.3 2 0 0 0.5", "0.4 0.3 2 30 0 -1", "0.3 0.1 1.2 0 -2 3"],
    65: ["1", "0.3"],
    66: ["1 1 1 1", "0.3 0.7 0.5 1.4"],
    67: ["1 1 1 1 0 0 0", "0.3 0.7 0.5 1.4 0 0 0", "0.3 0.7 0.5 1.4 1 0.4 25"],
    68: ["0.5 0.8", "1.3 0.2", "1 1"],
    69: [""],
    70: ["1 0.3", "0.5 0.6"],
    71: ["1 1 0.3", "0.3 0.5 0.6"],
    72: ["1", "0.3"],
    73: ["1", "0.3"],
    74: ["1 1", "0.3 0.4"],
    75: ["1 1 1 0 0 0", "0.3 0.4 0.7 0 0 0", "0.3 0.4 0.7 1 0.4 25"],
    76: [""],
    78: ["1", "2", "3", "0"],
}
"""Extra parameters that each internal function is asked with."""


def functions() -> None:
    """The functions that the language brings with it; a case's name has the number and the extra parameters.

    POV-Ray keeps the spectrum of a fractal's first call, so each scene asks for one set of parameters per function.
    """
    points = scattered(40, 1.4, 6) + scattered(6, 8, 7) + SPECIAL
    declared = "\n".join(f"#declare F{number}=function{{internal({number})}};" for number in INTERNAL)
    answers: dict[str, list[str]] = {}
    for turn in range(max(map(len, INTERNAL.values()))):
        cases = {
            f"{number} {sets[turn]}".strip(): f"F{number}({', '.join(['X', 'Y', 'Z', *sets[turn].split()])})"
            for number, sets in INTERNAL.items()
            if turn < len(sets)
        }
        answers |= dict(zip(cases, ask(declared, list(cases.values()), points), strict=True))
    write("functions", points, answers)


if __name__ == "__main__":
    noise()
    patterns()
    pigments()
    functions()
