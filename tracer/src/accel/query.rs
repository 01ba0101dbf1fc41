//! A ray made ready for box tests.

use crate::math::Ray;

/// A ray with the reciprocals of its direction.
#[derive(Clone, Copy, Debug)]
pub struct Query {
    /// The ray itself.
    pub ray: Ray,
    /// One over each component; huge with the right sign where the component is zero, so that no NaN arises.
    pub inverse: [f64; 3],
    /// Whether each component is negative.
    pub negative: [bool; 3],
}

impl Query {
    /// Prepares a ray.
    #[inline]
    pub fn new(ray: Ray) -> Query {
        let d: [f64; 3] = ray.direction.into();
        let inverse = d.map(|c| if c.abs() < 1e-300 { 1e300 } else { 1.0 / c });
        Query { ray, inverse, negative: inverse.map(|c| c < 0.0) }
    }
}
