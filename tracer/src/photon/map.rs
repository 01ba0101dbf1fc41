//! Photons where they fell, found by place: a balanced kd-tree in one array.

use std::cmp::Ordering;
use std::collections::BinaryHeap;
use std::f64::consts::PI;

use super::settings::Gathering;
use crate::color::Rgb;
use crate::math::{vec3, Vec3};

/// Light that fell on a surface, or came through a medium.
#[derive(Clone, Copy, Debug)]
pub struct Photon {
    /// Where.
    pub point: Vec3,
    /// Where it was going, of length one and coarse.
    pub direction: Vec3,
    /// What it brought: light times area.
    pub flux: Rgb,
}

/// The angles of a photon's direction are known in so many steps from 0 to pi (probed).
const STEPS: f64 = 127.0;

impl Photon {
    /// A photon; its direction becomes coarse, as POV-Ray keeps it: of light that only grazes a surface nothing is left.
    pub fn new(point: Vec3, direction: Vec3, flux: Rgb) -> Photon {
        let coarse = |angle: f64| (angle * STEPS / PI).trunc() * PI / STEPS;
        let (sin, cos) = coarse(direction.y.clamp(-1.0, 1.0).asin()).sin_cos();
        let (across, along) = coarse(direction.z.atan2(direction.x)).sin_cos();
        Photon { point, direction: vec3(cos * along, sin, cos * across), flux }
    }
}

/// Where all photons fell.
#[derive(Debug)]
pub struct PhotonMaps {
    /// Those on surfaces.
    pub surfaces: PhotonMap,
    /// Those in media; what they brought is light times area times the length of the way that they stand for.
    pub media: PhotonMap,
}

impl PhotonMaps {
    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.surfaces.photons.is_empty() && self.media.photons.is_empty()
    }
}

/// Photons by place.
#[derive(Debug)]
pub struct PhotonMap {
    /// A kd-tree: the middle photon of each range splits it along the axis of the node.
    photons: Vec<Photon>,
    axes: Vec<u8>,
    /// From how far photons are gathered at first.
    radius: f64,
    /// The fewest that are enough, and the most that are gathered.
    gather: [usize; 2],
    /// `expand_thresholds`: by how much light may grow, and how many photons are too few in any case, when it is
    /// gathered from farther away.
    expand: (f64, usize),
}

/// Photons around a point.
struct Found {
    near: BinaryHeap<Near>,
    /// The square of the distance within which they lie.
    square: f64,
}

impl Found {
    fn density(&self) -> f64 {
        self.near.len() as f64 / self.square
    }
}

/// A photon and the square of its distance.
struct Near(f64, u32);

impl PartialEq for Near {
    fn eq(&self, other: &Near) -> bool {
        self.0 == other.0
    }
}

impl Eq for Near {}

impl PartialOrd for Near {
    fn partial_cmp(&self, other: &Near) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Near {
    fn cmp(&self, other: &Near) -> Ordering {
        self.0.total_cmp(&other.0)
    }
}

/// How much farther away photons are looked for where there are too few (probed).
const EXPANSION: f64 = 3.0;

/// How much photons off the plane of the surface are farther away than they are, per unit of their height (probed).
const FLATTENING: f64 = 16.0;

/// From how many photons at most the radius of gathering is learnt (probed: POV-Ray takes a twentieth, but 100 at least).
const SAMPLES: usize = 1000;

/// Shares of the most photons between which a photon has few around it; those with fewer still are strays. By how many
/// radii the radius would grow if all had few (probed).
const FEWEST: f64 = 0.05;
const FEW: f64 = 0.71;
const GROWTH: f64 = 20.0;

impl PhotonMap {
    /// Sorts photons, of a volume or of surfaces.
    pub fn new(photons: Vec<Photon>, volume: bool, settings: &Gathering) -> PhotonMap {
        let count = photons.len();
        let Gathering { gather: [fewest, most], expand, .. } = *settings;
        let gather = [fewest, most.min(photons.len().max(1))];
        let mut map = PhotonMap { photons, axes: vec![0; count], radius: f64::INFINITY, gather, expand };
        map.split(0, count);
        map.radius = settings.radius.unwrap_or_else(|| map.usual_radius(volume)) * settings.radius_factor;
        map
    }

    fn split(&mut self, low: usize, high: usize) {
        if high - low < 2 {
            return;
        }
        let range = &mut self.photons[low..high];
        let spread = |axis: usize| {
            let ends = range.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), p| {
                (a.min(p.point[axis]), b.max(p.point[axis]))
            });
            ends.1 - ends.0
        };
        let axis = (0..3).max_by(|&a, &b| spread(a).total_cmp(&spread(b))).unwrap_or(0);
        let middle = (high - low) / 2;
        range.select_nth_unstable_by(middle, |a, b| a.point[axis].total_cmp(&b.point[axis]));
        self.axes[low + middle] = axis as u8;
        self.split(low, low + middle);
        self.split(low + middle + 1, high);
    }

    /// The radius in which the most photons lie at mean density, and more if many photons have few around them.
    fn usual_radius(&self, volume: bool) -> f64 {
        let step = self.photons.len().div_ceil(SAMPLES).max(1);
        let some = || self.photons.iter().step_by(step);
        let count = some().count().max(1) as f64;
        let power = if volume { 1.5 } else { 1.0 };
        let density = |photon: &Photon| {
            let found = self.nearest(photon.point, None, f64::INFINITY);
            found.near.len() as f64 / found.square.powf(power)
        };
        let mean = some().map(density).filter(|d| d.is_finite()).sum::<f64>() / count;
        let radius = (self.gather[1] as f64 / mean).powf(0.5 / power);
        let few = |photon: &&Photon| {
            let near = self.nearest(photon.point, None, radius).near.len() as f64;
            near < FEW * self.gather[1] as f64 && near > FEWEST * self.gather[1] as f64
        };
        radius * (1.0 + GROWTH * some().filter(few).count() as f64 / count)
    }

    /// The photons around a point; those off the plane of `normal` count as farther away.
    fn nearest(&self, point: Vec3, normal: Option<Vec3>, radius: f64) -> Found {
        let near = BinaryHeap::with_capacity(self.gather[1] + 1);
        let mut found = Found { near, square: radius * radius };
        self.search(0, self.photons.len(), point, normal.unwrap_or(Vec3::ZERO), &mut found);
        found
    }

    fn search(&self, low: usize, high: usize, point: Vec3, normal: Vec3, found: &mut Found) {
        if low >= high {
            return;
        }
        let middle = low + (high - low) / 2;
        let photon = &self.photons[middle];
        let axis = usize::from(self.axes[middle]);
        let across = point[axis] - photon.point[axis];
        let (near, far) = if across < 0.0 {
            ((low, middle), (middle + 1, high))
        } else {
            ((middle + 1, high), (low, middle))
        };
        self.search(near.0, near.1, point, normal, found);
        let away = point - photon.point;
        let square = away.dot(away) * (1.0 + FLATTENING * away.dot(normal).abs());
        if square < found.square {
            found.near.push(Near(square, middle as u32));
            if found.near.len() > self.gather[1] {
                found.near.pop();
            }
            if found.near.len() == self.gather[1] {
                found.square = found.near.peek().map_or(found.square, |farthest| farthest.0);
            }
        }
        if across * across < found.square {
            self.search(far.0, far.1, point, normal, found);
        }
    }

    /// Visits the photons around a point of a surface, or of a volume if there is no normal; gives the square of the
    /// distance within which they lie. Where there are few they are looked for farther away, unless that makes it
    /// much lighter.
    pub fn gather(&self, point: Vec3, normal: Option<Vec3>, mut visit: impl FnMut(&Photon)) -> f64 {
        if self.photons.is_empty() {
            return 1.0;
        }
        let mut found = self.nearest(point, normal, self.radius);
        if found.near.len() < self.gather[0] {
            let wider = self.nearest(point, normal, self.radius * EXPANSION);
            let (growth, few) = self.expand;
            if wider.near.len() < few || wider.density() <= found.density() * (1.0 + growth) {
                found = wider;
            }
        }
        for near in found.near {
            visit(&self.photons[near.1 as usize]);
        }
        found.square
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::Random;

    #[test]
    fn the_nearest_are_found() {
        let mut random = Random::new(5);
        let photons: Vec<_> =
            (0..500).map(|_| Photon::new(random.vector(3.0), -Vec3::Y, Rgb::WHITE)).collect();
        let gathering =
            Gathering { gather: [5, 20], radius: Some(1.5), radius_factor: 1.0, expand: (0.2, 35) };
        let map = PhotonMap::new(photons.clone(), false, &gathering);
        for _ in 0..50 {
            let point = random.vector(3.0);
            let mut squares: Vec<f64> =
                photons.iter().map(|p| (p.point - point).dot(p.point - point)).collect();
            squares.sort_by(f64::total_cmp);
            let within = squares.iter().filter(|&&s| s < 2.25).count();
            let mut found = 0;
            let square = map.gather(point, None, |_| found += 1);
            if within >= 5 {
                assert_eq!(found, within.min(20));
                let expected = if within >= 20 { squares[19] } else { 2.25 };
                assert!((square - expected).abs() < 1e-9);
            }
        }
    }
}
