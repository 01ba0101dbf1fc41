//! `--accelerator octree`: loose, cost-split, partitioned by objects.
//!
//! Each item lies in one cell, by the centre of its box, and cells grow to fit; so nothing is tested twice. A cell has
//! eight children with tight boxes, made by three halvings; the child's number says on which side of each it lies.
//! Visiting child `k XOR mask` for k = 0..7, where the mask has a bit for each halving that the ray runs against, goes
//! from near to far without sorting.

use arrayvec::ArrayVec;

use super::boxes::Boxes;
use super::build::Items;
use super::{Counters, Query};
use crate::math::{Bounds, Vec3};

/// A child number's parts: leaf flag, number of items, first item or cell.
const LEAF: u32 = 1 << 31;
const COUNT_SHIFT: u32 = 27;
const INDEX: u32 = (1 << COUNT_SHIFT) - 1;
/// More open cells than any path can leave behind: 7 per level.
const STACK: usize = 128;
/// Below this level groups are halved by number: with 2^27 items the tree then ends at level 18.
const DEEP: usize = 9;
/// Entries are stacked in single precision; the limit is stretched past their rounding.
const SLACK: f64 = 1.0 + 2.0 * f32::EPSILON as f64;

#[derive(Clone, Debug)]
#[repr(C, align(64))]
struct Cell {
    boxes: Boxes,
    children: [u32; 8],
    axes: [u8; 3],
}

/// A search tree over boxes.
#[derive(Debug, Default)]
pub struct Octree {
    cells: Vec<Cell>,
    items: Vec<u32>,
}

impl Octree {
    /// Builds the tree over finite boxes; leaves hold up to `leaf_size` (at most 15) items.
    pub fn build(boxes: &[Bounds], leaf_size: usize) -> Octree {
        let centers = boxes.iter().map(|b| b.min + b.max).collect();
        let mut octree = Octree { cells: Vec::new(), items: (0..boxes.len() as u32).collect() };
        let mut order = std::mem::take(&mut octree.items);
        if !order.is_empty() {
            octree.add(&Items { boxes, centers }, &mut order, 0, leaf_size.min(15), 0);
        }
        octree.items = order;
        octree
    }

    /// The items in the order of the leaves.
    pub fn order(&self) -> &[u32] {
        &self.items
    }

    /// Numbers the items by their places in [`Self::order`], for owners that keep their own data in that order.
    pub fn renumber(&mut self) {
        self.items = (0..self.items.len() as u32).collect();
    }

    fn add(&mut self, items: &Items, order: &mut [u32], start: usize, leaf_size: usize, depth: usize) -> u32 {
        let index = self.cells.len();
        self.cells.push(Cell { boxes: Boxes::EMPTY, children: [LEAF; 8], axes: [0; 3] });
        let split = items.split(order, depth > DEEP);
        self.cells[index].axes = split.axes;
        for (lane, group) in split.groups.into_iter().enumerate() {
            if group.is_empty() {
                continue;
            }
            let at = start + group.start;
            let members = &mut order[group];
            let bounds = members.iter().fold(Bounds::EMPTY, |b, &i| b.union(&items.boxes[i as usize]));
            self.cells[index].boxes.set(lane, &bounds);
            self.cells[index].children[lane] = if members.len() <= leaf_size {
                LEAF | (members.len() as u32) << COUNT_SHIFT | at as u32
            } else {
                self.add(items, members, at, leaf_size, depth + 1)
            };
        }
        index as u32
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
        if self.cells.is_empty() {
            return limit;
        }
        let mut stack = ArrayVec::<(u32, f32), STACK>::new();
        stack.push((0, 0.0));
        while let Some((child, entry)) = stack.pop() {
            if f64::from(entry) > limit * SLACK {
                continue;
            }
            if child & LEAF != 0 {
                let first = (child & INDEX) as usize;
                let count = (child >> COUNT_SHIFT & 15) as usize;
                for &item in &self.items[first..first + count] {
                    limit = visit(item, limit, counters);
                }
                continue;
            }
            let cell = &self.cells[child as usize];
            counters.cells += 1;
            counters.boxes += 8;
            let (mut mask, entries) = cell.boxes.entries(query, limit);
            if mask == 0 {
                continue;
            }
            let against =
                cell.axes.iter().fold(0, |m, &axis| m << 1 | usize::from(query.negative[usize::from(axis)]));
            // The farthest goes on the stack first.
            for k in (0..8).rev() {
                let lane = k ^ against;
                if mask >> lane & 1 != 0 {
                    stack.push((cell.children[lane], entries[lane] as f32));
                    mask &= !(1 << lane);
                    if mask == 0 {
                        break;
                    }
                }
            }
        }
        limit
    }

    /// See [`super::Accelerator::around`].
    pub fn around(&self, point: Vec3, mut visit: impl FnMut(u32) -> bool) -> bool {
        if self.cells.is_empty() {
            return false;
        }
        let mut stack = ArrayVec::<u32, STACK>::new();
        stack.push(0);
        while let Some(child) = stack.pop() {
            if child & LEAF != 0 {
                let first = (child & INDEX) as usize;
                let count = (child >> COUNT_SHIFT & 15) as usize;
                if self.items[first..first + count].iter().any(|&item| visit(item)) {
                    return true;
                }
                continue;
            }
            let cell = &self.cells[child as usize];
            let mut mask = cell.boxes.around(point);
            while mask != 0 {
                stack.push(cell.children[mask.trailing_zeros() as usize]);
                mask &= mask - 1;
            }
        }
        false
    }
}
