//! Photons gathered where they fell. See [`crate::photon`].

use super::layers::Spot;
use super::shadow::Place;
use super::{Finish, Tracer};
use crate::color::Rgb;
use crate::geometry::NodeId;
use crate::math::Vec3;
use crate::photon::Allowed;

impl Tracer<'_> {
    /// Light of the photons around a point, scattered and as highlights.
    pub(super) fn photon_light(
        &self,
        spot: &Spot,
        finish: &Finish,
        normal: Vec3,
        pigment: Rgb,
        opacity: f64,
    ) -> Rgb {
        let Some(map) = self.photons.filter(|_| collects(spot)) else {
            return Rgb::BLACK;
        };
        let mut sum = Rgb::BLACK;
        let area = map.gather(spot.point, spot.normal, |photon| {
            let towards = -photon.direction;
            let scattered = pigment.mul_each(photon.flux) * (finish.diffuse[0] * opacity);
            sum += scattered;
            let cos = normal.dot(towards);
            if cos > 0.0 {
                sum += finish.highlights(spot.path.ray.direction, towards, normal, photon.flux, pigment);
            }
        });
        sum * area.recip()
    }

    /// Whether photons of a light stand for what goes through an object, so that its shadow is dark on a surface that
    /// collects them (probed).
    pub(super) fn photons_pass(&self, light: u32, node: NodeId, place: &Place) -> bool {
        let looks = self.scene.geometry.looks(node);
        self.photons.is_some()
            && place.collects_photons
            && looks.photons.as_ref().is_some_and(|p| p.target.is_some())
            && Allowed::new(self.scene.lights[light as usize].photons.as_ref(), looks).refraction
    }
}

pub(super) fn collects(spot: &Spot) -> bool {
    spot.looks.photons.as_ref().is_none_or(|p| p.collect)
}
