//! SDL: `background { C }`, `sky_sphere { pigment {...} ... }`.

use crate::color::Rgbft;
use crate::math::Vec3;
use crate::shade::Radiance;

/// What rays see that hit nothing.
#[derive(Clone, Debug)]
pub struct Sky {
    /// The background's light.
    pub background: Radiance,
}

impl Sky {
    /// `alpha` keeps the background's transparency; without it the colour counts as far as it is opaque.
    pub fn new(background: Rgbft, alpha: bool) -> Sky {
        let opacity = background.opacity();
        let background =
            Radiance { rgb: background.rgb * opacity, transmit: if alpha { 1.0 - opacity } else { 0.0 } };
        Sky { background }
    }

    /// Light from a direction.
    pub fn light(&self, _direction: Vec3) -> Radiance {
        self.background
    }
}
