//! SDL: `interior { ior F }`: rays through surfaces.

use super::layers::Spot;
use super::{mirror_direction, Path, Radiance, Tracer};
use crate::accel::RayKind;
use crate::color::Rgb;
use crate::math::{Ray, Vec3};

impl Tracer<'_> {
    /// Density of what the ray is in over what lies behind the surface... as seen going through.
    pub(super) fn relative_ior(&self, spot: &Spot) -> f64 {
        let behind = self.beyond(spot);
        self.scene.ior_of(behind.innermost()) / self.scene.ior_of(spot.path.interiors.innermost())
    }

    /// The interiors around a ray that goes through the surface.
    fn beyond(&self, spot: &Spot) -> super::Interiors {
        let mut interiors = spot.path.interiors;
        if !interiors.leave(spot.interior) {
            interiors.enter(spot.interior);
        }
        interiors
    }

    /// Adds what is seen through the surface, times `filter`.
    pub(super) fn seen_through(
        &mut self,
        spot: &Spot,
        normal: Vec3,
        filter: Rgb,
        weight: f64,
        seen: &mut Radiance,
    ) {
        if !self.scene.quality.refraction {
            return;
        }
        let interiors = self.beyond(spot);
        let ray = &spot.path.ray;
        let ratio = self.scene.ior_of(ray_medium(spot)) / self.scene.ior_of(interiors.innermost());
        let direction = if (ratio - 1.0).abs() < 1e-10 {
            Some(ray.direction)
        } else {
            refracted(ray.direction, normal, ratio)
        };
        let (direction, interiors, kind) = match direction {
            Some(direction) => (direction, interiors, spot.path.kind),
            None => {
                let mirrored = mirror_direction(ray.direction, normal, spot.normal);
                (mirrored, spot.path.interiors, RayKind::Reflected)
            }
        };
        let path = Path { ray: Ray { origin: spot.point, direction }, interiors, kind };
        let behind = self.trace(&path, weight);
        seen.rgb += behind.rgb.mul_each(filter);
        seen.transmit += behind.transmit * filter.gray();
    }
}

fn ray_medium(spot: &Spot) -> Option<u32> {
    spot.path.interiors.innermost()
}

/// Snell's law; none where light is totally reflected. `ratio` is the density before over that behind.
fn refracted(direction: Vec3, normal: Vec3, ratio: f64) -> Option<Vec3> {
    let cos = direction.dot(normal);
    let (normal, cos) = if cos <= 0.0 { (normal, -cos) } else { (-normal, cos) };
    let inside = 1.0 + ratio * ratio * (cos * cos - 1.0);
    (inside >= 0.0).then(|| (direction * ratio + normal * (ratio * cos - inside.sqrt())).normalized())
}
