//! The exceptions, and the conversion of errors.

use bentray::gpu::GpuError;
use bentray::render::RenderError as Failure;
use bentray::scene;
use pyo3::exceptions::{PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};

pyo3::create_exception!(bentray, SceneError, PyValueError, "A scene is invalid. `errors` has one dict for each error.");
pyo3::create_exception!(bentray, DeviceError, PyRuntimeError, "No device can render, or the device failed.");
pyo3::create_exception!(bentray, RenderError, PyRuntimeError, "A render failed.");

/// Returns the exception for an invalid scene, with the place and the remedy of each error.
pub fn scene_error(py: Python, error: &scene::SceneError) -> PyErr {
    let exception = SceneError::new_err(error.to_string());
    let listed = || -> PyResult<()> {
        let errors = PyList::empty(py);
        if let scene::SceneError::Diagnostics(all) = error {
            for one in all {
                let entry = PyDict::new(py);
                entry.set_item("file", one.file.display().to_string())?;
                entry.set_item("line", one.line)?;
                entry.set_item("column", one.column)?;
                entry.set_item("excerpt", &one.excerpt)?;
                entry.set_item("problem", &one.problem)?;
                entry.set_item("help", &one.help)?;
                errors.append(entry)?;
            }
        }
        exception.value(py).setattr("errors", errors)
    };
    listed().err().unwrap_or(exception)
}

/// Returns the exception for a device that cannot be opened or failed.
pub fn device_error(error: &GpuError) -> PyErr {
    DeviceError::new_err(error.to_string())
}

/// Returns the exception for a failed render.
pub fn render_error(error: Failure) -> PyErr {
    match error {
        Failure::Gpu(error) => device_error(&error),
        other => RenderError::new_err(other.to_string()),
    }
}
