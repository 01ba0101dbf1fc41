//! SDL: `poly { order, <coefficients> }`, `cubic`, `quartic`, `polynomial`.

use super::{offer_rising, Crossing, Primitive};
use crate::accel::Counters;
use crate::math::polynomial::{roots_within, Few, MAX_DEGREE};
use crate::math::{vec3, Bounds, Ray, Vec3};

/// Nearer crossings are not seen, as in POV-Ray; in the surface's own measure.
const NEAREST: f64 = 1e-4;
/// How far along a ray roots are sought.
const FAR: f64 = 1e7;

/// One term: a coefficient and the powers of x, y, z.
#[derive(Clone, Copy, Debug)]
struct Term {
    coefficient: f64,
    powers: [usize; 3],
}

/// The points where a polynomial of x, y, z is negative.
#[derive(Clone, Debug)]
pub struct Poly {
    order: usize,
    terms: Vec<Term>,
}

impl Poly {
    /// Coefficients by falling power of x, then y, then z.
    pub fn new(order: usize, coefficients: &[f64]) -> Poly {
        let mut coefficients = coefficients.iter();
        let mut terms = Vec::new();
        for x in (0..=order).rev() {
            for y in (0..=order - x).rev() {
                for z in (0..=order - x - y).rev() {
                    let coefficient = coefficients.next().copied().unwrap_or(0.0);
                    if coefficient != 0.0 {
                        terms.push(Term { coefficient, powers: [x, y, z] });
                    }
                }
            }
        }
        Poly { order: order.min(MAX_DEGREE), terms }
    }

    fn value(&self, p: Vec3) -> f64 {
        let power = |v: f64, n: usize| v.powi(n as i32);
        self.terms
            .iter()
            .map(|t| {
                t.coefficient * power(p.x, t.powers[0]) * power(p.y, t.powers[1]) * power(p.z, t.powers[2])
            })
            .sum()
    }

    /// The polynomial of the ray's parameter, by rising power.
    fn along(&self, o: Vec3, d: Vec3) -> [f64; MAX_DEGREE + 1] {
        // Powers of each coordinate as polynomials of the parameter.
        let mut sum = [0.0; MAX_DEGREE + 1];
        for term in &self.terms {
            let mut product = [0.0; MAX_DEGREE + 1];
            product[0] = term.coefficient;
            let mut degree = 0;
            for axis in 0..3 {
                for _ in 0..term.powers[axis] {
                    degree += 1;
                    for k in (1..=degree).rev() {
                        product[k] = product[k] * o[axis] + product[k - 1] * d[axis];
                    }
                    product[0] *= o[axis];
                }
            }
            for (s, p) in sum.iter_mut().zip(&product[..=degree]) {
                *s += p;
            }
        }
        sum
    }
}

impl Primitive for Poly {
    fn bounds(&self) -> Bounds {
        Bounds::INFINITE
    }

    fn intersect(
        &self,
        ray: &Ray,
        from: f64,
        limit: f64,
        _counters: &mut Counters,
        offer: &mut impl FnMut(Crossing, f64) -> f64,
    ) -> f64 {
        let scale = ray.direction.length();
        let d = ray.direction / scale;
        let from = from.max(NEAREST / scale);
        // Around the point nearest to the origin, where the interesting part of such surfaces lies.
        let start = -ray.origin.dot(d);
        let polynomial = self.along(ray.origin + d * start, d);
        let high = (limit * scale).min(FAR) - start;
        let roots: Few<{ MAX_DEGREE + 1 }> =
            roots_within(&polynomial[..=self.order], from * scale - start, high);
        offer_rising(roots.iter().map(|t| Crossing::at((t + start) / scale)), from, limit, offer)
    }

    fn inside(&self, p: Vec3) -> bool {
        self.value(p) <= 0.0
    }

    fn normal(&self, p: Vec3, _: &Crossing) -> Vec3 {
        let mut gradient = Vec3::ZERO;
        for term in &self.terms {
            for axis in 0..3 {
                let mut slope = term.coefficient;
                for other in 0..3 {
                    let n = term.powers[other];
                    slope *= if other != axis {
                        p[other].powi(n as i32)
                    } else if n == 0 {
                        0.0
                    } else {
                        n as f64 * p[other].powi(n as i32 - 1)
                    };
                }
                gradient[axis] += slope;
            }
        }
        if gradient.length_squared() == 0.0 {
            vec3(1.0, 0.0, 0.0)
        } else {
            gradient
        }
    }
}
