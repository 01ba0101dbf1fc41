//! SDL: `julia_fractal { <-0.08, 0, -0.83, -0.025> quaternion sqr max_iteration 8 precision 20 slice <0,0,0,1>, 0 }`.
//!
//! A point of the slice is inside if h -> f(h) + p, begun at it, stays near the origin `max_iteration` times: within
//! 1 + |p| for quaternions, 4 for hypercomplex numbers. A ray is followed in steps of 1 / `precision`, or wider ones far
//! outside; where inside and outside change, the place is found by halving. What is thinner than a step may be missed,
//! as in POV-Ray.

use super::hypercomplex::{Function, Number};
use super::{Crossing, Primitive};
use crate::accel::Counters;
use crate::graph::shapes::{Algebra, JuliaFractal as Description};
use crate::math::{vec3, Bounds, Ray, Vec3};

/// Nearer than this to the start nothing is seen.
const FINE: f64 = 1e-7;
/// So many steps are taken at once by hypercomplex functions, at most.
const WIDEST: f64 = 30.0;
/// A ray makes so many steps for a unit of length at most.
const MOST_STEPS: f64 = 5e3;

/// A slice of a Julia set.
#[derive(Clone, Debug)]
pub struct JuliaFractal {
    parameter: Number,
    algebra: Algebra,
    function: Function,
    rounds: usize,
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
            rounds: fractal.max_iteration.max(1) as usize,
            step: 1.0 / fractal.precision.clamp(1.0, MOST_STEPS),
            fourth: (fractal.slice_distance / d, vec3(a, b, c) * (-1.0 / d)),
            radius,
        })
    }

    /// The number that a point of the slice is.
    fn number(&self, p: Vec3) -> Number {
        Number([p.x, p.y, p.z, self.fourth.0 + self.fourth.1.dot(p)])
    }

    /// The number that is asked whether a point is inside: POV-Ray has y for z in it, but in `sqr` and `reciprocal`.
    fn asked(&self, p: Vec3) -> Number {
        let mut number = self.number(p);
        let well = matches!(self.function, Function::Sqr | Function::Reciprocal);
        if self.algebra == Algebra::Hypercomplex && !well {
            number.0[2] = p.y;
        }
        number
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

    /// Whether the numbers that follow one stay near the origin; `path` gets them, up to the first that does not.
    fn stays(&self, mut h: Number, path: &mut Path) -> bool {
        for round in 0..self.rounds {
            path.write(round, h);
            if self.escaped(h) {
                return false;
            }
            h = self.next(h);
        }
        path.write(self.rounds, h);
        true
    }

    /// Whether a point is inside, and how far to go from there: a step, or more outside. For quaternions |h| ln |h| / |h'|
    /// tells how far the surface is (here the derivative takes one more round, for caution); for hypercomplex numbers
    /// |h|² is followed down along the ray, as in POV-Ray.
    fn stride(&self, p: Vec3, direction: Vec3, path: &mut Path) -> (bool, f64) {
        if self.stays(self.number(p), path) {
            return (true, self.step);
        }
        let h = path.numbers[path.last];
        let stride = match self.algebra {
            Algebra::Quaternion => {
                let growth: f64 = path.numbers[..=path.last].iter().map(|&at| self.stretch(at)).product();
                (h.norm() / growth).sqrt() * h.norm().ln()
            }
            Algebra::Hypercomplex if self.function == Function::Sqr => {
                h.norm() / (-2.0 * self.gradient(path, path.last).dot(direction))
            }
            // The slope is a guess there, so that a wide stride is not believed.
            Algebra::Hypercomplex => Some(h.norm() / -self.gradient(path, path.last).dot(direction))
                .filter(|&stride| stride <= WIDEST * self.step)
                .unwrap_or(0.0),
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

    /// The gradient of |h|² / 2 in x, y, z after some rounds; as POV-Ray has it for hypercomplex functions, where the
    /// first round counts as that of `sqr`.
    fn gradient(&self, path: &Path, rounds: usize) -> Vec3 {
        let mut slope = path.numbers[rounds];
        for (round, &at) in path.numbers[..rounds].iter().enumerate().rev() {
            slope = match self.algebra {
                Algebra::Quaternion => self.function.slope_of_quaternion(at, slope),
                Algebra::Hypercomplex if round > 0 => self.function.slope_of_hypercomplex(at, slope),
                Algebra::Hypercomplex => slope,
            };
        }
        if self.algebra == Algebra::Hypercomplex {
            slope = Function::Sqr.slope_of_hypercomplex(path.numbers[0], slope);
        }
        let [x, y, z, w] = slope.0;
        vec3(x, y, z) + self.fourth.1 * w
    }
}

/// The numbers that follow one. Behind the last one stand those of an earlier path, and POV-Ray's normals know them.
#[derive(Default)]
struct Path {
    numbers: Vec<Number>,
    last: usize,
}

impl Path {
    fn write(&mut self, round: usize, number: Number) {
        if round < self.numbers.len() {
            self.numbers[round] = number;
        } else {
            self.numbers.push(number);
        }
        self.last = round;
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
        let length = ray.direction.length();
        // What is one but for rounding is left as it is: near the sphere of radius 4 each bit counts.
        let scale = if (length - 1.0).abs() < 1e-14 { 1.0 } else { length };
        let unit = Ray { direction: ray.direction / scale, ..*ray };
        let middle = -unit.origin.dot(unit.direction);
        let half = (self.radius * self.radius - unit.origin.length_squared() + middle * middle).sqrt();
        let (enter, leave) = (middle - half, middle + half);
        if half.is_nan() || leave < FINE {
            return limit;
        }
        let mut t = enter.max(FINE);
        let path = &mut Path::default();
        let (mut inside, mut stride) = self.stride(unit.at(t), unit.direction, path);
        if inside {
            // Begun on the surface, or within.
            t += 2.0 * FINE;
            (inside, stride) = self.stride(unit.at(t), unit.direction, path);
        }
        loop {
            // After a hit is taken nothing behind it is wanted.
            if t + stride > leave || t > limit * scale || t + stride <= t {
                return limit;
            }
            let before = t;
            let mut width = stride;
            t += stride;
            let now;
            (now, stride) = self.stride(unit.at(t), unit.direction, path);
            if now == inside {
                continue;
            }
            // The change lies within the last step.
            let mut near = before;
            let mut last = inside;
            while width > FINE {
                width *= 0.5;
                last = self.stays(self.asked(unit.at(near + width)), path);
                if last == inside {
                    near += width;
                }
            }
            if !inside {
                near += width;
            }
            if last != now || !inside {
                self.stays(self.asked(unit.at(near)), path);
            }
            let found = near / scale;
            if found > from && found <= limit {
                let normal = self.gradient(path, self.rounds.min(path.numbers.len() - 1));
                let normal =
                    Some(normal.normalized()).filter(|normal| normal.is_finite()).unwrap_or(unit.at(near));
                let crossing = Crossing { u: normal.y.atan2(normal.x), v: normal.z, ..Crossing::at(found) };
                limit = offer(crossing, limit);
            }
            inside = now;
        }
    }

    fn inside(&self, p: Vec3) -> bool {
        self.stays(self.asked(p), &mut Path::default())
    }

    fn normal(&self, _: Vec3, crossing: &Crossing) -> Vec3 {
        let across = (1.0 - crossing.v * crossing.v).max(0.0).sqrt();
        vec3(across * crossing.u.cos(), across * crossing.u.sin(), crossing.v)
    }
}
