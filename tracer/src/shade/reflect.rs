//! SDL: `finish { reflection { minimum, maximum fresnel falloff F exponent F metallic F } }`.

use super::finish::Reflection;
use super::layers::Spot;
use super::{metallic_tint, Path, Tracer};
use crate::accel::RayKind;
use crate::color::Rgb;
use crate::math::{Ray, Vec3};

impl Tracer<'_> {
    /// The share of light that is mirrored, by the angle between ray and normal.
    pub(super) fn reflectivity(&self, spot: &Spot, mirror: &Reflection, normal: Vec3, pigment: Rgb) -> Rgb {
        let [low, high] = mirror.range;
        let cos = -spot.path.ray.direction.dot(normal);
        let share = if low == high {
            low
        } else {
            let rise = if mirror.fresnel {
                fresnel(cos, self.relative_ior(spot))
            } else {
                (1.0 - cos).max(0.0).powf(mirror.falloff)
            };
            low + (high + low * -1.0) * rise
        };
        if mirror.metallic == 0.0 {
            return share;
        }
        share.mul_each(metallic_tint(mirror.metallic, cos, pigment))
    }

    /// Light from the mirrored direction, times `share`.
    pub(super) fn mirrored(
        &mut self,
        spot: &Spot,
        mirror: &Reflection,
        normal: Vec3,
        share: Rgb,
        weight: f64,
    ) -> Rgb {
        if self.scene.quality.reflection {
            let direction = mirror_direction(spot.path.ray.direction, normal, spot.normal);
            let path = Path {
                ray: Ray { origin: spot.point, direction },
                interiors: spot.path.interiors,
                kind: RayKind::Reflected,
            };
            let seen = self.trace(&path, weight * share.max_element()).rgb;
            let seen = if mirror.exponent == 1.0 { seen } else { seen.map(|c| c.powf(mirror.exponent)) };
            seen.mul_each(share)
        } else {
            Rgb::BLACK
        }
    }
}

/// The direction mirrored at a perturbed normal, kept on the ray's side of the true surface.
pub(super) fn mirror_direction(direction: Vec3, normal: Vec3, true_normal: Vec3) -> Vec3 {
    let mirror = |d: Vec3, n: Vec3| d - n * (2.0 * d.dot(n));
    let mirrored = mirror(direction, normal);
    let kept = if mirrored.dot(true_normal) >= 0.0 {
        mirrored
    } else if mirrored.dot(normal) < 0.0 {
        mirror(direction, true_normal)
    } else {
        mirror(mirrored, true_normal)
    };
    kept.normalized()
}

/// Fresnel's law for unpolarised light that arrives at cosine `cos` and enters a medium of relative density `ior`.
fn fresnel(cos: f64, ior: f64) -> f64 {
    let g2 = ior * ior + cos * cos - 1.0;
    if g2 < 0.0 {
        return 1.0;
    }
    let g = g2.sqrt();
    let s = (g - cos) / (g + cos);
    let p = (cos * (g + cos) - 1.0) / (cos * (g - cos) + 1.0);
    0.5 * s * s * (1.0 + p * p)
}
