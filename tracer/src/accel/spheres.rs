//! `--accelerator spheres`: one level of bounding spheres, tested one after the other.

use super::{Counters, Query};
use crate::math::{Bounds, Vec3};

/// Share of its distance by which a sphere is widened past the rounding of the test.
const SLACK: f64 = 1e-12;

/// A sphere around each item.
#[derive(Debug)]
pub struct Spheres {
    /// Centre and squared radius.
    spheres: Vec<(Vec3, f64)>,
}

impl Spheres {
    /// Puts a sphere around each box.
    pub fn build(boxes: &[Bounds]) -> Spheres {
        let around = |b: &Bounds| ((b.min + b.max) * 0.5, (b.max - b.min).length_squared() * 0.25);
        Spheres { spheres: boxes.iter().map(around).collect() }
    }

    /// See [`super::Accelerator::along`].
    #[inline]
    pub fn along(
        &self,
        query: &Query,
        mut limit: f64,
        counters: &mut Counters,
        mut visit: impl FnMut(u32, f64, &mut Counters) -> f64,
    ) -> f64 {
        let direction = query.ray.direction;
        let squared_length = direction.length_squared();
        for (item, (center, squared_radius)) in self.spheres.iter().enumerate() {
            counters.boxes += 1;
            let to_center = *center - query.ray.origin;
            let squared_distance = to_center.length_squared();
            let radius2 = squared_radius + SLACK * squared_distance;
            let middle = to_center.dot(direction) / squared_length;
            let half_chord2 = radius2 - (squared_distance - middle * middle * squared_length);
            let outside = squared_distance > radius2;
            if half_chord2 < 0.0 || outside && middle < 0.0 {
                continue;
            }
            if outside && middle - (half_chord2 / squared_length).sqrt() > limit {
                continue;
            }
            limit = visit(item as u32, limit, counters);
            if limit == f64::NEG_INFINITY {
                break;
            }
        }
        limit
    }

    /// See [`super::Accelerator::around`].
    pub fn around(&self, point: Vec3, mut visit: impl FnMut(u32) -> bool) -> bool {
        self.spheres.iter().enumerate().any(|(item, (center, squared_radius))| {
            let squared_distance = (point - *center).length_squared();
            squared_distance <= squared_radius * (1.0 + SLACK) && visit(item as u32)
        })
    }
}
