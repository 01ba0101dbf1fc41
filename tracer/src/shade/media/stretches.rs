//! SDL: `media { intervals I ratio F }`: a way cut where beams of light begin and end, and then evenly.

use super::Way;
use crate::color::Rgb;
use crate::light::Beam;
use crate::math::Ray;
use crate::media::Sampling;
use crate::shade::Tracer;

/// Beams that overlap or leave less than this between them are one.
const SEAM: f64 = 1e-6;

/// A part of the way.
#[derive(Clone, Copy, Debug)]
pub struct Stretch {
    /// Where it begins, from the start of the ray.
    pub start: f64,
    /// How long it is.
    pub length: f64,
    /// Whether any lamp shines here.
    pub lit: bool,
}

impl Tracer<'_> {
    /// Puts the parts of the first `distance` of a way on the pile of stretches.
    pub(super) fn cut(&mut self, way: &Way, distance: f64, sampling: &Sampling) {
        let beams = if way.shadow { Vec::new() } else { self.beams(way, distance) };
        let whole = Stretch { start: 0.0, length: distance, lit: !beams.is_empty() };
        if beams.is_empty() || (beams[0].0 <= SEAM && beams[0].1 >= distance - SEAM) {
            return self.cut_evenly(whole, sampling.intervals);
        }
        let mut parts = Vec::with_capacity(2 * beams.len() + 1);
        let mut at = 0.0;
        for (start, end) in beams {
            if start > at + SEAM {
                parts.push(Stretch { start: at, length: start - at, lit: false });
            }
            parts.push(Stretch { start, length: end - start, lit: true });
            at = end;
        }
        if distance > at + SEAM {
            parts.push(Stretch { start: at, length: distance - at, lit: false });
        }
        self.share(&parts, sampling);
    }

    /// The parts of the way in any lamp's beam, in order, those that overlap as one.
    fn beams(&mut self, way: &Way, distance: f64) -> Vec<(f64, f64)> {
        let scene = self.scene;
        if way.matter.media(scene).all(|media| media.scattering == Rgb::BLACK) {
            return Vec::new();
        }
        let mut beams = Vec::new();
        for &number in scene.lights_for(way.light_group) {
            let light = &scene.lights[number as usize];
            if light.media_interaction && !light.shadowless {
                let met = beam_on(&light.beam, light.location, way.ray);
                beams.extend(met.map(|(start, end)| (start.max(0.0), end.min(distance))));
            }
        }
        beams.retain(|(start, end)| end - start > SEAM);
        beams.sort_by(|a, b| a.0.total_cmp(&b.0));
        beams.dedup_by(|next, kept| {
            let overlap = next.0 <= kept.1 + SEAM;
            if overlap {
                kept.1 = kept.1.max(next.1);
            }
            overlap
        });
        beams
    }

    /// Gives each part its share of the intervals by its length, which counts more in light.
    fn share(&mut self, parts: &[Stretch], sampling: &Sampling) {
        if sampling.intervals <= parts.len() {
            self.stretches.extend(parts);
            return;
        }
        let weight =
            |part: &Stretch| part.length * if part.lit { sampling.ratio } else { 1.0 - sampling.ratio };
        let total: f64 = parts.iter().map(weight).sum();
        let mut left = sampling.intervals;
        for (i, part) in parts.iter().enumerate() {
            let after = parts.len() - 1 - i;
            let share = (weight(part) / total * sampling.intervals as f64) as usize + 1;
            let count = if after == 0 { left } else { share.min(left - after) };
            self.cut_evenly(*part, count);
            left -= count;
        }
    }

    fn cut_evenly(&mut self, part: Stretch, count: usize) {
        let length = part.length / count as f64;
        self.stretches.extend((0..count).map(|i| Stretch {
            start: part.start + i as f64 * length,
            length,
            ..part
        }));
    }
}

/// Where a ray is in a beam.
fn beam_on(beam: &Beam, location: crate::math::Vec3, ray: &Ray) -> Option<(f64, f64)> {
    let from_light = ray.origin - location;
    match *beam {
        Beam::Point => Some((0.0, f64::INFINITY)),
        Beam::Spot { axis, falloff, .. } => {
            // Inside the cone: (p . axis)^2 >= |p|^2 falloff^2, ahead of the lamp.
            let (along, height) = (ray.direction.dot(axis), from_light.dot(axis));
            let cos2 = falloff * falloff;
            let a = along * along - cos2;
            let b = along * height - cos2 * ray.direction.dot(from_light);
            let c = height * height - cos2 * from_light.dot(from_light);
            if a.abs() < 1e-10 {
                let t = -0.5 * c / b;
                return (b.abs() > 1e-10 && height + t * along > 0.0).then_some((t, f64::INFINITY));
            }
            let root = b * b - a * c;
            if root <= 1e-10 {
                return None;
            }
            let root = root.sqrt();
            let (one, two) = ((-b - root) / a, (-b + root) / a);
            let (near, far) = (one.min(two), one.max(two));
            match (height + near * along > 0.0, height + far * along > 0.0) {
                (true, true) => Some((near, far)),
                (true, false) => Some((f64::NEG_INFINITY, near)),
                (false, true) => Some((far, f64::INFINITY)),
                (false, false) => None,
            }
        }
        Beam::Cylinder { axis, falloff, .. } => {
            let across = |v: crate::math::Vec3| v - axis * v.dot(axis);
            let (d, o) = (across(ray.direction), across(from_light));
            let (a, b, c) = (d.dot(d), d.dot(o), o.dot(o) - falloff * falloff);
            if a < 1e-10 {
                return (c < 0.0).then_some((0.0, f64::INFINITY));
            }
            let root = b * b - a * c;
            (root > 1e-10).then(|| ((-b - root.sqrt()) / a, (-b + root.sqrt()) / a))
        }
    }
}
