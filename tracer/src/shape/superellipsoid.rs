//! SDL: `superellipsoid { <e, n> }`: (|x|^(2/e) + |y|^(2/e))^(e/n) + |z|^(2/n) = 1.

use super::{Crossing, Primitive};
use crate::accel::Counters;
use crate::math::{vec3, Bounds, Ray, Vec3};

/// Nearer crossings are not seen, as in POV-Ray; in the shape's own measure.
const NEAREST: f64 = 1e-4;
/// The box is a little wider than the shape, as in POV-Ray.
const REACH: f64 = 1.0001;

/// A value above this is no rounding error.
const SURE: f64 = 1e-12;

/// A place on the ray and the value there.
type Sample = (f64, f64);

/// Something between a box, a ball, a cylinder and a star.
#[derive(Clone, Debug)]
pub struct Superellipsoid {
    /// 2 / e.
    around: f64,
    /// e / n.
    joint: f64,
    /// 2 / n.
    along: f64,
}

impl Superellipsoid {
    /// From SDL's exponents, both above zero.
    pub fn new(e: f64, n: f64) -> Superellipsoid {
        Superellipsoid { around: 2.0 / e, joint: e / n, along: 2.0 / n }
    }

    fn value(&self, p: Vec3) -> f64 {
        let flat = p.x.abs().powf(self.around) + p.y.abs().powf(self.around);
        flat.powf(self.joint) + p.z.abs().powf(self.along) - 1.0
    }

    /// The parameter between a and b where the sign changes.
    fn root(&self, ray: &Ray, (mut a, mut fa): Sample, (mut b, mut fb): Sample) -> f64 {
        for _ in 0..200 {
            // Illinois: false position that halves the weight of an end that stays.
            let m = (a * fb - b * fa) / (fb - fa);
            let m = if m > a && m < b { m } else { 0.5 * (a + b) };
            let fm = self.value(ray.at(m));
            if fm == 0.0 || b - a < 1e-13 * (1.0 + m.abs()) {
                return m;
            }
            if (fm < 0.0) == (fa < 0.0) {
                (a, fa) = (m, fm);
                fb *= 0.5;
            } else {
                (b, fb) = (m, fm);
                fa *= 0.5;
            }
            if fa.abs() < 1e-300 || fb.abs() < 1e-300 {
                return m;
            }
        }
        0.5 * (a + b)
    }

    /// A negative value between a and b, looked for by golden sections.
    fn lowest(&self, ray: &Ray, (mut a, mut fa): Sample, (mut b, mut fb): Sample) -> Option<Sample> {
        const GOLDEN: f64 = 0.618_033_988_749_894_8;
        let f = |t: f64| self.value(ray.at(t));
        // Then the value is a convex function along the ray.
        let convex = self.around >= 1.0 && self.along >= 1.0;
        let (mut p, mut q) = (b - GOLDEN * (b - a), a + GOLDEN * (b - a));
        let (mut fp, mut fq) = (f(p), f(q));
        for _ in 0..40 {
            if fp < 0.0 {
                return Some((p, fp));
            }
            if fq < 0.0 {
                return Some((q, fq));
            }
            if convex && least([(a, fa), (p, fp), (q, fq), (b, fb)]) > SURE {
                return None;
            }
            if fp < fq {
                (b, fb, q, fq) = (q, fq, p, fp);
                p = b - GOLDEN * (b - a);
                fp = f(p);
            } else {
                (a, fa, p, fp) = (p, fp, q, fq);
                q = a + GOLDEN * (b - a);
                fq = f(q);
            }
        }
        None
    }
}

/// What no convex function through four places falls below between the first and the last: each secant, made longer,
/// lies below the function.
fn least([a, p, q, b]: [Sample; 4]) -> f64 {
    let slope = |(s, fs): Sample, (t, ft): Sample| (ft - fs) / (t - s);
    let (before, between, behind) = (slope(a, p), slope(p, q), slope(q, b));
    let first = p.1 - between.max(0.0) * (p.0 - a.0);
    let last = q.1 + between.min(0.0) * (b.0 - q.0);
    let length = q.0 - p.0;
    let middle = (p.1 + before.min(0.0) * length).max(q.1 - behind.max(0.0) * length);
    first.min(last).min(middle)
}

impl Primitive for Superellipsoid {
    fn bounds(&self) -> Bounds {
        Bounds { min: Vec3::splat(-REACH), max: Vec3::splat(REACH) }
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
        let from = from.max(NEAREST / scale);
        let (mut enter, mut leave) = (from, limit);
        for axis in 0..3 {
            let (o, d) = (ray.origin[axis], ray.direction[axis]);
            if d == 0.0 {
                if o.abs() > REACH {
                    return limit;
                }
                continue;
            }
            let (a, b) = ((-REACH - o) / d, (REACH - o) / d);
            (enter, leave) = (enter.max(a.min(b)), leave.min(a.max(b)));
        }
        if enter >= leave {
            return limit;
        }
        // Between the planes of symmetry the value has one dip at most.
        let mut ends = [leave; 11];
        ends[0] = enter;
        let mut count = 1;
        let (o, d) = (ray.origin, ray.direction);
        let planes = [
            (o.x, d.x),
            (o.y, d.y),
            (o.z, d.z),
            (o.x - o.y, d.x - d.y),
            (o.x + o.y, d.x + d.y),
            (o.x - o.z, d.x - d.z),
            (o.x + o.z, d.x + d.z),
            (o.y - o.z, d.y - d.z),
            (o.y + o.z, d.y + d.z),
        ];
        for (at, slope) in planes {
            let t = -at / slope;
            if t > enter && t < leave {
                ends[count] = t;
                count += 1;
            }
        }
        ends[1..count].sort_unstable_by(f64::total_cmp);
        for pair in ends[..=count].windows(2) {
            let (a, b) = (pair[0], pair[1]);
            if a > limit || a >= b {
                continue;
            }
            let (a, b) = ((a, self.value(ray.at(a))), (b, self.value(ray.at(b))));
            let mut found = |a: Sample, b: Sample, limit: f64| {
                let t = self.root(ray, a, b);
                if t > from && t <= limit {
                    offer(Crossing::at(t), limit)
                } else {
                    limit
                }
            };
            if (a.1 < 0.0) != (b.1 < 0.0) {
                limit = found(a, b, limit);
            } else if a.1 >= 0.0 {
                if let Some(dip) = self.lowest(ray, a, b) {
                    limit = found(a, dip, limit);
                    limit = found(dip, b, limit);
                }
            }
        }
        limit
    }

    fn inside(&self, p: Vec3) -> bool {
        self.value(p) < 0.0
    }

    fn normal(&self, p: Vec3, _: &Crossing) -> Vec3 {
        let power = |v: f64, k: f64| v.abs().powf(k - 1.0).copysign(v);
        let flat = p.x.abs().powf(self.around) + p.y.abs().powf(self.around);
        let outer = if flat > 0.0 { flat.powf(self.joint - 1.0) } else { 0.0 };
        let n =
            vec3(outer * power(p.x, self.around), outer * power(p.y, self.around), power(p.z, self.along));
        if n.is_finite() && n.length_squared() > 0.0 {
            n
        } else {
            p
        }
    }
}
