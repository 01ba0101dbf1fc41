//! SDL: `background { C }`, `sky_sphere { pigment {...} ... }`.

use crate::color::Rgb;
use crate::graph::scene::Scene;
use crate::math::Vec3;
use crate::pattern::SurfaceContext;
use crate::shade::Radiance;
use crate::texture::{Builder, Pigment};

/// What rays see that hit nothing.
#[derive(Clone, Debug)]
pub struct Sky {
    /// The background's light.
    pub background: Radiance,
    /// The pigments of the sky sphere, the topmost first.
    layers: Vec<Pigment>,
    emission: Rgb,
}

impl Sky {
    /// `alpha` keeps the background's transparency; without it the colour counts as far as it is opaque.
    pub fn new(scene: &Scene, alpha: bool, patterns: &mut Builder) -> Sky {
        let opacity = scene.background.opacity();
        let transmit = if alpha { 1.0 - opacity } else { 0.0 };
        let background = Radiance { rgb: scene.background.rgb * opacity, transmit };
        let pigments = scene.sky_sphere.as_ref().map_or(&[][..], |sky| &sky.pigments);
        Sky {
            background,
            layers: pigments.iter().rev().map(|pigment| patterns.build_pigment(pigment)).collect(),
            emission: scene.sky_sphere.as_ref().map_or(Rgb::WHITE, |sky| sky.emission),
        }
    }

    /// Light from a direction.
    pub fn light(&self, direction: Vec3) -> Radiance {
        if self.layers.is_empty() {
            return self.background;
        }
        let mut seen = Radiance::BLACK;
        let mut filter = Rgb::WHITE;
        for layer in &self.layers {
            let color = layer.color(direction, &SurfaceContext::NONE);
            seen.rgb += color.rgb.mul_each(self.emission).mul_each(filter) * color.opacity();
            filter = filter.mul_each(color.rgb * color.filter + Rgb::WHITE * color.transmit);
        }
        seen.rgb += self.background.rgb.mul_each(filter);
        seen.transmit = self.background.transmit * filter.gray();
        seen
    }
}
