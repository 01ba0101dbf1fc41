//! `--accelerator linear`: every item is tested. The oracle of the other procedures.

use super::Counters;

/// Nothing but the number of items.
#[derive(Debug)]
pub struct Linear {
    count: u32,
}

impl Linear {
    /// A list of `count` items.
    pub fn new(count: usize) -> Linear {
        Linear { count: count as u32 }
    }

    /// See [`super::Accelerator::along`].
    #[inline]
    pub fn along(
        &self,
        mut limit: f64,
        counters: &mut Counters,
        mut visit: impl FnMut(u32, f64, &mut Counters) -> f64,
    ) -> f64 {
        for item in 0..self.count {
            limit = visit(item, limit, counters);
            if limit == f64::NEG_INFINITY {
                break;
            }
        }
        limit
    }

    /// See [`super::Accelerator::around`].
    #[inline]
    pub fn around(&self, visit: impl FnMut(u32) -> bool) -> bool {
        (0..self.count).any(visit)
    }
}
