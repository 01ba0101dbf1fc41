//! Photons where they fell, found by place: a balanced kd-tree in one array.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use crate::color::Rgb;
use crate::math::Vec3;

/// Light that fell on a surface.
#[derive(Clone, Copy, Debug)]
pub struct Photon {
    /// Where.
    pub point: Vec3,
    /// Where it was going, of length one.
    pub direction: Vec3,
    /// What it brought: light times area.
    pub flux: Rgb,
}

/// All photons on surfaces.
#[derive(Debug, Default)]
pub struct PhotonMap {
    /// A kd-tree: the middle photon of each range splits it along the axis of the node.
    photons: Vec<Photon>,
    axes: Vec<u8>,
    /// From how far photons are gathered.
    radius: f64,
    /// The most that are gathered.
    most: usize,
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

/// Where photons are this much sparser than usual, fewer than the most are gathered: the factor of the usual radius that
/// comes nearest to POV-Ray's pictures of a lens, a ring and a slab.
const SPARSE: f64 = 4.0;

/// From how many photons the radius of gathering is learnt.
const SAMPLES: usize = 200;

impl PhotonMap {
    /// Sorts photons; `radius` is from how far they are gathered, or a factor of what follows from their density.
    pub fn new(photons: Vec<Photon>, gather: [usize; 2], radius: Option<f64>, factor: f64) -> PhotonMap {
        let count = photons.len();
        let mut map = PhotonMap { photons, axes: vec![0; count], radius: f64::INFINITY, most: gather[1] };
        map.split(0, count);
        map.radius = radius.unwrap_or_else(|| map.usual_radius() * factor * SPARSE);
        map
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.photons.is_empty()
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

    /// The mean distance within which the most photons are found, over some of them.
    fn usual_radius(&self) -> f64 {
        let step = (self.photons.len() / SAMPLES).max(1);
        let radii: Vec<f64> =
            self.photons.iter().step_by(step).map(|photon| self.nearest(photon.point).1.sqrt()).collect();
        radii.iter().sum::<f64>() / radii.len().max(1) as f64
    }

    /// The photons around a point, and the square of the distance within which they lie.
    fn nearest(&self, point: Vec3) -> (BinaryHeap<Near>, f64) {
        let mut heap = BinaryHeap::with_capacity(self.most + 1);
        let mut limit = self.radius * self.radius;
        self.search(0, self.photons.len(), point, &mut heap, &mut limit);
        (heap, limit)
    }

    fn search(&self, low: usize, high: usize, point: Vec3, heap: &mut BinaryHeap<Near>, limit: &mut f64) {
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
        self.search(near.0, near.1, point, heap, limit);
        let away = point - photon.point;
        let square = away.dot(away);
        if square < *limit {
            heap.push(Near(square, middle as u32));
            if heap.len() > self.most {
                heap.pop();
            }
            if heap.len() == self.most {
                *limit = heap.peek().map_or(*limit, |farthest| farthest.0);
            }
        }
        if across * across < *limit {
            self.search(far.0, far.1, point, heap, limit);
        }
    }

    /// Visits the photons around a point that fall on the side of `normal`; gives the area that they fell on.
    pub fn gather(&self, point: Vec3, normal: Vec3, mut visit: impl FnMut(&Photon)) -> f64 {
        let (near, square) = self.nearest(point);
        // In the order of the tree: sums do not depend on the heap.
        let mut numbers: Vec<u32> = near.into_iter().map(|n| n.1).collect();
        numbers.sort_unstable();
        for number in numbers {
            let photon = &self.photons[number as usize];
            if photon.direction.dot(normal) < 0.0 {
                visit(photon);
            }
        }
        std::f64::consts::PI * square
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::Random;

    #[test]
    fn the_nearest_are_found() {
        let mut random = Random::new(5);
        let photons: Vec<_> = (0..500)
            .map(|_| Photon { point: random.vector(3.0), direction: -Vec3::Y, flux: Rgb::WHITE })
            .collect();
        let map = PhotonMap::new(photons.clone(), [5, 20], Some(1.5), 1.0);
        for _ in 0..50 {
            let point = random.vector(3.0);
            let mut squares: Vec<f64> = photons
                .iter()
                .map(|p| (p.point - point).dot(p.point - point))
                .filter(|&s| s < 2.25)
                .collect();
            squares.sort_by(f64::total_cmp);
            squares.truncate(20);
            let mut found = 0;
            let area = map.gather(point, Vec3::Y, |_| found += 1);
            assert_eq!(found, squares.len());
            let square = if squares.len() == 20 { squares[19] } else { 2.25 };
            assert!((area - std::f64::consts::PI * square).abs() < 1e-9);
        }
    }
}
