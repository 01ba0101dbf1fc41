//! SDL: `background { C }`, `sky_sphere { pigment {...} ... }`.

use crate::accel::RayKind;
use crate::color::Rgb;
use crate::graph::scene::Scene;
use crate::math::Vec3;
use crate::pattern::SurfaceContext;
use crate::shade::Radiance;
use crate::texture::{Builder, Pigment};

/// Scenes of an older version mix the layers of the sky by an older law.
const FILTERING_LAYERS: f64 = 3.7;

/// What rays see that hit nothing.
#[derive(Clone, Debug)]
pub struct Sky {
    /// The background's light.
    pub background: Radiance,
    /// The pigments of the sky sphere, the topmost first.
    layers: Vec<Pigment>,
    emission: Rgb,
    /// Before 3.7 the colours of upper layers do not filter lower layers, only the background (probed).
    legacy: bool,
    /// Only mirrors show the sky.
    unseen: bool,
}

impl Sky {
    /// `alpha` keeps the background's transparency; without it the colour counts as far as it is opaque. Before 3.7 the
    /// sky is opaque, or with `alpha` not there for rays from the camera.
    pub fn new(scene: &Scene, alpha: bool, patterns: &mut Builder) -> Sky {
        let legacy = scene.version < FILTERING_LAYERS;
        let opacity = if legacy { 1.0 } else { scene.background.opacity() };
        let transmit = if alpha { 1.0 - opacity } else { 0.0 };
        let background = Radiance { rgb: scene.background.rgb * opacity, transmit };
        let pigments = scene.sky_sphere.as_ref().map_or(&[][..], |sky| &sky.pigments);
        Sky {
            background,
            layers: pigments.iter().rev().map(|pigment| patterns.build_pigment(pigment)).collect(),
            emission: scene.sky_sphere.as_ref().map_or(Rgb::WHITE, |sky| sky.emission),
            legacy,
            unseen: legacy && alpha,
        }
    }

    /// Light from a direction.
    pub fn light(&self, direction: Vec3, kind: RayKind) -> Radiance {
        if self.unseen && kind == RayKind::Camera {
            return Radiance { rgb: Rgb::BLACK, transmit: 1.0 };
        }
        if self.layers.is_empty() {
            return self.background;
        }
        let mut seen = Radiance::BLACK;
        // What gets through the layers so far, and its two parts as the older law keeps them.
        let mut through = Rgb::WHITE;
        let (mut tint, mut filter, mut transmit) = (Rgb::WHITE, 1.0, 1.0);
        for layer in &self.layers {
            let color = layer.color(direction, &SurfaceContext::NONE);
            seen.rgb += color.rgb.mul_each(self.emission).mul_each(through) * color.opacity();
            if self.legacy {
                tint = tint.mul_each(color.rgb);
                filter *= color.filter;
                transmit *= color.transmit;
                through = Rgb::WHITE * (filter + transmit);
            } else {
                through = through.mul_each(color.rgb * color.filter + Rgb::WHITE * color.transmit);
            }
        }
        if self.legacy {
            through = tint * filter + Rgb::WHITE * transmit;
        }
        seen.rgb += self.background.rgb.mul_each(through);
        seen.transmit = self.background.transmit * through.gray();
        seen
    }
}
