//! Conversion of Python's dataclasses: values, shared nodes, unions by class name.

use std::any::{Any, TypeId};
use std::cell::RefCell;
use std::collections::HashMap;
use std::sync::Arc;

use pyo3::prelude::*;

use super::{nesting, Shared, Unsupported};
use crate::color::{Rgb, Rgbft};
use crate::math::{Transform, Vec3};

/// A node and its levels (`nesting`).
type Node = (Arc<dyn Any + Send + Sync>, usize);

thread_local! {
    #[allow(clippy::type_complexity)] // one table, read as a whole
    /// Nodes of the scene under conversion; the Python objects are kept so that no address is used twice.
    static NODES: RefCell<HashMap<(usize, TypeId), (Py<PyAny>, Node)>> = RefCell::default();
    static UNSUPPORTED: RefCell<Vec<Unsupported>> = const { RefCell::new(Vec::new()) };
}

/// Notes something that the core leaves out; each feature and place is kept once.
pub fn report_unsupported(feature: impl Into<String>, source: impl Into<String>) {
    let item = Unsupported { feature: feature.into(), source: source.into() };
    UNSUPPORTED.with_borrow_mut(|list| {
        if !list.contains(&item) {
            list.push(item);
        }
    });
}

/// Runs a conversion: gives its result and what it noted, and forgets the nodes.
pub fn collect_unsupported<T>(convert: impl FnOnce() -> PyResult<T>) -> PyResult<(T, Vec<Unsupported>)> {
    let result = convert();
    NODES.take();
    let unsupported = UNSUPPORTED.take();
    nesting::end()?;
    Ok((result?, unsupported))
}

impl<'a, 'py, T> FromPyObject<'a, 'py> for Shared<T>
where
    T: FromPyObject<'a, 'py> + Any + Send + Sync,
{
    type Error = PyErr;

    fn extract(obj: Borrowed<'a, 'py, PyAny>) -> PyResult<Shared<T>> {
        let key = (obj.as_ptr() as usize, TypeId::of::<T>());
        let known = NODES.with_borrow(|nodes| nodes.get(&key).map(|(_, node)| node.clone()));
        if let Some((node, levels)) = known {
            nesting::reused(levels);
            return Ok(Shared::from_arc(node.downcast().expect("the key holds the type")));
        }
        let (node, levels) = nesting::measured(|| obj.extract::<T>());
        let node = Arc::new(node.map_err(Into::into)?);
        NODES.with_borrow_mut(|nodes| nodes.insert(key, (obj.to_owned().unbind(), (node.clone(), levels))));
        Ok(Shared::from_arc(node))
    }
}

macro_rules! from_tuple {
    ($type:ident, $size:literal) => {
        impl FromPyObject<'_, '_> for $type {
            type Error = PyErr;

            fn extract(obj: Borrowed<'_, '_, PyAny>) -> PyResult<$type> {
                obj.extract::<[f64; $size]>().map($type::from)
            }
        }
    };
}

from_tuple!(Vec3, 3);
from_tuple!(Rgb, 3);
from_tuple!(Rgbft, 5);

impl FromPyObject<'_, '_> for Transform {
    type Error = PyErr;

    /// A map without inverse becomes the identity, and is reported.
    fn extract(obj: Borrowed<'_, '_, PyAny>) -> PyResult<Transform> {
        let matrix: [f64; 12] = obj.getattr("matrix")?.extract()?;
        Ok(Transform::from_matrix(matrix).unwrap_or_else(|| {
            report_unsupported("transformation that flattens space", "");
            Transform::IDENTITY
        }))
    }
}
