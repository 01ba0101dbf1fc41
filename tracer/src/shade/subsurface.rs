//! SDL: `finish { subsurface { translucency C } }`: the light that leaves a surface under which it was scattered.
//! See [`crate::subsurface`].

use super::layers::Spot;
use super::reflect::fresnel;
use super::refract::refracted;
use super::shadow::Place;
use super::{Path, Tracer, NEAREST};
use crate::color::{rgb, Rgb};
use crate::light::Arrival;
use crate::math::{Ray, Vec3};
use crate::subsurface::{directions, Dipole, Settings, Translucent};

/// Points nearer than this count as one.
const TOLERANCE: f64 = 1e-6;

/// Where no more care is needed.
const COARSE: Settings = Settings { many: 4, once: 1 };

/// Where light enters the object.
struct Entry {
    point: Vec3,
    /// Unit normal to the outside.
    normal: Vec3,
    /// How far it is from where it was sought.
    distance: f64,
}

impl Tracer<'_> {
    /// Light that lamps send into the object and that leaves it at this point towards the eye.
    pub(super) fn subsurface_light(
        &mut self,
        spot: &Spot,
        stuff: &Translucent,
        settings: Settings,
        normal: Vec3,
        pigment: Rgb,
        weight: f64,
    ) -> Rgb {
        // What is seen through such an object is sampled coarsely, and through a second one not at all (probed).
        let settings = match self.under_surfaces {
            0 => settings,
            1 => COARSE,
            _ => return Rgb::BLACK,
        };
        let ior = self.relative_ior(spot);
        let channels = stuff.channels(pigment, ior);
        let leaves = 1.0 - fresnel(-spot.path.ray.direction.dot(normal), ior);
        let many = self.scattered_often(spot, &channels, settings.many, ior);
        let Some(inwards) = refracted(spot.path.ray.direction, normal, ior.recip()) else {
            return many * leaves;
        };
        let once = self.scattered_once(spot, &channels, settings.once, inwards, normal, ior);
        (many + once) * leaves + self.seen_unscattered(spot, &channels, inwards, ior, weight)
    }

    /// Light scattered many times, from points around: those that are seen from a point below the surface.
    fn scattered_often(&mut self, spot: &Spot, channels: &[Dipole; 3], count: usize, ior: f64) -> Rgb {
        // Without a common depth POV-Ray finds nothing in any channel.
        if !channels.iter().all(Dipole::is_sound) {
            return Rgb::BLACK;
        }
        let depth = per_channel(channels, |dipole| dipole.extinction).gray().recip();
        let inwards = Ray { origin: spot.point, direction: -spot.normal };
        let thickness = self.entry(spot, inwards).map_or(f64::INFINITY, |entry| entry.distance);
        let below = inwards.at(depth.min(thickness / 2.0));
        let mut sum = Rgb::BLACK;
        let mut found = 0;
        for direction in directions(count, &mut self.random) {
            let Some(entry) = self.entry(spot, Ray { origin: below, direction }) else { continue };
            found += 1;
            let cos = entry.normal.dot(direction);
            if cos < TOLERANCE {
                continue;
            }
            let light = self.entering(spot, &entry, ior);
            if light != Rgb::BLACK {
                let area = 4.0 * std::f64::consts::PI * entry.distance * entry.distance / cos;
                let distance = (entry.point - spot.point).length();
                sum += light.mul_each(per_channel(channels, |dipole| dipole.spread(distance))) * area;
            }
        }
        sum * f64::from(found.max(1)).recip()
    }

    /// Light of all lamps that enters at a point.
    fn entering(&mut self, spot: &Spot, entry: &Entry, ior: f64) -> Rgb {
        let scene = self.scene;
        let mut sum = Rgb::BLACK;
        for &number in scene.lights_for(spot.looks.light_group) {
            let arrival = scene.lights[number as usize].arrival(entry.point);
            let cos = arrival.direction.dot(entry.normal);
            if cos > 0.0 {
                sum += self.outside_light(spot, number, entry.point, &arrival)
                    * (cos * (1.0 - fresnel(cos, ior)));
            }
        }
        sum
    }

    /// Light that goes straight from where it enters to a point on the refracted ray, and is scattered there.
    fn scattered_once(
        &mut self,
        spot: &Spot,
        channels: &[Dipole; 3],
        count: usize,
        inwards: Vec3,
        normal: Vec3,
        ior: f64,
    ) -> Rgb {
        let mut sum = [0.0; 3];
        for _ in 0..count {
            for (channel, dipole) in channels.iter().enumerate() {
                let way = -(1.0 - self.random.unit()).ln() / dipole.extinction;
                if dipole.is_sound() {
                    let light = self.scattered_at(
                        spot,
                        dipole,
                        spot.point + inwards * way,
                        -inwards.dot(normal),
                        ior,
                    );
                    sum[channel] += [light.r, light.g, light.b][channel];
                }
            }
        }
        Rgb::from(sum) * (count.max(1) as f64).recip()
    }

    /// Light of all lamps that is scattered at a point inside towards a ray that leaves at cosine `cos_out`.
    fn scattered_at(&mut self, spot: &Spot, dipole: &Dipole, point: Vec3, cos_out: f64, ior: f64) -> Rgb {
        let scene = self.scene;
        if !scene.geometry.inside(point, spot.object) {
            return Rgb::BLACK;
        }
        let way_out = (point - spot.point).length();
        let mut sum = Rgb::BLACK;
        for &number in scene.lights_for(spot.looks.light_group) {
            // The way to the lamp is taken as straight; how long it is after refraction is made good afterwards.
            let towards = scene.lights[number as usize].arrival(point).direction;
            let Some(entry) = self.entry(spot, Ray { origin: point, direction: towards }) else { continue };
            let arrival = scene.lights[number as usize].arrival(entry.point);
            let cos = arrival.direction.dot(entry.normal);
            let sin2 = (1.0 - cos * cos) / (ior * ior);
            if cos <= 0.0 || sin2 >= 1.0 {
                continue;
            }
            let cos_in = (1.0 - sin2).sqrt();
            let way_in = entry.distance * cos / cos_in;
            let lost = (-dipole.extinction * (way_out + way_in)).exp();
            let share =
                dipole.albedo / (1.0 + cos_out / cos_in) * lost * cos * (1.0 - fresnel(cos, ior)) / 4.0;
            sum += self.outside_light(spot, number, entry.point, &arrival) * share;
        }
        sum
    }

    /// What is seen through the object by light that is not scattered at all; the surfaces take nothing (probed).
    fn seen_unscattered(
        &mut self,
        spot: &Spot,
        channels: &[Dipole; 3],
        inwards: Vec3,
        ior: f64,
        weight: f64,
    ) -> Rgb {
        let geometry = &self.scene.geometry;
        let ray = Ray { origin: spot.point, direction: inwards };
        let Some(hit) = geometry.nearest(&ray, NEAREST, f64::INFINITY, spot.path.kind, &mut self.counters)
        else {
            return Rgb::BLACK;
        };
        if hit.object != spot.object {
            return Rgb::BLACK;
        }
        let surface = geometry.surface(&ray, &hit);
        let normal = if surface.normal.dot(inwards) > 0.0 { -surface.normal } else { surface.normal };
        let Some(direction) = refracted(inwards, normal, ior) else { return Rgb::BLACK };
        let left = per_channel(channels, |dipole| (-dipole.extinction * hit.crossing.t).exp());
        let path = Path { ray: Ray { origin: surface.point, direction }, ..*spot.path };
        self.under_surfaces += 1;
        let seen = self.trace(&path, weight * left.max_element()).rgb.mul_each(left);
        self.under_surfaces -= 1;
        seen
    }

    /// The nearest point of the object along a ray from inside it.
    fn entry(&mut self, spot: &Spot, ray: Ray) -> Option<Entry> {
        let geometry = &self.scene.geometry;
        let hit = geometry.nearest_of(spot.object, &ray, TOLERANCE, &mut self.counters)?;
        let surface = geometry.surface(&ray, &hit);
        let outwards = surface.normal.dot(ray.direction) >= 0.0;
        let normal = if outwards { surface.normal } else { -surface.normal };
        Some(Entry { point: surface.point, normal, distance: hit.crossing.t })
    }

    /// What of a lamp's light reaches the object's outside.
    fn outside_light(&mut self, spot: &Spot, number: u32, point: Vec3, arrival: &Arrival) -> Rgb {
        let place = Place { point, interiors: &spot.path.interiors, collects_photons: false };
        self.shadowed(number, &self.scene.lights[number as usize], &place, arrival)
    }
}

/// A number for each channel.
fn per_channel(channels: &[Dipole; 3], of: impl Fn(&Dipole) -> f64) -> Rgb {
    let [r, g, b] = channels.each_ref().map(of);
    rgb(r, g, b)
}
