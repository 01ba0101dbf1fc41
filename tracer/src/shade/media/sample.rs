//! One point of a medium: what it loses, gives, and throws towards the eye.

use super::stretches::Stretch;
use super::{passing, Influence, Way};
use crate::color::Rgb;
use crate::light::Light;
use crate::math::Vec3;
use crate::shade::shadow::Place;
use crate::shade::Tracer;

impl Tracer<'_> {
    /// What a stretch does if it is everywhere as at the share `at` of its length. With `fading`, light is dimmed on
    /// its way out of the stretch.
    pub(super) fn sample(&mut self, way: &Way, stretch: &Stretch, at: f64, fading: bool) -> Influence {
        let scene = self.scene;
        let point = way.ray.at(stretch.start + at * stretch.length);
        let mut extinction = Rgb::BLACK;
        let mut light = Rgb::BLACK;
        let mut scattering = Rgb::BLACK;
        for media in way.matter.media(scene) {
            let density = media.density(point);
            if density == Rgb::BLACK {
                continue;
            }
            extinction += density.mul_each(media.extinction);
            if way.shadow {
                continue;
            }
            light += density.mul_each(media.emission);
            scattering += density.mul_each(media.scattering);
        }
        if (stretch.lit || self.photons.is_some()) && scattering != Rgb::BLACK {
            light += scattering.mul_each(self.thrown(way, point));
        }
        if fading {
            light = light.mul_each(passing(extinction * (at * stretch.length)));
        }
        Influence { light: light * stretch.length, depth: extinction * stretch.length }
    }

    /// The share of all lamps' light that matter at a point throws towards the eye. Of several media all throw it by the
    /// mean of their phase functions, those too that are not at the point or do not scatter (probed).
    fn thrown(&mut self, way: &Way, point: Vec3) -> Rgb {
        let scene = self.scene;
        let collects = way.matter.media(scene).any(|media| media.collect);
        let place = Place { point, interiors: way.interiors, collects_photons: collects };
        let phase = |cos: f64| {
            let (mut phases, mut count) = (0.0, 0);
            for media in way.matter.media(scene) {
                phases += media.phase.factor(cos);
                count += 1;
            }
            phases / f64::from(count)
        };
        let mut sum = Rgb::BLACK;
        for &number in scene.lights_for(way.light_group) {
            let light: &Light = &scene.lights[number as usize];
            if !light.media_interaction || light.shadowless {
                continue;
            }
            let arrival = light.arrival(point);
            if arrival.color == Rgb::BLACK {
                continue;
            }
            let color = self.shadowed(number, light, &place, &arrival);
            if color == Rgb::BLACK {
                continue;
            }
            sum += color * phase(way.ray.direction.dot(arrival.direction));
        }
        if let Some(maps) = self.photons.filter(|_| collects) {
            let mut thrown = Rgb::BLACK;
            let square = maps.media.gather(point, None, |photon| {
                thrown += photon.flux * phase(-way.ray.direction.dot(photon.direction));
            });
            sum += thrown * (4.0 / 3.0 * std::f64::consts::PI * square * square.sqrt()).recip();
        }
        sum
    }
}
