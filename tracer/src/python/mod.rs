//! The thin Python binding of the core: `minipov.tracer._core`.

use pyo3::prelude::*;

#[pymodule]
mod _core {
    #[allow(unused_imports)]
    use super::*;
}
