//! SDL: `background`, `sky_sphere`, `fog`, `rainbow`: what is seen where nothing is hit, and between.

mod fog;
mod rainbow;
mod sky;

pub use fog::Fog;
pub use rainbow::Rainbow;
pub use sky::Sky;

use crate::color::Rgb;
use crate::graph::scene::Scene;
use crate::math::Ray;
use crate::noise::NoiseGenerator;
use crate::prepare::Quality;
use crate::render::Random;
use crate::shade::Radiance;

/// What lies between things.
#[derive(Clone, Debug, Default)]
pub struct Atmosphere {
    rainbows: Vec<Rainbow>,
    fogs: Vec<Fog>,
}

impl Atmosphere {
    /// The scene's rainbows and fogs, unless the quality leaves them out.
    pub fn new(scene: &Scene, quality: &Quality) -> Atmosphere {
        let fogs = scene.fogs.iter().filter(|fog| quality.volumes && fog.distance != 0.0);
        let generator = NoiseGenerator::from_number(i64::from(scene.settings.noise_generator));
        let rainbows = scene.rainbows.iter().filter(|_| quality.volumes);
        Atmosphere {
            rainbows: rainbows.filter_map(Rainbow::new).collect(),
            fogs: fogs.map(|fog| Fog::new(fog, generator)).collect(),
        }
    }

    /// Whether there is nothing in between.
    #[inline]
    pub fn is_clear(&self) -> bool {
        self.fogs.is_empty() && self.rainbows.is_empty()
    }

    /// Changes light that comes from `distance` along the ray by the fogs.
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

    /// Of several rainbows in one direction the mean is seen.
    pub fn pass_rainbows(&self, ray: &Ray, distance: f64, random: &mut Random, seen: &mut Radiance) {
        let mut bows = 0;
        let (mut left, mut own) = (Rgb::BLACK, Rgb::BLACK);
        for bow in self.rainbows.iter().filter_map(|rainbow| rainbow.look(ray, distance, random)) {
            bows += 1;
            left += bow.left;
            own += bow.own;
            seen.transmit *= bow.transmit;
        }
        if bows > 0 {
            seen.rgb = (seen.rgb.mul_each(left) + own) * f64::from(bows).recip();
        }
    }

    /// What is left of a lamp's light that comes from `distance` along the ray.
    pub fn filter(&self, ray: &Ray, distance: f64) -> Rgb {
        self.fogs.iter().fold(Rgb::WHITE, |left, fog| left.mul_each(fog.look(ray, distance).0))
    }
}
