//! Which objects hold a point.

use super::{Geometry, NodeId, Solid};
use crate::math::Vec3;
use crate::shape::Primitive;

impl Geometry {
    /// The objects at the top that hold `point`, in file order.
    pub fn containing(&self, point: Vec3) -> Vec<NodeId> {
        let mut holders: Vec<NodeId> =
            self.infinite.iter().copied().filter(|&id| self.inside(point, id)).collect();
        self.tree.around(point, |item| {
            let id = self.finite[item as usize];
            if self.inside(point, id) {
                holders.push(id);
            }
            false
        });
        holders.sort_unstable();
        holders
    }

    /// Whether `point` lies inside the node; `count` is raised by the number of tests.
    pub(crate) fn is_inside(&self, id: NodeId, point: Vec3, count: &mut u64) -> bool {
        let node = &self.nodes[id as usize];
        if node.patch || !node.clipped_by.iter().all(|&clip| self.is_inside(clip, point, count)) {
            return false;
        }
        match &node.solid {
            Solid::Primitive { shape, place } => {
                *count += 1;
                let local = place.as_ref().map_or(point, |place| place.inverse_point(point));
                shape.inside(local) != node.inverse
            }
            Solid::Composite(composite) => self.inside_composite(composite, point, count),
        }
    }
}
