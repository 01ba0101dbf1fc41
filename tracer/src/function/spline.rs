//! SDL: `spline { cubic_spline 0, <0,0,0> 1, <1,2,3> }`: a curve through points, of up to five numbers each.
//!
//! Outside its range a spline keeps its first or last value; the end points of a cubic one only give directions.

use crate::graph::function::SplineKind;

type Five = [f64; 5];

/// A spline ready to be asked.
#[derive(Clone, Debug)]
pub struct Spline {
    kind: SplineKind,
    at: Vec<f64>,
    values: Vec<Five>,
    /// Of a natural spline: the second derivative at every point.
    bends: Vec<Five>,
}

fn each(f: impl Fn(usize) -> f64) -> Five {
    std::array::from_fn(f)
}

impl Spline {
    /// A spline through points sorted by parameter. With too few for its kind it is a simpler one; a cubic one between
    /// two points has but one value, in their middle.
    pub fn new(kind: SplineKind, points: &[(f64, Five)]) -> Spline {
        let (at, values): (Vec<f64>, Vec<Five>) = points.iter().copied().unzip();
        if let (SplineKind::Cubic, [(at, p), (_, q)]) = (kind, points) {
            return Spline::new(SplineKind::Linear, &[(*at, each(|k| (p[k] + q[k]) / 2.0))]);
        }
        let kind = match (kind, at.len()) {
            (SplineKind::Quadratic, ..3) | (SplineKind::Cubic, ..3) => SplineKind::Linear,
            (kind, _) => kind,
        };
        let bends = match kind {
            SplineKind::Natural => bends(&at, &values),
            _ => Vec::new(),
        };
        Spline { kind, at, values, bends }
    }

    /// The point at parameter `t`.
    pub fn point(&self, t: f64) -> Five {
        let (Some(last), inset) = (self.at.len().checked_sub(1), usize::from(self.kind == SplineKind::Cubic))
        else {
            return [0.0; 5];
        };
        let (first, last) = (inset, last - inset);
        if t <= self.at[first] || first == last {
            return self.values[first];
        }
        // What is not a number counts as beyond the end.
        let i = match self.at.partition_point(|&a| a <= t).checked_sub(1) {
            Some(i) if i < last && t < self.at[last] => i,
            _ => return self.values[last],
        };
        match self.kind {
            SplineKind::Linear => self.linear(i, t),
            SplineKind::Quadratic => self.quadratic(i, t),
            SplineKind::Cubic => self.cubic(i, t),
            SplineKind::Natural => self.natural(i, t),
        }
    }

    fn linear(&self, i: usize, t: f64) -> Five {
        let s = (t - self.at[i]) / (self.at[i + 1] - self.at[i]);
        let (p, q) = (&self.values[i], &self.values[i + 1]);
        each(|k| p[k] + (q[k] - p[k]) * s)
    }

    /// Lagrange's parabola through three neighbouring points.
    fn quadratic(&self, i: usize, t: f64) -> Five {
        let i = i.max(1);
        let (p, q, r) = (self.at[i - 1], self.at[i], self.at[i + 1]);
        let weights = [
            (t - q) * (t - r) / ((p - q) * (p - r)),
            (t - p) * (t - r) / ((q - p) * (q - r)),
            (t - p) * (t - q) / ((r - p) * (r - q)),
        ];
        each(|k| (0..3).map(|j| weights[j] * self.values[i - 1 + j][k]).sum())
    }

    /// Hermite's cubic; the direction at a point is the mean of the slopes on both its sides.
    fn cubic(&self, i: usize, t: f64) -> Five {
        let at = &self.at[i - 1..i + 3];
        let step = at[2] - at[1];
        let s = (t - at[1]) / step;
        let (s2, s3) = (s * s, s * s * s);
        let (h00, h10) = (2.0 * s3 - 3.0 * s2 + 1.0, s3 - 2.0 * s2 + s);
        let (h01, h11) = (-2.0 * s3 + 3.0 * s2, s3 - s2);
        let v = &self.values[i - 1..i + 3];
        each(|k| {
            let slope = |j: usize| (v[j + 1][k] - v[j][k]) / (at[j + 1] - at[j]);
            let (leaving, arriving) = ((slope(0) + slope(1)) / 2.0, (slope(1) + slope(2)) / 2.0);
            h00 * v[1][k] + h10 * step * leaving + h01 * v[2][k] + h11 * step * arriving
        })
    }

    fn natural(&self, i: usize, t: f64) -> Five {
        let h = self.at[i + 1] - self.at[i];
        let (a, b) = ((self.at[i + 1] - t) / h, (t - self.at[i]) / h);
        let (p, q, m, n) = (&self.values[i], &self.values[i + 1], &self.bends[i], &self.bends[i + 1]);
        each(|k| a * p[k] + b * q[k] + ((a * a * a - a) * m[k] + (b * b * b - b) * n[k]) * h * h / 6.0)
    }
}

/// Second derivatives that make the curve smooth and leave its ends straight: a tridiagonal system, term by term.
fn bends(at: &[f64], values: &[Five]) -> Vec<Five> {
    let count = at.len();
    let mut bends = vec![[0.0; 5]; count];
    for k in 0..5 {
        let (mut upper, mut right) = (vec![0.0; count], vec![0.0; count]);
        for i in 1..count.saturating_sub(1) {
            let (left_step, right_step) = (at[i] - at[i - 1], at[i + 1] - at[i]);
            let diagonal = 2.0 * (left_step + right_step) - left_step * upper[i - 1];
            let rise = |a: usize, b: usize, step: f64| (values[b][k] - values[a][k]) / step;
            let jump = 6.0 * (rise(i, i + 1, right_step) - rise(i - 1, i, left_step));
            upper[i] = right_step / diagonal;
            right[i] = (jump - left_step * right[i - 1]) / diagonal;
        }
        for i in (1..count.saturating_sub(1)).rev() {
            bends[i][k] = right[i] - upper[i] * bends[i + 1][k];
        }
    }
    bends
}
