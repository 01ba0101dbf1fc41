//! Noise generators 1 and 2: values and gradients hashed on the integer lattice, blended by an s-curve.

use super::coefficients::{COEFFICIENTS, REACH};
use super::random::Lcg;
use crate::math::{vec3, Vec3};

const SIZE: usize = 4096;
const MASK: i64 = SIZE as i64 - 1;
/// Lattice coordinates are shifted by this before hashing.
const SHIFT: i64 = 10_000;

static PERMUTATION: [u16; SIZE] = shuffled();

const fn shuffled() -> [u16; SIZE] {
    let mut table = [0; SIZE];
    let mut i = 0;
    while i < SIZE {
        table[i] = i as u16;
        i += 1;
    }
    let mut random = Lcg(0);
    while i > 0 {
        i -= 1;
        let j = random.next_15_bits() as usize % SIZE;
        let kept = table[i];
        table[i] = table[j];
        table[j] = kept;
    }
    table
}

/// The cell of one coordinate: hash input of its lower and upper corner, and the place within.
#[inline(always)]
fn cell(x: f64) -> ([usize; 2], f64) {
    // Not `floor`, which is a call of a library on processors that are not told to be recent.
    let toward_zero = x as i64;
    let floor = toward_zero - i64::from(x < toward_zero as f64);
    let i = floor.wrapping_add(SHIFT);
    ([(i & MASK) as usize, (i.wrapping_add(1) & MASK) as usize], x - floor as f64)
}

/// The place of a number in the shuffle; the mask changes nothing, but saves a check.
#[inline(always)]
fn permuted(i: usize) -> usize {
    PERMUTATION[i & MASK as usize] as usize
}

/// 12 bits for a lattice column.
#[inline(always)]
fn hash2(ix: usize, iy: usize) -> usize {
    permuted(permuted(ix) ^ iy)
}

#[inline(always)]
fn s_curve(t: f64) -> f64 {
    t * t * (3.0 - 2.0 * t)
}

/// Calls `corner(weight, coefficients, offset from the corner)` for the eight corners of the cell around `p`.
#[inline(always)]
fn for_corners(p: Vec3, mut corner: impl FnMut(f64, &[f64; REACH], Vec3)) {
    let ((ix, x), (iy, y), (iz, z)) = (cell(p.x), cell(p.y), cell(p.z));
    let (sx, sy, sz) = (s_curve(x), s_curve(y), s_curve(z));
    for (dx, wx) in [(0, 1.0 - sx), (1, sx)] {
        for (dy, wy) in [(0, 1.0 - sy), (1, sy)] {
            let column = hash2(ix[dx], iy[dy]);
            for (dz, wz) in [(0, 1.0 - sz), (1, sz)] {
                let start = permuted(column ^ iz[dz]) & 0xff;
                let owned = COEFFICIENTS[start..start + REACH].first_chunk().expect("REACH long");
                corner(wx * wy * wz, owned, vec3(x - dx as f64, y - dy as f64, z - dz as f64));
            }
        }
    }
}

/// Signed noise, about -0.5..0.5 around its mean.
#[inline]
pub fn signed_noise(p: Vec3) -> f64 {
    let mut sum = 0.0;
    for_corners(p, |w, c, d| sum += w * (0.5 * c[0] + c[1] * d.x + c[2] * d.y + c[3] * d.z));
    sum
}

/// Three independent signed noises; the first is `signed_noise`. The same for every noise generator.
#[inline]
pub fn vector_noise(p: Vec3) -> Vec3 {
    let mut sum = [0.0; 3];
    for_corners(p, |w, c, d| {
        for (component, s) in sum.iter_mut().enumerate() {
            let c = &c[4 * component..][..4];
            *s += w * (0.5 * c[0] + c[1] * d.x + c[2] * d.y + c[3] * d.z);
        }
    });
    sum.into()
}

/// A pseudo-random 12-bit number for a unit cube, the seed of `cells` and `crackle`.
#[inline]
pub fn hash3(ix: i64, iy: i64, iz: i64) -> u16 {
    let wrap = |i: i64| (i & MASK) as usize;
    permuted(hash2(wrap(ix), wrap(iy)) ^ wrap(iz)) as u16
}
