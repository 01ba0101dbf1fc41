//! SDL: `image_map { ... }` and the other users of pictures: mirror of `minipov.tracer.image`.
#![allow(missing_docs)] // the fields are documented where they are mirrored from

use super::values::keywords;
use super::{Shared, Vec2};

/// Pixels of one file, row by row from the top.
#[derive(Clone, Debug)]
pub struct Image {
    pub width: usize,
    pub height: usize,
    pub color: Vec<[f32; 3]>,
    pub alpha: Option<Vec<f32>>,
    pub index: Option<Vec<u16>>,
    pub palette_size: usize,
    pub gray: bool,
}

keywords!(
    /// Which of a picture's numbers counts.
    ImageUse { Default = "default", Index = "index", Color = "color", Alpha = "alpha" }
);

#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct ImageMapping {
    pub image: Shared<Image>,
    pub map_type: u8,
    pub once: bool,
    pub interpolate: u8,
    #[cfg_attr(feature = "python", pyo3(attribute("use")))]
    pub used: ImageUse,
    pub repeat: Vec2,
    pub offset: Vec2,
}

#[cfg(feature = "python")]
impl<'py> pyo3::FromPyObject<'_, 'py> for Image {
    type Error = pyo3::PyErr;

    fn extract(object: pyo3::Borrowed<'_, 'py, pyo3::PyAny>) -> pyo3::PyResult<Image> {
        use numpy::{PyReadonlyArray2, PyReadonlyArray3};
        use pyo3::types::PyAnyMethods;
        let color: PyReadonlyArray3<f32> = object.getattr("color")?.extract()?;
        let color = color.as_array();
        let (height, width, _) = color.dim();
        let alpha: Option<PyReadonlyArray2<f32>> = object.getattr("alpha")?.extract()?;
        let index: Option<PyReadonlyArray2<u16>> = object.getattr("index")?.extract()?;
        Ok(Image {
            width,
            height,
            color: color.rows().into_iter().map(|p| [p[0], p[1], p[2]]).collect(),
            alpha: alpha.map(|a| a.as_array().iter().copied().collect()),
            index: index.map(|i| i.as_array().iter().copied().collect()),
            palette_size: object.getattr("palette_size")?.extract()?,
            gray: object.getattr("gray")?.extract()?,
        })
    }
}
