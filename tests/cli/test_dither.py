"""Dithering keeps the mean, and makes the patterns that POV-Ray makes."""

import numpy as np
import pytest

from minipov.dither import DITHER_METHODS, dither


@pytest.mark.parametrize("method", DITHER_METHODS)
def test_the_mean_is_kept(method: str) -> None:
    ramp = np.linspace(3, 9, 48 * 64 * 3).reshape(48, 64, 3)
    codes = dither(ramp, method)
    assert np.all(codes == np.round(codes))
    assert np.all(np.abs(codes - ramp) < 2)
    assert codes.mean() == pytest.approx(ramp.mean(), abs=0.6 if method == "B2" else 0.56)


@pytest.mark.parametrize("method", DITHER_METHODS)
def test_codes_stay_as_they_are(method: str) -> None:
    codes = np.arange(12.0).reshape(2, 2, 3)
    assert np.array_equal(dither(codes, method), codes)


def test_rows_as_povray_dithers_them() -> None:
    """POV-Ray, ``background { rgb 100.3713/255 }``, ``+THD1 File_Gamma=1``, 13 pixels wide."""
    codes = dither(np.full((3, 13, 1), 100.3713), "D1")[..., 0] - 100
    assert codes.tolist() == [
        [0, 1, 0, 0, 1, 0, 1, 0, 0, 1, 0, 0, 1],
        [0, 1, 0, 0, 1, 0, 0, 1, 0, 1, 0, 0, 1],
        [0, 0, 1, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0],
    ]
    pattern = dither(np.full((2, 4, 1), 100.6), "B2")[..., 0] - 100
    assert pattern.tolist() == [[0, 1, 0, 1], [1, 1, 1, 1]]
