//! SDL: `fog { fog_type 1|2 distance F color C fog_offset F fog_alt F up V turbulence V turb_depth F }`.

use crate::color::{Rgb, Rgbft};
use crate::graph::atmosphere as graph;
use crate::math::{Ray, Vec3};
use crate::noise::NoiseGenerator;
use crate::pattern::TurbulenceModifier;

/// What is looked at from infinitely far away is this far away.
const FARTHEST: f64 = 1e7;

/// A fog ready to be looked through.
#[derive(Clone, Debug)]
pub struct Fog {
    /// Where light falls to 1/e.
    distance: f64,
    color: Rgbft,
    ground: Option<Ground>,
    turbulence: Option<(TurbulenceModifier, f64)>,
    generator: NoiseGenerator,
}

/// Fog that thins out upwards.
#[derive(Clone, Debug)]
struct Ground {
    up: Vec3,
    offset: f64,
    altitude: f64,
}

impl Ground {
    /// The integral of the density over height from the offset up to `h` (negative below): the density is 1 below the
    /// offset and `1 / (1 + (h / altitude)^2)` above (probed).
    fn thickness(&self, h: f64) -> f64 {
        if h <= 0.0 {
            h
        } else {
            self.altitude * (h / self.altitude).atan()
        }
    }

    fn density(&self, h: f64) -> f64 {
        if h < 0.0 {
            1.0
        } else {
            (1.0 + (h / self.altitude).powi(2)).recip()
        }
    }

    /// The way through fog of density 1 that weighs as much as `distance` along the ray.
    fn depth(&self, ray: &Ray, distance: f64) -> f64 {
        let start = ray.origin.dot(self.up) - self.offset;
        let climb = ray.direction.dot(self.up) * distance;
        if climb.abs() < 1e-8 * distance.max(1.0) {
            return self.density(start) * distance;
        }
        (self.thickness(start + climb) - self.thickness(start)) / climb * distance
    }
}

impl Fog {
    /// Makes a fog ready; `generator` is the scene's.
    pub fn new(fog: &graph::Fog, generator: NoiseGenerator) -> Fog {
        let ground = (fog.fog_type == 2).then(|| Ground {
            up: fog.up.normalized(),
            offset: fog.fog_offset,
            altitude: fog.fog_alt,
        });
        let turbulence = fog.turbulence.as_ref().map(|t| (TurbulenceModifier::from(t), fog.turb_depth));
        Fog { distance: fog.distance, color: fog.color, ground, turbulence, generator }
    }

    /// The share of light that comes through from `distance` along the ray, by channel, and what the fog adds.
    pub fn look(&self, ray: &Ray, distance: f64) -> (Rgb, Rgb) {
        let distance = distance.min(FARTHEST);
        let depth = match &self.ground {
            None => distance,
            Some(ground) => ground.depth(ray, distance),
        };
        let depth = depth * self.thinning(ray, distance);
        let left = (-depth / self.distance).exp().max(self.color.transmit);
        let filter = Rgb::WHITE * (1.0 - self.color.filter) + self.color.rgb * self.color.filter;
        (filter * left, self.color.rgb * (1.0 - left))
    }

    /// Turbulence, as found half-way along the ray, makes fog thinner: the more, the less fog there is (probed).
    fn thinning(&self, ray: &Ray, distance: f64) -> f64 {
        let Some((turbulence, depth)) = &self.turbulence else {
            return 1.0;
        };
        let place = ray.at(distance / 2.0).mul_each(turbulence.amount);
        let amount = (turbulence.octaves.scalar(place, self.generator) * depth).min(1.0);
        1.0 - (-distance / self.distance).exp() * amount
    }
}
