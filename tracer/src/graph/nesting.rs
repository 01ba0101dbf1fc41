//! How deeply a scene's parts may be nested: all that walks the graph recurses, and its stack is finite.

use std::cell::Cell;

use pyo3::exceptions::PyRecursionError;
use pyo3::{PyErr, PyResult};

/// Levels of unions (objects in objects, functions in functions, operations in operations, ...) on one path.
pub const MOST_LEVELS: usize = 5000;

thread_local! {
    /// Levels above what is being converted.
    static DEPTH: Cell<usize> = const { Cell::new(0) };
    /// Levels of the highest part converted so far at this level.
    static HEIGHT: Cell<usize> = const { Cell::new(0) };
    /// Whether a conversion was refused: on its way up the error is wrapped once a level.
    static REFUSED: Cell<bool> = const { Cell::new(false) };
}

/// Converts something that may hold more of its kind.
///
/// # Errors
/// It is nested too deeply.
pub fn level<T>(convert: impl FnOnce() -> PyResult<T>) -> PyResult<T> {
    let depth = DEPTH.replace(DEPTH.get() + 1);
    let beside = HEIGHT.replace(0);
    let converted = if depth < MOST_LEVELS { convert() } else { Err(too_deep()) };
    DEPTH.set(depth);
    let height = HEIGHT.get() + 1;
    HEIGHT.set(height.max(beside));
    if height > MOST_LEVELS && converted.is_ok() {
        return Err(too_deep());
    }
    converted
}

/// Converts a node; also gives how many levels it has.
pub fn measured<T>(convert: impl FnOnce() -> T) -> (T, usize) {
    let beside = HEIGHT.replace(0);
    let converted = convert();
    let height = HEIGHT.get();
    HEIGHT.set(height.max(beside));
    (converted, height)
}

/// A node of so many levels, which has been converted before, is part of this level too.
pub fn reused(height: usize) {
    HEIGHT.set(HEIGHT.get().max(height));
}

/// Ends a conversion: gives the plain error if it was refused here, and forgets what was converted.
pub fn end() -> PyResult<()> {
    HEIGHT.set(0);
    if REFUSED.take() {
        let message =
            format!("nested too deeply: more than {MOST_LEVELS} levels of objects, textures or functions");
        return Err(PyRecursionError::new_err(message));
    }
    Ok(())
}

fn too_deep() -> PyErr {
    REFUSED.set(true);
    PyRecursionError::new_err("nested too deeply")
}
