//! The Python package: scenes, images and rays as `NumPy` arrays.
//!
//! *Practice.* `values` converts Python values to TOML, so that a dict is read and checked like a file; `scene` and `lens_map`
//! have the classes, and `state` the parts of a scene that change; `arrays` converts results; `device` opens each device once, and runs work on it while Python goes on.

mod arrays;
mod device;
mod display;
mod errors;
mod lens_map;
mod profile;
mod scene;
mod state;
mod values;

use pyo3::prelude::*;

#[pymodule]
mod _bentray {
    use pyo3::prelude::*;

    #[pymodule_export]
    use crate::errors::{DeviceError, RenderError, SceneError};
    #[pymodule_export]
    use crate::lens_map::LensMap;
    #[pymodule_export]
    use crate::scene::Scene;
    use bentray::render::Status;

    /// Returns the names of the devices that can render, best first.
    #[pyfunction]
    fn devices() -> Vec<String> {
        bentray::gpu::adapters().into_iter().map(|adapter| adapter.info.name).collect()
    }

    /// Returns the names and codes of the ends of rays.
    #[pyfunction]
    fn statuses() -> Vec<(String, u32)> {
        Status::ENDS.into_iter().map(|status| (status.name().to_uppercase(), status.code())).collect()
    }

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("__version__", env!("CARGO_PKG_VERSION"))
    }
}
