//! SDL: `background`, `sky_sphere`, `fog`, `rainbow`: what is seen where nothing is hit, and between.

mod fog;
mod sky;

pub use fog::Fog;
pub use sky::Sky;

use crate::color::Rgb;
use crate::graph::scene::Scene;
use crate::math::Ray;
use crate::noise::NoiseGenerator;
use crate::prepare::Quality;
use crate::shade::Radiance;

/// What lies between things.
#[derive(Clone, Debug, Default)]
pub struct Atmosphere {
    fogs: Vec<Fog>,
}

impl Atmosphere {
    /// The scene's fogs, unless the quality leaves them out.
    pub fn new(scene: &Scene, quality: &Quality) -> Atmosphere {
        let fogs = scene.fogs.iter().filter(|fog| quality.volumes && fog.distance != 0.0);
        let generator = NoiseGenerator::from_number(i64::from(scene.settings.noise_generator));
        Atmosphere { fogs: fogs.map(|fog| Fog::new(fog, generator)).collect() }
    }

    /// Whether there is nothing in between.
    #[inline]
    pub fn is_clear(&self) -> bool {
        self.fogs.is_empty()
    }

    /// Changes light that comes from `distance` along the ray.
    pub fn dim(&self, ray: &Ray, distance: f64, seen: &mut Radiance) {
        // Every fog adds its own light undimmed by the others (probed).
        let mut added = Rgb::BLACK;
        for fog in &self.fogs {
            let (left, own) = fog.look(ray, distance);
            seen.rgb = seen.rgb.mul_each(left);
            seen.transmit *= left.gray();
            added += own;
        }
        seen.rgb += added;
    }
}
