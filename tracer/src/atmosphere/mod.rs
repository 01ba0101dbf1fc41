//! SDL: `background`, `sky_sphere`, `fog`, `rainbow`: what is seen where nothing is hit, and between.

mod fog;
mod sky;

pub use fog::Fog;
pub use sky::Sky;

use crate::graph::scene::Scene;
use crate::prepare::Quality;
use crate::shade::{Path, Radiance};

/// What lies between things.
#[derive(Clone, Debug, Default)]
pub struct Atmosphere {
    fogs: Vec<Fog>,
}

impl Atmosphere {
    /// The scene's fogs, unless the quality leaves them out.
    pub fn new(scene: &Scene, quality: &Quality) -> Atmosphere {
        let fogs = scene.fogs.iter().filter(|fog| quality.volumes && fog.distance != 0.0);
        Atmosphere { fogs: fogs.map(Fog::new).collect() }
    }

    /// Changes light that comes from `distance` along the ray.
    pub fn dim(&self, path: &Path, distance: f64, seen: &mut Radiance) {
        for fog in &self.fogs {
            fog.dim(&path.ray, distance, seen);
        }
    }
}
