//! Algebraic surfaces: a polynomial times the field strength, the first parameter; most are cut off at -10 and 10.

use std::f64::consts::SQRT_2;

use crate::math::Vec3;

/// Field values are cut off here.
const LIMIT: f64 = 10.0;

fn limited(value: f64) -> f64 {
    // In this order, what is not a number becomes the upper limit.
    let upper = if value < LIMIT { value } else { LIMIT };
    upper.max(-LIMIT)
}

/// x², y², z².
fn squares(p: Vec3) -> (f64, f64, f64) {
    (p.x * p.x, p.y * p.y, p.z * p.z)
}

fn sq(a: f64) -> f64 {
    a * a
}

pub fn bicorn(p: Vec3, c: &[f64]) -> f64 {
    let (x2, y2, z2) = squares(p);
    let a = c[1];
    limited(-c[0] * (sq(x2 + z2 + 2.0 * a * p.y - a * a) - y2 * (a * a - x2 - z2)))
}

pub fn bifolia(p: Vec3, c: &[f64]) -> f64 {
    let (x2, y2, z2) = squares(p);
    limited(-c[0] * (sq(x2 + y2 + z2) - c[1] * (x2 + z2) * p.y))
}

pub fn boy_surface(p: Vec3, c: &[f64]) -> f64 {
    let (x2, y2, z2) = squares(p);
    let (z, rest, r2) = (p.z, 1.0 - p.z, x2 + y2);
    let value = 64.0 * rest.powi(3) * z.powi(3) - 48.0 * sq(rest) * z2 * (3.0 * r2 + 2.0 * z2)
        + 12.0
            * rest
            * z
            * (27.0 * r2 * r2 - 24.0 * z2 * r2 + 36.0 * SQRT_2 * p.y * z * (y2 - 3.0 * x2) + 4.0 * z2 * z2)
        + (9.0 * r2 - 2.0 * z2)
            * (-81.0 * r2 * r2 - 72.0 * z2 * r2 + 108.0 * SQRT_2 * p.x * z * (x2 - 3.0 * y2) + 4.0 * z2 * z2);
    limited(c[0] * c[1] * value)
}

pub fn crossed_trough(p: Vec3, c: &[f64]) -> f64 {
    limited(c[0] * (sq(p.x * p.z) - p.y))
}

pub fn cubic_saddle(p: Vec3, c: &[f64]) -> f64 {
    limited(c[0] * (p.z + p.y.powi(3) - p.x.powi(3)))
}

/// Serves `f_odd` too.
pub fn cushion(p: Vec3, c: &[f64]) -> f64 {
    let (x2, y2, z2) = squares(p);
    let z = p.z;
    let value =
        x2 * z2 - z2 * z2 + 2.0 * z2 * z - 2.0 * z2 + x2 - x2 * x2 - y2 * y2 - 2.0 * x2 * y2 - y2 * z2
            + 2.0 * y2 * z
            + y2;
    limited(c[0] * value)
}

pub fn devils_curve(p: Vec3, c: &[f64]) -> f64 {
    let (x2, y2, z2) = squares(p);
    limited(c[0] * (y2 * y2 - 0.25 * y2 - sq(x2 + z2) + 0.36 * x2))
}

/// A torus shifted by `c[3]`, `c[4]`, seen in a mirror sphere of radius `c[5]`.
pub fn dupin_cyclid(p: Vec3, c: &[f64]) -> f64 {
    let (x2, y2, z2) = squares(p);
    let (r2, k2) = (x2 + y2 + z2, c[5] * c[5]);
    let k4 = k2 * k2;
    let (dx, dy) = (c[3], c[4]);
    // The equation of the torus at the mirrored point, times the fourth power of the distance.
    let to_center = k4 - 2.0 * k2 * (p.x * dx + p.y * dy) + r2 * (dx * dx + dy * dy);
    let major2 = c[1] * c[1];
    let ring = sq(k2 * p.x - dx * r2) + k4 * z2;
    let wider = r2 * (major2 - c[2] * c[2]);
    // POV-Ray mistakes a sign: a square would have `to_center` alone in its middle term.
    let middle = to_center + 4.0 * k2 * p.y * dy;
    limited(-c[0] * (sq(to_center) + 2.0 * wider * middle + sq(wider) - 4.0 * major2 * ring))
}

/// Nearer to 0, z counts as this.
const ENNEPER_NEAREST: f64 = 0.2;

/// The leading terms of Enneper's surface.
pub fn enneper(p: Vec3, c: &[f64]) -> f64 {
    let (x2, y2, z2) = squares(p);
    let z = if p.z.abs() < ENNEPER_NEAREST { ENNEPER_NEAREST } else { p.z };
    let difference = y2 - x2;
    let value = (difference / (2.0 * z) + 2.0 / 9.0 * z2).powi(3) - 6.0 * sq(difference / (4.0 * z));
    limited(-c[0] * value)
}

pub fn folium_surface(p: Vec3, c: &[f64]) -> f64 {
    let (x2, y2, z2) = squares(p);
    limited(c[0] * ((y2 + z2) * (1.0 + (c[2] - 4.0 * c[1]) * p.x) + x2 * (1.0 + c[2])))
}

pub fn glob(p: Vec3, c: &[f64]) -> f64 {
    let (x2, y2, z2) = squares(p);
    limited(c[0] * (0.5 * x2 * x2 * (p.x + 1.0) - y2 - z2))
}

pub fn heart(p: Vec3, c: &[f64]) -> f64 {
    let (x2, y2, z2) = squares(p);
    limited(-c[0] * ((2.0 * x2 + y2 + z2 - 1.0).powi(3) - (0.1 * x2 + y2) * z2 * p.z))
}

pub fn hunt_surface(p: Vec3, c: &[f64]) -> f64 {
    let (x2, y2, z2) = squares(p);
    let value = 4.0 * (x2 + y2 + z2 - 13.0).powi(3) + 27.0 * sq(3.0 * x2 + y2 - 4.0 * z2 - 12.0);
    limited(-c[0] * value)
}

pub fn hyperbolic_torus(p: Vec3, c: &[f64]) -> f64 {
    let (x2, y2, z2) = squares(p);
    let (sum, difference) = radii(c);
    let value = sq(x2 + y2 - z2) - 2.0 * sum * (x2 - z2) + 2.0 * difference * y2 + sq(difference);
    limited(-c[0] * value)
}

/// Sum and difference of the squares of a major and a minor radius.
fn radii(c: &[f64]) -> (f64, f64) {
    (c[1] * c[1] + c[2] * c[2], c[1] * c[1] - c[2] * c[2])
}

pub fn kampyle_of_eudoxus(p: Vec3, c: &[f64]) -> f64 {
    let (x2, y2, z2) = squares(p);
    limited(c[0] * (c[2] * c[2] * (x2 * x2 - c[1] * c[1] * x2) - y2 - z2))
}

pub fn klein_bottle(p: Vec3, c: &[f64]) -> f64 {
    let (x2, y2, z2) = squares(p);
    let r2 = x2 + y2 + z2;
    let (above, below) = (r2 + 2.0 * p.y - 1.0, r2 - 2.0 * p.y - 1.0);
    limited(-c[0] * (above * (sq(below) - 8.0 * z2) + 16.0 * p.x * p.z * below))
}

pub fn kummer_surface_v1(p: Vec3, c: &[f64]) -> f64 {
    kummer_surface_v2(p, &[c[0], -1.0, -1.0, 0.0, -1.0])
}

/// The rods of Kummer's surface; a fifth parameter that only this file gives turns the sign of the constant.
pub fn kummer_surface_v2(p: Vec3, c: &[f64]) -> f64 {
    let (x2, y2, z2) = squares(p);
    let constant = c.get(4).copied().unwrap_or(1.0);
    let value = x2 * x2
        + y2 * y2
        + z2 * z2
        + c[1] * (x2 + y2 + z2)
        + c[2] * (x2 * y2 + x2 * z2 + y2 * z2)
        + c[3] * p.x * p.y * p.z
        - constant;
    limited(-c[0] * value)
}

pub fn lemniscate_of_gerono(p: Vec3, c: &[f64]) -> f64 {
    let (x2, y2, z2) = squares(p);
    limited(-c[0] * (x2 * x2 - x2 + y2 + z2))
}

pub fn mitre(p: Vec3, c: &[f64]) -> f64 {
    let (x2, y2, z2) = squares(p);
    limited(-c[0] * (4.0 * x2 * (x2 + y2 + z2) - y2 * (1.0 - y2 - z2)))
}

pub fn nodal_cubic(p: Vec3, c: &[f64]) -> f64 {
    limited(-c[0] * (p.y.powi(3) + p.z.powi(3) - 6.0 * p.y * p.z))
}

pub fn ovals_of_cassini(p: Vec3, c: &[f64]) -> f64 {
    let (x2, y2, z2) = squares(p);
    let a2 = c[1] * c[1];
    limited(-c[0] * (sq(x2 + y2 + z2 + a2) - c[3] * a2 * (x2 + z2) - c[2] * c[2]))
}

pub fn paraboloid(p: Vec3, c: &[f64]) -> f64 {
    let (x2, _, z2) = squares(p);
    limited(c[0] * (p.y - x2 - z2))
}

pub fn parabolic_torus(p: Vec3, c: &[f64]) -> f64 {
    let (x2, y2, _) = squares(p);
    let (sum, difference) = radii(c);
    limited(-c[0] * (sq(x2 + y2 - p.z) - sum * (x2 - p.z) + difference * y2 + sq(difference)))
}

pub fn pillow(p: Vec3, c: &[f64]) -> f64 {
    let (x2, y2, z2) = squares(p);
    limited(c[0] * (x2 * x2 + y2 * y2 + z2 * z2 - x2 - y2 - z2))
}

pub fn piriform(p: Vec3, c: &[f64]) -> f64 {
    let (x2, y2, z2) = squares(p);
    limited(c[0] * (x2 * x2 - x2 * p.x + y2 + z2))
}

pub fn quartic_paraboloid(p: Vec3, c: &[f64]) -> f64 {
    limited(c[0] * (p.y - p.x.powi(4) - p.z.powi(4)))
}

pub fn quartic_saddle(p: Vec3, c: &[f64]) -> f64 {
    limited(c[0] * (p.y - p.x.powi(4) + p.z.powi(4)))
}

pub fn quartic_cylinder(p: Vec3, c: &[f64]) -> f64 {
    let (x2, y2, z2) = squares(p);
    let b2 = c[2] * c[2];
    limited(-c[0] * ((x2 + z2) * (y2 + b2) - c[1] * c[1] * b2))
}

pub fn steiners_roman(p: Vec3, c: &[f64]) -> f64 {
    let (x2, y2, z2) = squares(p);
    limited(-c[0] * (x2 * y2 + x2 * z2 + y2 * z2 + p.x * p.y * p.z))
}

pub fn strophoid(p: Vec3, c: &[f64]) -> f64 {
    let (x2, y2, z2) = squares(p);
    limited(c[0] * ((p.x - c[2]) * (y2 + z2) + c[3] * c[3] * x2 * (c[1] + p.x)))
}

pub fn torus2(p: Vec3, c: &[f64]) -> f64 {
    let (x2, y2, z2) = squares(p);
    let (sum, difference) = radii(c);
    limited(-c[0] * (sq(x2 + y2 + z2) - 2.0 * sum * (x2 + z2) + 2.0 * difference * y2 + sq(difference)))
}

pub fn torus_gumdrop(p: Vec3, c: &[f64]) -> f64 {
    let (x2, y2, z2) = squares(p);
    let ring = y2 + z2;
    limited(-c[0] * (4.0 * (x2 * x2 + ring * ring) + 17.0 * x2 * ring - 20.0 * (x2 + ring) + 17.0))
}

pub fn umbrella(p: Vec3, c: &[f64]) -> f64 {
    limited(-c[0] * (p.x * p.x - p.y * p.z * p.z))
}

pub fn witch_of_agnesi(p: Vec3, c: &[f64]) -> f64 {
    let (x2, _, z2) = squares(p);
    limited(c[0] * (c[1] - p.y * (c[1] + x2 + z2)))
}
