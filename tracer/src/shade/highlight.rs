//! SDL: `finish { phong F phong_size F specular F roughness F metallic F }`: mirror images of the lamps.

use super::{metallic_tint, Finish};
use crate::color::Rgb;
use crate::math::Vec3;

impl Finish {
    /// Both highlights for a ray in direction `eye`, a lamp in direction `towards` and its colour.
    #[inline]
    pub fn highlights(&self, eye: Vec3, towards: Vec3, normal: Vec3, color: Rgb, pigment: Rgb) -> Rgb {
        let strength =
            self.phong_strength(eye, towards, normal) + self.specular_strength(eye, towards, normal);
        if strength == 0.0 {
            return Rgb::BLACK;
        }
        let light = color * strength;
        if self.metallic == 0.0 {
            return light;
        }
        light.mul_each(metallic_tint(self.metallic, normal.dot(towards), pigment))
    }

    /// Phong: a power of the cosine between the mirrored ray and the lamp.
    fn phong_strength(&self, eye: Vec3, towards: Vec3, normal: Vec3) -> f64 {
        let (factor, size) = self.phong;
        if factor <= 0.0 {
            return 0.0;
        }
        let cos = (eye - normal * (2.0 * eye.dot(normal))).dot(towards);
        // A tiny cosine to a high power would only underflow.
        if cos <= 0.0 || (size >= 60.0 && cos <= 0.0008) {
            return 0.0;
        }
        factor * cos.powf(size)
    }

    /// Blinn: a power of the cosine between the normal and the direction halfway between eye and lamp.
    fn specular_strength(&self, eye: Vec3, towards: Vec3, normal: Vec3) -> f64 {
        let (factor, exponent) = self.specular;
        if factor <= 0.0 {
            return 0.0;
        }
        let cos = (towards - eye).normalized().dot(normal);
        if cos <= 0.0 {
            return 0.0;
        }
        factor * cos.powf(exponent)
    }
}
