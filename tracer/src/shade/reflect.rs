//! SDL: `finish { reflection { minimum, maximum fresnel falloff F exponent F metallic F } }`.

use super::finish::Reflection;
use super::layers::Spot;
use super::{metallic_tint, Finish, Path, Tracer};
use crate::accel::RayKind;
use crate::color::Rgb;
use crate::math::{Ray, Vec3};

/// A mirror seen under a certain angle.
#[derive(Clone, Copy, Debug)]
pub(super) struct Mirrored {
    /// The perturbed normal.
    pub normal: Vec3,
    /// The share of light that is mirrored.
    pub share: Rgb,
    /// What the mirrored ray counts in the pixel.
    pub weight: f64,
    /// The power that mirrored light is raised to.
    pub exponent: f64,
    /// The layer that is the mirror.
    pub layer: usize,
}

impl Reflection {
    /// What a mirrored ray counts: of a mirror by angle the most that it could.
    pub(super) fn strength(&self, share: Rgb) -> f64 {
        if self.fresnel {
            share.max_element()
        } else {
            self.range[0].max_element().max(self.range[1].max_element())
        }
    }
}

impl Tracer<'_> {
    /// The share of light that is mirrored, by the angle between ray and normal.
    pub(super) fn reflectivity(&self, spot: &Spot, mirror: &Reflection, normal: Vec3, pigment: Rgb) -> Rgb {
        let [low, high] = mirror.range;
        let cos = -spot.path.ray.direction.dot(normal);
        let share = if low == high {
            low
        } else {
            let rise = if mirror.fresnel {
                fresnel(cos, self.mirror_ior(spot))
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

    /// Light from the mirrored direction, times the mirror's share; `finish` is that of the mirror's layer.
    pub(super) fn mirrored(&mut self, spot: &Spot, mirrored: &Mirrored, finish: &Finish) -> Rgb {
        if !self.scene.quality.reflection || mirrored.share == Rgb::BLACK {
            return Rgb::BLACK;
        }
        let seen = self.reflected(spot, mirrored.normal, finish, mirrored.weight);
        let seen =
            if mirrored.exponent == 1.0 { seen } else { seen.map(|c| c.max(0.0).powf(mirrored.exponent)) };
        seen.mul_each(mirrored.share)
    }

    /// Light from the mirrored direction, coloured by a thin film.
    pub(super) fn reflected(&mut self, spot: &Spot, normal: Vec3, finish: &Finish, weight: f64) -> Rgb {
        let direction = mirror_direction(spot.path.ray.direction, normal, spot.normal);
        let ray = Ray { origin: spot.point, direction };
        let path = Path { ray, kind: RayKind::Reflected, ..*spot.path };
        let seen = self.trace(&path, weight).rgb;
        match &finish.irid {
            Some(film) => self.film(film, spot, normal, direction, seen),
            None => seen,
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

/// Fresnel's law for unpolarised light that arrives at cosine `cos` and enters a medium of relative density `ior`; all
/// is mirrored where bumps turn the surface away from the ray.
pub(super) fn fresnel(cos: f64, ior: f64) -> f64 {
    let g2 = ior * ior + cos * cos - 1.0;
    if g2 < 0.0 {
        return 1.0;
    }
    let g = g2.sqrt();
    let s = (g - cos) / (g + cos);
    let p = (cos * (g + cos) - 1.0) / (cos * (g - cos) + 1.0);
    (0.5 * s * s * (1.0 + p * p)).min(1.0)
}
