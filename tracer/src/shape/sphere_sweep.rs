//! SDL: `sphere_sweep { b_spline 4, <0,0,0>, 0.5, <1,0,0>, 0.5, <1,1,0>, 0.3, <2,1,0>, 0.2 tolerance 0.01 }`.
//!
//! All space that a ball of changing size passes on its way. A ray is within the ball at place s between
//! b(s) - √Δ(s) and b(s) + √Δ(s), where b is the centre's distance along the ray and Δ the square of the radius less
//! that of the centre's distance from the ray. Where Δ ≥ 0 on a stretch of s, these spans overlap each other: together
//! they are one span from the least beginning to the greatest end, and the piece is hit at these two.

use super::{Crossing, Primitive};
use crate::accel::{Accelerator, AcceleratorKind, Counters, Query};
use crate::graph::shapes::SplineKind;
use crate::math::polynomial::{roots_within, value};
use crate::math::{vec3, Bounds, Ray, Vec3};

/// How the ball moves from one knot to the next: the coordinates of its centre and its radius as cubics of 0..1.
#[derive(Clone, Debug)]
struct Piece {
    center: [[f64; 4]; 3],
    radius: [f64; 4],
    /// How many coefficients count.
    terms: usize,
}

/// A span of a ray inside: where it begins and ends, and the places of the balls there.
#[derive(Clone, Copy, Debug)]
struct Span {
    begin: (f64, f64),
    end: (f64, f64),
    /// The pieces that the two ends are on.
    pieces: [u32; 2],
}

/// What a moving ball covers. A crossing's part is the number of the piece, `u` the place on it.
#[derive(Debug)]
pub struct SphereSweep {
    pieces: Vec<Piece>,
    tolerance: f64,
    tree: Accelerator,
    bounds: Bounds,
}

/// Product of two polynomials.
fn product<const N: usize>(p: &[f64], q: &[f64]) -> [f64; N] {
    let mut result = [0.0; N];
    for (i, a) in p.iter().enumerate() {
        for (j, b) in q.iter().enumerate() {
            result[i + j] += a * b;
        }
    }
    result
}

/// Derivative of a polynomial.
fn derived<const N: usize>(p: &[f64]) -> [f64; N] {
    std::array::from_fn(|i| p.get(i + 1).map_or(0.0, |c| c * (i + 1) as f64))
}

impl Piece {
    /// The pieces through or near consecutive balls.
    fn all(kind: SplineKind, balls: &[(Vec3, f64)]) -> Vec<Piece> {
        let (size, terms) = if kind == SplineKind::Linear { (2, 2) } else { (4, 4) };
        let cubic = |v: [f64; 4]| -> [f64; 4] {
            let [p, q, r, s] = v;
            match kind {
                SplineKind::Linear => [p, q - p, 0.0, 0.0],
                SplineKind::B => [
                    (p + 4.0 * q + r) / 6.0,
                    (r - p) / 2.0,
                    (p - 2.0 * q + r) / 2.0,
                    (s - p) / 6.0 + (q - r) / 2.0,
                ],
                _ => [q, (r - p) / 2.0, p - 2.5 * q + 2.0 * r - s / 2.0, (s - p) / 2.0 + 1.5 * (q - r)],
            }
        };
        let piece = |w: &[(Vec3, f64)]| {
            let of = |pick: &dyn Fn(&(Vec3, f64)) -> f64| {
                cubic(std::array::from_fn(|i| w.get(i).map_or(0.0, pick)))
            };
            Piece {
                center: std::array::from_fn(|axis| of(&|ball| ball.0[axis])),
                radius: of(&|ball| ball.1),
                terms,
            }
        };
        balls.windows(size).map(piece).collect()
    }

    fn center(&self, s: f64) -> Vec3 {
        let [x, y, z] = [0, 1, 2].map(|axis| value(&self.center[axis], s));
        vec3(x, y, z)
    }

    /// The box around all balls, by the Bezier points of each coordinate less and plus the radius.
    fn bounds(&self) -> Bounds {
        let control = |c: &[f64; 4]| {
            [c[0], c[0] + c[1] / 3.0, c[0] + 2.0 * c[1] / 3.0 + c[2] / 3.0, c[0] + c[1] + c[2] + c[3]]
        };
        let radius = control(&self.radius).map(f64::abs);
        let [x, y, z] = [0, 1, 2].map(|axis| control(&self.center[axis]));
        Bounds::around((0..4).flat_map(|i| {
            let (center, reach) = (vec3(x[i], y[i], z[i]), Vec3::splat(radius[i]));
            [center - reach, center + reach]
        }))
    }

    /// Offers the spans of the ray inside; its direction has length one.
    fn spans(&self, number: u32, o: Vec3, d: Vec3, mut found: impl FnMut(Span)) {
        let n = self.terms;
        // From here on with the centre as seen from the ray's origin.
        let mut center = self.center;
        for axis in 0..3 {
            center[axis][0] -= o[axis];
        }
        let along: [f64; 4] =
            std::array::from_fn(|k| center[0][k] * d.x + center[1][k] * d.y + center[2][k] * d.z);
        let squares = |p: &[f64; 4]| product::<7>(&p[..n], &p[..n]);
        let [x, y, z] = [0, 1, 2].map(|axis| {
            let away: [f64; 4] = std::array::from_fn(|k| center[axis][k] - along[k] * d[axis]);
            squares(&away)
        });
        let radius = squares(&self.radius);
        let delta: [f64; 7] = std::array::from_fn(|k| radius[k] - x[k] - y[k] - z[k]);
        let delta = &delta[..2 * n - 1];
        let edges = roots_within::<8>(delta, 0.0, 1.0);
        if edges.is_empty() && value(delta, 0.0) < 0.0 {
            return;
        }
        // b ∓ √Δ stands still where 4 b'² Δ = Δ'².
        let (slope_b, slope): ([f64; 3], [f64; 6]) = (derived(&along[..n]), derived(delta));
        let (slope_b, slope) = (&slope_b[..n - 1], &slope[..2 * n - 2]);
        let square_b: [f64; 5] = product(slope_b, slope_b);
        let left: [f64; 11] = product(&square_b[..2 * n - 3], delta);
        let right: [f64; 11] = product(slope, slope);
        let still: [f64; 11] = std::array::from_fn(|k| 4.0 * left[k] - right[k]);
        let still = &still[..4 * n - 5];

        let mut low = 0.0;
        for i in 0..=edges.len() {
            let high = edges.get(i).copied().unwrap_or(1.0);
            if value(delta, 0.5 * (low + high)) >= 0.0 {
                let mut span =
                    Span { begin: (f64::INFINITY, low), end: (f64::NEG_INFINITY, low), pieces: [number; 2] };
                let mut try_at = |s: f64| {
                    let (middle, half) = (value(&along, s), value(delta, s).max(0.0).sqrt());
                    if middle - half < span.begin.0 {
                        span.begin = (middle - half, s);
                    }
                    if middle + half > span.end.0 {
                        span.end = (middle + half, s);
                    }
                };
                try_at(low);
                try_at(high);
                roots_within::<12>(still, low, high).iter().for_each(|&s| try_at(s));
                // Across the sweep b' is nearly 0, and the two roots there are too close to be told apart.
                roots_within::<7>(slope, low, high).iter().for_each(|&s| try_at(s));
                found(span);
            }
            low = high;
        }
    }
}

impl SphereSweep {
    /// From the balls at the knots.
    pub fn new(kind: SplineKind, balls: &[(Vec3, f64)], tolerance: f64) -> SphereSweep {
        let pieces = Piece::all(kind, balls);
        let boxes: Vec<Bounds> = pieces.iter().map(Piece::bounds).collect();
        SphereSweep {
            tree: Accelerator::build(AcceleratorKind::Octree, &boxes),
            bounds: boxes.iter().fold(Bounds::EMPTY, |sum, b| sum.union(b)),
            pieces,
            tolerance,
        }
    }
}

/// Joins spans that overlap.
fn joined(mut spans: Vec<Span>) -> Vec<Span> {
    spans.sort_by(|a, b| a.begin.0.total_cmp(&b.begin.0));
    let mut kept: Vec<Span> = Vec::with_capacity(spans.len());
    for span in spans {
        match kept.last_mut() {
            Some(last) if span.begin.0 <= last.end.0 => {
                if span.end.0 > last.end.0 {
                    last.end = span.end;
                    last.pieces[1] = span.pieces[1];
                }
            }
            _ => kept.push(span),
        }
    }
    kept
}

impl Primitive for SphereSweep {
    fn bounds(&self) -> Bounds {
        self.bounds
    }

    fn intersect(
        &self,
        ray: &Ray,
        from: f64,
        mut limit: f64,
        counters: &mut Counters,
        offer: &mut impl FnMut(Crossing, f64) -> f64,
    ) -> f64 {
        let scale = ray.direction.length();
        let d = ray.direction / scale;
        let from = from.max(self.tolerance / scale);
        let mut spans = Vec::new();
        // A piece beyond the limit cannot matter; one near it may begin before and end after it.
        self.tree.along(&Query::new(*ray), limit, counters, |item, limit, _| {
            self.pieces[item as usize].spans(item, ray.origin, d, |span| spans.push(span));
            limit
        });
        for span in joined(spans) {
            for ((t, u), part) in [span.begin, span.end].into_iter().zip(span.pieces) {
                let t = t / scale;
                if t > from && t <= limit {
                    limit = offer(Crossing { t, part, u, v: 0.0 }, limit);
                }
            }
        }
        limit
    }

    fn inside(&self, point: Vec3) -> bool {
        self.tree.around(point, |item| {
            let piece = &self.pieces[item as usize];
            let mut center = piece.center;
            for axis in 0..3 {
                center[axis][0] -= point[axis];
            }
            let [x, y, z, r] =
                [&center[0], &center[1], &center[2], &piece.radius].map(|p| product::<7>(p, p));
            let excess: [f64; 7] = std::array::from_fn(|k| x[k] + y[k] + z[k] - r[k]);
            value(&excess, 0.0) < 0.0 || !roots_within::<8>(&excess, 0.0, 1.0).is_empty()
        })
    }

    fn normal(&self, point: Vec3, crossing: &Crossing) -> Vec3 {
        point - self.pieces[crossing.part as usize].center(crossing.u)
    }
}
