//! Names of mirrors that are not written yet, so that their owners can already hold them.

macro_rules! pending {
    ($($name:ident),*) => {$(
        /// Mirror to come.
        #[derive(Clone, Debug, Default)]
        pub struct $name;

        #[cfg(feature = "python")]
        impl<'a, 'py> pyo3::FromPyObject<'a, 'py> for $name {
            type Error = pyo3::PyErr;
            fn extract(_: pyo3::Borrowed<'a, 'py, pyo3::PyAny>) -> pyo3::PyResult<Self> {
                Ok($name)
            }
        }
    )*};
}

pending!(Function, Pattern, PatternModifiers, ColorMap, Normal, ImageMapping, Turbulence);

#[allow(missing_docs)]
pub mod pattern {
    pub use super::{Pattern, PatternModifiers};
}
#[allow(missing_docs)]
pub mod normal {
    pub use super::Normal;
}
#[allow(missing_docs)]
pub mod image {
    pub use super::ImageMapping;
}
#[allow(missing_docs)]
pub mod warp {
    pub use super::Turbulence;
}
