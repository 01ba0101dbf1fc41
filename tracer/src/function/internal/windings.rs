//! Tubes that wind: helices, spirals, woven threads.

use std::f64::consts::{PI, TAU};

use super::bodies::profile;
use crate::math::Vec3;

/// The size of a cross section around `(x, y)`: 0 square, 1 round, 2 a diamond, between and beyond what lies there.
fn cross_section(x: f64, y: f64, kind: f64) -> f64 {
    let (x, y) = (x.abs(), y.abs());
    if kind == 0.0 {
        x.max(y)
    } else if kind == 1.0 {
        x.hypot(y)
    } else {
        let power = 2.0 / kind;
        (x.powf(power) + y.powf(power)).powf(kind / 2.0)
    }
}

fn rotated(x: f64, y: f64, degrees: f64) -> (f64, f64) {
    let (sin, cos) = degrees.to_radians().sin_cos();
    (x * cos - y * sin, x * sin + y * cos)
}

/// A ball with a tail that bends around and grows thin.
pub fn comma(p: Vec3, c: &[f64]) -> f64 {
    let size = c[0];
    let ball = (p - Vec3::X * (size / 2.0)).length() - size / 2.0;
    let x = if p.x == 0.0 && p.z == 0.0 { COMMA_NEAREST } else { p.x };
    let thickness = size / 2.0 * (p.z.atan2(x) / 2.0).cos();
    let tail = ((x + size / 4.0).hypot(p.z) - size * 0.75).hypot(p.y) - thickness;
    ball.min(if p.z == 0.0 { tail } else { tail.max(-p.z) })
}

/// On the axis, x counts as this.
const COMMA_NEAREST: f64 = 0.0001;

/// Tubes around the y axis.
pub fn helix1(p: Vec3, c: &[f64]) -> f64 {
    let &[count, period, minor, major, shape, kind, angle, ..] = c else { return 0.0 };
    let turn = count * (p.z.atan2(p.x) + period * p.y);
    let turn = turn - TAU * (turn / TAU).floor() - PI;
    let (x, y) = (p.x.hypot(p.z) - major, turn / (count * period * shape));
    let (x, y) = rotated(x, y, angle);
    cross_section(x, y, kind).min(p.x.hypot(p.z) + major) - minor
}

/// A tube whose slices across the y axis are all alike.
pub fn helix2(p: Vec3, c: &[f64]) -> f64 {
    let &[_, period, minor, major, _, kind, ..] = c else { return 0.0 };
    let (sin, cos) = (period * p.y).sin_cos();
    let (x, z) = (p.x - major * cos, p.z - major * sin);
    cross_section(x * cos + z * sin, z * cos - x * sin, kind) - minor
}

/// A flat spiral cut out of a sphere.
pub fn spiral(p: Vec3, c: &[f64]) -> f64 {
    let &[distance, thickness, diameter, _, _, kind, ..] = c else { return 0.0 };
    let windings = p.x.hypot(p.z) / distance + p.z.atan2(p.x) / TAU - 0.5;
    let off = (windings - windings.round()) * distance;
    // On the axis, x counts as a little.
    let p = if p.x == 0.0 && p.z == 0.0 { p + Vec3::X * 0.000001 } else { p };
    (cross_section(off, p.y, kind).min(p.length()) - thickness).max(p.length() - diameter)
}

/// Threads along x and z, woven.
pub fn mesh1(p: Vec3, c: &[f64]) -> f64 {
    let &[step_x, step_z, thickness, amplitude, thickness_y, ..] = c else { return 0.0 };
    // Every other thread is over where its neighbours are under.
    let thread = |along: f64, step_along: f64, across: f64, step_across: f64, side: f64| {
        let height = side * amplitude * (PI * along / step_along).cos();
        let off = across - 2.0 * step_across * (across / (2.0 * step_across)).round();
        (thickness_y * (p.y - height)).hypot(thickness * off)
    };
    let threads = [
        thread(p.x, step_x, p.z, step_z, 1.0),
        thread(p.x, step_x, p.z + step_z, step_z, -1.0),
        thread(p.z, step_z, p.x, step_x, -1.0),
        thread(p.z, step_z, p.x + step_x, step_x, 1.0),
    ];
    threads.into_iter().fold(f64::INFINITY, f64::min)
}

/// Tubes around the y axis, as far from it as a polynomial of y says.
pub fn polytubes(p: Vec3, c: &[f64]) -> f64 {
    let count = c[0].clamp(0.0, 1000.0);
    let radius = profile(p.y, &c[1..]);
    let distance = |i: i32| {
        let (sin, cos) = (TAU * f64::from(i) / count).sin_cos();
        (p.x - radius * sin).hypot(p.z - radius * cos)
    };
    (0..count as i32).map(distance).fold(10000.0, f64::min)
}
