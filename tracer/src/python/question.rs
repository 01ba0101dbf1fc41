//! SDL's questions about one object: `trace`, `inside`, `min_extent`, `max_extent`.

use pyo3::prelude::*;

use crate::geometry::Questioned;
use crate::graph::{collect_unsupported, Object};
use crate::math::Vec3;

type Triple = (f64, f64, f64);

fn triple(v: Vec3) -> Triple {
    (v.x, v.y, v.z)
}

/// An object made ready for questions; keep it where the same object is asked often.
#[pyclass(frozen)]
pub struct Question(Questioned);

#[pymethods]
impl Question {
    #[new]
    fn new(object: &Bound<'_, PyAny>) -> PyResult<Question> {
        let (object, _) = collect_unsupported(|| object.extract::<Object>())?;
        Ok(Question(Questioned::new(&object)))
    }

    /// The first point of the surface along a ray and its normal, or None.
    fn trace(&self, origin: Vec3, direction: Vec3) -> Option<(Triple, Triple)> {
        self.0.trace(origin, direction).map(|(point, normal)| (triple(point), triple(normal)))
    }

    /// Whether a point lies inside.
    fn inside(&self, point: Vec3) -> bool {
        self.0.inside(point)
    }

    /// The corners of the box around the object.
    fn extents(&self) -> (Triple, Triple) {
        let bounds = self.0.extents();
        (triple(bounds.min), triple(bounds.max))
    }
}
