//! Spatial search: which boxes does a ray meet, which hold a point.
//!
//! One interface over several procedures; all of them offer at least every item whose box the ray meets, so that the
//! picture does not depend on the choice.

mod boxes;
mod build;
mod counters;
mod linear;
mod octree;
mod query;

pub use counters::{Counters, RayKind};
pub use linear::Linear;
pub use octree::Octree;
pub use query::Query;

use crate::math::{Bounds, Vec3};

/// The procedures to choose from (`--accelerator`).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum AcceleratorKind {
    /// Every item, one after the other.
    Linear,
    /// The loose, cost-split octree.
    #[default]
    Octree,
}

impl std::str::FromStr for AcceleratorKind {
    type Err = String;
    fn from_str(name: &str) -> Result<Self, String> {
        match name {
            "linear" => Ok(AcceleratorKind::Linear),
            "octree" => Ok(AcceleratorKind::Octree),
            _ => Err(format!("{name:?} is no accelerator: linear, octree")),
        }
    }
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
    /// See [`Octree`].
    Octree(Octree),
}

impl Accelerator {
    /// Builds the structure over finite boxes; item `i` is `boxes[i]`.
    pub fn build(kind: AcceleratorKind, boxes: &[Bounds]) -> Accelerator {
        match kind {
            AcceleratorKind::Linear => Accelerator::Linear(Linear::new(boxes.len())),
            AcceleratorKind::Octree => {
                let boxes: Vec<Bounds> = boxes.iter().map(padded).collect();
                Accelerator::Octree(Octree::build(&boxes, 1))
            }
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
            Accelerator::Octree(octree) => octree.along(query, limit, counters, visit),
        }
    }

    /// Visits items whose boxes hold `point` until `visit` returns true; whether it did.
    #[inline]
    pub fn around(&self, point: Vec3, visit: impl FnMut(u32) -> bool) -> bool {
        match self {
            Accelerator::Linear(linear) => linear.around(visit),
            Accelerator::Octree(octree) => octree.around(point, visit),
        }
    }
}
