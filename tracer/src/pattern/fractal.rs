//! SDL: `mandel I`, `julia V, I`, `magnet 1|2 mandel I | julia V, I`, `exponent I`, `exterior I, F`, `interior I, F`:
//! how long the iteration of a complex number stays near.

use crate::graph::pattern as graph;
use crate::math::Vec3;

/// Beyond this, squared, an iteration is known to run away; for the magnets it is far away.
const FAR: f64 = 4.0;
const FAR_MAGNET: f64 = 10_000.0;

/// Parameters of a fractal pattern.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fractal {
    max_iteration: u32,
    /// The constant of a Julia set; None for the Mandelbrot kind, where each place has its own.
    coordinate: Option<Complex>,
    /// Which formula for magnetism; 0 for powers.
    magnet: u8,
    exponent: u32,
    exterior: (u8, f64),
    interior: (u8, f64),
}

#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Complex {
    re: f64,
    im: f64,
}

impl From<&graph::Fractal> for Fractal {
    fn from(node: &graph::Fractal) -> Fractal {
        Fractal {
            max_iteration: node.max_iteration,
            coordinate: node.coordinate.map(|[re, im]| Complex { re, im }),
            magnet: node.magnet,
            exponent: node.exponent,
            exterior: node.exterior,
            interior: node.interior,
        }
    }
}

impl Fractal {
    /// The Mandelbrot set proper, which has a colour map of its own.
    pub fn is_plain_mandel(&self) -> bool {
        self.magnet == 0 && self.exponent == 2 && self.coordinate.is_none()
    }

    /// The value at `p`, of which x and y count.
    pub fn value(&self, p: Vec3) -> f64 {
        let place = Complex { re: p.x, im: p.y };
        let c = self.coordinate.unwrap_or(place);
        let starts_at_zero = self.magnet != 0 && self.coordinate.is_none();
        let mut z = if starts_at_zero { Complex::default() } else { place };
        let mut nearest = if starts_at_zero { FAR_MAGNET } else { z.size_squared() };
        for iteration in 0..self.max_iteration {
            z = self.step(z, c);
            let size = z.size_squared();
            nearest = nearest.min(size);
            let escapes = match self.magnet {
                0 => size > FAR,
                _ => size > FAR_MAGNET || z.minus(1.0).size_squared() < 1.0 / FAR_MAGNET,
            };
            if escapes {
                return self.outside(iteration, z);
            }
        }
        let (kind, factor) = self.interior;
        match kind {
            1 => nearest.sqrt() * factor,
            // Neither the root nor the factor are taken of the whole, unlike outside (probed).
            6 => z.re * z.re + z.im * z.im * factor,
            _ => z.number(kind) * factor,
        }
    }

    fn step(&self, z: Complex, c: Complex) -> Complex {
        match self.magnet {
            0 => (1..self.exponent).fold(z, |power, _| power.times(z)).plus(c),
            1 => {
                let above = z.times(z).plus(c).minus(1.0);
                above.over(z.plus(z).plus(c).minus(2.0)).square()
            }
            _ => {
                let (c1, c2) = (c.minus(1.0), c.minus(2.0));
                let rest = c1.times(c2);
                let triple = |v: Complex| v.plus(v).plus(v);
                let above = z.times(z).times(z).plus(triple(c1.times(z))).plus(rest);
                let below = triple(z.times(z)).plus(triple(c2.times(z))).plus(rest).minus(-1.0);
                above.over(below).square()
            }
        }
    }

    fn outside(&self, iteration: u32, z: Complex) -> f64 {
        let (kind, factor) = self.exterior;
        let cycle =
            |length: f64| if length >= 1.0 { f64::from(iteration % length as u32) / factor } else { 0.0 };
        match kind {
            1 => f64::from(iteration) / f64::from(self.max_iteration),
            7 => cycle(factor),
            8 => cycle(factor + 1.0),
            _ => factor * z.number(kind),
        }
    }
}

impl Complex {
    fn plus(self, o: Complex) -> Complex {
        Complex { re: self.re + o.re, im: self.im + o.im }
    }

    fn minus(self, real: f64) -> Complex {
        Complex { re: self.re - real, im: self.im }
    }

    fn times(self, o: Complex) -> Complex {
        Complex { re: self.re * o.re - self.im * o.im, im: self.re * o.im + self.im * o.re }
    }

    fn square(self) -> Complex {
        self.times(self)
    }

    fn over(self, o: Complex) -> Complex {
        let size = o.size_squared();
        let turned = self.times(Complex { re: o.re, im: -o.im });
        Complex { re: turned.re / size, im: turned.im / size }
    }

    fn size_squared(self) -> f64 {
        self.re * self.re + self.im * self.im
    }

    /// What `exterior` and `interior` say of the last number.
    fn number(self, kind: u8) -> f64 {
        match kind {
            2 => self.re,
            3 => self.im,
            4 => self.re * self.re,
            5 => self.im * self.im,
            6 => self.size_squared().sqrt(),
            _ => 1.0,
        }
    }
}
