//! Eight boxes at once: the only module with `unsafe`, for AVX2; a scalar twin gives the same bits.
#![allow(unsafe_code)]

use super::Query;
use crate::math::{Bounds, Vec3};

/// Widens the far end of a slab interval past the rounding of three multiplications, so that no box is missed.
const WIDEN: f64 = 1.0 + 4.0 * f64::EPSILON;

/// Eight boxes as a structure of arrays: the smallest x of all, the largest x of all, then y, then z.
/// They are rounded outward to single precision.
#[derive(Clone, Debug)]
#[repr(C, align(32))]
pub struct Boxes {
    planes: [[[f32; 8]; 2]; 3],
}

/// Which of the eight a ray meets (bit mask), and where it enters each.
pub type Entries = (u32, [f64; 8]);

fn round_down(x: f64) -> f32 {
    let y = x as f32;
    if f64::from(y) <= x {
        y
    } else if y > 0.0 {
        f32::from_bits(y.to_bits() - 1)
    } else if y == 0.0 {
        -f32::from_bits(1)
    } else {
        f32::from_bits(y.to_bits() + 1)
    }
}

/// Where a ray enters a box at parameters from 0 to `limit`, if it does.
#[inline]
pub fn entry(bounds: &Bounds, query: &Query, limit: f64) -> Option<f64> {
    let (mut near, mut far) = (0.0f64, limit);
    for axis in 0..3 {
        let to = |plane: f64| (plane - query.ray.origin[axis]) * query.inverse[axis];
        let (low, high) = (to(bounds.min[axis]), to(bounds.max[axis]));
        near = near.max(low.min(high));
        far = far.min(low.max(high) * WIDEN);
    }
    (near <= far).then_some(near)
}

impl Boxes {
    /// Boxes that no ray meets.
    pub const EMPTY: Boxes = Boxes { planes: [[[f32::INFINITY; 8], [f32::NEG_INFINITY; 8]]; 3] };

    /// Sets one of the eight.
    pub fn set(&mut self, lane: usize, bounds: &Bounds) {
        for axis in 0..3 {
            self.planes[axis][0][lane] = round_down(bounds.min[axis]);
            self.planes[axis][1][lane] = -round_down(-bounds.max[axis]);
        }
    }

    /// The boxes that the ray meets at parameters from 0 to `limit`.
    #[inline]
    pub fn entries(&self, query: &Query, limit: f64) -> Entries {
        #[cfg(target_arch = "x86_64")]
        if is_x86_feature_detected!("avx2") {
            // SAFETY: the processor has AVX2, as just checked.
            return unsafe { self.entries_avx2(query, limit) };
        }
        self.entries_scalar(query, limit)
    }

    /// The twin of the vector path.
    pub fn entries_scalar(&self, query: &Query, limit: f64) -> Entries {
        let (mut mask, mut enter) = (0, [0.0; 8]);
        for (lane, enter) in enter.iter_mut().enumerate() {
            let (mut near, mut far) = (0.0f64, limit);
            for axis in 0..3 {
                let side = usize::from(query.negative[axis]);
                let to = |plane: f32| (f64::from(plane) - query.ray.origin[axis]) * query.inverse[axis];
                near = near.max(to(self.planes[axis][side][lane]));
                far = far.min(to(self.planes[axis][1 - side][lane]) * WIDEN);
            }
            mask |= u32::from(near <= far) << lane;
            *enter = near;
        }
        (mask, enter)
    }

    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx2")]
    unsafe fn entries_avx2(&self, query: &Query, limit: f64) -> Entries {
        use std::arch::x86_64::*;
        let mut enter = [0.0; 8];
        let mut mask = 0;
        let widen = _mm256_set1_pd(WIDEN);
        let origin: [__m256d; 3] = std::array::from_fn(|axis| _mm256_set1_pd(query.ray.origin[axis]));
        let inverse: [__m256d; 3] = std::array::from_fn(|axis| _mm256_set1_pd(query.inverse[axis]));
        for half in 0..2 {
            let (mut near, mut far) = (_mm256_setzero_pd(), _mm256_set1_pd(limit));
            for axis in 0..3 {
                let side = usize::from(query.negative[axis]);
                let load = |side: usize| {
                    let four = &self.planes[axis][side][half * 4..half * 4 + 4];
                    // SAFETY: `four` is a slice of four floats.
                    unsafe { _mm256_cvtps_pd(_mm_loadu_ps(four.as_ptr())) }
                };
                let to = |plane| _mm256_mul_pd(_mm256_sub_pd(plane, origin[axis]), inverse[axis]);
                near = _mm256_max_pd(near, to(load(side)));
                far = _mm256_min_pd(far, _mm256_mul_pd(to(load(1 - side)), widen));
            }
            let hit = _mm256_cmp_pd::<_CMP_LE_OQ>(near, far);
            mask |= (_mm256_movemask_pd(hit) as u32) << (half * 4);
            // SAFETY: four doubles fit at index 0 and at index 4 of eight.
            unsafe { _mm256_storeu_pd(enter.as_mut_ptr().add(half * 4), near) };
        }
        (mask, enter)
    }

    /// The boxes that hold the point, as a bit mask.
    #[inline]
    pub fn around(&self, p: Vec3) -> u32 {
        let mut mask = 0xff;
        for axis in 0..3 {
            let [low, high] = &self.planes[axis];
            for lane in 0..8 {
                let holds = f64::from(low[lane]) <= p[axis] && p[axis] <= f64::from(high[lane]);
                mask &= !(u32::from(!holds) << lane);
            }
        }
        mask
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::{vec3, Ray};
    use crate::testing::Random;

    #[test]
    fn vector_path_equals_scalar_twin() {
        let mut random = Random::new(7);
        for _ in 0..2000 {
            let mut boxes = Boxes::EMPTY;
            for lane in 0..7 {
                let (a, b) = (random.vector(3.0), random.vector(3.0));
                boxes.set(lane, &Bounds::around([a, b]));
            }
            let mut direction = random.vector(1.0);
            if random.unit() < 0.3 {
                direction.y = 0.0;
            }
            let query = Query::new(Ray { origin: random.vector(4.0), direction });
            let limit = random.unit() * 10.0;
            assert_eq!(boxes.entries(&query, limit), boxes.entries_scalar(&query, limit));
        }
    }

    #[test]
    fn rounding_goes_outward() {
        let mut boxes = Boxes::EMPTY;
        let third = 1.0 / 3.0;
        boxes.set(0, &Bounds { min: Vec3::splat(-third), max: Vec3::splat(third) });
        assert_eq!(boxes.around(vec3(third, -third, third)), 1);
        assert_eq!(boxes.around(vec3(third + 1e-6, 0.0, 0.0)), 0);
    }
}
