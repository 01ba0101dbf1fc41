//! SDL: `map_type 0|1|2|5|7`: from space to the unit square that a picture fills.

use std::f64::consts::{PI, TAU};

use crate::math::Vec3;

/// The body that a picture is wrapped round.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MapType {
    /// 0: the xy plane.
    Planar,
    /// 1: a sphere round the origin.
    Spherical,
    /// 2: a cylinder round the y axis.
    Cylindrical,
    /// 5: a torus round the y axis with major radius 1.
    Torus,
    /// 7: an angular map (light probe): directions by their angle to +z (3.8).
    Angular,
}

impl MapType {
    /// By SDL's number.
    pub fn from_number(number: u8) -> MapType {
        match number {
            1 => MapType::Spherical,
            2 => MapType::Cylindrical,
            5 => MapType::Torus,
            7 => MapType::Angular,
            _ => MapType::Planar,
        }
    }

    /// The place of `p` in the unit square, or in a copy of it; None at the centre of the body.
    pub fn unit_square(self, p: Vec3) -> Option<[f64; 2]> {
        Some(match self {
            MapType::Cylindrical if p.x == 0.0 && p.z == 0.0 => return None,
            MapType::Spherical if p == Vec3::ZERO => return None,
            MapType::Planar => [p.x, p.y],
            MapType::Spherical => [turn(p.x, p.z), 0.5 + p.normalized().y.asin() / PI],
            MapType::Cylindrical => [turn(p.x, p.z), p.y],
            MapType::Torus => [turn(p.x, p.z), turn(1.0 - p.x.hypot(p.z), -p.y)],
            MapType::Angular => {
                let d = p.normalized();
                let share = d.z.clamp(-1.0, 1.0).acos() / PI / 2.0;
                let length = d.x.hypot(d.y);
                let out = if length > 0.0 { share / length } else { 0.0 };
                [0.5 + d.x * out, 0.5 + d.y * out]
            }
        })
    }

    /// Along which axes of the unit square copies may lie.
    pub fn repeats(self) -> [bool; 2] {
        [self == MapType::Planar, matches!(self, MapType::Planar | MapType::Cylindrical)]
    }
}

/// The share of a turn from the first axis to the second.
fn turn(along: f64, across: f64) -> f64 {
    across.atan2(along).rem_euclid(TAU) / TAU
}
