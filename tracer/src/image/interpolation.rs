//! SDL: `interpolate 0|2|3|4`: how a picture runs on between its pixels.

/// What is seen between the centres of pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Interpolation {
    /// 0: each pixel is a flat square.
    None,
    /// 2: linear along both axes.
    Bilinear,
    /// 3: cubic along both axes, through all pixels.
    Bicubic,
    /// 4: the four nearest pixels by the inverse square of their distance.
    NormalizedDistance,
}

impl Interpolation {
    /// By SDL's number.
    pub fn from_number(number: u8) -> Interpolation {
        match number {
            2 => Interpolation::Bilinear,
            3 => Interpolation::Bicubic,
            4 => Interpolation::NormalizedDistance,
            _ => Interpolation::None,
        }
    }

    /// Calls `visit(column, row, weight)` for the pixels around a place; these may lie outside the picture.
    #[inline]
    pub fn cells(self, column: f64, row: f64, mut visit: impl FnMut(i64, i64, f64)) {
        if self == Interpolation::None {
            return visit(column.floor() as i64, row.floor() as i64, 1.0);
        }
        let (column, row) = (column - 0.5, row - 0.5);
        let (x, y) = (column.floor(), row.floor());
        let (s, t) = (column - x, row - y);
        let (x, y) = (x as i64, y as i64);
        match self {
            Interpolation::Bicubic => {
                let across = cubic_weights(s);
                for (j, along) in cubic_weights(t).into_iter().enumerate() {
                    for (i, weight) in across.into_iter().enumerate() {
                        visit(x + i as i64 - 1, y + j as i64 - 1, weight * along);
                    }
                }
            }
            Interpolation::NormalizedDistance if s == 0.0 && t == 0.0 => visit(x, y, 1.0),
            _ => {
                let corners = [(0, 0), (1, 0), (0, 1), (1, 1)];
                let weights = corners.map(|(i, j)| {
                    let (dx, dy) = (s - f64::from(i), t - f64::from(j));
                    match self {
                        Interpolation::Bilinear => (1.0 - dx.abs()) * (1.0 - dy.abs()),
                        _ => 1.0 / (dx * dx + dy * dy),
                    }
                });
                let sum: f64 = weights.iter().sum();
                for ((i, j), weight) in corners.into_iter().zip(weights) {
                    visit(x + i64::from(i), y + i64::from(j), weight / sum);
                }
            }
        }
    }
}

/// Of four neighbours for a place between the middle two: the cubic that passes through these with their mean slopes.
pub(crate) fn cubic_weights(t: f64) -> [f64; 4] {
    let (square, cube) = (t * t, t * t * t);
    [
        0.5 * (-t + 2.0 * square - cube),
        0.5 * (2.0 - 5.0 * square + 3.0 * cube),
        0.5 * (t + 4.0 * square - 3.0 * cube),
        0.5 * (cube - square),
    ]
}
