//! Every procedure offers the items whose boxes a ray meets, each once.

use super::{Accelerator, AcceleratorKind, Counters, Query};
use crate::math::{vec3, Bounds, Ray, Vec3};
use crate::testing::Random;

const KINDS: [AcceleratorKind; 4] =
    [AcceleratorKind::Spheres, AcceleratorKind::Hierarchy, AcceleratorKind::Grid, AcceleratorKind::Octree];

fn boxes(random: &mut Random, count: usize, flat: bool) -> Vec<Bounds> {
    let squash = if flat { vec3(1.0, 0.0, 1.0) } else { Vec3::splat(1.0) };
    (0..count)
        .map(|_| {
            let corner = random.vector(5.0).mul_each(squash);
            Bounds::around([corner, corner + random.vector(0.6).mul_each(squash)])
        })
        .collect()
}

/// Where a ray meets a box, as an item would answer.
fn meets(bounds: &Bounds, query: &Query, limit: f64) -> bool {
    super::boxes::entry(bounds, query, limit).is_some()
}

#[test]
fn rays_are_offered_every_box_that_they_meet() {
    let mut random = Random::new(11);
    for (count, flat) in [(0, false), (1, false), (7, true), (300, false), (300, true)] {
        let boxes = boxes(&mut random, count, flat);
        for kind in KINDS {
            let accelerator = Accelerator::build(kind, &boxes);
            for number in 0..200 {
                let mut direction = random.vector(1.0);
                if number % 5 == 0 {
                    direction = vec3(0.0, direction.y, 0.0);
                }
                let query = Query::new(Ray { origin: random.vector(8.0), direction });
                let limit = if number % 3 == 0 { 4.0 } else { f64::INFINITY };
                let mut offered = vec![0; count];
                accelerator.along(&query, limit, &mut Counters::default(), |item, limit, _| {
                    offered[item as usize] += 1;
                    limit
                });
                for (item, bounds) in boxes.iter().enumerate() {
                    assert!(offered[item] <= 1, "{kind:?}: item {item} twice");
                    assert!(
                        offered[item] == 1 || !meets(bounds, &query, limit),
                        "{kind:?}: item {item} missed"
                    );
                }
            }
        }
    }
}

#[test]
fn points_are_offered_every_box_around_them() {
    let mut random = Random::new(12);
    let boxes = boxes(&mut random, 200, false);
    for kind in KINDS {
        let accelerator = Accelerator::build(kind, &boxes);
        for _ in 0..300 {
            let point = random.vector(5.0);
            let mut offered = vec![false; boxes.len()];
            accelerator.around(point, |item| {
                offered[item as usize] = true;
                false
            });
            for (item, bounds) in boxes.iter().enumerate() {
                assert!(offered[item] || !bounds.contains(point), "{kind:?}: item {item} missed");
            }
        }
    }
}
