//! Plain values: points of curves, and keywords read from strings.

/// Two numbers: a point of a curve, a texture coordinate.
pub type Vec2 = [f64; 2];
/// Four numbers: a quaternion.
pub type Vec4 = [f64; 4];

/// An enum whose variants are SDL keywords, read from Python strings.
macro_rules! keywords {
    ($(#[$doc:meta])* $name:ident { $($variant:ident = $word:literal),* $(,)? }) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum $name {
            $(#[doc = concat!("`", $word, "`")] $variant),*
        }

        impl std::str::FromStr for $name {
            type Err = String;
            fn from_str(word: &str) -> Result<Self, String> {
                match word {
                    $($word => Ok($name::$variant),)*
                    _ => Err(format!("{word:?} is no {}", stringify!($name))),
                }
            }
        }

        #[cfg(feature = "python")]
        impl<'a, 'py> pyo3::FromPyObject<'a, 'py> for $name {
            type Error = pyo3::PyErr;
            fn extract(object: pyo3::Borrowed<'a, 'py, pyo3::PyAny>) -> pyo3::PyResult<Self> {
                object.extract::<String>()?.parse().map_err(pyo3::exceptions::PyValueError::new_err)
            }
        }
    };
}
pub(crate) use keywords;
