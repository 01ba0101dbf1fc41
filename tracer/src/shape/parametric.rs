//! SDL: `parametric { function { cos(u) } function { v } function { sin(u) } <0, 0>, <6.28, 1> contained_by {...} }`.
//!
//! The rectangle of u and v is halved and halved again, as long as the ray meets the box that, by `max_gradient`, holds
//! a piece of the surface (and in any case its corners), until the piece or its box is smaller than `accuracy`. As in
//! POV-Ray the hit is where the ray enters that box across z, and the whole surface stands one accuracy too low on every
//! axis. It has no inside.

use super::container::Container;
use super::{Crossing, Primitive};
use crate::accel::Counters;
use crate::function::Function;
use crate::graph::shapes as graph;
use crate::math::{Bounds, Ray, Vec3};

/// Pieces are not halved more often than this.
const DEEPEST: u32 = 48;
/// The boxes of all pieces down to this level, at most, are worked out beforehand.
const DEEPEST_KNOWN: u32 = 16;
/// The search begins this many accuracies behind the container.
const STEP_INSIDE: f64 = 4.0;
/// Rays whose direction has a smaller component go along the plane across that axis.
const PARALLEL: f64 = 1e-10;

/// A surface given by three functions of u and v.
#[derive(Clone, Debug)]
pub struct Parametric {
    functions: [Function; 3],
    low: [f64; 2],
    high: [f64; 2],
    container: Container,
    max_gradient: f64,
    accuracy: f64,
    /// By axis and by the number of the piece, whose halves have twice the number and one more.
    known: [Vec<Reach>; 3],
}

/// What a function reaches on a piece.
#[derive(Clone, Copy, Debug, Default)]
struct Reach {
    low: f64,
    high: f64,
}

/// A rectangle of u and v. The whole has number 1.
#[derive(Clone, Copy)]
struct Piece {
    low: [f64; 2],
    high: [f64; 2],
    number: u64,
    depth: u32,
}

impl Piece {
    /// The longer side, and its length.
    fn longer(&self) -> (usize, f64) {
        let sides = [self.high[0] - self.low[0], self.high[1] - self.low[1]];
        let axis = usize::from(sides[1] > sides[0]);
        (axis, sides[axis])
    }

    fn halves(&self) -> [Piece; 2] {
        let (axis, _) = self.longer();
        let middle = (self.low[axis] + self.high[axis]) / 2.0;
        let half = Piece { number: self.number.wrapping_mul(2), depth: self.depth + 1, ..*self };
        let (mut lower, mut upper) = (half, Piece { number: half.number.wrapping_add(1), ..half });
        lower.high[axis] = middle;
        upper.low[axis] = middle;
        [lower, upper]
    }
}

impl Parametric {
    /// With its functions compiled.
    pub fn new(node: &graph::Parametric, functions: [Function; 3]) -> Parametric {
        let mut surface = Parametric {
            functions,
            low: node.low,
            high: node.high,
            container: Container::from(&node.contained_by),
            max_gradient: node.max_gradient,
            accuracy: node.accuracy,
            known: Default::default(),
        };
        let halvings =
            |axis: usize| ((node.high[axis] - node.low[axis]) / node.accuracy).log2().ceil().clamp(0.0, 64.0);
        let levels = (halvings(0) + halvings(1)) as u32 + 1;
        let (depth, x, y, z) = node.precompute.unwrap_or_default();
        for (axis, precompute) in [x, y, z].into_iter().enumerate() {
            // Precomputed boxes hold no more than those of their halves do.
            let tight = if precompute { 1_u64 << depth.clamp(0, 20) } else { 0 };
            let mut known = vec![Reach::default(); tight.max(1 << levels.min(DEEPEST_KNOWN)) as usize];
            surface.fill(axis, &surface.whole(), tight, &mut known);
            surface.known[axis] = known;
        }
        surface
    }

    fn whole(&self) -> Piece {
        Piece { low: self.low, high: self.high, number: 1, depth: 0 }
    }

    /// Fills in the boxes of a piece and of all known below it.
    fn fill(&self, axis: usize, piece: &Piece, tight: u64, known: &mut [Reach]) {
        let number = piece.number as usize;
        if number >= known.len() {
            return;
        }
        piece.halves().iter().for_each(|half| self.fill(axis, half, tight, known));
        known[number] = if piece.number < tight / 2 {
            let [a, b] = [known[2 * number], known[2 * number + 1]];
            Reach { low: a.low.min(b.low), high: a.high.max(b.high) }
        } else {
            self.computed_reach(axis, piece)
        };
    }

    /// The point at u and v.
    fn point(&self, uv: [f64; 2]) -> Vec3 {
        Vec3::from(self.functions.each_ref().map(|f| f.value(&uv)))
    }

    fn computed_reach(&self, axis: usize, piece: &Piece) -> Reach {
        let f = |u: f64, v: f64| self.functions[axis].value(&[u, v]);
        let ([u0, v0], [u1, v1]) = (piece.low, piece.high);
        let corners = [f(u0, v0), f(u0, v1), f(u1, v0), f(u1, v1)].map(|value| value - self.accuracy);
        let middle = corners.iter().sum::<f64>() / 4.0;
        let rise = self.max_gradient * ((u1 - u0) + (v1 - v0)) / 2.0;
        let reach = Reach { low: middle - rise, high: middle + rise };
        corners.into_iter().fold(reach, |r, value| Reach { low: r.low.min(value), high: r.high.max(value) })
    }

    #[inline]
    fn reach(&self, axis: usize, piece: &Piece) -> Reach {
        match self.known[axis].get(piece.number as usize) {
            Some(&known) if piece.depth < u64::BITS => known,
            _ => self.computed_reach(axis, piece),
        }
    }

    /// Where the ray enters the box of a piece across the last axis that it is not parallel to, and how long it stays
    /// between two of its sides at most; None where it does not meet the box from `near` to `far` and before `best`.
    #[inline]
    fn entry(&self, ray: &Ray, piece: &Piece, near: f64, far: f64, best: f64) -> Option<(f64, f64)> {
        let (mut enter, mut leave) = (f64::NEG_INFINITY, f64::INFINITY);
        let (mut start, mut longest) = (f64::NEG_INFINITY, 0.0_f64);
        for axis in 0..3 {
            let Reach { low, high } = self.reach(axis, piece);
            let (o, d) = (ray.origin[axis], ray.direction[axis]);
            if d.abs() < PARALLEL {
                if high < o || low > o {
                    return None;
                }
                continue;
            }
            let (a, b) = ((low - o) / d, (high - o) / d);
            let (first, last) = if a <= b { (a, b) } else { (b, a) };
            if first > far || last < near || first > best || first > leave || last < enter {
                return None;
            }
            enter = enter.max(first);
            leave = leave.min(last);
            start = first;
            longest = longest.max(last - first);
        }
        Some((start, longest))
    }
}

impl Primitive for Parametric {
    fn bounds(&self) -> Bounds {
        self.container.bounds()
    }

    fn intersect(
        &self,
        ray: &Ray,
        from: f64,
        limit: f64,
        _counters: &mut Counters,
        offer: &mut impl FnMut(Crossing, f64) -> f64,
    ) -> f64 {
        let Some([enter, leave]) = self.container.span(ray) else { return limit };
        let (near, far) = (enter.t.max(0.0) + STEP_INSIDE * self.accuracy, leave.t);
        if near > far {
            return limit;
        }
        let mut best = Crossing::at(f64::INFINITY);
        // Halves are asked from the lower, so that few wait at any time.
        let mut waiting = [self.whole(); DEEPEST as usize + 2];
        let mut count = 1;
        while count > 0 {
            count -= 1;
            let piece = waiting[count];
            let Some((start, longest)) = self.entry(ray, &piece, near, far, best.t) else { continue };
            let (_, side) = piece.longer();
            if side.min(longest) >= self.accuracy && piece.depth < DEEPEST {
                let [lower, upper] = piece.halves();
                waiting[count] = upper;
                waiting[count + 1] = lower;
                count += 2;
            } else if start < best.t && start > near {
                best = Crossing { t: start, part: 0, u: piece.low[0], v: piece.low[1] };
            }
        }
        if best.t < far && best.t > from && best.t <= limit {
            return offer(best, limit);
        }
        limit
    }

    /// A ray is told where it meets the surface first.
    fn tells_all(&self) -> bool {
        false
    }

    fn inside(&self, _: Vec3) -> bool {
        false
    }

    /// By differences over `accuracy`.
    fn normal(&self, _: Vec3, crossing: &Crossing) -> Vec3 {
        let (u, v, step) = (crossing.u, crossing.v, self.accuracy);
        let here = self.point([u, v]);
        let normal = (self.point([u + step, v]) - here).cross(self.point([u, v + step]) - here);
        if normal == Vec3::ZERO || !normal.is_finite() {
            return Vec3::X;
        }
        normal
    }

    fn uv(&self, _: Vec3, crossing: &Crossing) -> Option<[f64; 2]> {
        Some([crossing.u, crossing.v])
    }

    fn solid(&self) -> bool {
        false
    }
}
