//! SDL: `cells`: a random constant for each unit cube; and the random points that `crackle` is made of.

use std::sync::LazyLock;

use crate::math::{vec3, Vec3};
use crate::noise::{hash3, MersenneTwister};

/// A cube reaches this far below its lower faces, so that faces on its border lie safely inside.
pub(super) const TOLERANCE: f64 = 1e-10;

/// One stream of fractions; a cube's hash says where in it the cube begins to read.
static FRACTIONS: LazyLock<Vec<f64>> = LazyLock::new(|| {
    let mut random = MersenneTwister::default();
    (0..4096 + 2).map(|_| random.next_unit()).collect()
});

pub(super) fn cells(p: Vec3) -> f64 {
    let c = p.map(|v| (v + TOLERANCE).floor());
    FRACTIONS[usize::from(hash3(c.x as i64, c.y as i64, c.z as i64))]
}

/// The random point of a unit cube.
#[inline]
pub(crate) fn point_in_cube(x: i64, y: i64, z: i64) -> Vec3 {
    let start = usize::from(hash3(x, y, z));
    let f = &FRACTIONS[start..start + 3];
    vec3(x as f64 + f[0], y as f64 + f[1], z as f64 + f[2])
}

/// The random points of the unit cube around `p` and of its neighbours, but for those two steps away along more than
/// one axis.
pub(crate) fn cubes_around(p: Vec3) -> impl Iterator<Item = Vec3> {
    let c = p.map(|v| (v - TOLERANCE).floor());
    let (x, y, z) = (c.x as i64, c.y as i64, c.z as i64);
    let steps = (0..125_i64).map(|i| (i / 25 - 2, i / 5 % 5 - 2, i % 5 - 2));
    let far = |step: i64| usize::from(step.abs() == 2);
    let near = steps.filter(move |&(dx, dy, dz)| far(dx) + far(dy) + far(dz) <= 1);
    near.map(move |(dx, dy, dz)| point_in_cube(x + dx, y + dy, z + dz))
}
