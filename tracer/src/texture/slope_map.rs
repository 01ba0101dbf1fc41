//! SDL: `slope_map { [0 <0, 1>] [1 <1, 0>] }`: the profile of a bump by heights and slopes.

use super::color_map::BlendMap;

/// Heights and slopes by the value of a pattern.
#[derive(Clone, Debug)]
pub struct SlopeMap(BlendMap<[f64; 2]>);

impl SlopeMap {
    /// Entries of a value with its height and slope; at least one.
    pub fn new(entries: Vec<(f64, [f64; 2])>) -> SlopeMap {
        SlopeMap(BlendMap::new(entries))
    }

    /// The height at a value, on the cubic curve through the entries around it.
    pub fn height(&self, value: f64) -> f64 {
        let (&[low, low_slope], &[high, high_slope], t) = self.0.around(value);
        if t == 0.0 {
            return low;
        }
        let (square, cube) = (t * t, t * t * t);
        let rise = 3.0 * square - 2.0 * cube;
        low * (1.0 - rise)
            + high * rise
            + low_slope * (cube - 2.0 * square + t)
            + high_slope * (cube - square)
    }
}
