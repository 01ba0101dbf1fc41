//! Functions can run for ever (`sum(i, 0, 1e300, ...)`): how long a loop may be, and how a render stops one.

use std::cell::RefCell;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::Arc;

/// A `sum` or `prod` of more turns than this is no number: it would not end while anybody waits.
pub const MOST_TURNS: f64 = 1e9;

/// A running loop asks after so many turns whether it shall stop; a power of two.
pub const TURNS_AT_ONCE: u64 = 64;

thread_local! {
    static CANCELLED: RefCell<Option<Arc<AtomicBool>>> = const { RefCell::new(None) };
}

/// Functions that run in this thread stop when the flag is set; their values do not matter then.
pub fn heed(cancelled: &Arc<AtomicBool>) {
    CANCELLED.set(Some(Arc::clone(cancelled)));
}

/// Whether to stop.
pub fn is_over() -> bool {
    CANCELLED.with_borrow(|flag| flag.as_ref().is_some_and(|flag| flag.load(Ordering::Relaxed)))
}
