//! SDL: `checker`, `brick brick_size V mortar F`, `hexagon`, `cubic`, `square`, `triangular`: numbered blocks.

use super::cells::TOLERANCE;
use crate::math::{vec3, Vec3};

/// Unit cubes, 0 and 1 in turn.
pub(super) fn checker(p: Vec3) -> f64 {
    let c = p.map(|v| (v + TOLERANCE).floor());
    (c.x + c.y + c.z).rem_euclid(2.0)
}

/// Parameters of `brick`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Brick {
    /// Size of a brick with its mortar.
    pub brick_size: Vec3,
    /// Width of the joints.
    pub mortar: f64,
}

impl Default for Brick {
    fn default() -> Brick {
        Brick { brick_size: vec3(8.0, 3.0, 4.5), mortar: 0.5 }
    }
}

impl Brick {
    /// 0 in the mortar, 1 in a brick.
    pub(super) fn value(&self, p: Vec3) -> f64 {
        let size = self.brick_size;
        let bricks = vec3(p.x / size.x, p.y / size.y, p.z / size.z).map(|v| v + TOLERANCE);
        // Odd layers are shifted by half a brick along x, even ones along z.
        let odd_layer = bricks.y.floor().rem_euclid(2.0) == 1.0;
        let (shift_x, shift_z) = if odd_layer { (0.5, 0.0) } else { (0.0, 0.5) };
        let place = vec3(bricks.x + shift_x, bricks.y, bricks.z + shift_z).map(|v| v - v.floor());
        let in_joint = (0..3).any(|axis| (1.0 - place[axis]) * size[axis] <= self.mortar);
        f64::from(!in_joint)
    }
}

/// Hexagonal rods along y with side length 1, in three kinds.
pub(super) fn hexagon(p: Vec3) -> f64 {
    // Axial coordinates: one axis along z, the other 60 degrees off; centres are the integer points.
    let row_height = 3.0_f64.sqrt();
    let q = (p.x + TOLERANCE) / 1.5;
    let r = (p.z + TOLERANCE) / row_height - 0.5 * q;
    // The nearest centre: round all three hexagonal coordinates, then mend the worst.
    let s = -q - r;
    let (mut rq, mut rr, rs) = (q.round(), r.round(), s.round());
    let (eq, er, es) = ((rq - q).abs(), (rr - r).abs(), (rs - s).abs());
    if eq > er && eq > es {
        rq = -rr - rs;
    } else if er > es {
        rr = -rq - rs;
    }
    (rr - rq).rem_euclid(3.0)
}

/// Which face of a cube around the origin `p` lies towards: +x, +y, +z, -x, -y, -z.
pub(super) fn cubic(p: Vec3) -> f64 {
    let a = p.map(f64::abs);
    let axis = if a.x >= a.y && a.x >= a.z {
        0
    } else if a.y >= a.z {
        1
    } else {
        2
    };
    axis as f64 + if p[axis] < 0.0 { 3.0 } else { 0.0 }
}

/// Unit squares of the xz plane in four kinds.
pub(super) fn square(p: Vec3) -> f64 {
    let x = p.x.floor().rem_euclid(2.0);
    let z = p.z.floor().rem_euclid(2.0);
    match (x == 1.0, z == 1.0) {
        (false, false) => 0.0,
        (false, true) => 1.0,
        (true, true) => 2.0,
        (true, false) => 3.0,
    }
}

/// Unit-side triangles of the xz plane in six kinds.
pub(super) fn triangular(p: Vec3) -> f64 {
    // Axial coordinates along two sides of the lattice; each unit rhombus holds two triangles.
    let r = (p.z + TOLERANCE) / (0.5 * 3.0_f64.sqrt());
    let q = p.x - 0.5 * r;
    let (i, j) = (q.floor(), r.floor());
    let upper = (q - i) + (r - j) > 1.0;
    // The six triangles around a lattice point are all of different kinds.
    let kinds = if upper { [3.0, 5.0, 1.0] } else { [0.0, 4.0, 2.0] };
    kinds[(i - j).rem_euclid(3.0) as usize]
}
