//! Photons gathered where they fell. See [`crate::photon`].

use super::layers::Spot;
use super::shadow::Place;
use super::{Finish, Tracer};
use crate::color::Rgb;
use crate::geometry::NodeId;
use crate::math::Vec3;
use crate::photon::Allowed;

impl Tracer<'_> {
    /// Light of the photons around a point, each as that of a lamp.
    pub(super) fn photon_light(
        &mut self,
        spot: &Spot,
        finish: &Finish,
        normal: Vec3,
        pigment: Rgb,
        opacity: f64,
    ) -> Rgb {
        let Some(maps) = self.photons.filter(|_| collects(spot)) else {
            return Rgb::BLACK;
        };
        let mut sum = Rgb::BLACK;
        let square = maps.surfaces.gather(spot.point, Some(normal), |photon| {
            let towards = -photon.direction;
            let cos = towards.dot(spot.normal);
            if cos > 0.0 {
                // A photon brings what falls on the surface, a lamp what goes through a plane across its rays.
                let color = photon.flux * cos.recip();
                sum += self.one_lamp(spot, finish, true, normal, towards, color, pigment, opacity, false);
            }
        });
        sum * (std::f64::consts::PI * square).recip()
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
