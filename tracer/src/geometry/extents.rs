//! Boxes around the surface, the inside and the outside of nodes.

use super::node::{overlaps_of_others, Extent, Node, NodeId};
use crate::csg::Operation;
use crate::math::{Bounds, Transform};
use crate::shape::{Primitive, Shape};

/// Extent of a primitive in its place.
pub fn of_primitive(shape: &Shape, place: Option<&Transform>, inverse: bool) -> Extent {
    let placed = |bounds: Bounds| match (shape, place) {
        (Shape::Sphere(sphere), Some(place)) => {
            sphere.bounds_in(place).unwrap_or_else(|| bounds.transformed(place))
        }
        (_, Some(place)) => bounds.transformed(place),
        (_, None) => bounds,
    };
    let surface = placed(shape.bounds());
    let inside = placed(shape.solid_bounds());
    let outside = match shape {
        Shape::Plane(plane) => placed(plane.hollow_bounds()),
        _ => Bounds::INFINITE,
    };
    let (solid, hollow) = match (shape.solid(), inverse) {
        (false, _) => (Bounds::EMPTY, Bounds::INFINITE),
        (true, false) => (inside, outside),
        (true, true) => (outside, inside),
    };
    Extent { surface, solid, hollow }
}

/// Extent of several nodes put together.
pub fn of_composite(operation: Operation, children: &[NodeId], nodes: &[Node]) -> Extent {
    let extents: Vec<&Extent> = children.iter().map(|&id| &nodes[id as usize].extent).collect();
    let all = |pick: fn(&Extent) -> Bounds| extents.iter().map(|e| pick(e)).collect::<Vec<_>>();
    let union = |boxes: &[Bounds]| boxes.iter().fold(Bounds::EMPTY, |sum, b| sum.union(b));
    let overlap = |boxes: &[Bounds]| boxes.iter().fold(Bounds::INFINITE, |sum, b| sum.intersection(b));
    // A child's surface counts where the other children let it, and where it encloses something, at that.
    let cut = |boxes: &[Bounds]| {
        let kept = extents.iter().zip(boxes).zip(overlaps_of_others(boxes)).map(|((e, own), others)| {
            let kept = e.surface.intersection(&others);
            if own.is_empty() {
                kept
            } else {
                kept.intersection(own)
            }
        });
        kept.filter(|b| !b.is_empty()).fold(Bounds::EMPTY, |sum, b| sum.union(&b))
    };
    let (surfaces, solids, hollows) = (all(|e| e.surface), all(|e| e.solid), all(|e| e.hollow));
    match operation {
        Operation::Union => {
            Extent { surface: union(&surfaces), solid: union(&solids), hollow: overlap(&hollows) }
        }
        Operation::Merge => {
            Extent { surface: cut(&hollows), solid: union(&solids), hollow: overlap(&hollows) }
        }
        Operation::Intersection => {
            Extent { surface: cut(&solids), solid: overlap(&solids), hollow: union(&hollows) }
        }
    }
}

/// Takes away what a clipping object takes away.
pub fn clip(extent: &mut Extent, by: &Extent) {
    extent.surface = extent.surface.intersection(&by.solid);
    extent.solid = extent.solid.intersection(&by.solid);
    extent.hollow = extent.hollow.union(&by.hollow);
}
