//! Light that other surfaces throw at a point: reused from around, or gathered anew. See [`crate::radiosity`].

use super::layers::Spot;
use super::{Interiors, Path, Tracer};
use crate::accel::RayKind;
use crate::color::Rgb;
use crate::math::{Ray, Vec3};
use crate::radiosity::{hemisphere, Gathered, Mean, Settings};

impl Tracer<'_> {
    /// The mean light from the hemisphere over a surface, black where light is no longer thrown on, or where it would
    /// add too little to the pixel: `weight` counts what the surface throws back of it (probed).
    pub(super) fn indirect_light(&mut self, spot: &Spot, normal: Vec3, weight: f64) -> Rgb {
        let (Some(settings), Some(indirect)) = (&self.scene.radiosity, &self.indirect) else {
            return Rgb::BLACK;
        };
        if indirect.bounces >= settings.recursion_limit || weight < self.scene.adc_bailout {
            return Rgb::BLACK;
        }
        let pole = if settings.normal { normal } else { spot.normal };
        let mut mean = Mean::default();
        // Coarse passes are more careful with light that is seen at once, not with what it was thrown by.
        let bound = match indirect.bounces {
            0 => indirect.error_bound,
            bounces => settings.bound(bounces),
        };
        for cache in [indirect.shared, &indirect.own] {
            cache.collect(spot.point, pole, bound, indirect.bounces, &mut mean);
        }
        let enough = if indirect.take_any || indirect.bounces > 0 { 1 } else { settings.nearest_count };
        let light =
            if mean.count >= enough { mean.light() } else { self.gather(settings, spot, pole, weight) };
        light * settings.brightness
    }

    /// Shoots rays into the hemisphere, and remembers what they brought.
    fn gather(&mut self, settings: &Settings, spot: &Spot, pole: Vec3, weight: f64) -> Rgb {
        let bounces = self.indirect.as_ref().map_or(0, |indirect| indirect.bounces);
        let count = settings.rays(bounces);
        let mut sum = Rgb::BLACK;
        let mut nearness = 0.0;
        let (mut nearest, mut toward) = (f64::INFINITY, pole);
        self.set_bounces(bounces + 1);
        let directions = hemisphere(pole, count, &mut self.random);
        for direction in directions {
            if direction.dot(spot.normal) <= 0.0 {
                continue;
            }
            let ray = Ray { origin: spot.point, direction };
            // POV-Ray takes the ray for one in open space, wherever the surface is.
            let path = Path { ray, interiors: Interiors::NONE, kind: RayKind::Radiosity, band: None };
            let (seen, distance) = self.trace_far(&path, weight);
            sum += settings.limited(seen.rgb);
            nearness += distance.recip();
            if distance < nearest {
                (nearest, toward) = (distance, direction);
            }
        }
        self.set_bounces(bounces);
        let light = sum * (count as f64).recip();
        let from_camera = (spot.point - self.scene.camera.location()).length();
        // Light that is thrown on needs less care: its reach doubles with every ray that leads there (probed).
        let [most, least] = settings.reuse.map(|share| share * from_camera * f64::from(bounces).exp2());
        let radius = (count as f64 / nearness).min(most).max(least);
        if let Some(indirect) = &mut self.indirect {
            let gathered =
                Gathered { point: spot.point, normal: pole, light, radius, nearest, toward, bounces };
            indirect.own.insert(gathered, gathered.reach(settings.bound(bounces)));
        }
        light
    }

    /// Whether the current ray was shot to gather light.
    pub(super) fn is_gathering(&self) -> bool {
        self.indirect.as_ref().is_some_and(|indirect| indirect.bounces > 0)
    }

    /// Whether media, fog and rainbows show along the current ray: for gathered light only with `media on`.
    pub(super) fn sees_volumes(&self) -> bool {
        let gathering = || self.scene.radiosity.as_ref().filter(|_| self.is_gathering());
        self.scene.quality.volumes && gathering().is_none_or(|settings| settings.media)
    }

    fn set_bounces(&mut self, bounces: u32) {
        if let Some(indirect) = &mut self.indirect {
            indirect.bounces = bounces;
        }
    }
}

impl Settings {
    /// What of one ray's light counts: `max_sample`, `gray_threshold`.
    fn limited(&self, light: Rgb) -> Rgb {
        let largest = light.max_element();
        let light = if self.max_sample > 0.0 && largest > self.max_sample {
            light * (self.max_sample / largest)
        } else {
            light
        };
        light * (1.0 - self.gray_threshold) + Rgb::WHITE * (light.gray() * self.gray_threshold)
    }
}
