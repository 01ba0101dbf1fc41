//! Unions of the scene graph: which Python class is which variant.

/// Conversion of a union: the class name picks the variant, whose content is extracted from the object itself.
///
/// `from_class_name!(Texture { PlainTexture => Plain, LayeredTexture => Layered });`
macro_rules! from_class_name {
    ($type:ident { $($class:ident => $variant:ident),* $(,)? }) => {
        #[cfg(feature = "python")]
        impl<'py> pyo3::FromPyObject<'_, 'py> for $type {
            type Error = pyo3::PyErr;

            fn extract(obj: pyo3::Borrowed<'_, 'py, pyo3::PyAny>) -> pyo3::PyResult<$type> {
                use pyo3::types::{PyAnyMethods, PyStringMethods, PyTypeMethods};
                let class = obj.get_type().name()?;
                crate::graph::nesting::level(|| match class.to_str()? {
                    $(stringify!($class) => Ok($type::$variant(obj.extract()?)),)*
                    other => Err(pyo3::exceptions::PyTypeError::new_err(format!(
                        "{other} is no {}", stringify!($type)
                    ))),
                })
            }
        }
    };
}
