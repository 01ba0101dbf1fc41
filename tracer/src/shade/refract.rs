//! SDL: `interior { ior F }`: rays through surfaces.

use super::layers::Spot;
use super::{mirror_direction, Interiors, Path, Radiance, Tracer};
use crate::accel::RayKind;
use crate::color::Rgb;
use crate::math::{Ray, Vec3};

impl Tracer<'_> {
    /// Density of what lies behind the surface over that of what the ray is in.
    pub(super) fn relative_ior(&self, spot: &Spot) -> f64 {
        self.scene.ior_of(beyond(spot).innermost()) / self.scene.ior_of(spot.path.interiors.innermost())
    }

    /// How a ray would go on through the surface.
    pub(super) fn passage(&self, spot: &Spot, normal: Vec3) -> Passage {
        let ratio = 1.0 / self.relative_ior(spot);
        if (ratio - 1.0).abs() < 1e-10 {
            return Passage::Straight;
        }
        refracted(spot.path.ray.direction, normal, ratio).map_or(Passage::None, Passage::Bent)
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
        let attenuation = self.scene.view_attenuation(spot);
        let ray = &spot.path.ray;
        let onward = |direction| {
            let ray = Ray { origin: spot.point, direction };
            Path { ray, interiors: beyond(spot), kind: spot.path.kind }
        };
        let (behind, filter) = match self.passage(spot, normal) {
            Passage::Straight => (self.trace_on(&onward(ray.direction), weight), filter),
            Passage::Bent(direction) => (self.trace(&onward(direction), weight), filter),
            Passage::None => {
                let direction = mirror_direction(ray.direction, normal, spot.normal);
                let ray = Ray { origin: spot.point, direction };
                let path = Path { ray, interiors: spot.path.interiors, kind: RayKind::Reflected };
                (self.trace(&path, weight), Rgb::WHITE)
            }
        };
        seen.rgb += behind.rgb.mul_each(filter).mul_each(attenuation);
        seen.transmit += behind.transmit * filter.gray();
    }
}

/// How a ray goes through a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Passage {
    /// Unbent.
    Straight,
    /// In another direction.
    Bent(Vec3),
    /// Not at all: it is totally reflected.
    None,
}

/// The interiors around a ray that goes through the surface.
fn beyond(spot: &Spot) -> Interiors {
    let mut interiors = spot.path.interiors;
    if !interiors.leave(spot.body) {
        interiors.enter(spot.body);
    }
    interiors
}

/// Snell's law; none where light is totally reflected. `ratio` is the density before over that behind.
fn refracted(direction: Vec3, normal: Vec3, ratio: f64) -> Option<Vec3> {
    let cos = direction.dot(normal);
    let (normal, cos) = if cos <= 0.0 { (normal, -cos) } else { (-normal, cos) };
    let inside = 1.0 + ratio * ratio * (cos * cos - 1.0);
    (inside >= 0.0).then(|| (direction * ratio + normal * (ratio * cos - inside.sqrt())).normalized())
}
