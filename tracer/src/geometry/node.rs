//! One thing that rays can hit.

use crate::accel::RayKind;
use crate::csg::Composite;
use crate::math::{Bounds, Transform};
use crate::shape::Shape;

/// Number of a node.
pub type NodeId = u32;

/// A primitive or a CSG.
#[derive(Debug)]
pub enum Solid {
    /// A primitive; `place` carries its own space into the world (none: they are the same).
    Primitive {
        /// The shape in its own space.
        shape: Shape,
        /// From its space to the world.
        place: Option<Box<Transform>>,
    },
    /// Several nodes put together.
    Composite(Box<Composite>),
}

/// A placed object.
#[derive(Debug)]
pub struct Node {
    /// What it is.
    pub solid: Solid,
    /// Inside and outside are exchanged (primitives only; CSG hands it down).
    pub inverse: bool,
    /// Has no inside, ever.
    pub patch: bool,
    /// Bit k set: rays of kind k pass by.
    pub hidden: u8,
    /// Only what lies inside all of these exists.
    pub clipped_by: Box<[NodeId]>,
    /// A ray that misses one of these misses the node.
    pub bounded_by: Box<[NodeId]>,
    /// Where things are.
    pub extent: Extent,
}

impl Node {
    /// Whether rays of this kind pass by.
    #[inline]
    pub fn is_hidden(&self, kind: RayKind) -> bool {
        self.hidden >> kind as usize & 1 != 0
    }
}

/// Boxes in the world around parts of a node.
#[derive(Clone, Copy, Debug)]
pub struct Extent {
    /// Around its surface.
    pub surface: Bounds,
    /// Around its inside.
    pub solid: Bounds,
    /// Around its outside.
    pub hollow: Bounds,
}

/// The overlap of all boxes but the one at each place.
pub fn overlaps_of_others(boxes: &[Bounds]) -> Vec<Bounds> {
    let mut after = vec![Bounds::INFINITE; boxes.len() + 1];
    for i in (0..boxes.len()).rev() {
        after[i] = after[i + 1].intersection(&boxes[i]);
    }
    let mut before = Bounds::INFINITE;
    (0..boxes.len())
        .map(|i| {
            let others = before.intersection(&after[i + 1]);
            before = before.intersection(&boxes[i]);
            others
        })
        .collect()
}
