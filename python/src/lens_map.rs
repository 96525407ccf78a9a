//! The class `LensMap`.

use std::collections::BTreeMap;
use std::sync::Arc;

use bentray::render::{END_VALUES, LensMap as Ends};
use bentray::scene::{Rays, Scene};
use numpy::{PyArray1, PyArrayMethods};
use pyo3::exceptions::{PyKeyError, PyValueError};
use pyo3::prelude::*;

/// The ends of the rays of an image.
#[pyclass(module = "bentray", frozen)]
pub struct LensMap {
    pub ends: Arc<Ends>,
    /// The integration of the rays.
    pub rays: Rays,
    /// The values of the scene.
    pub values: BTreeMap<String, String>,
}

#[pymethods]
impl LensMap {
    /// Returns the names of the values.
    fn keys(&self) -> Vec<&'static str> {
        END_VALUES.iter().map(|value| value.channel).collect()
    }

    /// Returns a value of the first ray of each pixel.
    fn __getitem__<'py>(&self, py: Python<'py>, name: &str) -> PyResult<Bound<'py, PyAny>> {
        let [width, height] = self.ends.size.map(|side| side as usize);
        let value = END_VALUES.iter().find(|value| value.channel == name);
        let value = value.ok_or_else(|| PyKeyError::new_err(name.to_owned()))?;
        let bits = match self.ends.plane(name) {
            [] => vec![0; width * height],
            bits => bits.to_vec(),
        };
        if value.is_whole {
            return Ok(PyArray1::from_vec(py, bits).reshape([height, width])?.into_any());
        }
        let floats = bits.into_iter().map(f32::from_bits).collect();
        Ok(PyArray1::<f32>::from_vec(py, floats).reshape([height, width])?.into_any())
    }

    /// The width and height of the image.
    #[getter]
    fn size(&self) -> (u32, u32) {
        self.ends.size.into()
    }

    fn __repr__(&self) -> String {
        let [width, height] = self.ends.size;
        format!("<bentray.LensMap {width}x{height}>")
    }
}

impl LensMap {
    /// Rejects a scene that needs other rays; `values` are those of the scene.
    pub fn check(&self, scene: &Scene, values: &BTreeMap<String, String>) -> PyResult<()> {
        if let Some(problem) = scene.refuses_map() {
            return Err(PyValueError::new_err(problem));
        }
        let differs = |key: &&String| self.values.get(*key) != values.get(*key) && !scene.is_look(key);
        match self.values.keys().chain(values.keys()).find(differs) {
            Some(key) => Err(PyValueError::new_err(format!(
                "`{key}` differs from the scene of the lens map, and needs other rays: make a new map"
            ))),
            None => Ok(()),
        }
    }
}
