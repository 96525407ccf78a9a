//! Python values as TOML.

use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyFloat, PyInt, PyMapping, PySequence, PyString};
use toml::{Table, Value};

/// The largest depth of nested values.
const DEEPEST: usize = 64;

/// Converts a mapping with text keys.
pub fn table(value: &Bound<PyAny>) -> PyResult<Table> {
    match toml(value, "the scene")? {
        Value::Table(table) => Ok(table),
        _ => Err(PyTypeError::new_err("a scene must be a dict of tables, or a text")),
    }
}

/// Converts a value; `name` is its key, for errors.
pub fn toml(value: &Bound<PyAny>, name: &str) -> PyResult<Value> {
    nested(value, name, DEEPEST)
}

fn nested(value: &Bound<PyAny>, name: &str, depth: usize) -> PyResult<Value> {
    let wrong = |problem: &str| Err(PyTypeError::new_err(format!("`{name}` {problem}")));
    if depth == 0 {
        return wrong("is nested too deeply");
    }
    if let Ok(text) = value.cast::<PyString>() {
        return Ok(Value::String(text.extract()?));
    }
    if let Ok(truth) = value.cast::<PyBool>() {
        return Ok(Value::Boolean(truth.is_true()));
    }
    if value.is_instance_of::<PyInt>() {
        return match value.extract() {
            Ok(number) => Ok(Value::Integer(number)),
            Err(_) => value.extract().map(Value::Float),
        };
    }
    if let Ok(number) = value.cast::<PyFloat>() {
        return Ok(Value::Float(number.value()));
    }
    if let Ok(mapping) = value.cast::<PyMapping>() {
        let mut table = Table::new();
        for item in mapping.items()? {
            let (key, value): (Bound<PyAny>, Bound<PyAny>) = item.extract()?;
            let Ok(key) = key.extract::<String>() else { return wrong("has a key that is not a string") };
            let value = nested(&value, &key, depth - 1)?;
            table.insert(key, value);
        }
        return Ok(Value::Table(table));
    }
    // Arrays and numbers of NumPy.
    if value.hasattr("tolist")? {
        return nested(&value.call_method0("tolist")?, name, depth - 1);
    }
    if value.hasattr("__fspath__")? {
        return nested(&value.call_method0("__fspath__")?, name, depth - 1);
    }
    if let Ok(sequence) = value.cast::<PySequence>() {
        let items = sequence.try_iter()?.map(|item| nested(&item?, name, depth - 1));
        return items.collect::<PyResult<_>>().map(Value::Array);
    }
    wrong(&format!("is of the type {}, which no scene has", value.get_type().name()?))
}
