//! Noise generator 3: gradient noise on a lattice of 2048 cells per axis, after Perlin.

use std::sync::LazyLock;

use super::random::Lcg;
use crate::math::{vec3, Vec3};

const SIZE: usize = 2048;
const MASK: i64 = SIZE as i64 - 1;
/// Coordinates are shifted by this, which also rounds them to a multiple of 2^-29.
const SHIFT: f64 = 10_000_000.023157213;
/// The result is `MEAN + AMPLITUDE * gradient noise`, limited to 0..1.
const MEAN: f64 = 0.4925;
const AMPLITUDE: f64 = 0.795;

struct Tables {
    permutation: [u16; SIZE],
    gradients: [Vec3; SIZE],
}

static TABLES: LazyLock<Tables> = LazyLock::new(|| {
    let mut random = Lcg(1);
    let mut component = || (random.next_15_bits() % (2 * SIZE as u32)) as f64 / SIZE as f64 - 1.0;
    // Directions drawn uniformly: from the cube, those outside the ball rejected.
    let gradients = std::array::from_fn(|_| loop {
        let v = vec3(component(), component(), component());
        if v.length_squared() <= 1.0 {
            break v.normalized();
        }
    });
    let mut permutation: [u16; SIZE] = std::array::from_fn(|i| i as u16);
    // Only every other element starts a swap, and the first swap brings in a zero from past the end.
    permutation[random.next_15_bits() as usize % SIZE] = 0;
    for i in (2..SIZE).step_by(2).rev() {
        permutation.swap(i, random.next_15_bits() as usize % SIZE);
    }
    Tables { permutation, gradients }
});

#[inline(always)]
fn cell(x: f64) -> ([i64; 2], f64) {
    let t = x + SHIFT;
    let i = t as i64;
    ([i & MASK, (i + 1) & MASK], t - i as f64)
}

/// Noise in 0..1.
#[inline]
pub fn noise(p: Vec3) -> f64 {
    let Tables { permutation, gradients } = &*TABLES;
    let ((ix, x), (iy, y), (iz, z)) = (cell(p.x), cell(p.y), cell(p.z));
    let s_curve = |t: f64| t * t * (3.0 - 2.0 * t);
    let lerp = |t: f64, a: f64, b: f64| a + t * (b - a);
    let (sx, sy, sz) = (s_curve(x), s_curve(y), s_curve(z));
    let corner = |column: i64, dx: usize, dy: usize, dz: usize| {
        let g = gradients[((column + iz[dz]) & MASK) as usize];
        g.dot(vec3(x - dx as f64, y - dy as f64, z - dz as f64))
    };
    let column = |dx: usize, dy: usize| {
        let row = permutation[ix[dx] as usize] as i64;
        permutation[((row + iy[dy]) & MASK) as usize] as i64
    };
    let along_z = |dx, dy| {
        let c = column(dx, dy);
        lerp(sz, corner(c, dx, dy, 0), corner(c, dx, dy, 1))
    };
    let along_y = |dx| lerp(sy, along_z(dx, 0), along_z(dx, 1));
    (MEAN + AMPLITUDE * lerp(sx, along_y(0), along_y(1))).clamp(0.0, 1.0)
}
