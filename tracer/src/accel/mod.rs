//! Spatial search: which boxes does a ray meet, which hold a point.
//!
//! One interface over several procedures; all of them offer at least every item whose box the ray meets, so that the
//! picture does not depend on the choice.

mod boxes;
mod build;
mod counters;
mod grid;
mod hierarchy;
mod linear;
mod octree;
mod query;
mod spheres;
#[cfg(test)]
mod tests;

pub use counters::{Counters, RayKind};
pub use grid::Grid;
pub use hierarchy::Hierarchy;
pub use linear::Linear;
pub use octree::Octree;
pub use query::Query;
pub use spheres::Spheres;

use crate::math::{Bounds, Vec3};

/// The procedures to choose from (`--accelerator`).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum AcceleratorKind {
    /// Every item, one after the other.
    Linear,
    /// Bounding spheres, one after the other.
    Spheres,
    /// The binary tree of bounding boxes.
    Hierarchy,
    /// The uniform grid.
    Grid,
    /// The loose, cost-split octree.
    #[default]
    Octree,
}

/// Share of its coordinates by which a box is widened past the rounding of what is inside.
const MARGIN: f64 = 1e-9;

fn padded(b: &Bounds) -> Bounds {
    let reach = b.min.map(f64::abs).max(b.max.map(f64::abs)).max_element();
    b.widened(MARGIN * reach)
}

/// A search structure over numbered boxes.
#[derive(Debug)]
pub enum Accelerator {
    /// See [`Linear`].
    Linear(Linear),
    /// See [`Spheres`].
    Spheres(Spheres),
    /// See [`Hierarchy`].
    Hierarchy(Hierarchy),
    /// See [`Grid`].
    Grid(Grid),
    /// See [`Octree`].
    Octree(Octree),
}

impl Accelerator {
    /// Builds the structure over finite boxes; item `i` is `boxes[i]`.
    pub fn build(kind: AcceleratorKind, boxes: &[Bounds]) -> Accelerator {
        let boxes: Vec<Bounds> = boxes.iter().map(padded).collect();
        match kind {
            AcceleratorKind::Linear => Accelerator::Linear(Linear::new(boxes.len())),
            AcceleratorKind::Spheres => Accelerator::Spheres(Spheres::build(&boxes)),
            AcceleratorKind::Hierarchy => Accelerator::Hierarchy(Hierarchy::build(&boxes)),
            AcceleratorKind::Grid => Accelerator::Grid(Grid::build(&boxes)),
            AcceleratorKind::Octree => Accelerator::Octree(Octree::build(&boxes, 1)),
        }
    }

    /// Visits items that the ray may meet before `limit`. `visit` gets an item and the limit, and returns the new
    /// limit: the old one, a nearer one, or negative infinity to stop. The last limit is returned.
    #[inline]
    pub fn along(
        &self,
        query: &Query,
        limit: f64,
        counters: &mut Counters,
        visit: impl FnMut(u32, f64, &mut Counters) -> f64,
    ) -> f64 {
        match self {
            Accelerator::Linear(linear) => linear.along(limit, counters, visit),
            Accelerator::Spheres(spheres) => spheres.along(query, limit, counters, visit),
            Accelerator::Hierarchy(hierarchy) => hierarchy.along(query, limit, counters, visit),
            Accelerator::Grid(grid) => grid.along(query, limit, counters, visit),
            Accelerator::Octree(octree) => octree.along(query, limit, counters, visit),
        }
    }

    /// Visits items whose boxes hold `point` until `visit` returns true; whether it did.
    #[inline]
    pub fn around(&self, point: Vec3, visit: impl FnMut(u32) -> bool) -> bool {
        match self {
            Accelerator::Linear(linear) => linear.around(visit),
            Accelerator::Spheres(spheres) => spheres.around(point, visit),
            Accelerator::Hierarchy(hierarchy) => hierarchy.around(point, visit),
            Accelerator::Grid(grid) => grid.around(point, visit),
            Accelerator::Octree(octree) => octree.around(point, visit),
        }
    }
}
