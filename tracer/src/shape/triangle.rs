//! SDL: `triangle { a, b, c }` and `smooth_triangle { a, na, b, nb, c, nc }`.

use super::{offer_rising, Crossing, Primitive};
use crate::accel::Counters;
use crate::math::{Bounds, Ray, Transform, Vec3};

const NEAREST: f64 = 1e-6;

/// A corner and the two edges from it.
#[derive(Clone, Copy, Debug)]
pub struct Facet {
    corner: Vec3,
    edge_u: Vec3,
    edge_v: Vec3,
}

impl Facet {
    /// From three corners.
    pub fn new(a: Vec3, b: Vec3, c: Vec3) -> Facet {
        Facet { corner: a, edge_u: b - a, edge_v: c - a }
    }

    /// The box around it.
    pub fn bounds(&self) -> Bounds {
        Bounds::around([self.corner, self.corner + self.edge_u, self.corner + self.edge_v])
    }

    /// Where the ray meets the facet: parameter and the shares of the second and third corner
    /// (Möller and Trumbore 1997).
    #[inline]
    pub fn crossing(&self, ray: &Ray, part: u32) -> Option<Crossing> {
        let p = ray.direction.cross(self.edge_v);
        let determinant = self.edge_u.dot(p);
        if determinant == 0.0 {
            return None;
        }
        let scale = 1.0 / determinant;
        let s = ray.origin - self.corner;
        let u = s.dot(p) * scale;
        if !(0.0..=1.0).contains(&u) {
            return None;
        }
        let q = s.cross(self.edge_u);
        let v = ray.direction.dot(q) * scale;
        if v < 0.0 || u + v > 1.0 {
            return None;
        }
        Some(Crossing { t: self.edge_v.dot(q) * scale, part, u, v })
    }

    /// Normal of any length; seen from its tip the corners go clockwise, as in POV-Ray.
    #[inline]
    pub fn normal(&self) -> Vec3 {
        self.edge_v.cross(self.edge_u)
    }
}

/// A triangle; `normals` are those of the corners of a smooth one.
#[derive(Clone, Debug)]
pub struct Triangle {
    facet: Facet,
    normals: Option<[Vec3; 3]>,
}

/// The normal between three.
#[inline]
pub fn interpolated_normal(normals: [Vec3; 3], crossing: &Crossing) -> Vec3 {
    let [a, b, c] = normals;
    a * (1.0 - crossing.u - crossing.v) + b * crossing.u + c * crossing.v
}

impl Triangle {
    /// A flat triangle.
    pub fn flat(corners: [Vec3; 3], place: &Transform) -> Triangle {
        let [a, b, c] = corners.map(|p| place.point(p));
        Triangle { facet: Facet::new(a, b, c), normals: None }
    }

    /// A triangle shaded as if it were bent.
    pub fn smooth(corners: [Vec3; 3], normals: [Vec3; 3], place: &Transform) -> Triangle {
        let normals = normals.map(|n| place.normal(n.normalized()).normalized());
        Triangle { normals: Some(normals), ..Triangle::flat(corners, place) }
    }
}

impl Primitive for Triangle {
    fn bounds(&self) -> Bounds {
        self.facet.bounds()
    }

    #[inline]
    fn intersect(
        &self,
        ray: &Ray,
        from: f64,
        limit: f64,
        _counters: &mut Counters,
        offer: &mut impl FnMut(Crossing, f64) -> f64,
    ) -> f64 {
        offer_rising(self.facet.crossing(ray, 0), from.max(NEAREST), limit, offer)
    }

    fn inside(&self, _: Vec3) -> bool {
        false
    }

    fn normal(&self, _: Vec3, crossing: &Crossing) -> Vec3 {
        self.normals.map_or_else(|| self.facet.normal(), |normals| interpolated_normal(normals, crossing))
    }

    fn geometric_normal(&self, _: Vec3, _: &Crossing) -> Vec3 {
        self.facet.normal()
    }

    fn solid(&self) -> bool {
        false
    }
}
