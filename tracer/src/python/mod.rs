//! The thin Python binding of the core: `minipov.tracer._core`.

mod function;
mod question;
mod render;

use pyo3::prelude::*;

#[pymodule]
mod _core {
    use pyo3::prelude::*;

    #[pymodule_export]
    use super::function::{vturbulence, Function};
    #[pymodule_export]
    use super::question::Question;
    #[pymodule_export]
    use super::render::RenderJob;

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("MOST_TURNS", crate::function::patience::MOST_TURNS)
    }
}
