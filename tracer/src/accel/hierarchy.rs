//! `--accelerator hierarchy`: a tree of bounding boxes, halved by number along the longest side, as the textbooks have it.

use arrayvec::ArrayVec;

use super::boxes::entry;
use super::{Counters, Query};
use crate::math::{Bounds, Vec3};

/// Deeper than any tree of 2^32 items that is halved by number.
const STACK: usize = 64;

/// A box with either an item in it or two further boxes.
#[derive(Debug)]
struct Node {
    bounds: Bounds,
    content: Content,
}

#[derive(Debug)]
enum Content {
    Item(u32),
    /// The number of the second box; the first follows this one. The axis tells along which they were parted.
    Two(u32, u8),
}

/// A binary tree, the root first.
#[derive(Debug, Default)]
pub struct Hierarchy {
    nodes: Vec<Node>,
}

impl Hierarchy {
    /// Builds the tree over finite boxes.
    pub fn build(boxes: &[Bounds]) -> Hierarchy {
        let mut tree = Hierarchy::default();
        let mut items: Vec<u32> = (0..boxes.len() as u32).collect();
        if !items.is_empty() {
            tree.add(boxes, &mut items);
        }
        tree
    }

    fn add(&mut self, boxes: &[Bounds], items: &mut [u32]) {
        let of = |item: &u32| &boxes[*item as usize];
        let bounds = items.iter().fold(Bounds::EMPTY, |sum, item| sum.union(of(item)));
        if let [item] = items {
            self.nodes.push(Node { bounds, content: Content::Item(*item) });
            return;
        }
        let size = bounds.max - bounds.min;
        let axis = (0..3).max_by(|&a, &b| size[a].total_cmp(&size[b])).unwrap_or(0);
        let center = |item: &u32| of(item).min[axis] + of(item).max[axis];
        items.sort_by(|a, b| center(a).total_cmp(&center(b)));
        let index = self.nodes.len();
        self.nodes.push(Node { bounds, content: Content::Two(0, axis as u8) });
        let (low, high) = items.split_at_mut(items.len() / 2);
        self.add(boxes, low);
        self.nodes[index].content = Content::Two(self.nodes.len() as u32, axis as u8);
        self.add(boxes, high);
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
        if self.nodes.is_empty() {
            return limit;
        }
        let mut stack = ArrayVec::<u32, STACK>::new();
        stack.push(0);
        while let Some(index) = stack.pop() {
            let node = &self.nodes[index as usize];
            counters.boxes += 1;
            if entry(&node.bounds, query, limit).is_none() {
                continue;
            }
            match node.content {
                Content::Item(item) => limit = visit(item, limit, counters),
                Content::Two(second, axis) => {
                    counters.cells += 1;
                    // The nearer of the two comes off the stack first.
                    let against = query.negative[usize::from(axis)];
                    let order = if against { [index + 1, second] } else { [second, index + 1] };
                    stack.extend(order);
                }
            }
        }
        limit
    }

    /// See [`super::Accelerator::around`].
    pub fn around(&self, point: Vec3, mut visit: impl FnMut(u32) -> bool) -> bool {
        let mut open = if self.nodes.is_empty() { vec![] } else { vec![0u32] };
        while let Some(index) = open.pop() {
            let node = &self.nodes[index as usize];
            if !node.bounds.contains(point) {
                continue;
            }
            match node.content {
                Content::Item(item) if visit(item) => return true,
                Content::Item(_) => {}
                Content::Two(second, _) => open.extend([second, index + 1]),
            }
        }
        false
    }
}
