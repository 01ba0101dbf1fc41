//! Numbers of four parts, and the functions that `julia_fractal` iterates.
//!
//! A hypercomplex number is two complex numbers in other coordinates: functions, products and slopes work on each alone.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// A complex number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Complex {
    re: f64,
    im: f64,
}

const I: Complex = Complex { re: 0.0, im: 1.0 };
const ONE: Complex = Complex { re: 1.0, im: 0.0 };

macro_rules! operator {
    ($trait:ident, $method:ident, |$a:ident, $b:ident| $result:expr) => {
        impl $trait for Complex {
            type Output = Complex;
            #[inline]
            fn $method(self, other: Complex) -> Complex {
                let ($a, $b) = (self, other);
                $result
            }
        }
    };
}

operator!(Add, add, |a, b| Complex { re: a.re + b.re, im: a.im + b.im });
operator!(Sub, sub, |a, b| Complex { re: a.re - b.re, im: a.im - b.im });
operator!(Mul, mul, |a, b| Complex { re: a.re * b.re - a.im * b.im, im: a.re * b.im + a.im * b.re });
operator!(Div, div, |a, b| {
    let scale = 1.0 / (b.re * b.re + b.im * b.im);
    a * b.conjugate() * scale
});

impl Neg for Complex {
    type Output = Complex;
    fn neg(self) -> Complex {
        self * -1.0
    }
}

impl Mul<f64> for Complex {
    type Output = Complex;
    fn mul(self, factor: f64) -> Complex {
        Complex { re: self.re * factor, im: self.im * factor }
    }
}

impl Complex {
    fn conjugate(self) -> Complex {
        Complex { im: -self.im, ..self }
    }

    #[inline]
    fn square(self) -> Complex {
        self * self
    }

    fn exp(self) -> Complex {
        Complex { re: self.im.cos(), im: self.im.sin() } * self.re.exp()
    }

    fn ln(self) -> Complex {
        Complex { re: self.re.hypot(self.im).ln(), im: self.im.atan2(self.re) }
    }

    fn sqrt(self) -> Complex {
        let size = self.re.hypot(self.im);
        let re = (0.5 * (size + self.re)).max(0.0).sqrt();
        Complex { re, im: (0.5 * (size - self.re)).max(0.0).sqrt().copysign(self.im) }
    }

    fn sinh(self) -> Complex {
        (self.exp() - (-self).exp()) * 0.5
    }

    fn cosh(self) -> Complex {
        (self.exp() + (-self).exp()) * 0.5
    }

    fn asinh(self) -> Complex {
        (self + (self.square() + ONE).sqrt()).ln()
    }

    fn acosh(self) -> Complex {
        (self + (self.square() - ONE).sqrt()).ln()
    }

    fn atanh(self) -> Complex {
        ((ONE + self) / (ONE - self)).ln() * 0.5
    }
}

/// SDL's functions.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(missing_docs)]
pub enum Function {
    Sqr,
    Cube,
    Exp,
    Reciprocal,
    Sin,
    Asin,
    Sinh,
    Asinh,
    Cos,
    Acos,
    Cosh,
    Acosh,
    Tan,
    Atan,
    Tanh,
    Atanh,
    Ln,
    Pwr(Complex),
}

impl Function {
    /// By SDL's name; `exponent` is that of `pwr`.
    pub fn named(name: &str, exponent: [f64; 2]) -> Option<Function> {
        use Function::*;
        let [re, im] = exponent;
        Some(match name {
            "sqr" => Sqr,
            "cube" => Cube,
            "exp" => Exp,
            "reciprocal" => Reciprocal,
            "sin" => Sin,
            "asin" => Asin,
            "sinh" => Sinh,
            "asinh" => Asinh,
            "cos" => Cos,
            "acos" => Acos,
            "cosh" => Cosh,
            "acosh" => Acosh,
            "tan" => Tan,
            "atan" => Atan,
            "tanh" => Tanh,
            "atanh" => Atanh,
            "ln" | "log" => Ln,
            "pwr" => Pwr(Complex { re, im }),
            _ => return None,
        })
    }

    #[inline]
    fn of(self, z: Complex) -> Complex {
        use Function::*;
        match self {
            Sqr => z.square(),
            Cube => z.square() * z,
            Exp => z.exp(),
            Reciprocal => ONE / z,
            Sin => -I * (I * z).sinh(),
            Asin => -I * (I * z).asinh(),
            Sinh => z.sinh(),
            Asinh => z.asinh(),
            Cos => (I * z).cosh(),
            Acos => -I * z.acosh(),
            Cosh => z.cosh(),
            Acosh => z.acosh(),
            Tan => Sin.of(z) / Cos.of(z),
            Atan => -I * (I * z).atanh(),
            Tanh => z.sinh() / z.cosh(),
            Atanh => z.atanh(),
            Ln => z.ln(),
            Pwr(exponent) => (exponent * z.ln()).exp(),
        }
    }

    /// What POV-Ray takes for the derivative: outside `sqr` and `reciprocal` it is the function itself.
    fn slope(self, z: Complex) -> Complex {
        match self {
            Function::Sqr => z * 2.0,
            Function::Reciprocal => -ONE / z.square(),
            _ => self.of(z),
        }
    }

    /// Image of a quaternion. Only `sqr` and `cube` are known to quaternions.
    #[inline]
    pub fn of_quaternion(self, h: Number) -> Number {
        let [a, x, y, z] = h.0;
        let size = x * x + y * y + z * z;
        let (real, share) = if self == Function::Cube {
            (a * (a * a - 3.0 * size), 3.0 * a * a - size)
        } else {
            (a * a - size, 2.0 * a)
        };
        Number([real, share * x, share * y, share * z])
    }

    /// The gradient before the function from the gradient behind it.
    pub fn slope_of_quaternion(self, h: Number, behind: Number) -> Number {
        let ([a, x, y, z], [ga, gx, gy, gz]) = (h.0, behind.0);
        let size = x * x + y * y + z * z;
        let along = x * gx + y * gy + z * gz;
        // The image is (r(a, s), q(a, s) v) with s = |v|².
        let (r_a, r_s, q, q_a, q_s) = if self == Function::Cube {
            (3.0 * (a * a - size), -3.0 * a, 3.0 * a * a - size, 6.0 * a, -1.0)
        } else {
            (2.0 * a, -1.0, 2.0 * a, 2.0, 0.0)
        };
        let to_vector = 2.0 * (r_s * ga + q_s * along);
        Number([
            r_a * ga + q_a * along,
            to_vector * x + q * gx,
            to_vector * y + q * gy,
            to_vector * z + q * gz,
        ])
    }

    /// Image of a hypercomplex number.
    #[inline]
    pub fn of_hypercomplex(self, h: Number) -> Number {
        let [a, b] = h.pair();
        Number::from_pair([self.of(a), self.of(b)])
    }

    /// The gradient before the function from the gradient behind it.
    pub fn slope_of_hypercomplex(self, h: Number, behind: Number) -> Number {
        let ([a, b], [ga, gb]) = (h.pair(), behind.pair());
        Number::from_pair([ga * self.slope(a).conjugate(), gb * self.slope(b).conjugate()])
    }
}

/// A quaternion or hypercomplex number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Number(pub [f64; 4]);

impl Number {
    /// Sum of both.
    #[inline]
    pub fn plus(self, other: Number) -> Number {
        let ([a, b, c, d], [e, f, g, h]) = (self.0, other.0);
        Number([a + e, b + f, c + g, d + h])
    }

    /// Squared distance from 0.
    #[inline]
    pub fn norm(self) -> f64 {
        let [a, b, c, d] = self.0;
        a * a + b * b + c * c + d * d
    }

    /// The two complex numbers that a hypercomplex one is.
    #[inline]
    fn pair(self) -> [Complex; 2] {
        let [x, y, z, w] = self.0;
        [Complex { re: x - w, im: y + z }, Complex { re: x + w, im: y - z }]
    }

    #[inline]
    fn from_pair([a, b]: [Complex; 2]) -> Number {
        Number([0.5 * (a.re + b.re), 0.5 * (a.im + b.im), 0.5 * (a.im - b.im), 0.5 * (b.re - a.re)])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::Random;

    /// The gradient of |f(h)|² / 2 is what finite differences give.
    #[test]
    fn slopes_are_slopes() {
        let mut random = Random::new(5);
        for name in ["sqr", "cube"] {
            let function = Function::named(name, [0.0; 2]).unwrap();
            for _ in 0..20 {
                let h = Number(std::array::from_fn(|_| random.unit() * 0.8 + 0.1));
                let check = |f: &dyn Fn(Number) -> Number, slope: Number| {
                    for axis in 0..4 {
                        let moved = |by: f64| {
                            let mut m = h;
                            m.0[axis] += by;
                            0.5 * f(m).norm()
                        };
                        let difference = (moved(1e-6) - moved(-1e-6)) / 2e-6;
                        let wanted = slope.0[axis];
                        assert!((difference - wanted).abs() < 1e-4 * (1.0 + wanted.abs()), "{name} {h:?}");
                    }
                };
                let f = |h| function.of_quaternion(h);
                check(&f, function.slope_of_quaternion(h, f(h)));
                if function == Function::Sqr {
                    let f = |h| function.of_hypercomplex(h);
                    check(&f, function.slope_of_hypercomplex(h, f(h)));
                }
            }
        }
    }

    /// Values that POV-Ray gives for <0.5, 0.3, 0.3, 0>.
    #[test]
    fn functions_are_those_of_pov_ray() {
        let h = Number([0.5, 0.3, 0.3, 0.0]);
        let known = [
            ("exp", [1.504735, 0.465469, 0.465469, 0.143986]),
            ("sin", [0.523884, 0.279358, 0.279358, -0.044458]),
            ("asin", [0.477015, 0.309887, 0.309887, 0.046584]),
            ("acosh", [0.309887, 1.093782, 0.046584, -0.309887]),
            ("tan", [0.452115, 0.321031, 0.321031, 0.094188]),
            ("ln", [-0.470148, 0.438029, 0.438029, -0.223000]),
            ("pwr", [0.259169, 0.214468, 0.287459, 0.086768]),
        ];
        for (name, wanted) in known {
            let image = Function::named(name, [1.5, 0.3]).unwrap().of_hypercomplex(h);
            let far = (0..4).any(|k| (image.0[k] - wanted[k]).abs() > 2e-6);
            assert!(!far, "{name} {image:?}");
        }
    }
}
