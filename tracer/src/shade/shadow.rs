//! What of a lamp's light reaches a point past the objects in between.

use super::{Interiors, Path, Tracer};
use crate::accel::RayKind;
use crate::color::Rgb;
use crate::geometry::{Answer, Hit};
use crate::light::{Arrival, Light};
use crate::math::{Ray, Vec3};
use crate::shape::Crossing;

/// Occluders nearer than this to the point or the lamp throw no shadow.
const TOLERANCE: f64 = 1e-3;

/// Where light is asked for, on a surface or in a medium.
pub(super) struct Place<'a> {
    /// The point.
    pub point: Vec3,
    /// The objects that it lies in.
    pub interiors: &'a Interiors,
    /// Whether light thrown here by lenses comes as photons.
    pub collects_photons: bool,
}

impl Tracer<'_> {
    /// The colour of a lamp's light after shadows.
    pub(super) fn shadowed(&mut self, number: u32, light: &Light, place: &Place, arrival: &Arrival) -> Rgb {
        if !self.scene.quality.shadows {
            return arrival.color;
        }
        if light.shadowless {
            return self.projected(light, place, arrival).map_or(Rgb::BLACK, |_| arrival.color);
        }
        match &light.area {
            // Light that is gathered is blurred anyway.
            Some(area) if self.scene.quality.area_lights && !self.is_gathering() => {
                self.area_shadow(number, light, area, place, arrival)
            }
            _ => self.point_shadow(number, light, place, arrival),
        }
    }

    /// How far a shadow ray has to go: to the lamp, or to the object that the light is projected through; none where it
    /// misses that.
    fn projected(&mut self, light: &Light, place: &Place, arrival: &Arrival) -> Option<f64> {
        let Some(window) = &light.projected_through else {
            return Some(arrival.distance);
        };
        let ray = Ray { origin: place.point, direction: arrival.direction };
        let hit = window.nearest(&ray, TOLERANCE, arrival.distance, RayKind::Question, &mut self.counters)?;
        Some(hit.crossing.t)
    }

    /// Shadow of a single point of light.
    pub(super) fn point_shadow(
        &mut self,
        number: u32,
        light: &Light,
        place: &Place,
        arrival: &Arrival,
    ) -> Rgb {
        let Some(distance) = self.projected(light, place, arrival) else {
            return Rgb::BLACK;
        };
        let arrival = &Arrival { distance, ..*arrival };
        let scene = self.scene;
        let ray = Ray { origin: place.point, direction: arrival.direction };
        let limit = arrival.distance - TOLERANCE;
        let last = &mut self.occluders[number as usize];
        let opaque = |node| scene.is_opaque(node);
        if let Some(node) = *last {
            if scene.geometry.any_of(node, &ray, TOLERANCE, limit, &mut self.counters, |hit| {
                if opaque(hit.node) {
                    Answer::Stop
                } else {
                    Answer::Continue
                }
            }) {
                return Rgb::BLACK;
            }
        }
        let mut crossed = std::mem::take(&mut self.crossed);
        crossed.clear();
        let blocked =
            scene.geometry.any(&ray, TOLERANCE, limit, RayKind::Shadow, &mut self.counters, |hit| {
                if opaque(hit.node) {
                    *last = Some(hit.object);
                    Answer::Stop
                } else {
                    crossed.push(*hit);
                    Answer::Continue
                }
            });
        let color = if blocked {
            Rgb::BLACK
        } else if crossed.is_empty() && !scene.is_murky(place.interiors, light) {
            arrival.color
        } else {
            crossed.sort_unstable_by(Hit::order);
            self.filtered(number, light, place, arrival, &crossed)
        };
        self.crossed = crossed;
        color
    }

    /// Light filtered by the transparent surfaces that it crosses and the media between, from the point to the lamp.
    fn filtered(
        &mut self,
        number: u32,
        light: &Light,
        place: &Place,
        arrival: &Arrival,
        crossed: &[Hit],
    ) -> Rgb {
        let mut path = Path {
            ray: Ray { origin: place.point, direction: arrival.direction },
            interiors: *place.interiors,
            kind: RayKind::Shadow,
            band: None,
        };
        let mut color = arrival.color;
        // How far the light has been followed.
        let mut done = 0.0;
        let mut ahead = crossed.iter();
        while color.max_element() > 0.0 {
            let nearest = ahead.find(|hit| hit.crossing.t > done + TOLERANCE);
            let distance = nearest.map_or(arrival.distance - TOLERANCE, |hit| hit.crossing.t) - done;
            if self.scene.is_murky(&path.interiors, light) {
                // Of the last part, up to a lamp in a medium, POV-Ray counts only the atmosphere.
                color = color.mul_each(self.media_filter(&path, distance, nearest.is_some(), light));
            }
            let Some(hit) = nearest else {
                break;
            };
            if self.photons_pass(number, hit.node, place) {
                return Rgb::BLACK;
            }
            let here = Hit { crossing: Crossing { t: distance, ..hit.crossing }, ..*hit };
            color = color.mul_each(self.surface_filter(&path, &here));
            path.ray.origin = path.ray.at(distance);
            done = hit.crossing.t;
            let interior = self.scene.body_of(hit.node);
            if !path.interiors.leave(interior) {
                path.interiors.enter(interior);
            }
        }
        color
    }
}
