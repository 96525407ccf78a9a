//! The class `Scene`.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::{Arc, Mutex, MutexGuard};

use bentray::chart::Sweep;
use bentray::measure::{Candidate, Verification, all_methods, refuses_optical_paths};
use bentray::output::{FileSettings, open as open_image};
use bentray::program::{Layer, Schedule};
use bentray::render::Band;
use bentray::scene::{Files, Override, Rays, Scene as Checked, SceneError};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::sync::MutexExt;
use pyo3::types::{PyBytes, PyDict, PyList, PyMapping, PyString};

use crate::arrays::{self, Ends};
use crate::device::open;
use crate::errors::{RenderError as Failed, render_error, scene_error};
use crate::lens_map::LensMap;
use crate::profile::Wanted;
use crate::state::State;
use crate::values;

/// A scene, with its program on a device.
#[pyclass(module = "bentray", frozen)]
pub struct Scene {
    text: String,
    /// The name of the scene in errors; its files are relative to the folder.
    path: PathBuf,
    device: Option<String>,
    state: Mutex<State>,
}

#[pymethods]
impl Scene {
    #[new]
    #[pyo3(signature = (source, *, folder = None, device = None))]
    fn new(source: &Bound<PyAny>, folder: Option<PathBuf>, device: Option<String>) -> PyResult<Self> {
        let text = match source.cast::<PyString>() {
            Ok(text) => text.extract()?,
            Err(_) => values::table(source)?.to_string(),
        };
        Self::of(source.py(), text, folder.unwrap_or_default().join("scene"), device)
    }

    /// Returns the scene of a file.
    #[staticmethod]
    #[pyo3(signature = (path, *, device = None))]
    fn load(py: Python, path: PathBuf, device: Option<String>) -> PyResult<Self> {
        let text = match std::fs::read(&path) {
            Ok(bytes) => String::from_utf8(bytes)
                .map_err(|_| PyValueError::new_err(format!("{}: the file is not valid UTF-8", path.display())))?,
            Err(source) => return Err(scene_error(py, &SceneError::Read { path, source })),
        };
        Self::of(py, text, path, device)
    }

    /// Changes keys of the scene, such as `{"camera.fov": 30}`; `None` removes a key.
    fn set(&self, py: Python, changes: &Bound<PyMapping>) -> PyResult<()> {
        let mut state = self.state(py);
        let mut all = state.changes.clone();
        for item in changes.items()? {
            let (key, value): (String, Bound<PyAny>) = item.extract()?;
            let value = if value.is_none() { String::new() } else { values::toml(&value, &key)?.to_string() };
            let change: Override = format!("{key}={value}").parse().map_err(|error| scene_error(py, &error))?;
            all.retain(|(other, _)| *other != key);
            all.push((key, change));
        }
        let scene = self.checked(&mut state.files, &all).map_err(|error| scene_error(py, &error))?;
        (state.changes, state.scene, state.tracer) = (all, scene, None);
        Ok(())
    }

    /// Returns an image: arrays by the names of layers.
    #[pyo3(signature = (*, size = None, samples = None, layers = None, lens_map = None))]
    fn render<'py>(
        &self,
        py: Python<'py>,
        size: Option<[u32; 2]>,
        samples: Option<u32>,
        layers: Option<Vec<String>>,
        lens_map: Option<&LensMap>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let layers = layers.unwrap_or_default().iter().map(|name| layer(name)).collect::<PyResult<Vec<Layer>>>()?;
        if let Some(map) = lens_map {
            if size.is_some() || samples.is_some() {
                return Err(PyValueError::new_err("a lens map has a size and a number of samples already"));
            }
            return arrays::image(py, self.shaded(py, map, &layers)?, &layers);
        }
        let (band, _) = self.image(py, size, samples, &layers)?;
        arrays::image(py, band, &layers)
    }

    /// Follows rays to their ends.
    #[allow(clippy::too_many_arguments)] // keywords in Python
    #[pyo3(signature = (x, v, *, paths = false, crossings = false, jacobian = false, optical_path = false))]
    fn trace<'py>(
        &self,
        py: Python<'py>,
        x: &Bound<'py, PyAny>,
        v: &Bound<'py, PyAny>,
        paths: bool,
        crossings: bool,
        jacobian: bool,
        optical_path: bool,
    ) -> PyResult<Bound<'py, PyDict>> {
        let rays = arrays::rays(x, v)?;
        let device = open(self.device.as_deref())?;
        let mut guard = self.state(py);
        let state = &mut *guard;
        let ends = device.run(py, || state.follow(device, &rays).map(|ends| Ends::of(&ends)))?;
        let found = ends.map_err(render_error)?.arrays(py)?;
        if paths {
            let followed = device.run(py, || state.paths(device, &rays))?.map_err(render_error)?;
            found.set_item("paths", arrays::points(py, followed)?)?;
        }
        if crossings {
            let followed = device.run(py, || state.crossings(device, &rays))?.map_err(render_error)?;
            found.set_item("crossings", arrays::crossings(py, &followed)?)?;
        }
        if jacobian {
            let followed = device.run(py, || state.jacobians(device, &rays))?.map_err(render_error)?;
            found.set_item("jacobian", arrays::jacobians(py, &followed)?)?;
        }
        if optical_path {
            if let Some(problem) = refuses_optical_paths(&state.scene) {
                return Err(PyValueError::new_err(problem));
            }
            let followed = device.run(py, || state.optical_paths(device, &rays))?.map_err(render_error)?;
            arrays::optical_paths(py, &followed, &found)?;
        }
        Ok(found)
    }

    /// Returns a line profile, a light curve or a spectrum of the scene's surfaces.
    #[pyo3(signature = (kind = "line", *, emissivity = None, range = None, points = 200, objects = None))]
    fn profile<'py>(
        &self,
        py: Python<'py>,
        kind: &str,
        emissivity: Option<&str>,
        range: Option<[f64; 2]>,
        points: usize,
        objects: Option<Vec<u32>>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let wanted = Wanted::new(kind, emissivity, range, points)?;
        let device = open(self.device.as_deref())?;
        let mut guard = self.state(py);
        let state = &mut *guard;
        wanted.check(&state.scene, objects.as_deref())?;
        let found = device.run(py, || state.emissions(device, objects.as_deref()))?.map_err(render_error)?;
        wanted.measure(py, &state.scene, &found)
    }

    /// Follows the rays of the image, and returns their ends.
    fn map(&self, py: Python) -> PyResult<LensMap> {
        let device = open(self.device.as_deref())?;
        let mut guard = self.state(py);
        let state = &mut *guard;
        if let Some(problem) = state.scene.refuses_map() {
            return Err(PyValueError::new_err(problem));
        }
        let values = self.values(py, state)?;
        let (ends, rays) = device.run(py, || state.map(device))?.map_err(render_error)?;
        Ok(LensMap { ends: Arc::new(ends), rays, values })
    }

    /// Follows the rays of some pixels again in 64 bits, and returns the errors of the image.
    #[pyo3(signature = (rays = 1000))]
    fn verify<'py>(&self, py: Python<'py>, rays: usize) -> PyResult<Bound<'py, PyDict>> {
        if !(1..=1_000_000).contains(&rays) {
            return Err(PyValueError::new_err("`rays` must be from 1 to 1000000"));
        }
        let device = open(self.device.as_deref())?;
        let mut guard = self.state(py);
        let state = &mut *guard;
        let Verification { found, tolerance } = device.run(py, || state.verify(device, rays))?.map_err(render_error)?;
        let errors = PyDict::new(py);
        for (name, count) in [
            ("rays", found.rays),
            ("unresolved", found.unresolved),
            ("wrong_terminations", found.wrong),
            ("flagged", found.flagged),
        ] {
            errors.set_item(name, count)?;
        }
        errors.set_item("tolerance", tolerance)?;
        let light = found.light.map(|light| ("intensity", light));
        let all = [("angle_radians", found.angle), ("position", found.position), ("tau", found.tau)];
        for (name, quantiles) in all.into_iter().chain(light) {
            let own = PyDict::new(py);
            own.set_item("median", quantiles.median)?;
            own.set_item("p99", quantiles.p99)?;
            own.set_item("max", quantiles.max)?;
            errors.set_item(name, own)?;
        }
        Ok(errors)
    }

    /// Measures the time and the error of integration methods over their settings.
    #[pyo3(signature = (methods = None, *, rays = 100_000, compared = 300, repeats = 3))]
    fn compare<'py>(
        &self,
        py: Python<'py>,
        methods: Option<Vec<String>>,
        rays: u32,
        compared: usize,
        repeats: usize,
    ) -> PyResult<Bound<'py, PyList>> {
        if !(64..=100_000_000).contains(&rays) || !(1..=100_000).contains(&compared) || !(1..=100).contains(&repeats) {
            let problem =
                "`rays` must be from 64 to 100000000, `compared` from 1 to 100000, and `repeats` from 1 to 100";
            return Err(PyValueError::new_err(problem));
        }
        let device = open(self.device.as_deref())?;
        let scene = self.state(py).scene.clone();
        if scene.camera.is_none() {
            return Err(render_error(bentray::render::RenderError::NoCamera));
        }
        let known: Vec<&str> = all_methods(&scene).iter().map(|method| method.name).collect();
        if let Some(name) = methods.iter().flatten().find(|name| !known.contains(&name.as_str())) {
            return Err(PyValueError::new_err(format!("there is no method {name:?}; methods: {}", known.join(", "))));
        }
        let wanted =
            |method: &Candidate| methods.as_ref().is_none_or(|names| names.iter().any(|name| name == method.name));
        let sweep = Sweep { gpu: device.gpu, rays, compared, repeats, schedule: Schedule::Fused, slowest: 300.0 };
        let chart = device.run(py, || sweep.scene("", &scene, &wanted, &|_| ()))?.map_err(render_error)?;
        arrays::comparison(py, &chart)
    }

    /// Returns the image as a PNG, with the exposure and tone map of the scene.
    fn png<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyBytes>> {
        let (band, scene) = self.image(py, None, None, &[])?;
        let failed = |error: &dyn std::fmt::Display| Failed::new_err(error.to_string());
        let folder = tempfile::tempdir().map_err(|error| failed(&error))?;
        let path = folder.path().join("image.png");
        let settings = FileSettings {
            exposure: scene.output.exposure,
            tonemap: scene.output.tonemap,
            bits: scene.output.bits,
            alpha: scene.is_transparent(),
            ..FileSettings::new(scene.image.size)
        };
        let written = open_image(&path, &settings).and_then(|mut writer| {
            writer.write_band(&band)?;
            writer.finish()
        });
        written.map_err(|error| failed(&error))?;
        let bytes = std::fs::read(&path).map_err(|error| failed(&error))?;
        Ok(PyBytes::new(py, &bytes))
    }

    fn _repr_png_<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyBytes>>> {
        if self.state(py).scene.camera.is_none() { Ok(None) } else { self.png(py).map(Some) }
    }

    fn __repr__(&self, py: Python) -> String {
        let state = self.state(py);
        let [width, height] = state.scene.image.size;
        format!("<bentray.Scene {}, {width}x{height}, {} objects>", self.path.display(), state.scene.objects.len())
    }

    /// The width and height of the image.
    #[getter]
    fn size(&self, py: Python) -> (u32, u32) {
        self.state(py).scene.image.size.into()
    }

    /// The integration method with its settings, once it is chosen.
    #[getter]
    fn method(&self, py: Python) -> Option<String> {
        self.state(py).rays().map(Rays::followed)
    }

    /// The text of the scene, without later changes.
    #[getter]
    fn toml(&self) -> &str {
        &self.text
    }
}

/// Returns the layer with this name.
fn layer(name: &str) -> PyResult<Layer> {
    let known = || Layer::ALL.into_iter().map(Layer::name).collect::<Vec<_>>().join(", ");
    let found = Layer::ALL.into_iter().find(|layer| layer.name() == name);
    found.ok_or_else(|| PyValueError::new_err(format!("there is no layer {name:?}; layers: {}", known())))
}

impl Scene {
    fn of(py: Python, text: String, path: PathBuf, device: Option<String>) -> PyResult<Self> {
        let mut files = Files::default();
        let scene = Checked::parse_with(&mut files, &text, &path, &[]).map_err(|error| scene_error(py, &error))?;
        let state = Mutex::new(State::new(files, scene));
        Ok(Self { text, path, device, state })
    }

    /// Locks the state; other Python threads go on meanwhile.
    fn state(&self, py: Python) -> MutexGuard<'_, State> {
        self.state.lock_py_attached(py).unwrap_or_else(std::sync::PoisonError::into_inner)
    }

    /// Returns the scene after changes.
    fn checked(&self, files: &mut Files, changes: &[(String, Override)]) -> Result<Checked, SceneError> {
        let overrides: Vec<Override> = changes.iter().map(|(_, change)| change.clone()).collect();
        Checked::parse_with(files, &self.text, &self.path, &overrides)
    }

    /// Returns the values of the scene by their keys.
    fn values(&self, py: Python, state: &State) -> PyResult<BTreeMap<String, String>> {
        let overrides: Vec<Override> = state.changes.iter().map(|(_, change)| change.clone()).collect();
        Checked::text_listing(&self.text, &self.path, &overrides).map_err(|error| scene_error(py, &error))
    }

    /// Renders an image from the rays of a map.
    fn shaded(&self, py: Python, map: &LensMap, layers: &[Layer]) -> PyResult<Band> {
        let device = open(self.device.as_deref())?;
        let mut guard = self.state(py);
        let state = &mut *guard;
        map.check(&state.scene, &self.values(py, state)?)?;
        if let Some(layer) = layers.iter().find(|layer| layer.is_of_paths()) {
            let problem =
                format!("the layer `{}` describes a whole path, and a lens map has only its end", layer.name());
            return Err(PyValueError::new_err(problem));
        }
        if let Some(refusal) = layers.iter().find_map(|layer| layer.refused_by(&state.scene)) {
            return Err(PyValueError::new_err(refusal));
        }
        let scene = Checked { rays: map.rays.clone(), ..state.scene.clone() };
        device.run(py, || state.shade(device, scene, &map.ends, layers))?.map_err(render_error)
    }

    /// Renders an image of this size with this number of samples, by default those of the scene.
    fn image(
        &self,
        py: Python,
        size: Option<[u32; 2]>,
        samples: Option<u32>,
        layers: &[Layer],
    ) -> PyResult<(Band, Checked)> {
        let device = open(self.device.as_deref())?;
        let mut guard = self.state(py);
        let state = &mut *guard;
        let mut changes = state.changes.clone();
        if let Some([width, height]) = size {
            changes.push(("image.size".into(), over(py, &format!("image.size=[{width}, {height}]"))?));
        }
        if let Some(samples) = samples {
            changes.push(("image.samples".into(), over(py, &format!("image.samples={samples}"))?));
        }
        let scene = if changes.len() == state.changes.len() {
            state.scene.clone()
        } else {
            self.checked(&mut state.files, &changes).map_err(|error| scene_error(py, &error))?
        };
        if let Some(refusal) = layers.iter().find_map(|layer| layer.refused_by(&scene)) {
            return Err(PyValueError::new_err(refusal));
        }
        let shown = scene.clone();
        let band = device.run(py, || state.draw(device, scene, layers))?.map_err(render_error)?;
        Ok((band, shown))
    }
}

fn over(py: Python, text: &str) -> PyResult<Override> {
    text.parse().map_err(|error| scene_error(py, &error))
}
