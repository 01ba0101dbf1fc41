//! Building the octree: three halvings per cell, each along the axis where it saves most.

use std::ops::Range;

use crate::math::{Bounds, Vec3};

const BINS: usize = 16;

/// The eight groups of a cell and the axes of its three halvings; group number's highest bit tells the first.
pub struct Split {
    /// Ranges of the order, possibly empty.
    pub groups: [Range<usize>; 8],
    /// Axis of the halving that decides bit 2, bit 1, bit 0.
    pub axes: [u8; 3],
}

/// Items to be ordered.
pub struct Items<'a> {
    /// Box of each item.
    pub boxes: &'a [Bounds],
    /// Twice the centre of each box.
    pub centers: Vec<Vec3>,
}

/// A halving of one group: where to cut, and what the two halves cost.
#[derive(Clone, Copy)]
struct Cut {
    position: f64,
    cost: f64,
}

/// Half the surface of a box.
fn area(b: &Bounds) -> f64 {
    if b.is_empty() {
        return 0.0;
    }
    let d = b.max - b.min;
    d.x * d.y + d.y * d.z + d.z * d.x
}

impl Items<'_> {
    /// Orders `order` so that the eight groups lie one after the other; `by_number` halves without looking.
    pub fn split(&self, order: &mut [u32], by_number: bool) -> Split {
        let mut groups: Vec<_> = std::iter::once(0..order.len()).collect();
        let axes = std::array::from_fn(|_| {
            let (axis, cuts) = self.best_cuts(order, &groups);
            let halves = groups.iter().zip(cuts).flat_map(|(group, cut)| {
                let cut = cut.filter(|_| !by_number);
                self.halve(order, group.clone(), axis, cut)
            });
            groups = halves.collect();
            axis as u8
        });
        Split { groups: groups.try_into().expect("three halvings give eight groups"), axes }
    }

    /// The axis along which halving all groups costs least, and the cut of each group.
    fn best_cuts(&self, order: &[u32], groups: &[Range<usize>]) -> (usize, Vec<Option<Cut>>) {
        let along = |axis: usize| -> (usize, Vec<Option<Cut>>) {
            (axis, groups.iter().map(|g| self.cut(&order[g.clone()], axis)).collect())
        };
        // A group that cannot be cut stays as it is, at what it costs whole.
        let cost = |cuts: &[Option<Cut>]| -> f64 {
            groups
                .iter()
                .zip(cuts)
                .map(|(g, c)| c.map_or_else(|| self.cost(&order[g.clone()]), |c| c.cost))
                .sum()
        };
        let [x, y, z] = [0, 1, 2].map(along);
        [y, z].into_iter().fold(x, |best, other| if cost(&other.1) < cost(&best.1) { other } else { best })
    }

    fn cost(&self, group: &[u32]) -> f64 {
        let bounds = group.iter().fold(Bounds::EMPTY, |b, &i| b.union(&self.boxes[i as usize]));
        area(&bounds) * group.len() as f64
    }

    /// The cheapest of the cuts between bins; none where all centres coincide.
    fn cut(&self, group: &[u32], axis: usize) -> Option<Cut> {
        let center = |i: &u32| self.centers[*i as usize][axis];
        let (low, high) = group
            .iter()
            .map(center)
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), c| (l.min(c), h.max(c)));
        if high <= low {
            return None;
        }
        let scale = BINS as f64 / (high - low);
        let mut bins = [(Bounds::EMPTY, 0usize); BINS];
        for i in group {
            let bin = &mut bins[(((center(i) - low) * scale) as usize).min(BINS - 1)];
            *bin = (bin.0.union(&self.boxes[*i as usize]), bin.1 + 1);
        }
        let mut right = [0.0; BINS];
        let mut sum = (Bounds::EMPTY, 0usize);
        for k in (1..BINS).rev() {
            sum = (sum.0.union(&bins[k].0), sum.1 + bins[k].1);
            right[k] = area(&sum.0) * sum.1 as f64;
        }
        sum = (Bounds::EMPTY, 0);
        let mut best: Option<Cut> = None;
        for k in 1..BINS {
            sum = (sum.0.union(&bins[k - 1].0), sum.1 + bins[k - 1].1);
            let cost = area(&sum.0) * sum.1 as f64 + right[k];
            if sum.1 < group.len() && best.is_none_or(|b| cost < b.cost) {
                best = Some(Cut { position: low + k as f64 / scale, cost });
            }
        }
        best
    }

    /// Parts one group; by number where centres coincide.
    fn halve(
        &self,
        order: &mut [u32],
        group: Range<usize>,
        axis: usize,
        cut: Option<Cut>,
    ) -> [Range<usize>; 2] {
        let (start, end) = (group.start, group.end);
        let items = &mut order[group];
        let mut middle = match cut {
            Some(cut) => partition(items, |i| self.centers[i as usize][axis] < cut.position),
            None => items.len().div_ceil(2),
        };
        if middle == 0 || middle == items.len() {
            middle = items.len().div_ceil(2);
        }
        [start..start + middle, start + middle..end]
    }
}

/// Moves the items of the first kind to the front, keeping both in order; returns their number.
fn partition(items: &mut [u32], first: impl Fn(u32) -> bool) -> usize {
    let (front, back): (Vec<u32>, Vec<u32>) = items.iter().partition(|&&i| first(i));
    items[..front.len()].copy_from_slice(&front);
    items[front.len()..].copy_from_slice(&back);
    front.len()
}
