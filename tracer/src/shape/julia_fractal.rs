//! SDL: `julia_fractal { <-0.08, 0, -0.83, -0.025> quaternion sqr max_iteration 8 precision 20 slice <0,0,0,1>, 0 }`.
//!
//! A point of the slice is inside if h -> f(h) + p, begun at it, stays near the origin `max_iteration` times: within
//! 1 + |p| for quaternions, 4 for hypercomplex numbers. A ray is followed in steps of 1 / `precision`, or wider ones far outside; where inside and
//! outside change, the place is found by halving. What is thinner than a step may be missed, as in POV-Ray.

use super::hypercomplex::{Function, Number};
use super::{Crossing, Primitive};
use crate::accel::Counters;
use crate::graph::shapes::{Algebra, JuliaFractal as Description};
use crate::math::polynomial::quadratic;
use crate::math::{vec3, Bounds, Ray, Vec3};

/// Nearer than this to the start nothing is seen.
const FINE: f64 = 1e-8;
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
        let numbers = fractal.parameter.iter().chain(&fractal.slice_normal);
        let numbers = numbers.chain([&fractal.slice_distance, &fractal.precision]);
        if numbers.into_iter().any(|number| number.is_nan()) {
            return None;
        }
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
        let size = h.norm();
        // What is no number any more has escaped.
        size > self.radius * self.radius || size.is_nan()
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

    /// Whether a point is inside, and how far to go from there: a step, or more outside. For quaternions |h| ln |h| / |h'|
    /// tells how far the surface is (here the derivative takes one more round, for caution); for hypercomplex numbers
    /// |h|² is followed down along the ray, as in POV-Ray. `path` is room for the h before.
    fn stride(&self, p: Vec3, direction: Vec3, path: &mut Vec<Number>) -> (bool, f64) {
        path.clear();
        let mut h = self.start(p);
        while !self.escaped(h) {
            if path.len() + 1 >= self.rounds as usize {
                return (true, self.step);
            }
            path.push(h);
            h = self.next(h);
        }
        let stride = match self.algebra {
            Algebra::Quaternion => {
                let growth: f64 = path.iter().map(|&at| self.stretch(at)).product();
                (h.norm() / (growth * self.stretch(h))).sqrt() * h.norm().ln()
            }
            Algebra::Hypercomplex => h.norm() / (-2.0 * self.gradient(h, path).dot(direction)),
        };
        (false, stride.max(self.step))
    }

    /// The square of the derivative's size.
    fn stretch(&self, h: Number) -> f64 {
        let size = h.norm();
        if self.function == Function::Cube {
            9.0 * size * size
        } else {
            4.0 * size
        }
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
        let mut path = Vec::new();
        let (mut inside, mut stride) = self.stride(unit.at(t), unit.direction, &mut path);
        if inside {
            // Begun on the surface, or within.
            t += 2.0 * FINE;
            (inside, stride) = self.stride(unit.at(t), unit.direction, &mut path);
        }
        let end = leave.min(limit * scale + self.step);
        loop {
            if t + stride > end || t + stride <= t {
                return limit;
            }
            let gone = stride;
            t += gone;
            let now;
            (now, stride) = self.stride(unit.at(t), unit.direction, &mut path);
            if now == inside {
                continue;
            }
            // The change lies within the last step.
            let (mut near, mut far) = (t - gone, t);
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
            (inside, stride) = self.stride(unit.at(t), unit.direction, &mut path);
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
