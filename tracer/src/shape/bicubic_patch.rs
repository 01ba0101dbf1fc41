//! SDL: `bicubic_patch { type 1 flatness 0.01 u_steps 3 v_steps 3 <0,0,0>, ... 16 points }`.
//!
//! The patch is halved in both directions until it is flat enough or as often as the steps allow; each piece is two
//! triangles, shaded by the normals of the true surface at their corners.

use super::{interpolated_normal, Crossing, Facet, Primitive};
use crate::accel::{Counters, Octree, Query};
use crate::graph::shapes::BicubicPatch as Description;
use crate::math::{Bounds, Ray, Vec3};

/// Nearer crossings are not seen.
const NEAREST: f64 = 1e-5;
/// Vectors shorter than this have no direction.
const SHORTEST: f64 = 1e-10;
/// Steps beyond this make more triangles than memory holds.
const MOST_STEPS: i32 = 12;

/// Control points by u, then v.
type Net = [[Vec3; 4]; 4];

/// A triangle, and for each corner the place on the unit square and the normal.
#[derive(Clone, Copy, Debug)]
struct Tile {
    facet: Facet,
    places: [[f64; 2]; 3],
    normals: [Vec3; 3],
}

/// A patch cut into triangles. A crossing's part is the number of the triangle.
#[derive(Debug)]
pub struct BicubicPatch {
    octree: Octree,
    tiles: Vec<Tile>,
    bounds: Bounds,
    uv_vectors: [[f64; 2]; 4],
}

/// Both halves of a Bezier curve.
fn halves(p: [Vec3; 4]) -> [[Vec3; 4]; 2] {
    let middle = |a: Vec3, b: Vec3| (a + b) * 0.5;
    let (a, b, c) = (middle(p[0], p[1]), middle(p[1], p[2]), middle(p[2], p[3]));
    let (d, e) = (middle(a, b), middle(b, c));
    let f = middle(d, e);
    [[p[0], a, d, f], [f, e, c, p[3]]]
}

fn transposed(net: &Net) -> Net {
    std::array::from_fn(|i| std::array::from_fn(|j| net[j][i]))
}

/// Both halves of a net, cut across v.
fn halved_in_v(net: &Net) -> [Net; 2] {
    let rows = net.map(halves);
    [0, 1].map(|half| std::array::from_fn(|i| rows[i][half]))
}

/// Both halves of a net, cut across u.
fn halved_in_u(net: &Net) -> [Net; 2] {
    halved_in_v(&transposed(net)).map(|half| transposed(&half))
}

/// How far a control point lies from the plane through three corners.
fn height(net: &Net) -> f64 {
    let corner = net[0][0];
    let corners = [net[3][0], net[0][3], net[3][3]];
    let plane = [(0, 1), (0, 2), (1, 2)]
        .map(|(i, j)| (corners[i] - corner).cross(corners[j] - corner))
        .into_iter()
        .find(|n| n.length() > SHORTEST);
    let Some(normal) = plane.map(Vec3::normalized) else { return 0.0 };
    net.iter().flatten().map(|&p| (p - corner).dot(normal).abs()).fold(0.0, f64::max)
}

/// What the cutting has made so far.
struct Cutting<'a> {
    whole: &'a Net,
    flatness: f64,
    steps: [i32; 2],
    tiles: Vec<Tile>,
}

impl Cutting<'_> {
    /// Cuts a piece over the given ranges of u and v.
    fn cut(&mut self, net: &Net, [u0, u1]: [f64; 2], [v0, v1]: [f64; 2], depth: i32) {
        let [split_u, split_v] = self.steps.map(|steps| depth < steps);
        if !(split_u || split_v) || height(net) < self.flatness {
            let corners =
                [(net[0][0], [u0, v0]), (net[0][3], [u0, v1]), (net[3][3], [u1, v1]), (net[3][0], [u1, v0])];
            for [a, b, c] in [[0, 1, 2], [0, 2, 3]] {
                let [p, q, r] = [corners[a], corners[b], corners[c]];
                let facet = Facet::new(p.0, q.0, r.0);
                if facet.normal().length() > SHORTEST {
                    let places = [p.1, q.1, r.1];
                    let normals = places.map(|place| normal_at(self.whole, place, facet.normal()));
                    self.tiles.push(Tile { facet, places, normals });
                }
            }
            return;
        }
        let (um, vm) = (0.5 * (u0 + u1), 0.5 * (v0 + v1));
        let in_u = if split_u {
            let [low, high] = halved_in_u(net);
            vec![(low, [u0, um]), (high, [um, u1])]
        } else {
            vec![(*net, [u0, u1])]
        };
        for (half, us) in in_u {
            if split_v {
                let [low, high] = halved_in_v(&half);
                self.cut(&low, us, [v0, vm], depth + 1);
                self.cut(&high, us, [vm, v1], depth + 1);
            } else {
                self.cut(&half, us, [v0, v1], depth + 1);
            }
        }
    }
}

/// Weights of the four points of a Bezier curve at `t`, and their slopes.
fn weights(t: f64) -> ([f64; 4], [f64; 4]) {
    let s = 1.0 - t;
    (
        [s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t],
        [-3.0 * s * s, 3.0 * s * (s - 2.0 * t), 3.0 * t * (2.0 * s - t), 3.0 * t * t],
    )
}

/// The unit normal of the surface at a place; where it has none, that of the triangle.
fn normal_at(net: &Net, [u, v]: [f64; 2], flat: Vec3) -> Vec3 {
    let ((wu, su), (wv, sv)) = (weights(u), weights(v));
    let (mut along_u, mut along_v) = (Vec3::ZERO, Vec3::ZERO);
    for i in 0..4 {
        for j in 0..4 {
            along_u += net[i][j] * (su[i] * wv[j]);
            along_v += net[i][j] * (wu[i] * sv[j]);
        }
    }
    let normal = along_u.cross(along_v);
    (if normal.length() > SHORTEST { normal } else { flat }).normalized()
}

impl BicubicPatch {
    /// Cuts the patch; `None` without 16 points.
    pub fn new(patch: &Description) -> Option<BicubicPatch> {
        if patch.points.len() != 16 {
            return None;
        }
        let net: Net = std::array::from_fn(|i| std::array::from_fn(|j| patch.points[4 * i + j]));
        let steps = [patch.u_steps, patch.v_steps].map(|steps| steps.min(MOST_STEPS));
        let mut cutting = Cutting { whole: &net, flatness: patch.flatness, steps, tiles: Vec::new() };
        cutting.cut(&net, [0.0, 1.0], [0.0, 1.0], 0);
        let boxes: Vec<Bounds> = cutting.tiles.iter().map(|tile| tile.facet.bounds()).collect();
        let mut octree = Octree::build(&boxes, 2);
        let tiles = octree.order().iter().map(|&i| cutting.tiles[i as usize]).collect();
        octree.renumber();
        let bounds = boxes.iter().fold(Bounds::EMPTY, |sum, b| sum.union(b));
        Some(BicubicPatch { octree, tiles, bounds, uv_vectors: patch.uv_vectors })
    }

    /// Where on the unit square a crossing lies.
    fn place(&self, crossing: &Crossing) -> [f64; 2] {
        let [a, b, c] = self.tiles[crossing.part as usize].places;
        let rest = 1.0 - crossing.u - crossing.v;
        [0, 1].map(|k| a[k] * rest + b[k] * crossing.u + c[k] * crossing.v)
    }
}

impl Primitive for BicubicPatch {
    fn bounds(&self) -> Bounds {
        self.bounds
    }

    fn intersect(
        &self,
        ray: &Ray,
        from: f64,
        limit: f64,
        counters: &mut Counters,
        offer: &mut impl FnMut(Crossing, f64) -> f64,
    ) -> f64 {
        let from = from.max(NEAREST);
        self.octree.along(&Query::new(*ray), limit, counters, |item, limit, _| {
            match self.tiles[item as usize].facet.crossing(ray, item) {
                Some(crossing) if crossing.t > from && crossing.t <= limit => offer(crossing, limit),
                _ => limit,
            }
        })
    }

    fn inside(&self, _: Vec3) -> bool {
        false
    }

    fn normal(&self, _: Vec3, crossing: &Crossing) -> Vec3 {
        interpolated_normal(self.tiles[crossing.part as usize].normals, crossing)
    }

    fn geometric_normal(&self, _: Vec3, crossing: &Crossing) -> Vec3 {
        self.tiles[crossing.part as usize].facet.normal()
    }

    /// The corners stand at (0,0), (1,0), (1,1), (0,1), the first way along the rows of points.
    fn uv(&self, _: Vec3, crossing: &Crossing) -> Option<[f64; 2]> {
        let [v, u] = self.place(crossing);
        let [a, b, c, d] = self.uv_vectors;
        let mix = |k: usize| {
            a[k] * (1.0 - u) * (1.0 - v) + b[k] * u * (1.0 - v) + c[k] * u * v + d[k] * (1.0 - u) * v
        };
        Some([mix(0), mix(1)])
    }

    fn solid(&self) -> bool {
        false
    }
}
