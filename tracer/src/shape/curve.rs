//! SDL: `linear_spline`, `quadratic_spline`, `cubic_spline`, `bezier_spline`: plane curves of prism and lathe.

use crate::graph::shapes::SplineKind;
use crate::math::polynomial::{roots_within, value, Few};

/// One piece: both coordinates as cubics of 0..1, by rising power.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Segment {
    /// First coordinate.
    pub a: [f64; 4],
    /// Second coordinate.
    pub b: [f64; 4],
}

impl Segment {
    /// The point at `u`.
    pub fn at(&self, u: f64) -> [f64; 2] {
        [value(&self.a, u), value(&self.b, u)]
    }

    /// The direction at `u`.
    pub fn tangent(&self, u: f64) -> [f64; 2] {
        [&self.a, &self.b].map(|c| c[1] + u * (2.0 * c[2] + u * 3.0 * c[3]))
    }

    /// Smallest and largest value of each coordinate, by its Bezier points.
    pub fn range(&self) -> [[f64; 2]; 2] {
        [&self.a, &self.b].map(|c| {
            let control =
                [c[0], c[0] + c[1] / 3.0, c[0] + 2.0 * c[1] / 3.0 + c[2] / 3.0, c[0] + c[1] + c[2] + c[3]];
            let low = control.into_iter().fold(f64::INFINITY, f64::min);
            let high = control.into_iter().fold(f64::NEG_INFINITY, f64::max);
            [low, high]
        })
    }
}

/// The roots of a cubic from 0 to just before 1, so that a joint of two pieces counts once.
pub fn unit_roots(cubic: &[f64; 4]) -> Few<4> {
    if cubic[2] == 0.0 && cubic[3] == 0.0 {
        let mut roots = Few::new();
        let u = -cubic[0] / cubic[1];
        if (0.0..1.0).contains(&u) {
            roots.push(u);
        }
        return roots;
    }
    roots_within(cubic, 0.0, 1.0)
}

/// How many crossings of the curve lie at the given second coordinate beyond the given first one: odd inside.
pub fn crossings_beyond(segments: &[Segment], a: f64, b: f64) -> usize {
    let mut count = 0;
    for segment in segments {
        let [[_, far], [low, high]] = segment.range();
        if b < low || b > high || a > far {
            continue;
        }
        let mut shifted = segment.b;
        shifted[0] -= b;
        count += unit_roots(&shifted).iter().filter(|&&u| value(&segment.a, u) > a).count();
    }
    count
}

/// The pieces through consecutive points of one curve. Fewer points than a piece needs give none.
pub fn segments(kind: SplineKind, points: &[[f64; 2]]) -> Vec<Segment> {
    let piece = |coefficients: &dyn Fn(usize) -> [f64; 4]| Segment { a: coefficients(0), b: coefficients(1) };
    let window = |n: usize, make: &dyn Fn(&[[f64; 2]]) -> Segment| points.windows(n).map(make).collect();
    match kind {
        SplineKind::Linear => window(2, &|p| piece(&|k| [p[0][k], p[1][k] - p[0][k], 0.0, 0.0])),
        SplineKind::Quadratic => window(3, &|p| {
            piece(&|k| {
                let [p, q, r] = [p[0][k], p[1][k], p[2][k]];
                [q, (r - p) / 2.0, (p + r) / 2.0 - q, 0.0]
            })
        }),
        SplineKind::Cubic | SplineKind::B => window(4, &|p| {
            piece(&|k| {
                let [p, q, r, s] = [p[0][k], p[1][k], p[2][k], p[3][k]];
                [q, (r - p) / 2.0, p - 2.5 * q + 2.0 * r - s / 2.0, (s - p) / 2.0 + 1.5 * (q - r)]
            })
        }),
        SplineKind::Bezier => points
            .chunks_exact(4)
            .map(|p| {
                piece(&|k| {
                    let [p, q, r, s] = [p[0][k], p[1][k], p[2][k], p[3][k]];
                    [p, 3.0 * (q - p), 3.0 * (p - 2.0 * q + r), s - p + 3.0 * (q - r)]
                })
            })
            .collect(),
    }
}

/// The pieces of several closed curves. Where a curve begins again at its first point, the next one starts; a
/// quadratic curve has a control point before, a cubic one also a control point behind.
pub fn closed_curves(kind: SplineKind, points: &[[f64; 2]]) -> Vec<Segment> {
    let (before, behind) = match kind {
        SplineKind::Bezier => return segments(kind, points),
        SplineKind::Linear => (0, 0),
        SplineKind::Quadratic => (1, 0),
        SplineKind::Cubic | SplineKind::B => (1, 1),
    };
    let mut all = Vec::new();
    let mut rest = points;
    while rest.len() > before + behind + 1 {
        let first = rest[before];
        let again = rest.iter().skip(before + 1).position(|&p| p == first).map(|i| i + before + 1);
        let end = again.map_or(rest.len(), |i| (i + 1 + behind).min(rest.len()));
        let mut curve = rest[..end].to_vec();
        if again.is_none() && kind == SplineKind::Linear {
            curve.push(first);
        }
        all.extend(segments(kind, &curve));
        rest = &rest[end..];
    }
    all.retain(|s| s.tangent(0.3) != [0.0; 2]);
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pieces_join() {
        let points = [[0.0, 1.0], [1.0, 2.0], [2.0, 0.5], [3.0, 3.0], [2.5, 4.0]];
        for kind in [SplineKind::Linear, SplineKind::Quadratic, SplineKind::Cubic] {
            for pair in segments(kind, &points).windows(2) {
                let (end, start) = (pair[0].at(1.0), pair[1].at(0.0));
                assert!((end[0] - start[0]).abs() + (end[1] - start[1]).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn rings_have_holes() {
        let ring = |r: f64| [[-r, -r], [r, -r], [r, r], [-r, r], [-r, -r]];
        let curve = closed_curves(SplineKind::Linear, &[ring(2.0), ring(1.0)].concat());
        assert_eq!(curve.len(), 8);
        assert_eq!(crossings_beyond(&curve, 0.1, 0.2) % 2, 0);
        assert_eq!(crossings_beyond(&curve, 1.5, 0.2) % 2, 1);
        assert_eq!(crossings_beyond(&curve, 2.5, 0.2) % 2, 0);
    }
}
