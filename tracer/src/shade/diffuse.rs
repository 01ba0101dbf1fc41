//! SDL: `finish { diffuse F brilliance F irid { ... } }`: light of the lamps, scattered by a surface.

use super::layers::Spot;
use super::{Finish, Tracer};
use crate::color::{rgb, Rgb};
use crate::graph::finish::Iridescence;
use crate::math::Vec3;
use crate::noise::Octaves;

/// The turbulence of thin films (probed).
const FILM_OCTAVES: Octaves = Octaves { octaves: 5, omega: 0.5, lambda: 2.0 };

/// Light fainter than this in every channel counts as none.
const NOTHING: f64 = 1e-10;

impl Tracer<'_> {
    /// Light that all lamps of the object's light group send to the eye: diffuse and highlights.
    pub(super) fn lamp_light(
        &mut self,
        spot: &Spot,
        finish: &Finish,
        normal: Vec3,
        pigment: Rgb,
        opacity: f64,
    ) -> Rgb {
        let scene = self.scene;
        let mut sum = Rgb::BLACK;
        for &number in scene.lights_for(spot.looks.light_group) {
            let light = &scene.lights[number as usize];
            let arrival = light.arrival(spot.point);
            if arrival.color.max_element() < NOTHING && arrival.color.map(|c| -c).max_element() < NOTHING {
                continue;
            }
            // Which side a lamp lights: none if it lies behind a surface that takes no light from there.
            let side = |towards: Vec3| {
                let behind = normal.dot(towards) < 1e-10 && !spot.looks.double_illuminate;
                (!behind || finish.lit_from_behind).then_some(behind)
            };
            let area = light.area.as_ref().filter(|area| area.illumination && scene.quality.area_lights);
            if area.is_none() && side(arrival.direction).is_none() {
                continue;
            }
            let color = self.shadowed(number, light, &spot.place(), &arrival);
            if color == Rgb::BLACK {
                continue;
            }
            let lobes = |tracer: &mut Self, towards| match side(towards) {
                Some(behind) => {
                    let shines = !light.shadowless && !behind;
                    tracer.one_lamp(spot, finish, shines, normal, towards, color, pigment, opacity, behind)
                }
                None => Rgb::BLACK,
            };
            let Some(area) = area else {
                sum += lobes(self, arrival.direction);
                continue;
            };
            let points = self.area_points(light, area, arrival.direction);
            let share = 1.0 / points.len() as f64;
            for point in points {
                sum += lobes(self, light.arrival_from(point, spot.point).direction) * share;
            }
        }
        sum
    }

    /// Light of one lamp, already shadowed; with highlights if it `shines`.
    #[allow(clippy::too_many_arguments)] // everything that a lobe depends on
    pub(super) fn one_lamp(
        &mut self,
        spot: &Spot,
        finish: &Finish,
        shines: bool,
        normal: Vec3,
        towards: Vec3,
        color: Rgb,
        pigment: Rgb,
        opacity: f64,
        backside: bool,
    ) -> Rgb {
        let mut sum = Rgb::BLACK;
        let diffuse = finish.diffuse[usize::from(backside)];
        if diffuse != 0.0 && finish.subsurface.is_none() {
            let cos = normal.dot(towards).abs();
            let lobe = if finish.brilliance == 1.0 { cos } else { cos.powf(finish.brilliance) };
            let mut strength = diffuse * lobe * opacity;
            if finish.crand > 0.0 {
                strength -= self.random.unit() * finish.crand;
            }
            sum += pigment.mul_each(color) * strength;
        }
        if shines {
            sum += finish.highlights(spot.path.ray.direction, towards, normal, color, pigment);
        }
        if let Some(film) = &finish.irid {
            sum = self.film(film, spot, normal, towards, sum);
        }
        sum
    }

    /// Interference on a thin film: light of each wavelength gains or loses by its phase.
    pub(super) fn film(
        &self,
        film: &Iridescence,
        spot: &Spot,
        normal: Vec3,
        towards: Vec3,
        light: Rgb,
    ) -> Rgb {
        let cosines = normal.dot(towards).abs() + normal.dot(spot.path.ray.direction).abs();
        let mut thickness = film.thickness;
        if film.turbulence != 0.0 {
            let noise = FILM_OCTAVES.scalar(spot.point, self.scene.noise_generator);
            thickness *= 1.0 + film.turbulence * (2.0 * noise - 1.0);
        }
        let path = 2.0 * std::f64::consts::PI * thickness * cosines;
        let wave = self.scene.irid_wavelength;
        let gain = |wavelength: f64| 1.0 + film.amount * (path / wavelength).cos();
        light.mul_each(rgb(gain(wave.r), gain(wave.g), gain(wave.b)))
    }
}
