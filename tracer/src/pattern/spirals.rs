//! SDL: `spiral1 I`, `spiral2 I`: arms winding about the z axis.

use std::f64::consts::TAU;

use super::wave::triangle;
use super::Modifiers;
use crate::math::Vec3;

/// The share of a turn from -y over +x; 0 on the axis.
fn turn(p: Vec3) -> f64 {
    if p.x == 0.0 && p.y == 0.0 {
        return 0.0;
    }
    p.x.atan2(-p.y).rem_euclid(TAU) / TAU
}

/// Radius, height and angle in arms. Turbulence has moved the point already, and shifts the sum once more.
fn winding(p: Vec3, arms: f64, modifiers: &Modifiers) -> f64 {
    let turbulence =
        modifiers.turbulence.map_or(0.0, |t| t.amount.x * t.octaves.scalar(p, modifiers.noise_generator));
    p.z + p.x.hypot(p.y) + arms * turn(p) + turbulence
}

/// One period a turn and arm.
pub(super) fn spiral1(p: Vec3, arms: f64, modifiers: &Modifiers) -> f64 {
    winding(p, arms, modifiers)
}

/// The same with a triangular profile, and rings.
pub(super) fn spiral2(p: Vec3, arms: f64, modifiers: &Modifiers) -> f64 {
    triangle(winding(p, arms, modifiers)) + triangle(p.x.hypot(p.y))
}
