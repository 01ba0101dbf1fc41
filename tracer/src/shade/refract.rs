//! SDL: `interior { ior F }`: rays through surfaces.

use super::layers::Spot;
use super::{mirror_direction, Path, Radiance, Tracer};
use crate::accel::RayKind;
use crate::color::Rgb;
use crate::math::{Ray, Vec3};

impl Tracer<'_> {
    /// Density of what lies behind the surface over that of what the ray is in.
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
        let scene = self.scene;
        if !scene.quality.refraction {
            return;
        }
        let ray = &spot.path.ray;
        let onward = |direction, interiors| Path {
            ray: Ray { origin: spot.point, direction },
            interiors,
            ..*spot.path
        };
        let interiors = self.beyond(spot);
        let ratio = scene.ior_of(spot.path.interiors.innermost()) / scene.ior_of(interiors.innermost());
        let behind = if (ratio - 1.0).abs() < 1e-10 {
            self.trace_on(&onward(ray.direction, interiors), weight)
        } else {
            match refracted(ray.direction, normal, ratio) {
                Some(direction) => self.trace(&onward(direction, interiors), weight),
                None => {
                    let direction = mirror_direction(ray.direction, normal, spot.normal);
                    let path = Path { kind: RayKind::Reflected, ..onward(direction, spot.path.interiors) };
                    self.trace(&path, weight)
                }
            }
        };
        seen.rgb += behind.rgb.mul_each(filter);
        seen.transmit += behind.transmit * filter.gray();
    }
}

/// Snell's law; none where light is totally reflected. `ratio` is the density before over that behind.
fn refracted(direction: Vec3, normal: Vec3, ratio: f64) -> Option<Vec3> {
    let cos = direction.dot(normal);
    let (normal, cos) = if cos <= 0.0 { (normal, -cos) } else { (-normal, cos) };
    let inside = 1.0 + ratio * ratio * (cos * cos - 1.0);
    (inside >= 0.0).then(|| (direction * ratio + normal * (ratio * cos - inside.sqrt())).normalized())
}
