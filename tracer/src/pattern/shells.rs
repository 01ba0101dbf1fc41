//! SDL: `spherical`, `boxed`, `cylindrical`, `planar`, `onion`, `wood`, `marble`, `gradient V`, `leopard`, `radial`,
//! `quilted`: patterns by formula.

use std::f64::consts::TAU;

use super::wave::cycloidal;
use super::Modifiers;
use crate::math::Vec3;

/// The fraction of a value above 1; values below are left to the waveform.
#[inline]
pub(super) fn wrapped(v: f64) -> f64 {
    if v > 1.0 {
        v % 1.0
    } else {
        v
    }
}

/// 1 at distance 0, falling to 0 at distance 1.
#[inline]
pub(super) fn fading(distance: f64) -> f64 {
    1.0 - distance.min(1.0)
}

/// The largest coordinate in size.
pub(super) fn chebyshev(p: Vec3) -> f64 {
    p.map(f64::abs).max_element()
}

/// Distance from the z axis; turbulence sways the rings by a sine of itself.
pub(super) fn wood(p: Vec3, modifiers: &Modifiers) -> f64 {
    let q = match &modifiers.turbulence {
        None => p,
        Some(t) => p + (p + t.octaves.vector(p)).mul_each(t.amount).map(cycloidal),
    };
    q.x.hypot(q.y)
}

/// x, shifted by the scalar turbulence times the x component of its amount.
pub(super) fn marble(p: Vec3, modifiers: &Modifiers) -> f64 {
    let shift =
        modifiers.turbulence.map_or(0.0, |t| t.amount.x * t.octaves.scalar(p, modifiers.noise_generator));
    p.x + shift
}

/// Squared mean of three sines.
pub(super) fn leopard(p: Vec3) -> f64 {
    ((p.x.sin() + p.y.sin() + p.z.sin()) / 3.0).powi(2)
}

/// The angle about the y axis: 0 at +x, one quarter at -z.
pub(super) fn radial(p: Vec3) -> f64 {
    if p.x.abs() < 0.001 && p.z.abs() < 0.001 {
        return 0.25;
    }
    0.25 + (p.x.atan2(p.z) + TAU / 2.0) / TAU
}

/// Distance from the centre of the unit cube along a Bezier curve with inner ordinates `control0`, `control1`, times
/// the sum of the sizes of the coordinates.
pub(super) fn quilted(p: Vec3, control0: f64, control1: f64) -> f64 {
    let d = p.map(|c| (c - c.floor() - 0.5).abs());
    let size = 2.0 / 27.0_f64.sqrt() * (d.x + d.y + d.z);
    size * quilt_curve(d.length(), control0, control1)
}

/// The way from the centre of the unit cube, along the same curve; of length one at the corners, nearly.
pub(crate) fn quilted_bump(p: Vec3, control0: f64, control1: f64) -> Vec3 {
    let d = p.map(|c| c - c.floor() - 0.5);
    d * (quilt_curve(d.length(), control0, control1) * 2.0 / 3.0_f64.sqrt())
}

/// The cubic Bezier curve with ordinates 0, `control0`, `control1`, 1.
fn quilt_curve(t: f64, control0: f64, control1: f64) -> f64 {
    let s = 1.0 - t;
    3.0 * s * s * t * control0 + 3.0 * s * t * t * control1 + t * t * t
}
