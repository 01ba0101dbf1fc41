//! SDL: `color_map { [0 rgb 0] [0.5 rgb x] [1 rgb 1] }`, and the look-up that all maps share.

use crate::color::Rgbft;
use crate::graph::pigment as graph;

/// Values with what they stand for, in the order they were written.
#[derive(Clone, Debug)]
pub struct BlendMap<T>(Vec<(f64, T)>);

/// A `color_map`.
pub type ColorMap = BlendMap<Rgbft>;

impl<T> BlendMap<T> {
    /// At least one entry.
    pub fn new(entries: Vec<(f64, T)>) -> BlendMap<T> {
        assert!(!entries.is_empty(), "a map needs an entry");
        BlendMap(entries)
    }

    /// A list as a map: its entries stand at 0, 1, 2, ...
    pub fn numbered(list: Vec<T>) -> BlendMap<T> {
        BlendMap::new(list.into_iter().enumerate().map(|(i, entry)| (i as f64, entry)).collect())
    }

    /// All entries, in order.
    pub fn entries(&self) -> &[(f64, T)] {
        &self.0
    }

    /// The two entries around `value` and how far `value` lies between them, 0..=1.
    ///
    /// Below the first entry it is the first, from the last on the last; else at equal entries the first counts.
    #[inline]
    pub fn around(&self, value: f64) -> (&T, &T, f64) {
        let entries = &self.0[..];
        let last = &entries[entries.len() - 1];
        if value >= last.0 {
            return (&last.1, &last.1, 0.0);
        }
        let above = entries.iter().position(|e| value <= e.0);
        match above {
            Some(0) => (&entries[0].1, &entries[0].1, 0.0),
            Some(i) => {
                let ((low, a), (high, b)) = (&entries[i - 1], &entries[i]);
                (a, b, (value - low) / (high - low))
            }
            None => (&last.1, &last.1, 0.0),
        }
    }
}

impl From<&graph::ColorMap> for ColorMap {
    fn from(map: &graph::ColorMap) -> ColorMap {
        ColorMap::new(map.entries.clone())
    }
}

impl ColorMap {
    /// The colour at `value`, all five components interpolated.
    #[inline]
    pub fn color(&self, value: f64) -> Rgbft {
        let (a, b, t) = self.around(value);
        Rgbft::lerp(a, b, t)
    }
}
