//! SDL's functions called while a scene is read: `F(1, 2, 3)`, and `vturbulence`.

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyTuple;

use crate::function;
use crate::graph::{collect_unsupported, Function as Node, Shared};
use crate::math::Vec3;
use crate::noise::Octaves;
use crate::texture::Builder;

/// A function made ready to be called; keep it where the same function is called often.
#[pyclass(frozen)]
pub struct Function {
    function: function::Function,
    /// Whether Python's other threads go on meanwhile, so that Ctrl-C is heard.
    detached: bool,
}

#[pymethods]
impl Function {
    #[new]
    #[pyo3(signature = (function, noise_generator=2, number_of_waves=10))]
    fn new(function: &Bound<'_, PyAny>, noise_generator: i64, number_of_waves: usize) -> PyResult<Function> {
        let (node, mut unsupported) = collect_unsupported(|| function.extract::<Node>())?;
        let mut builder = Builder::new(noise_generator, number_of_waves);
        let made = builder.function(&Shared::new(node));
        unsupported.append(&mut builder.unsupported);
        match (made, unsupported.first()) {
            (Some(function), None) => Ok(Function { detached: function.loops(), function }),
            (_, missing) => {
                let what = missing.map_or("this", |missing| &missing.feature);
                Err(PyValueError::new_err(format!("{what} cannot be called yet")))
            }
        }
    }

    /// The value: a float, or a tuple of its components.
    #[pyo3(signature = (*arguments))]
    fn __call__<'py>(&self, py: Python<'py>, arguments: &Bound<'py, PyTuple>) -> PyResult<Bound<'py, PyAny>> {
        let mut given = [0.0; 64];
        let count = arguments.len().min(given.len());
        for (value, argument) in given.iter_mut().zip(arguments.iter()) {
            *value = argument.extract()?;
        }
        let given = &given[..count];
        let function = &self.function;
        if function.size() == 1 {
            let value =
                if self.detached { py.detach(|| function.value(given)) } else { function.value(given) };
            return Ok(value.into_pyobject(py)?.into_any());
        }
        let components = function.components(given);
        Ok(PyTuple::new(py, &components[..function.size()])?.into_any())
    }

    /// The values on a grid of the unit square, row 0 at y = 0: each a list of its components.
    fn unit_square(&self, py: Python<'_>, width: usize, height: usize) -> Vec<f64> {
        py.detach(|| {
            let size = self.function.size();
            let place = |i: usize, count: usize| i as f64 / (count.max(2) - 1) as f64;
            let mut values = Vec::with_capacity(width * height * size);
            for row in 0..height {
                for column in 0..width {
                    let point = [place(column, width), place(row, height), 0.0];
                    values.extend_from_slice(&self.function.components(&point)[..size]);
                }
            }
            values
        })
    }
}

/// The displacement that turbulence gives a point.
#[pyfunction]
pub fn vturbulence(lambda: f64, omega: f64, octaves: i64, point: Vec3) -> (f64, f64, f64) {
    let v = Octaves::new(octaves, omega, lambda).vector(point);
    (v.x, v.y, v.z)
}
