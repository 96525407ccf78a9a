//! `NumPy` arrays of images and rays.

use bentray::chart::SceneChart;
use bentray::glam::DMat2;
use bentray::measure::{EndJacobian, Jacobian, OpticalPath};
use bentray::program::{CROSSINGS, Layer};
use bentray::render::{Band, Crossing, Crossings, Plane, Traced};
use numpy::{PyArray1, PyArrayMethods, PyReadonlyArrayDyn, PyUntypedArrayMethods};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};
use rayon::prelude::*;

/// The largest magnitude of a number, and the smallest of a velocity's largest component; both are far within the range of f32.
const LARGEST: f64 = 1e30;
const SMALLEST: f64 = 1e-30;
/// The smallest number of rays that a thread converts at once.
const FEW: usize = 1 << 12;

/// Returns the arrays of an image, with these layers.
pub fn image<'py>(py: Python<'py>, band: Band, layers: &[Layer]) -> PyResult<Bound<'py, PyDict>> {
    let size = [band.rows as usize, band.width as usize];
    let arrays = PyDict::new(py);
    arrays.set_item("color", components(py, size, &band.color)?)?;
    if let Some(alpha) = band.alpha {
        arrays.set_item("alpha", PyArray1::from_vec(py, alpha).reshape(size)?)?;
    }
    for (layer, plane) in band.layers {
        if !layers.contains(&layer) {
            continue;
        }
        let array = match plane {
            Plane::Scalar(plane) => PyArray1::from_vec(py, plane).reshape(size)?.into_any(),
            Plane::Id(plane) => PyArray1::from_vec(py, plane).reshape(size)?.into_any(),
            Plane::Vector(planes) => components(py, size, &planes)?,
            Plane::Crossings(planes) => components(py, size, &planes)?,
        };
        arrays.set_item(layer.name(), array)?;
    }
    Ok(arrays)
}

/// Returns an array with several components per pixel.
fn components<'py, const N: usize>(
    py: Python<'py>,
    [rows, width]: [usize; 2],
    planes: &[Vec<f32>; N],
) -> PyResult<Bound<'py, PyAny>> {
    let mixed = (0..rows * width).flat_map(|pixel| planes.each_ref().map(|plane| plane[pixel]));
    Ok(PyArray1::from_iter(py, mixed).reshape([rows, width, N])?.into_any())
}

/// The ends of rays, as columns.
pub struct Ends {
    status: Vec<u32>,
    x: Vec<f64>,
    v: Vec<f64>,
    tau: Vec<f64>,
    segments: Vec<f64>,
    steps: Vec<u32>,
    rejected: Vec<u32>,
    object: Vec<i64>,
}

impl Ends {
    /// Converts ends on all processors.
    pub fn of(ends: &[Traced]) -> Self {
        Self {
            status: column(ends, |end| end.status.code()),
            x: flat(ends, |end| end.x),
            v: flat(ends, |end| end.v),
            tau: column(ends, |end| end.tau),
            segments: column(ends, |end| end.segments),
            steps: column(ends, |end| end.steps),
            rejected: column(ends, |end| end.rejected),
            object: column(ends, |end| end.object.map_or(-1, i64::from)),
        }
    }

    /// Returns the columns as arrays, without a copy.
    pub fn arrays<'py>(self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let shape = [self.status.len(), 3];
        let arrays = PyDict::new(py);
        arrays.set_item("status", PyArray1::from_vec(py, self.status))?;
        arrays.set_item("x", PyArray1::from_vec(py, self.x).reshape(shape)?)?;
        arrays.set_item("v", PyArray1::from_vec(py, self.v).reshape(shape)?)?;
        arrays.set_item("tau", PyArray1::from_vec(py, self.tau))?;
        arrays.set_item("segments", PyArray1::from_vec(py, self.segments))?;
        arrays.set_item("steps", PyArray1::from_vec(py, self.steps))?;
        arrays.set_item("rejected", PyArray1::from_vec(py, self.rejected))?;
        arrays.set_item("object", PyArray1::from_vec(py, self.object))?;
        Ok(arrays)
    }
}

/// Returns the points of each path as an array of the shape (points, 3).
pub fn points(py: Python, paths: Vec<Vec<[f64; 3]>>) -> PyResult<Bound<PyList>> {
    let array = |path: Vec<[f64; 3]>| {
        let count = path.len();
        PyArray1::from_vec(py, path.into_flattened()).reshape([count, 3])
    };
    PyList::new(py, paths.into_iter().map(array).collect::<PyResult<Vec<_>>>()?)
}

/// Returns crossings as arrays of the shape (rays, crossings). A missing crossing is NaN, and its object is −1.
pub fn crossings<'py>(py: Python<'py>, rays: &[Crossings]) -> PyResult<Bound<'py, PyDict>> {
    let shape = [rays.len(), CROSSINGS];
    let each = || rays.iter().flatten();
    let number = |of: fn(&Crossing) -> Option<f64>| {
        let values = each().map(|crossing| crossing.as_ref().and_then(of).unwrap_or(f64::NAN));
        PyArray1::from_iter(py, values).reshape(shape)
    };
    let arrays = PyDict::new(py);
    let objects = each().map(|crossing| crossing.map_or(-1, |crossing| i64::from(crossing.object)));
    arrays.set_item("object", PyArray1::from_iter(py, objects).reshape(shape)?)?;
    let places = each().flat_map(|crossing| crossing.map_or([f64::NAN; 3], |crossing| crossing.x));
    arrays.set_item("x", PyArray1::from_iter(py, places).reshape([rays.len(), CROSSINGS, 3])?)?;
    arrays.set_item("tau", number(|crossing| Some(crossing.tau))?)?;
    arrays.set_item("r", number(|crossing| Some(crossing.radius))?)?;
    arrays.set_item("phi", number(|crossing| Some(crossing.azimuth))?)?;
    arrays.set_item("t", number(|crossing| crossing.time)?)?;
    arrays.set_item("g", number(|crossing| crossing.redshift)?)?;
    arrays.set_item("angle", number(|crossing| crossing.angle)?)?;
    Ok(arrays)
}

/// Returns a dict for each setting of each method.
pub fn comparison<'py>(py: Python<'py>, chart: &SceneChart) -> PyResult<Bound<'py, PyList>> {
    let all = PyList::empty(py);
    for (curve, point) in chart.curves.iter().flat_map(|curve| curve.points.iter().map(move |point| (curve, point))) {
        let row = PyDict::new(py);
        row.set_item("method", curve.name)?;
        row.set_item("words", &point.words)?;
        for (name, value) in [
            ("setting", point.setting),
            ("seconds_per_ray", point.time),
            ("evaluations_per_ray", point.evaluations),
            ("error_median", point.found.judged(chart.judged).median),
            ("error_p99", point.found.judged(chart.judged).p99),
            ("image_rms", point.image),
        ] {
            row.set_item(name, value)?;
        }
        for (name, count) in [("wrong_terminations", point.found.wrong), ("unresolved", point.found.unresolved)] {
            row.set_item(name, count)?;
        }
        all.append(row)?;
    }
    Ok(all)
}

/// Returns Jacobians as arrays of the shape (rays, 2, 2), and magnifications; NaN for a ray without one.
pub fn jacobians<'py>(py: Python<'py>, rays: &[EndJacobian]) -> PyResult<Bound<'py, PyDict>> {
    let matrix = |of: fn(&Jacobian) -> DMat2| {
        let rows = |(_, found): &EndJacobian| {
            found.as_ref().map_or([f64::NAN; 4], |jacobian| of(jacobian).transpose().to_cols_array())
        };
        PyArray1::from_iter(py, rays.iter().flat_map(rows)).reshape([rays.len(), 2, 2])
    };
    let magnification = rays.iter().map(|(_, found)| found.as_ref().map_or(f64::NAN, Jacobian::magnification));
    let arrays = PyDict::new(py);
    arrays.set_item("direction", matrix(|jacobian| jacobian.direction)?)?;
    arrays.set_item("position", matrix(|jacobian| jacobian.position)?)?;
    arrays.set_item("magnification", PyArray1::from_iter(py, magnification))?;
    Ok(arrays)
}

/// Adds the lengths of paths to the ends of rays.
pub fn optical_paths(py: Python, paths: &[OpticalPath], found: &Bound<PyDict>) -> PyResult<()> {
    found.set_item("length", PyArray1::from_iter(py, paths.iter().map(|path| path.length)))?;
    found.set_item("optical_path", PyArray1::from_iter(py, paths.iter().map(|path| path.optical)))
}

fn column<T: Send>(ends: &[Traced], of: impl Fn(&Traced) -> T + Sync + Send) -> Vec<T> {
    ends.par_iter().with_min_len(FEW).map(of).collect()
}

/// Returns the components of vectors one after the other.
fn flat(ends: &[Traced], of: impl Fn(&Traced) -> [f64; 3] + Sync) -> Vec<f64> {
    let mut values = vec![0.0; 3 * ends.len()];
    let rows = values.par_chunks_exact_mut(3).zip(ends).with_min_len(FEW);
    rows.for_each(|(row, end)| row.copy_from_slice(&of(end)));
    values
}

/// Returns rays from positions and velocities: arrays of the shape (rays, 3), or one vector for all rays.
pub fn rays(x: &Bound<PyAny>, v: &Bound<PyAny>) -> PyResult<Vec<[f64; 6]>> {
    let (x, v) = (vectors_of(x, "x")?, vectors_of(v, "v")?);
    let count = match (x.shape(), v.shape()) {
        ([3], [3]) => 1,
        ([3], [count, 3]) | ([count, 3], [3]) => *count,
        ([one, 3], [other, 3]) if one == other => *one,
        ([one, 3], [other, 3]) => {
            return Err(PyValueError::new_err(format!(
                "`x` has {one} rows and `v` has {other}; give one velocity per ray"
            )));
        }
        (one, other) => {
            return Err(PyValueError::new_err(format!(
                "`x` and `v` must have the shape (rays, 3) or (3,), and have {one:?} and {other:?}"
            )));
        }
    };
    let (x_values, v_values) = (x.as_slice()?, v.as_slice()?);
    let step = |array: &PyReadonlyArrayDyn<f64>| if array.ndim() == 1 { 0 } else { 3 };
    let (x_step, v_step) = (step(&x), step(&v));
    let ray = |i: usize| {
        let (x, v) = (&x_values[i * x_step..][..3], &v_values[i * v_step..][..3]);
        [x[0], x[1], x[2], v[0], v[1], v[2]]
    };
    let rays: Vec<[f64; 6]> = (0..count).into_par_iter().with_min_len(FEW).map(ray).collect();
    // Not a number is not small either.
    let is_small = |value: &f64| value.abs() <= LARGEST;
    let is_fine = |ray: &[f64; 6]| ray.iter().all(is_small) && ray[3..].iter().any(|value| value.abs() >= SMALLEST);
    let Some(i) = rays.par_iter().with_min_len(FEW).position_first(|ray| !is_fine(ray)) else { return Ok(rays) };
    Err(PyValueError::new_err(match rays[i].iter().find(|value| !is_small(value)) {
        Some(value) => format!("ray {i} has the number {value}; numbers must be finite, and at most {LARGEST:e}"),
        None => format!("the velocity of ray {i} is 0"),
    }))
}

/// Returns an argument as an array of f64 in the order of C.
fn vectors_of<'py>(given: &Bound<'py, PyAny>, name: &str) -> PyResult<PyReadonlyArrayDyn<'py, f64>> {
    let py = given.py();
    let numpy = py.import("numpy")?;
    let array = numpy.call_method1("asarray", (given,))?;
    let kind: String = array.getattr("dtype")?.getattr("kind")?.extract()?;
    if !["f", "i", "u"].contains(&&*kind) {
        let found = array.getattr("dtype")?;
        return Err(PyValueError::new_err(format!(
            "`{name}` must be an array of real numbers, and its type is {found}"
        )));
    }
    let array = numpy.call_method1("ascontiguousarray", (array, numpy.getattr("float64")?))?;
    array.extract()
}
