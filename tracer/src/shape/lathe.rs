//! SDL: `lathe { linear_spline 4, <0,0>, <1,1>, <3,2>, <2,3> }`: a curve in (radius, y) turned about the y axis.

use super::curve::{crossings_beyond, unit_roots, Segment};
use super::sphere::longitude;
use super::torus::within_ring;
use super::{Crossing, Primitive};
use crate::accel::Counters;
use crate::math::polynomial::{quadratic, roots_within, value};
use crate::math::{vec3, Bounds, Ray, Vec3};

/// Nearer crossings are not seen, as in POV-Ray; in the lathe's own measure.
const NEAREST: f64 = 1e-4;

/// A turned curve. A crossing's part is the number of the piece of the curve, `u` the place on it.
#[derive(Clone, Debug)]
pub struct Lathe {
    segments: Vec<Segment>,
    /// Ranges of radius and y of each piece.
    ranges: Vec<[[f64; 2]; 2]>,
    bounds: Bounds,
}

/// Product of two polynomials.
fn product<const N: usize, const M: usize>(p: &[f64], q: &[f64; N]) -> [f64; M] {
    let mut result = [0.0; M];
    for (i, a) in p.iter().enumerate() {
        for (j, b) in q.iter().enumerate() {
            result[i + j] += a * b;
        }
    }
    result
}

impl Lathe {
    /// From the pieces of the curve.
    pub fn new(segments: Vec<Segment>) -> Lathe {
        let ranges: Vec<_> = segments.iter().map(Segment::range).collect();
        let corners = ranges.iter().flat_map(|[r, y]| {
            let reach = r[0].abs().max(r[1].abs());
            [vec3(-reach, y[0], -reach), vec3(reach, y[1], reach)]
        });
        let bounds = Bounds::around(corners);
        Lathe { segments, ranges, bounds }
    }
}

impl Primitive for Lathe {
    fn bounds(&self) -> Bounds {
        self.bounds
    }

    fn intersect(
        &self,
        ray: &Ray,
        from: f64,
        mut limit: f64,
        _counters: &mut Counters,
        offer: &mut impl FnMut(Crossing, f64) -> f64,
    ) -> f64 {
        let scale = ray.direction.length();
        let d = ray.direction / scale;
        let from = from.max(NEAREST / scale);
        // Start near the middle, for precision.
        let start = -ray.origin.dot(d);
        let o = ray.origin + d * start;
        let across = d.x * d.x + d.z * d.z;
        for (i, (segment, [radii, heights])) in self.segments.iter().zip(&self.ranges).enumerate() {
            let margin = 1e-9 * (1.0 + heights[1].abs().max(heights[0].abs()));
            let reach = radii[0].abs().max(radii[1].abs()) * (1.0 + 1e-9);
            let span = [heights[0] - margin, heights[1] + margin];
            let Some((enter, leave)) = within_ring(o, d, reach, span) else { continue };
            if (leave + start) / scale < from || (enter + start) / scale > limit {
                continue;
            }
            let mut height = segment.b;
            height[0] -= o.y;
            let mut check = |t: f64, u: f64, limit: f64| {
                let t = (t + start) / scale;
                if t > from && t <= limit {
                    offer(Crossing { t, part: i as u32, u, v: 0.0 }, limit)
                } else {
                    limit
                }
            };
            if d.y.abs() < 1e-9 {
                for &u in unit_roots(&height).iter() {
                    let r = value(&segment.a, u);
                    let c = o.x * o.x + o.z * o.z - r * r;
                    for &t in quadratic(across, o.x * d.x + o.z * d.z, c).iter() {
                        limit = check(t, u, limit);
                    }
                }
                continue;
            }
            // With t = (y(u) - o.y) / d.y put into x² + z² = r(u)², times d.y².
            let square: [f64; 7] = product(&height, &height);
            let radius: [f64; 7] = product(&segment.a, &segment.a);
            let along = 2.0 * d.y * (o.x * d.x + o.z * d.z);
            let mut sextic: [f64; 7] = std::array::from_fn(|k| across * square[k] - d.y * d.y * radius[k]);
            for k in 0..4 {
                sextic[k] += along * height[k];
            }
            sextic[0] += d.y * d.y * (o.x * o.x + o.z * o.z);
            for &u in roots_within::<8>(&sextic, 0.0, 1.0).iter() {
                limit = check(value(&height, u) / d.y, u, limit);
            }
        }
        limit
    }

    fn inside(&self, p: Vec3) -> bool {
        self.bounds.contains(p) && crossings_beyond(&self.segments, p.x.hypot(p.z), p.y) % 2 == 1
    }

    fn normal(&self, p: Vec3, crossing: &Crossing) -> Vec3 {
        let [r, y] = self.segments[crossing.part as usize].tangent(crossing.u);
        let distance = p.x.hypot(p.z);
        if distance == 0.0 {
            return Vec3::Y;
        }
        vec3(y * p.x / distance, -r, y * p.z / distance)
    }

    fn uv(&self, p: Vec3, crossing: &Crossing) -> Option<[f64; 2]> {
        Some([longitude(p), (f64::from(crossing.part) + crossing.u) / self.segments.len() as f64])
    }
}
