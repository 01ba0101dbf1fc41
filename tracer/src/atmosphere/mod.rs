//! SDL: `background`, `sky_sphere`, `fog`, `rainbow`: what is seen where nothing is hit, and between.

mod sky;

pub use sky::Sky;

use crate::shade::{Path, Radiance};

/// What lies between things.
#[derive(Clone, Debug, Default)]
pub struct Atmosphere {}

impl Atmosphere {
    /// Changes light that comes from `distance` along the ray.
    pub fn dim(&self, _path: &Path, _distance: f64, _seen: &mut Radiance) {}
}
