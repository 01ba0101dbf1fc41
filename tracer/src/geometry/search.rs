//! Shooting rays: the nearest hit, or any.

use std::cmp::Ordering;

use super::{Geometry, Node, NodeId, Solid};
use crate::accel::{Counters, Query, RayKind};
use crate::math::{Bounds, Ray, Vec3};
use crate::shape::{Crossing, Primitive};

/// Where a ray meets an object.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// Where on the ray, and where on the primitive.
    pub crossing: Crossing,
    /// The primitive.
    pub node: NodeId,
    /// The object at the top that it belongs to.
    pub object: NodeId,
}

/// What `Geometry::any` is told after each hit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Answer {
    /// Go on to other hits.
    Continue,
    /// Enough.
    Stop,
}

impl Geometry {
    /// The first hit with `from < t <= limit`. Where surfaces coincide exactly, the object whose box the ray enters first
    /// wins, else the first in the file; within a CSG the last child.
    pub fn nearest(
        &self,
        ray: &Ray,
        from: f64,
        limit: f64,
        kind: RayKind,
        counters: &mut Counters,
    ) -> Option<Hit> {
        let mut best: Option<Hit> = None;
        self.offer_all(ray, from, limit, kind, counters, &mut |hit, limit| match best {
            Some(b) if hit.crossing.t == b.crossing.t && !self.is_seen_first(ray, &hit, &b) => limit,
            _ => {
                best = Some(hit);
                hit.crossing.t
            }
        });
        best
    }

    /// Which of two hits at the same point is seen. POV-Ray asks objects in the order in which the ray enters their
    /// boxes; for boxes that share a side this hangs on the rounding of single precision, and the surfaces look speckled.
    #[cold]
    fn is_seen_first(&self, ray: &Ray, challenger: &Hit, holder: &Hit) -> bool {
        if challenger.object == holder.object || self.finite.len() + self.infinite.len() < BOXED {
            return wins_tie(challenger, holder);
        }
        let entry = |hit: &Hit| coarse_entry(&self.nodes[hit.object as usize].extent.surface, ray);
        match entry(challenger).total_cmp(&entry(holder)) {
            Ordering::Less => true,
            Ordering::Greater => false,
            Ordering::Equal => wins_tie(challenger, holder),
        }
    }

    /// The first hit of one object at the top with `from < t`.
    pub fn nearest_of(&self, object: NodeId, ray: &Ray, from: f64, counters: &mut Counters) -> Option<Hit> {
        let mut best = None;
        let mut keep = |hit: Hit, _: f64| {
            best = Some(Hit { object, ..hit });
            hit.crossing.t
        };
        self.offer_node(object, &Query::new(*ray), from, f64::INFINITY, counters, &mut keep);
        best
    }

    /// Shows every hit with `from < t <= limit`, in no certain order, until told to stop; whether it was.
    pub fn any(
        &self,
        ray: &Ray,
        from: f64,
        limit: f64,
        kind: RayKind,
        counters: &mut Counters,
        mut visit: impl FnMut(&Hit) -> Answer,
    ) -> bool {
        self.offer_all(ray, from, limit, kind, counters, &mut |hit, limit| match visit(&hit) {
            Answer::Continue => limit,
            Answer::Stop => f64::NEG_INFINITY,
        }) == f64::NEG_INFINITY
    }

    /// Shows the hits of one object at the top: the occluder that the last shadow ray met, or a bounding object.
    pub fn any_of(
        &self,
        node: NodeId,
        ray: &Ray,
        from: f64,
        limit: f64,
        counters: &mut Counters,
        mut visit: impl FnMut(&Hit) -> Answer,
    ) -> bool {
        self.offer_node(node, &Query::new(*ray), from, limit, counters, &mut |hit, limit| match visit(&hit) {
            Answer::Continue => limit,
            Answer::Stop => f64::NEG_INFINITY,
        }) == f64::NEG_INFINITY
    }

    #[inline]
    fn offer_all(
        &self,
        ray: &Ray,
        from: f64,
        mut limit: f64,
        kind: RayKind,
        counters: &mut Counters,
        offer: &mut impl FnMut(Hit, f64) -> f64,
    ) -> f64 {
        counters.rays[kind as usize] += 1;
        let query = Query::new(*ray);
        for &id in &self.infinite {
            if !self.nodes[id as usize].is_hidden(kind) {
                limit = self.offer_node(id, &query, from, limit, counters, &mut |hit: Hit, limit: f64| {
                    offer(Hit { object: id, ..hit }, limit)
                });
            }
        }
        self.tree.along(&query, limit, counters, |item, limit, counters| {
            let id = self.finite[item as usize];
            if self.nodes[id as usize].is_hidden(kind) {
                return limit;
            }
            self.offer_node(id, &query, from, limit, counters, &mut |hit: Hit, limit: f64| {
                offer(Hit { object: id, ..hit }, limit)
            })
        })
    }

    /// Offers the hits of one node.
    #[inline]
    pub(crate) fn offer_node<F: FnMut(Hit, f64) -> f64 + ?Sized>(
        &self,
        id: NodeId,
        query: &Query,
        from: f64,
        limit: f64,
        counters: &mut Counters,
        offer: &mut F,
    ) -> f64 {
        let node = &self.nodes[id as usize];
        if !node.bounded_by.is_empty() && !self.enters_bounds(node, query, counters) {
            return limit;
        }
        if node.clipped_by.is_empty() {
            return self.offer_unclipped(id, node, query, from, limit, counters, offer);
        }
        let mut inside = 0;
        let limit =
            self.offer_clipped(id, node, query, from, limit, counters, &mut |hit: Hit, limit: f64| {
                let point = query.ray.at(hit.crossing.t);
                if node.clipped_by.iter().all(|&clip| self.is_inside(clip, point, &mut inside)) {
                    offer(hit, limit)
                } else {
                    limit
                }
            });
        counters.inside += inside;
        limit
    }

    #[inline(never)]
    #[allow(clippy::too_many_arguments)] // one ray, one range, one place to count, one to answer
    fn offer_clipped(
        &self,
        id: NodeId,
        node: &Node,
        query: &Query,
        from: f64,
        limit: f64,
        counters: &mut Counters,
        offer: &mut dyn FnMut(Hit, f64) -> f64,
    ) -> f64 {
        self.offer_unclipped(id, node, query, from, limit, counters, offer)
    }

    #[inline]
    #[allow(clippy::too_many_arguments)]
    fn offer_unclipped<F: FnMut(Hit, f64) -> f64 + ?Sized>(
        &self,
        id: NodeId,
        node: &Node,
        query: &Query,
        from: f64,
        limit: f64,
        counters: &mut Counters,
        offer: &mut F,
    ) -> f64 {
        match &node.solid {
            Solid::Primitive { shape, place } => {
                let mut with_node = |crossing, limit| offer(Hit { crossing, node: id, object: id }, limit);
                match place {
                    None => shape.intersect(&query.ray, from, limit, counters, &mut with_node),
                    Some(place) => {
                        let ray = place.inverse_ray(&query.ray);
                        shape.intersect(&ray, from, limit, counters, &mut with_node)
                    }
                }
            }
            Solid::Composite(composite) => {
                self.offer_composite(composite, query, from, limit, counters, &mut |hit, limit| {
                    offer(hit, limit)
                })
            }
        }
    }

    /// Whether the ray meets every bounding object or starts inside it.
    fn enters_bounds(&self, node: &Node, query: &Query, counters: &mut Counters) -> bool {
        node.bounded_by.iter().all(|&bound| {
            self.is_inside(bound, query.ray.origin, &mut counters.inside.clone())
                || self.offer_node(bound, query, 0.0, f64::INFINITY, counters, &mut |_: Hit, _: f64| {
                    f64::NEG_INFINITY
                }) == f64::NEG_INFINITY
        })
    }

    /// Whether a ray is told all its crossings with the node.
    pub fn tells_all(&self, node: NodeId) -> bool {
        match &self.nodes[node as usize].solid {
            Solid::Primitive { shape, .. } => shape.tells_all(),
            Solid::Composite(_) => true,
        }
    }

    /// Whether `point` lies inside the node.
    pub fn inside(&self, point: Vec3, node: NodeId) -> bool {
        self.is_inside(node, point, &mut 0)
    }
}

impl Hit {
    /// The order in which a ray meets hits; of those at the same point the one that is seen comes first.
    pub fn order(&self, other: &Hit) -> Ordering {
        let tie = || match (wins_tie(self, other), wins_tie(other, self)) {
            (true, _) => Ordering::Less,
            (_, true) => Ordering::Greater,
            _ => Ordering::Equal,
        };
        self.crossing.t.total_cmp(&other.crossing.t).then_with(tie)
    }
}

/// Fewer objects than this POV-Ray asks one after the other.
const BOXED: usize = 3;

/// Where a ray's line enters a box that is kept as a corner and lengths, reckoned in single precision but for one sum.
fn coarse_entry(bounds: &Bounds, ray: &Ray) -> f64 {
    if !bounds.is_finite() {
        return f64::NEG_INFINITY;
    }
    let mut entry = f64::NEG_INFINITY;
    for axis in 0..3 {
        let direction = ray.direction[axis];
        if direction == 0.0 {
            continue;
        }
        let inverse = (1.0 / direction) as f32;
        let low = (bounds.min[axis] as f32 - ray.origin[axis] as f32) * inverse;
        let length = (bounds.max[axis] - bounds.min[axis]) as f32 * inverse;
        let near = if inverse > 0.0 { f64::from(low) } else { f64::from(low) + f64::from(length) };
        entry = entry.max(near);
    }
    entry
}

/// Which of two hits at the same point is seen: of two objects the first in the file, in a CSG the last.
fn wins_tie(challenger: &Hit, holder: &Hit) -> bool {
    let order = |hit: &Hit| (std::cmp::Reverse(hit.object), hit.node, hit.crossing.part);
    order(challenger) > order(holder)
}
