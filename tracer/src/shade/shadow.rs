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

/// The last part of the way to a lamp, where the air dims its light.
pub(super) struct LastPart {
    /// From behind the last surface on.
    path: Path,
    /// Its length.
    pub distance: f64,
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
    fn point_shadow(&mut self, number: u32, light: &Light, place: &Place, arrival: &Arrival) -> Rgb {
        match self.past_objects(number, light, place, arrival) {
            (color, Some(last)) => color.mul_each(self.air_filter(&last.path, last.distance, light)),
            (color, None) => color,
        }
    }

    /// What objects leave of the light of a point, and the part of the way that is left to look at.
    pub(super) fn past_objects(
        &mut self,
        number: u32,
        light: &Light,
        place: &Place,
        arrival: &Arrival,
    ) -> (Rgb, Option<LastPart>) {
        let Some(distance) = self.projected(light, place, arrival) else {
            return (Rgb::BLACK, None);
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
                return (Rgb::BLACK, None);
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
        let seen = if blocked {
            (Rgb::BLACK, None)
        } else if crossed.is_empty() && !scene.is_murky(place.interiors, light) {
            (arrival.color, None)
        } else {
            self.filtered(number, light, place, arrival, &mut crossed)
        };
        self.crossed = crossed;
        seen
    }

    /// Light filtered by the transparent surfaces that it crosses and the media between, from the point to the lamp.
    ///
    /// Behind a surface of what tells a ray only its first crossings, the rest of the way is looked at anew.
    fn filtered(
        &mut self,
        number: u32,
        light: &Light,
        place: &Place,
        arrival: &Arrival,
        crossed: &mut Vec<Hit>,
    ) -> (Rgb, Option<LastPart>) {
        let scene = self.scene;
        let mut path = Path {
            ray: Ray { origin: place.point, direction: arrival.direction },
            interiors: *place.interiors,
            kind: RayKind::Shadow,
            band: None,
        };
        let mut color = arrival.color;
        let mut left = arrival.distance - TOLERANCE;
        crossed.sort_unstable_by(Hit::order);
        // How many of those that are ahead have been looked at, and how far from where they are counted.
        let (mut seen, mut done) = (0, 0.0);
        while let Some(&hit) = crossed.get(seen) {
            seen += 1;
            let distance = hit.crossing.t - done;
            if distance <= TOLERANCE {
                continue;
            }
            if scene.is_murky(&path.interiors, light) {
                color = color.mul_each(self.media_filter(&path, distance, light));
            }
            if color.max_element() <= 0.0 || self.photons_pass(number, hit.node, place) {
                return (Rgb::BLACK, None);
            }
            let here = Hit { crossing: Crossing { t: distance, ..hit.crossing }, ..hit };
            color = color.mul_each(self.surface_filter(&path, &here));
            path.ray.origin = path.ray.at(distance);
            left -= distance;
            done = hit.crossing.t;
            let interior = scene.body_of(hit.node);
            if !path.interiors.leave(interior) {
                path.interiors.enter(interior);
            }
            if !scene.geometry.tells_all(hit.node) {
                crossed.clear();
                scene.geometry.any(&path.ray, TOLERANCE, left, RayKind::Shadow, &mut self.counters, |hit| {
                    crossed.push(*hit);
                    Answer::Continue
                });
                crossed.sort_unstable_by(Hit::order);
                (seen, done) = (0, 0.0);
            }
        }
        // Of the last part, up to a lamp in a medium, POV-Ray counts only the air.
        let last = LastPart { path, distance: left };
        (color, self.scene.air_dims(light).then_some(last))
    }
}
