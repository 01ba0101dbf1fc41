//! The thin Python binding of the core: `minipov.tracer._core`.

mod render;

use pyo3::prelude::*;

#[pymodule]
mod _core {
    #[pymodule_export]
    use super::render::RenderJob;
}
