//! SDL: `julia_fractal { <-0.08, 0, -0.83, -0.025> quaternion sqr max_iteration 8 precision 20 slice <0,0,0,1>, 0 }`.
//!
//! A point of the slice is inside if h -> f(h) + p, begun at it, stays near the origin `max_iteration` times: within
//! 1 + |p| for quaternions, 4 for hypercomplex numbers. A ray is followed in steps of 1 / `precision`; where inside and
//! outside change, the place is found by halving. What is thinner than a step may be missed, as in POV-Ray.

use super::hypercomplex::{Function, Number};
use super::{Crossing, Primitive};
use crate::accel::Counters;
use crate::graph::shapes::{Algebra, JuliaFractal as Description};
use crate::math::polynomial::quadratic;
use crate::math::{vec3, Bounds, Ray, Vec3};

/// Nearer than this to the start nothing is seen.
const FINE: f64 = 1e-8;
/// Share of the way to where |h|² would be small enough, if it fell evenly, that is safe to go.
const CAUTION: f64 = 0.5;
/// How often the step in which something changed is halved.
const HALVINGS: usize = 26;
/// A ray makes so many steps for a unit of length at most.
const MOST_STEPS: f64 = 1e5;

/// A slice of a Julia set.
#[derive(Clone, Debug)]
pub struct JuliaFractal {
    parameter: Number,
    algebra: Algebra,
    function: Function,
    rounds: i32,
    /// How far a ray goes at a time.
    step: f64,
    /// The fourth coordinate of the slice's points: a constant and its change with x, y, z.
    fourth: (f64, Vec3),
    /// Farther out a point has escaped.
    radius: f64,
}

impl JuliaFractal {
    /// From SDL's numbers; `None` if there is no such function.
    pub fn new(fractal: &Description) -> Option<JuliaFractal> {
        let parameter = Number(fractal.parameter);
        let function = match fractal.algebra {
            Algebra::Quaternion => Function::named(&fractal.function, fractal.exponent)?,
            // As POV-Ray does it.
            Algebra::Hypercomplex if fractal.function == "cube" => Function::Sqr,
            Algebra::Hypercomplex => Function::named(&fractal.function, fractal.exponent)?,
        };
        let radius = match fractal.algebra {
            Algebra::Quaternion => 1.0 + parameter.norm().sqrt(),
            Algebra::Hypercomplex => 4.0,
        };
        let [a, b, c, d] = fractal.slice_normal;
        Some(JuliaFractal {
            parameter,
            algebra: fractal.algebra,
            function,
            rounds: fractal.max_iteration.max(1),
            step: 1.0 / fractal.precision.clamp(1.0, MOST_STEPS),
            fourth: (fractal.slice_distance / d, vec3(a, b, c) * (-1.0 / d)),
            radius,
        })
    }

    fn start(&self, p: Vec3) -> Number {
        Number([p.x, p.y, p.z, self.fourth.0 + self.fourth.1.dot(p)])
    }

    fn escaped(&self, h: Number) -> bool {
        // Not `>`: what is no number any more has escaped.
        !(h.norm() <= self.radius * self.radius)
    }

    fn next(&self, h: Number) -> Number {
        let image = match self.algebra {
            Algebra::Quaternion => self.function.of_quaternion(h),
            Algebra::Hypercomplex => self.function.of_hypercomplex(h),
        };
        image.plus(self.parameter)
    }

    fn stays(&self, p: Vec3) -> bool {
        let mut h = self.start(p);
        for _ in 1..self.rounds {
            if self.escaped(h) {
                return false;
            }
            h = self.next(h);
        }
        !self.escaped(h)
    }

    /// How far to go from a point outside: a step, or more where h is fast to escape, for there the growth of |h|² tells
    /// how far the surface is at least.
    fn stride(&self, p: Vec3) -> f64 {
        let start = self.start(p);
        let (path, h) = if self.escaped(start) { (&[][..], start) } else { (&[start][..], self.next(start)) };
        if !self.escaped(h) {
            return self.step;
        }
        let slope = 2.0 * self.gradient(h, path).length();
        (CAUTION * (h.norm() - self.radius * self.radius) / slope).max(self.step)
    }

    /// The gradient of |h|² / 2 in x, y, z, for the h that follows `path`.
    fn gradient(&self, h: Number, path: &[Number]) -> Vec3 {
        let mut slope = h;
        for &at in path.iter().rev() {
            slope = match self.algebra {
                Algebra::Quaternion => self.function.slope_of_quaternion(at, slope),
                Algebra::Hypercomplex => self.function.slope_of_hypercomplex(at, slope),
            };
        }
        let [x, y, z, w] = slope.0;
        vec3(x, y, z) + self.fourth.1 * w
    }
}

impl Primitive for JuliaFractal {
    fn bounds(&self) -> Bounds {
        Bounds { min: Vec3::splat(-self.radius), max: Vec3::splat(self.radius) }
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
        let unit = Ray { direction: ray.direction / scale, ..*ray };
        let square = unit.origin.length_squared() - self.radius * self.radius;
        let span = quadratic(1.0, unit.origin.dot(unit.direction), square);
        let [enter, leave] = span[..] else { return limit };
        if leave < FINE {
            return limit;
        }
        let mut t = enter.max(FINE);
        let mut inside = self.stays(unit.at(t));
        if inside {
            // Begun on the surface, or within.
            t += 2.0 * FINE;
            inside = self.stays(unit.at(t));
        }
        let end = leave.min(limit * scale + self.step);
        loop {
            let stride = if inside { self.step } else { self.stride(unit.at(t)) };
            if t + stride > end || t + stride <= t {
                return limit;
            }
            t += stride;
            if self.stays(unit.at(t)) == inside {
                continue;
            }
            // The change lies within the last step.
            let (mut near, mut far) = (t - stride, t);
            for _ in 0..HALVINGS {
                let middle = 0.5 * (near + far);
                if self.stays(unit.at(middle)) == inside {
                    near = middle;
                } else {
                    far = middle;
                }
            }
            let found = far / scale;
            if found > from && found <= limit {
                limit = offer(Crossing::at(found), limit);
            }
            t = far;
            inside = !inside;
        }
    }

    fn inside(&self, p: Vec3) -> bool {
        p.length_squared() <= self.radius * self.radius && self.stays(p)
    }

    /// The slope of |h|² after all rounds.
    fn normal(&self, p: Vec3, _: &Crossing) -> Vec3 {
        let mut path = Vec::new();
        let mut h = self.start(p);
        for _ in 0..self.rounds {
            path.push(h);
            h = self.next(h);
            if self.escaped(h) {
                break;
            }
        }
        let normal = self.gradient(h, &path);
        if normal.is_finite() && normal.length_squared() > 0.0 {
            normal
        } else {
            p
        }
    }
}
