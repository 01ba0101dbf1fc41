//! Plane curves, drawn out along z or turned about the y axis: the last three parameters are the switch for turning,
//! the distance of the curve from the axis and the angle in degrees that the curve is rotated by.

use crate::math::Vec3;

/// Field values of most curves are cut off here.
const LIMIT: f64 = 10.0;

/// The point of the plane that a point of space shows.
fn in_plane(p: Vec3, switch: f64, offset: f64, angle: f64) -> (f64, f64) {
    if switch <= 0.0 {
        return (p.x, p.y);
    }
    let from_axis = p.x.hypot(p.z) - offset;
    let (sin, cos) = angle.to_radians().sin_cos();
    (from_axis * cos - p.y * sin, from_axis * sin + p.y * cos)
}

fn limited(value: f64, limit: f64) -> f64 {
    value.min(limit).max(-limit)
}

/// A field of the plane by its strength `c[0]` and limit `c[1]`.
fn cylinder(p: Vec3, c: &[f64], field: impl Fn(f64, f64) -> f64) -> f64 {
    let (x, y) = in_plane(p, c[2], c[3], c[4]);
    limited(c[0] * field(x, y), c[1])
}

/// A field of the plane by its strength `c[0]`, turned as the last three parameters say.
fn curve(p: Vec3, c: &[f64], turning: usize, field: impl Fn(f64, f64) -> f64) -> f64 {
    let (x, y) = in_plane(p, c[turning], c[turning + 1], c[turning + 2]);
    limited(c[0] * field(x, y), LIMIT)
}

pub fn algbr_cyl1(p: Vec3, c: &[f64]) -> f64 {
    cylinder(p, c, |x, y| y * y + x.abs().powi(3) - x * x)
}

pub fn algbr_cyl2(p: Vec3, c: &[f64]) -> f64 {
    cylinder(p, c, |x, y| -(2.0 * x.powi(4) - 3.0 * x * x * y + (y - y * y).powi(2)))
}

pub fn algbr_cyl3(p: Vec3, c: &[f64]) -> f64 {
    cylinder(p, c, |x, y| {
        let (x2, y2) = (x * x, y * y);
        -(x2 * x2 + x2 * y2 - 2.0 * x2 * y - x * y2 + y2)
    })
}

pub fn algbr_cyl4(p: Vec3, c: &[f64]) -> f64 {
    cylinder(p, c, |x, y| {
        let (x2, y2) = (x * x, y * y);
        -((x2 + y2).powi(2) - y * (y2 - 3.0 * x2))
    })
}

pub fn devils_curve_2d(p: Vec3, c: &[f64]) -> f64 {
    curve(p, c, 3, |x, y| {
        let (x2, y2) = (x * x, y * y);
        y2 * (y2 - c[2] * c[2]) - x2 * (x2 - c[1] * c[1])
    })
}

pub fn folium_surface_2d(p: Vec3, c: &[f64]) -> f64 {
    curve(p, c, 3, |x, y| -(y * y * (1.0 + (c[2] - 4.0 * c[1]) * x) + x * x * (1.0 + c[2])))
}

pub fn kampyle_of_eudoxus_2d(p: Vec3, c: &[f64]) -> f64 {
    curve(p, c, 3, |x, y| {
        let (x2, c2) = (x * x, c[2] * c[2]);
        c2 * x2 * (x2 - c[1] * c[2]) - y * y
    })
}

pub fn lemniscate_of_gerono_2d(p: Vec3, c: &[f64]) -> f64 {
    curve(p, c, 3, |x, y| -(c[2] * c[2] * x * x * (x * x - c[1] * c[1]) + y * y))
}

pub fn piriform_2d(p: Vec3, c: &[f64]) -> f64 {
    curve(p, c, 4, |x, y| c[3] * c[3] * x.powi(3) * (c[1] + c[2] * x) - y * y)
}

pub fn strophoid_2d(p: Vec3, c: &[f64]) -> f64 {
    curve(p, c, 4, |x, y| (x - c[2]) * y * y + c[3] * c[3] * x * x * (c[1] + x))
}

pub fn witch_of_agnesi_2d(p: Vec3, c: &[f64]) -> f64 {
    curve(p, c, 3, |x, y| c[2] - y * (c[1] * c[1] + x * x))
}
