//! SDL: `union`, `merge`, `intersection`, `difference` where they cannot be taken apart.
//!
//! A hit on a child counts if the point is inside all other children (intersection) or inside none (merge). Children
//! stand in a search tree: a ray asks only those whose boxes it meets, and a point only those whose boxes hold it; a
//! child that is all but a hole (the later ones of a difference) holds every point outside the hole's box.

use crate::accel::{Accelerator, AcceleratorKind, Counters, Query};
use crate::geometry::{Geometry, Hit, NodeId};
use crate::math::Vec3;

/// How children go together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Operation {
    /// All surfaces of all children.
    Union,
    /// The surface of the whole.
    Merge,
    /// What is inside every child.
    Intersection,
}

/// Whether a child can be skipped for points outside its box.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Beyond {
    /// No: its answer must be asked everywhere.
    Unknown,
    /// It holds all points outside the box.
    Inside,
    /// It holds no point outside the box.
    Outside,
}

/// Several nodes put together.
#[derive(Debug)]
pub struct Composite {
    operation: Operation,
    /// Children with their box's meaning: those in the tree first, by its item numbers.
    children: Vec<(NodeId, Beyond)>,
    /// How many of them are in the tree.
    in_tree: usize,
    tree: Accelerator,
    /// Whether the answer of some child in the tree matters outside its box.
    required: Vec<u32>,
}

/// Fewer children than this are asked one after the other.
const WORTH_A_TREE: usize = 3;

impl Composite {
    /// Puts nodes together; `nodes` holds them and all before them.
    pub fn new(
        operation: Operation,
        children: &[NodeId],
        nodes: &[crate::geometry::Node],
        kind: AcceleratorKind,
    ) -> Composite {
        let extent = |id: &NodeId| &nodes[*id as usize].extent;
        let (finite, infinite): (Vec<NodeId>, Vec<NodeId>) =
            children.iter().partition(|id| extent(id).surface.is_finite() && children.len() >= WORTH_A_TREE);
        let beyond = |id: &NodeId| {
            let e = extent(id);
            let within = |b: &crate::math::Bounds| b.is_empty() || e.surface.intersection(b) == *b;
            if within(&e.solid) {
                Beyond::Outside
            } else if within(&e.hollow) {
                Beyond::Inside
            } else {
                Beyond::Unknown
            }
        };
        let boxes: Vec<_> = finite.iter().map(|id| extent(id).surface).collect();
        let in_tree = finite.len();
        let children: Vec<_> = finite.iter().chain(&infinite).map(|id| (*id, beyond(id))).collect();
        // What a point outside a child's box would have to be told by the child itself.
        let decisive = if operation == Operation::Intersection { Beyond::Inside } else { Beyond::Outside };
        let required = (0..children.len() as u32)
            .filter(|&i| i as usize >= in_tree || children[i as usize].1 != decisive)
            .collect();
        Composite { operation, children, in_tree, tree: Accelerator::build(kind, &boxes), required }
    }

    /// The nodes put together.
    pub fn children(&self) -> impl Iterator<Item = NodeId> + '_ {
        self.children.iter().map(|c| c.0)
    }
}

impl Geometry {
    /// Offers those hits of the children that are on the surface of the whole.
    pub(crate) fn offer_composite(
        &self,
        composite: &Composite,
        query: &Query,
        from: f64,
        limit: f64,
        counters: &mut Counters,
        offer: &mut dyn FnMut(Hit, f64) -> f64,
    ) -> f64 {
        let mut inside = 0;
        let mut visit = |item: u32, limit: f64, counters: &mut Counters| {
            let id = composite.children[item as usize].0;
            self.offer_node(id, query, from, limit, counters, &mut |hit: Hit, limit: f64| {
                if self.is_on_surface(composite, item, query.ray.at(hit.crossing.t), &mut inside) {
                    offer(hit, limit)
                } else {
                    limit
                }
            })
        };
        let mut limit = composite.tree.along(query, limit, counters, &mut visit);
        for item in composite.in_tree..composite.children.len() {
            limit = visit(item as u32, limit, counters);
        }
        counters.inside += inside;
        limit
    }

    /// Whether a surface point of child `of` is on the surface of the whole.
    fn is_on_surface(&self, composite: &Composite, of: u32, point: Vec3, count: &mut u64) -> bool {
        match composite.operation {
            Operation::Union => true,
            Operation::Merge => !self.some_child(composite, point, Some(of), true, count),
            Operation::Intersection => !self.some_child(composite, point, Some(of), false, count),
        }
    }

    /// Whether `point` lies inside the whole.
    pub(crate) fn inside_composite(&self, composite: &Composite, point: Vec3, count: &mut u64) -> bool {
        match composite.operation {
            Operation::Union | Operation::Merge => self.some_child(composite, point, None, true, count),
            Operation::Intersection => !self.some_child(composite, point, None, false, count),
        }
    }

    /// Whether the answer of some child, but for one, to "inside?" is `answer`.
    fn some_child(
        &self,
        composite: &Composite,
        point: Vec3,
        but: Option<u32>,
        answer: bool,
        count: &mut u64,
    ) -> bool {
        let mut gives = |item: u32| {
            Some(item) != but && self.is_inside(composite.children[item as usize].0, point, count) == answer
        };
        if composite.required.iter().any(|&item| gives(item)) {
            return true;
        }
        composite.required.len() < composite.children.len() && composite.tree.around(point, gives)
    }
}
