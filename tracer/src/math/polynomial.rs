//! Real roots of polynomials within an interval, without guesses.
//!
//! Between two neighbouring roots of its derivative a polynomial is monotone, so it has a root there exactly when its
//! signs at the ends differ. Starting from the linear derivative, each level brackets the roots of the next one.

/// Highest degree that can be solved (`poly` allows 35).
pub const MAX_DEGREE: usize = 35;

/// Values in a fixed array.
#[derive(Clone, Copy, Debug)]
pub struct Few<const N: usize> {
    values: [f64; N],
    len: usize,
}

impl<const N: usize> Few<N> {
    /// None yet.
    pub fn new() -> Few<N> {
        Few { values: [0.0; N], len: 0 }
    }

    /// Adds one; beyond the capacity it is lost.
    #[inline]
    pub fn push(&mut self, value: f64) {
        if self.len < N {
            self.values[self.len] = value;
            self.len += 1;
        }
    }
}

impl<const N: usize> Default for Few<N> {
    fn default() -> Self {
        Few::new()
    }
}

impl<const N: usize> std::ops::Deref for Few<N> {
    type Target = [f64];
    fn deref(&self) -> &[f64] {
        &self.values[..self.len]
    }
}

impl<const N: usize> std::ops::DerefMut for Few<N> {
    fn deref_mut(&mut self) -> &mut [f64] {
        &mut self.values[..self.len]
    }
}

/// Value of the polynomial; coefficients by rising power.
#[inline]
pub fn value(coefficients: &[f64], x: f64) -> f64 {
    coefficients.iter().rev().fold(0.0, |sum, c| sum * x + c)
}

/// Value and slope.
#[inline]
fn value_and_slope(coefficients: &[f64], x: f64) -> (f64, f64) {
    coefficients.iter().rev().fold((0.0, 0.0), |(sum, slope), c| (sum * x + c, slope * x + sum))
}

/// The root between `a` and `b`, where the signs differ: Newton's steps, halving where they leave the bracket.
fn refine(coefficients: &[f64], mut a: f64, mut b: f64, rising: bool) -> f64 {
    let mut x = 0.5 * (a + b);
    for _ in 0..100 {
        let (y, slope) = value_and_slope(coefficients, x);
        if y == 0.0 {
            return x;
        }
        if (y < 0.0) == rising {
            a = x;
        } else {
            b = x;
        }
        let newton = x - y / slope;
        let next = if newton > a && newton < b { newton } else { 0.5 * (a + b) };
        if (next - x).abs() <= 1e-15 * (1.0 + x.abs()) || b - a <= 1e-15 * (1.0 + x.abs()) {
            return next;
        }
        x = next;
    }
    x
}

/// Roots of odd multiplicity between `low` and `high`, in rising order. Coefficients by rising power; `N` must exceed
/// the degree.
pub fn roots_within<const N: usize>(coefficients: &[f64], low: f64, high: f64) -> Few<N> {
    let mut degree = coefficients.len().saturating_sub(1);
    while degree > 0 && coefficients[degree] == 0.0 {
        degree -= 1;
    }
    let mut roots = Few::<N>::new();
    // derived holds the k-th derivative while roots holds the roots of the (k+1)-th.
    for k in (0..degree).rev() {
        let mut derived = [0.0; N];
        let derived = &mut derived[..=degree - k];
        for (i, d) in derived.iter_mut().enumerate() {
            *d = (1..=k).fold(coefficients[i + k], |c, j| c * (i + j) as f64 / j as f64);
        }
        let mut found = Few::<N>::new();
        let mut a = low;
        let mut at_a = value(derived, a);
        for i in 0..=roots.len() {
            let b = roots.get(i).copied().unwrap_or(high);
            let at_b = value(derived, b);
            if (at_a < 0.0) != (at_b < 0.0) {
                found.push(refine(derived, a, b, at_a < 0.0));
            }
            (a, at_a) = (b, at_b);
        }
        roots = found;
    }
    roots
}

/// Both roots of a x² + 2 b x + c in rising order, or the one of a line.
#[inline]
pub fn quadratic(a: f64, b: f64, c: f64) -> Few<2> {
    let mut roots = Few::new();
    if a == 0.0 {
        if b != 0.0 {
            roots.push(-c / (2.0 * b));
        }
        return roots;
    }
    let square = b * b - a * c;
    if square < 0.0 {
        return roots;
    }
    let q = -(b + square.sqrt().copysign(b));
    let (x, y) = (q / a, if q == 0.0 { 0.0 } else { c / q });
    roots.push(x.min(y));
    roots.push(x.max(y));
    roots
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::Random;

    #[test]
    fn finds_known_roots() {
        let mut random = Random::new(3);
        for degree in 1..9 {
            for _ in 0..50 {
                let mut wanted: Vec<f64> = (0..degree).map(|_| random.unit() * 4.0 - 2.0).collect();
                wanted.sort_by(f64::total_cmp);
                let mut product = vec![1.0];
                for root in &wanted {
                    let mut next = vec![0.0; product.len() + 1];
                    for (i, c) in product.iter().enumerate() {
                        next[i + 1] += c;
                        next[i] -= c * root;
                    }
                    product = next;
                }
                if wanted.windows(2).any(|w| w[1] - w[0] < 0.03) {
                    continue;
                }
                let found = roots_within::<10>(&product, -3.0, 3.0);
                assert_eq!(found.len(), wanted.len());
                for (f, w) in found.iter().zip(&wanted) {
                    assert!((f - w).abs() < 1e-6, "{f} {w}");
                }
            }
        }
    }

    #[test]
    fn quadratics() {
        assert_eq!(&*quadratic(1.0, -1.5, 2.0), &[1.0, 2.0]);
        assert_eq!(&*quadratic(0.0, 1.0, -4.0), &[2.0]);
        assert!(quadratic(1.0, 0.0, 1.0).is_empty());
        // However little is left of the square, it has two roots.
        let [near, far] = quadratic(1e-33, -1.0, 4.0)[..] else { panic!("two roots") };
        assert_eq!(near, 2.0);
        assert!(far > 1e32);
    }
}
