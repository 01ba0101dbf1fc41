//! SDL: `interior { ior F }`: rays through surfaces.

use super::dispersion::Band;
use super::layers::Spot;
use super::{Finish, Interiors, Path, Radiance, Tracer};
use crate::color::Rgb;
use crate::math::{Ray, Vec3};

/// Ratios nearer to 1 than this do not bend.
const UNBENT: f64 = 1e-10;

impl Tracer<'_> {
    /// Density of what lies behind the surface over that of what the ray is in.
    pub(super) fn relative_ior(&self, spot: &Spot) -> f64 {
        self.scene.ior_of(beyond(spot).innermost()) / self.scene.ior_of(spot.path.interiors.innermost())
    }

    /// The same as Fresnel's law of mirrors has it. Between two objects the outer one is overlooked: POV-Ray asks what
    /// the ray is in before it has left.
    pub(super) fn mirror_ior(&self, spot: &Spot) -> f64 {
        let around = &spot.path.interiors;
        if around.contains(spot.body) && around.len() > 1 {
            self.scene.ior_of(around.innermost()) / self.scene.ior_of(Some(spot.body))
        } else {
            self.relative_ior(spot)
        }
    }

    /// The ratio of violet's density to red's behind the surface over that before it, where it parts colours.
    pub(super) fn dispersion(&self, spot: &Spot) -> Option<f64> {
        let (before, behind) = (spot.path.interiors.innermost(), beyond(spot).innermost());
        let dispersion = self.scene.dispersion_of(before) / self.scene.dispersion_of(behind);
        ((dispersion - 1.0).abs() >= UNBENT).then_some(dispersion)
    }

    /// Adds what is seen through the surface, times `filter`; says whether all was reflected instead.
    pub(super) fn seen_through(
        &mut self,
        spot: &Spot,
        normal: Vec3,
        filter: Rgb,
        weight: f64,
        top: &Finish,
        seen: &mut Radiance,
    ) -> bool {
        let scene = self.scene;
        if !scene.quality.refraction {
            return false;
        }
        let attenuation = scene.view_attenuation(spot) * scene.refraction(spot.body);
        let ior = 1.0 / self.relative_ior(spot);
        let (behind, totally) = match (self.dispersion(spot), spot.path.band) {
            (None, _) if (ior - 1.0).abs() < UNBENT => {
                (self.trace_on(&onward(spot, spot.path.ray.direction), weight), false)
            }
            (None, _) => self.seen_bent(spot, normal, ior, weight, top),
            (Some(dispersion), Some(band)) => {
                self.seen_bent(spot, normal, band.bends(ior, dispersion), weight, top)
            }
            (Some(dispersion), None) => {
                let count = scene.dispersion_samples(spot.body);
                let mut sum = Radiance::BLACK;
                for band in Band::all(count) {
                    let path = Path { band: Some(band), ..*spot.path };
                    let spot = Spot { path: &path, ..*spot };
                    let (light, _) = self.seen_bent(&spot, normal, band.bends(ior, dispersion), weight, top);
                    sum.rgb += light.rgb.mul_each(band.hue()) * (1.0 / count as f64);
                }
                (sum, false)
            }
        };
        let filter = if totally { Rgb::WHITE } else { filter };
        seen.rgb += behind.rgb.mul_each(filter).mul_each(attenuation);
        seen.transmit += behind.transmit * filter.gray();
        totally
    }

    /// Light from behind a surface that bends by the density before over that behind, or the mirrored light and `true`
    /// where it is totally reflected.
    fn seen_bent(
        &mut self,
        spot: &Spot,
        normal: Vec3,
        ratio: f64,
        weight: f64,
        top: &Finish,
    ) -> (Radiance, bool) {
        match refracted(spot.path.ray.direction, normal, ratio) {
            Some(direction) => (self.trace(&onward(spot, direction), weight), false),
            None => (Radiance { rgb: self.reflected(spot, normal, top, weight), ..Radiance::BLACK }, true),
        }
    }
}

/// The interiors around a ray that goes through the surface.
fn beyond(spot: &Spot) -> Interiors {
    let mut interiors = spot.path.interiors;
    if !interiors.leave(spot.body) {
        interiors.enter(spot.body);
    }
    interiors
}

/// The ray behind the surface.
pub(super) fn onward(spot: &Spot, direction: Vec3) -> Path {
    let ray = Ray { origin: spot.point, direction };
    Path { ray, interiors: beyond(spot), ..*spot.path }
}

/// Snell's law; none where light is totally reflected. `ratio` is the density before over that behind.
pub(super) fn refracted(direction: Vec3, normal: Vec3, ratio: f64) -> Option<Vec3> {
    let cos = direction.dot(normal);
    let (normal, cos) = if cos <= 0.0 { (normal, -cos) } else { (-normal, cos) };
    let inside = 1.0 + ratio * ratio * (cos * cos - 1.0);
    (inside >= 0.0).then(|| (direction * ratio + normal * (ratio * cos - inside.sqrt())).normalized())
}
