//! SDL: `interior { ior F dispersion F dispersion_samples I }`: white light bent by colours.
//!
//! Light is parted in bands from red to violet; each has a refractive index and a colour of its own. A ray of one band
//! stays in it until it ends.

use crate::color::{rgb, Rgb};

/// One of several equal parts of the spectrum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Band {
    number: usize,
    count: usize,
}

impl Band {
    /// All bands of a spectrum.
    pub(super) fn all(count: usize) -> impl Iterator<Item = Band> {
        (0..count).map(move |number| Band { number, count })
    }

    /// The ratio by which this band is bent: the middle of the spectrum is bent as without dispersion.
    pub(super) fn bends(self, ior: f64, dispersion: f64) -> f64 {
        ior * dispersion.powf((self.number as f64 + 0.5) / self.count as f64 - 0.5)
    }

    /// The colour of the band's light; all bands together are nearly white.
    pub(super) fn hue(self) -> Rgb {
        let steps = HUES.len() as f64;
        let [start, end] = [self.number, self.number + 1].map(|n| n as f64 / self.count as f64 * steps);
        let mut sum = Rgb::BLACK;
        let mut at = start as usize;
        while at < HUES.len() && (at as f64) < end {
            let share = (end.min(at as f64 + 1.0) - start.max(at as f64)).max(0.0);
            let [r, g, b] = HUES[at];
            sum += rgb(r, g, b) * share;
            at += 1;
        }
        sum * (1.0 / (end - start))
    }
}

/// Mean colours of 72 equal parts of the spectrum, from red to violet (probed).
const HUES: [[f64; 3]; 72] = [
    [0.686, 0.000, 0.000],
    [0.985, 0.000, 0.000],
    [1.259, 0.000, 0.000],
    [1.510, 0.000, 0.000],
    [1.751, 0.000, 0.000],
    [1.964, 0.000, 0.000],
    [2.157, 0.000, 0.000],
    [2.330, 0.000, 0.000],
    [2.485, 0.000, 0.000],
    [2.618, 0.000, 0.000],
    [2.733, 0.000, 0.000],
    [2.832, 0.092, 0.000],
    [2.904, 0.331, 0.000],
    [2.953, 0.609, 0.000],
    [2.988, 0.874, 0.000],
    [3.003, 1.124, 0.000],
    [2.996, 1.354, 0.000],
    [2.971, 1.567, 0.000],
    [2.924, 1.771, 0.000],
    [2.853, 1.953, 0.000],
    [2.765, 2.116, 0.000],
    [2.659, 2.271, 0.000],
    [2.531, 2.404, 0.000],
    [2.383, 2.516, 0.000],
    [2.211, 2.621, 0.000],
    [2.026, 2.706, 0.000],
    [1.818, 2.769, 0.000],
    [1.593, 2.828, 0.000],
    [1.339, 2.854, 0.000],
    [1.069, 2.878, 0.000],
    [0.781, 2.882, 0.000],
    [0.472, 2.866, 0.000],
    [0.160, 2.838, 0.000],
    [0.000, 2.789, 0.037],
    [0.000, 2.727, 0.294],
    [0.000, 2.647, 0.547],
    [0.000, 2.548, 0.776],
    [0.000, 2.433, 1.001],
    [0.000, 2.310, 1.206],
    [0.000, 2.156, 1.392],
    [0.000, 2.000, 1.574],
    [0.000, 1.819, 1.741],
    [0.000, 1.624, 1.891],
    [0.000, 1.410, 2.030],
    [0.000, 1.182, 2.156],
    [0.000, 0.940, 2.267],
    [0.000, 0.680, 2.366],
    [0.000, 0.405, 2.452],
    [0.000, 0.107, 2.523],
    [0.000, 0.000, 2.583],
    [0.000, 0.000, 2.629],
    [0.000, 0.000, 2.662],
    [0.000, 0.000, 2.681],
    [0.000, 0.000, 2.688],
    [0.000, 0.000, 2.678],
    [0.000, 0.000, 2.658],
    [0.000, 0.000, 2.625],
    [0.000, 0.000, 2.578],
    [0.000, 0.000, 2.518],
    [0.023, 0.000, 2.443],
    [0.093, 0.000, 2.356],
    [0.160, 0.000, 2.255],
    [0.221, 0.000, 2.140],
    [0.260, 0.000, 2.018],
    [0.291, 0.000, 1.873],
    [0.310, 0.000, 1.721],
    [0.313, 0.000, 1.556],
    [0.299, 0.000, 1.377],
    [0.284, 0.000, 1.178],
    [0.249, 0.000, 0.975],
    [0.201, 0.000, 0.756],
    [0.140, 0.000, 0.525],
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_bands_together_are_white() {
        for count in [2, 3, 7, 50, 100] {
            let sum = Band::all(count).fold(Rgb::BLACK, |sum, band| sum + band.hue());
            let mean = sum * (1.0 / count as f64);
            assert!(
                (mean.r - 0.994).abs() < 2e-3 && (mean.g - 1.0).abs() < 2e-3 && (mean.b - 0.996).abs() < 2e-3
            );
        }
    }

    #[test]
    fn red_is_bent_least() {
        let bands: Vec<_> = Band::all(3).map(|band| band.bends(1.5, 1.2)).collect();
        assert!(bands[0] < 1.5 && (bands[1] - 1.5).abs() < 1e-12 && bands[2] > 1.5);
        let ends: Vec<_> = Band::all(7).map(Band::hue).collect();
        assert!(ends[0].r > 1.7 && ends[0].b == 0.0 && ends[6].b > 1.4);
    }
}
