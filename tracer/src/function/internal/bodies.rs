//! Distances, angles, and fields of round bodies.

use crate::math::Vec3;

pub fn r(p: Vec3, _: &[f64]) -> f64 {
    p.length()
}

/// The angle from the y axis.
pub fn ph(p: Vec3, _: &[f64]) -> f64 {
    p.x.hypot(p.z).atan2(p.y)
}

/// The angle about the y axis, from z towards x.
pub fn th(p: Vec3, _: &[f64]) -> f64 {
    p.x.atan2(p.z)
}

pub fn sphere(p: Vec3, c: &[f64]) -> f64 {
    p.length() - c[0]
}

pub fn ellipsoid(p: Vec3, c: &[f64]) -> f64 {
    p.mul_each(Vec3::from([c[0], c[1], c[2]])).length()
}

pub fn torus(p: Vec3, c: &[f64]) -> f64 {
    let from_ring = (p.x * p.x + p.z * p.z).sqrt() - c[0];
    (from_ring * from_ring + p.y * p.y).sqrt() - c[1]
}

/// POV-Ray's boxes are thicker by this.
const BOX_MARGIN: f64 = 0.000001;

pub fn rounded_box(p: Vec3, c: &[f64]) -> f64 {
    let beyond = |at: f64, size: f64| (at.abs() - (size - c[0])).max(0.0);
    let corner = Vec3::from([beyond(p.x, c[1]), beyond(p.y, c[2]), beyond(p.z, c[3])]);
    corner.length() - c[0] - BOX_MARGIN
}

pub fn superellipsoid(p: Vec3, c: &[f64]) -> f64 {
    let (e, n) = (c[0], c[1]);
    let level = (p.x.abs().powf(2.0 / e) + p.y.abs().powf(2.0 / e)).powf(e / n);
    1.0 - (level + p.z.abs().powf(2.0 / n)).powf(n / 2.0)
}

/// Two components `c[0]` apart on the x axis, each by its strength and inverse radius.
pub fn blob(p: Vec3, c: &[f64]) -> f64 {
    let component = |center: f64, strength: f64, inverse: f64| {
        let d2 = (p - Vec3::X * center).length_squared() * inverse * inverse;
        if d2 > 1.0 {
            0.0
        } else {
            strength * (1.0 - d2) * (1.0 - d2)
        }
    };
    -(component(-c[0] / 2.0, c[1], c[2]) + component(c[0] / 2.0, c[3], c[4]))
}

pub fn blob2(p: Vec3, c: &[f64]) -> f64 {
    let component = |center: f64| (-c[1] * (p - Vec3::X * center).length_squared()).exp();
    c[3] - c[2] * (component(0.0) + component(c[0]))
}

/// The squared lengths of three ellipsoids, each with another axis of its own.
fn three_ellipsoids(p: Vec3, eccentricity: f64) -> [f64; 3] {
    let (x2, y2, z2) = (p.x * p.x, p.y * p.y, p.z * p.z);
    let e = eccentricity;
    [x2 + e * (y2 + z2), y2 + e * (x2 + z2), z2 + e * (x2 + y2)]
}

pub fn cross_ellipsoids(p: Vec3, c: &[f64]) -> f64 {
    let nearest = three_ellipsoids(p, c[0]).into_iter().fold(f64::INFINITY, f64::min);
    c[3] - c[2] * (-c[1] * nearest).exp()
}

pub fn isect_ellipsoids(p: Vec3, c: &[f64]) -> f64 {
    let farthest = three_ellipsoids(p, c[0]).into_iter().fold(0.0, f64::max);
    c[3] - c[2] * (-c[1] * farthest).exp()
}

pub fn flange_cover(p: Vec3, c: &[f64]) -> f64 {
    let sum: f64 = three_ellipsoids(p, c[0]).map(|d| (-c[1] * d).exp()).iter().sum();
    c[3] - c[2] * sum
}

pub fn spikes(p: Vec3, c: &[f64]) -> f64 {
    let sum: f64 = three_ellipsoids(p, c[0]).map(|d| (-c[1] * d).exp()).iter().sum();
    c[2] * (sum - c[4] * (-c[3] * p.length_squared()).exp())
}

pub fn spikes_2d(p: Vec3, c: &[f64]) -> f64 {
    let fading = (-c[3] * (p.x * p.x + p.z * p.z)).exp();
    p.y - c[0] * (c[1] * p.x).cos() * (c[2] * p.z).cos() * fading
}

/// The density of an electron's orbit.
pub fn quantum(p: Vec3, _: &[f64]) -> f64 {
    let shape = 2.0 * p.y * p.y - p.x * p.x - p.z * p.z;
    1.2 - 1.6 * shape * shape * (-p.length() * 1.33333332).exp()
}

pub fn poly4(p: Vec3, c: &[f64]) -> f64 {
    p.x.hypot(p.z) - profile(p.y, c)
}

/// A polynomial of four degrees.
pub fn profile(y: f64, c: &[f64]) -> f64 {
    c[0] + y * (c[1] + y * (c[2] + y * (c[3] + y * c[4])))
}

const SIN_60: f64 = 0.866_025_403_784_438_6;

/// In the plane's hexagon around a point: the distance from the middle, and how far along the side.
fn hexagon(p: Vec3) -> (f64, f64) {
    let width = 2.0 * SIN_60;
    let from = |cx: f64, cy: f64| {
        let i = ((p.x - cx) / width).round();
        let j = ((p.y - cy) / 3.0).round();
        (p.x - cx - i * width, p.y - cy - j * 3.0)
    };
    let (a, b) = (from(0.0, 0.0), from(SIN_60, 1.5));
    let (x, y) = if a.0.hypot(a.1) <= b.0.hypot(b.1) { a } else { b };
    let (x, y) = (x.abs(), y.abs());
    let slanted = 0.5 * x + SIN_60 * y;
    if x >= slanted {
        (x, y)
    } else {
        (slanted, (SIN_60 * x - 0.5 * y).abs())
    }
}

pub fn hex_x(p: Vec3, _: &[f64]) -> f64 {
    hexagon(p).0
}

pub fn hex_y(p: Vec3, _: &[f64]) -> f64 {
    hexagon(p).1
}
