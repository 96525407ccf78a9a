//! Line profiles, light curves and spectra as arrays.

use bentray::assets::{Emissivity, FormulaError};
use bentray::measure::profile::{Emission, InvalidEmissivity, Kind, measure};
use bentray::program::CROSSINGS;
use bentray::scene::Scene;
use numpy::{PyArray1, PyArrayMethods};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// The requested profile.
pub struct Wanted {
    kind: Kind,
    emissivity: Emissivity,
    range: Option<[f64; 2]>,
    points: usize,
}

impl Wanted {
    /// Checks the arguments.
    pub fn new(kind: &str, emissivity: Option<&str>, range: Option<[f64; 2]>, points: usize) -> PyResult<Self> {
        let Some(kind) = Kind::ALL.into_iter().find(|own| own.name() == kind) else {
            let known = Kind::ALL.map(Kind::name).join(", ");
            return Err(PyValueError::new_err(format!("there is no kind {kind:?}; kinds: {known}")));
        };
        if !(2..=100_000).contains(&points) {
            return Err(PyValueError::new_err("`points` must be from 2 to 100000"));
        }
        if let Some(problem) = kind.refuses(range, emissivity.is_some()) {
            return Err(PyValueError::new_err(problem));
        }
        let wrong =
            |error: FormulaError| PyValueError::new_err(format!("`emissivity`: {}; {}", error.problem, error.help));
        Ok(Self { kind, emissivity: emissivity.unwrap_or("r^-3").parse().map_err(wrong)?, range, points })
    }

    /// Checks that the scene has such a profile.
    pub fn check(&self, scene: &Scene, objects: Option<&[u32]>) -> PyResult<()> {
        self.kind.refuses_scene(scene, objects).map_or(Ok(()), |problem| Err(PyValueError::new_err(problem)))
    }

    /// Returns the profile as arrays.
    pub fn measure<'py>(&self, py: Python<'py>, scene: &Scene, all: &[Emission]) -> PyResult<Bound<'py, PyDict>> {
        let invalid = |error: InvalidEmissivity| PyValueError::new_err(error.to_string());
        let points = measure(self.kind, scene, all, &self.emissivity, self.range, self.points).map_err(invalid)?;
        let arrays = PyDict::new(py);
        arrays.set_item(self.kind.column(), PyArray1::from_iter(py, points.iter().map(|(place, _)| *place)))?;
        let totals = points.iter().map(|(_, orders)| orders.iter().sum::<f64>());
        arrays.set_item("flux", PyArray1::from_iter(py, totals))?;
        let orders = PyArray1::from_iter(py, points.iter().flat_map(|(_, orders)| *orders));
        arrays.set_item("orders", orders.reshape([points.len(), CROSSINGS])?)?;
        Ok(arrays)
    }
}
