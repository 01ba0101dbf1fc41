//! SDL: `polygon { n, points }`: rings in one plane; what an odd number of rings encloses is filled.

use super::{offer_rising, Crossing, Primitive};
use crate::accel::Counters;
use crate::math::{Bounds, Ray, Transform, Vec3};

const NEAREST: f64 = 1e-8;

/// A flat figure.
#[derive(Clone, Debug)]
pub struct Polygon {
    normal: Vec3,
    distance: f64,
    /// The two axes that the figure is looked at along the third.
    axes: [usize; 2],
    edges: Vec<[[f64; 2]; 2]>,
    bounds: Bounds,
}

/// The rings in a list of points: each ends where its first point comes again, the last also at the list's end.
pub fn rings<P: Copy + PartialEq>(points: &[P]) -> Vec<Vec<P>> {
    let mut rings = Vec::new();
    let mut ring: Vec<P> = Vec::new();
    for &point in points {
        if ring.len() > 1 && ring[0] == point {
            rings.push(std::mem::take(&mut ring));
        } else {
            ring.push(point);
        }
    }
    if ring.len() > 2 {
        rings.push(ring);
    }
    rings
}

impl Polygon {
    /// The figure in its place; none where the points do not span a plane.
    pub fn new(points: &[Vec3], place: &Transform) -> Option<Polygon> {
        let points: Vec<Vec3> = points.iter().map(|&p| place.point(p)).collect();
        let rings = rings(&points);
        let first = rings.first()?;
        // Newell: the area vector of the first ring.
        let normal = (0..first.len()).fold(Vec3::ZERO, |sum, i| {
            sum + (first[i] - first[0]).cross(first[(i + 1) % first.len()] - first[0])
        });
        if normal.length() < 1e-30 {
            return None;
        }
        let normal = normal.normalized();
        let flat = (0..3).max_by(|&a, &b| normal[a].abs().total_cmp(&normal[b].abs()))?;
        let axes = [(flat + 1) % 3, (flat + 2) % 3];
        let flatten = |p: Vec3| [p[axes[0]], p[axes[1]]];
        let edges = rings.iter().flat_map(|ring| {
            (0..ring.len()).map(move |i| [flatten(ring[i]), flatten(ring[(i + 1) % ring.len()])])
        });
        Some(Polygon {
            normal,
            distance: normal.dot(first[0]),
            axes,
            edges: edges.collect(),
            bounds: Bounds::around(points.iter().copied()),
        })
    }

    /// Whether an odd number of edges lies to one side.
    fn covers(&self, p: Vec3) -> bool {
        let [x, y] = self.axes.map(|axis| p[axis]);
        self.edges
            .iter()
            .filter(|[[ax, ay], [bx, by]]| {
                (*ay > y) != (*by > y) && x < (bx - ax) * (y - ay) / (by - ay) + ax
            })
            .count()
            % 2
            == 1
    }
}

impl Primitive for Polygon {
    fn bounds(&self) -> Bounds {
        self.bounds
    }

    fn intersect(
        &self,
        ray: &Ray,
        from: f64,
        limit: f64,
        _counters: &mut Counters,
        offer: &mut impl FnMut(Crossing, f64) -> f64,
    ) -> f64 {
        let slope = self.normal.dot(ray.direction);
        let t = (self.distance - self.normal.dot(ray.origin)) / slope;
        if slope == 0.0 || t > limit || !self.covers(ray.at(t)) {
            return limit;
        }
        offer_rising([Crossing::at(t)], from.max(NEAREST), limit, offer)
    }

    fn inside(&self, _: Vec3) -> bool {
        false
    }

    fn normal(&self, _: Vec3, _: &Crossing) -> Vec3 {
        self.normal
    }

    fn solid(&self) -> bool {
        false
    }
}
