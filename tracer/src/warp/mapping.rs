//! SDL: `warp { cylindrical | spherical | toroidal | planar orientation V dist_exp F }`, `warp { cubic }`: the unit
//! square wrapped round a body.

use std::f64::consts::{PI, TAU};

use crate::math::{vec3, Vec3};

/// The body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Projection {
    /// Round the y axis.
    Cylindrical,
    /// Round the origin.
    Spherical,
    /// Round the y axis, and round a circle of this radius about it.
    Toroidal(f64),
    /// On the plane z = 0, with this as the third coordinate.
    Planar(f64),
}

/// A projection and where its result faces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mapping {
    projection: Projection,
    dist_exp: f64,
    /// Images of the axes.
    rows: [Vec3; 3],
}

/// The share of a full turn, 0..1.
fn turn(angle: f64) -> f64 {
    angle.rem_euclid(TAU) / TAU
}

impl Mapping {
    /// `orientation` need not have length one.
    pub fn new(projection: Projection, orientation: Vec3, dist_exp: f64) -> Mapping {
        let o = orientation.normalized();
        // Probed: a rotation for orientations along an axis, a skew map for others.
        let rows = [vec3(o.y + o.z, 0.0, -o.x), vec3(0.0, o.x + o.z, o.y), vec3(o.x, -o.y, o.z)];
        Mapping { projection, dist_exp, rows }
    }

    /// Where `p` comes from: two surface coordinates and the distance from the body's centre.
    pub fn apply(&self, p: Vec3) -> Vec3 {
        let around = turn(p.z.atan2(p.x));
        let radius = p.x.hypot(p.z);
        let q = match self.projection {
            // The axis itself stays where it is.
            Projection::Cylindrical | Projection::Toroidal(_) if radius == 0.0 => return p,
            Projection::Cylindrical => vec3(around * self.stretch(radius), p.y, radius),
            Projection::Spherical => {
                let distance = p.length();
                let height = if distance == 0.0 { 0.0 } else { 0.5 + p.y.atan2(radius) / PI };
                vec3(around, height, 0.0) * self.stretch(distance) + Vec3::Z * distance
            }
            Projection::Toroidal(major_radius) => {
                let out = radius - major_radius;
                let distance = out.hypot(p.y);
                let tube = turn(p.y.atan2(out) + PI);
                vec3(around, tube, 0.0) * self.stretch(distance) + Vec3::Z * distance
            }
            Projection::Planar(distance) => vec3(p.x, p.y, distance),
        };
        self.rows[0] * q.x + self.rows[1] * q.y + self.rows[2] * q.z
    }

    fn stretch(&self, distance: f64) -> f64 {
        if self.dist_exp == 0.0 {
            1.0
        } else {
            distance.powf(self.dist_exp)
        }
    }
}

/// The cube of the six pyramids around the origin, unfolded: four sides in a row, top and bottom at the second.
pub(super) fn cubic(p: Vec3) -> Vec3 {
    let size = p.map(f64::abs);
    let d = size.max_element();
    if d == 0.0 {
        return Vec3::ZERO;
    }
    let f = p / d;
    // Column, row, and the place on the face from -1 to 1.
    let (column, row, u, v) = if size.x == d {
        if p.x > 0.0 {
            (2.0, 1.0, -f.z, f.y)
        } else {
            (0.0, 1.0, f.z, f.y)
        }
    } else if size.y == d {
        if p.y > 0.0 {
            (1.0, 2.0, f.x, -f.z)
        } else {
            (1.0, 0.0, f.x, f.z)
        }
    } else if p.z > 0.0 {
        (1.0, 1.0, f.x, f.y)
    } else {
        (3.0, 1.0, -f.x, f.y)
    };
    vec3((column + (u + 1.0) / 2.0) / 4.0, (row + (v + 1.0) / 2.0) / 3.0, d)
}
