//! SDL: `translate V`, `scale V`, `rotate V`, `matrix <12 numbers>`.
//!
//! POV-Ray writes points as row vectors: `q = p * M + row 4`; so does this module.

use super::{vec3, Ray, Vec3};

/// An affine map kept together with its inverse.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Transform {
    /// Rows 0..3 are the images of the axes, row 3 that of the origin.
    pub rows: [Vec3; 4],
    /// The same for the inverse map.
    pub inverse_rows: [Vec3; 4],
}

fn apply_direction(m: &[Vec3; 4], v: Vec3) -> Vec3 {
    m[0] * v.x + m[1] * v.y + m[2] * v.z
}

impl Transform {
    /// The map that changes nothing.
    pub const IDENTITY: Transform = Transform {
        rows: [Vec3::X, Vec3::Y, Vec3::Z, Vec3::ZERO],
        inverse_rows: [Vec3::X, Vec3::Y, Vec3::Z, Vec3::ZERO],
    };

    /// From SDL's twelve numbers, row by row; `None` when the map has no inverse.
    pub fn from_matrix(m: [f64; 12]) -> Option<Transform> {
        let rows = [
            vec3(m[0], m[1], m[2]),
            vec3(m[3], m[4], m[5]),
            vec3(m[6], m[7], m[8]),
            vec3(m[9], m[10], m[11]),
        ];
        let (a, b, c) = (rows[0], rows[1], rows[2]);
        let (bc, ca, ab) = (b.cross(c), c.cross(a), a.cross(b));
        let det = a.dot(bc);
        if det == 0.0 || !det.is_finite() {
            return None;
        }
        let (u, v, w) = (bc / det, ca / det, ab / det);
        let mut inverse_rows = [vec3(u.x, v.x, w.x), vec3(u.y, v.y, w.y), vec3(u.z, v.z, w.z), Vec3::ZERO];
        inverse_rows[3] = -apply_direction(&inverse_rows, rows[3]);
        Some(Transform { rows, inverse_rows })
    }

    /// A shift by `v`.
    pub fn translate(v: Vec3) -> Transform {
        let mut t = Transform::IDENTITY;
        t.rows[3] = v;
        t.inverse_rows[3] = -v;
        t
    }

    /// First `self`, then `next`.
    pub fn then(&self, next: &Transform) -> Transform {
        let compose = |first: &[Vec3; 4], second: &[Vec3; 4]| {
            [
                apply_direction(second, first[0]),
                apply_direction(second, first[1]),
                apply_direction(second, first[2]),
                apply_direction(second, first[3]) + second[3],
            ]
        };
        Transform {
            rows: compose(&self.rows, &next.rows),
            inverse_rows: compose(&next.inverse_rows, &self.inverse_rows),
        }
    }

    /// The inverse map.
    pub fn inverse(&self) -> Transform {
        Transform { rows: self.inverse_rows, inverse_rows: self.rows }
    }

    /// Image of a point.
    #[inline]
    pub fn point(&self, p: Vec3) -> Vec3 {
        apply_direction(&self.rows, p) + self.rows[3]
    }

    /// Image of a direction.
    #[inline]
    pub fn direction(&self, d: Vec3) -> Vec3 {
        apply_direction(&self.rows, d)
    }

    /// Where a point came from.
    #[inline]
    pub fn inverse_point(&self, p: Vec3) -> Vec3 {
        apply_direction(&self.inverse_rows, p) + self.inverse_rows[3]
    }

    /// Where a direction came from.
    #[inline]
    pub fn inverse_direction(&self, d: Vec3) -> Vec3 {
        apply_direction(&self.inverse_rows, d)
    }

    /// Image of a surface normal (the inverse transpose), not normalised.
    #[inline]
    pub fn normal(&self, n: Vec3) -> Vec3 {
        let m = &self.inverse_rows;
        vec3(m[0].dot(n), m[1].dot(n), m[2].dot(n))
    }

    /// Where a surface normal came from, not normalised.
    #[inline]
    pub fn inverse_normal(&self, n: Vec3) -> Vec3 {
        let m = &self.rows;
        vec3(m[0].dot(n), m[1].dot(n), m[2].dot(n))
    }

    /// A ray carried back; its parameter `t` keeps its meaning.
    #[inline]
    pub fn inverse_ray(&self, r: &Ray) -> Ray {
        Ray { origin: self.inverse_point(r.origin), direction: self.inverse_direction(r.direction) }
    }

    /// Whether this is exactly the identity.
    pub fn is_identity(&self) -> bool {
        *self == Transform::IDENTITY
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn inverse_undoes() {
        let t = Transform::from_matrix([1.0, 2.0, 0.0, 0.0, 1.0, 3.0, 1.0, 0.0, 1.0, 5.0, 6.0, 7.0]).unwrap();
        let p = vec3(0.3, -2.0, 9.0);
        assert!((t.inverse_point(t.point(p)) - p).length() < 1e-12);
        let u = t.then(&Transform::translate(vec3(1.0, 2.0, 3.0)));
        assert!((u.point(p) - t.point(p) - vec3(1.0, 2.0, 3.0)).length() < 1e-12);
        assert!((u.inverse().point(u.point(p)) - p).length() < 1e-12);
    }

    #[test]
    fn singular_is_refused() {
        assert!(
            Transform::from_matrix([1.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0]).is_none()
        );
    }
}
