//! Conversion of one node to one value: each function reads one type of value, or returns a fault.
//!
//! Every number becomes a 32-bit float later, so all numbers must be finite, and 0 or between 10⁻³⁰ and 10³⁰ in magnitude.

use super::synonyms::synonym;
use super::{C, Dimension, Node, Quantity, SpannedError, Value};
use glam::{DVec2, DVec3};
use std::ops::RangeInclusive;
use strsim::levenshtein;

/// A value, or the fault of the node.
pub type Parsed<T> = Result<T, SpannedError>;

/// The largest magnitude that a number in a scene may have.
pub const LARGEST: f64 = 1e30;
/// The smallest magnitude that a number in a scene may have, except 0.
pub const SMALLEST: f64 = 1e-30;

impl Node {
    /// Returns a fault at this node.
    pub fn fault(&self, problem: impl Into<String>, help: impl Into<String>) -> SpannedError {
        SpannedError { place: self.place, problem: problem.into(), help: help.into() }
    }

    /// Returns the fault that this node is not the expected value.
    #[must_use]
    pub fn expected(&self, what: &str) -> SpannedError {
        let found = match &self.value {
            Value::Text(text) => &format!("the string {text:?}"),
            Value::Quantity(read) => &format!("{} ({})", read.dimension.name(), read.text),
            Value::Integer(_) => "a whole number",
            Value::Float(_) => "a number",
            Value::Boolean(_) => "true or false",
            Value::Date => "a date",
            Value::Array(items) => &format!("an array of length {}", items.len()),
            Value::Table(_) => "a table",
        };
        self.fault(format!("expected {what}, found {found}"), "")
    }
}

/// Reads a number.
pub fn number(node: &Node) -> Parsed<f64> {
    let value = match node.value {
        Value::Integer(value) => value as f64,
        Value::Float(value) => value,
        Value::Text(ref text) if Quantity::parse(text).is_some() => {
            let mut fault = node.expected("a number");
            fault.problem.push_str(", and units require the table [units]");
            return Err(fault);
        }
        _ => return Err(node.expected("a number")),
    };
    in_range(node, value)
}

/// Returns the value, or a fault if no 32-bit float can store it.
fn in_range(node: &Node, value: f64) -> Parsed<f64> {
    if !value.is_finite() {
        let help = "use a finite number";
        return Err(node.fault("not a finite number", help));
    }
    let size = value.abs();
    if size > LARGEST || (size < SMALLEST && size > 0.0) {
        let help = "use 0, or a magnitude from 1e-30 to 1e30";
        return Err(node.fault("outside the range of 32-bit floats", help));
    }
    Ok(value)
}

/// Reads a number that satisfies `fits`; `what` describes the valid numbers.
pub fn number_where(what: &'static str, fits: fn(f64) -> bool) -> impl Fn(&Node) -> Parsed<f64> {
    fitting(number, what, fits)
}

/// Reads a value with `read` that satisfies `fits`; `what` describes the valid values.
pub fn fitting(
    read: impl Fn(&Node) -> Parsed<f64>,
    what: &'static str,
    fits: fn(f64) -> bool,
) -> impl Fn(&Node) -> Parsed<f64> {
    move |node| match read(node)? {
        value if fits(value) => Ok(value),
        value => Err(node.fault(format!("expected {what}, found {value}"), "")),
    }
}

/// Reads a number, or a quantity of one of these dimensions; messages name the first.
fn measured(node: &Node, dimensions: &[Dimension], of: impl Fn(&Quantity) -> Option<f64>) -> Parsed<f64> {
    let Value::Quantity(read) = &node.value else { return number(node) };
    let [expected, ..] = dimensions else { return number(node) };
    if !dimensions.contains(&read.dimension) {
        let help = format!("use a number, or {} with one of the units {}", expected.name(), expected.units());
        return Err(SpannedError { help, ..node.expected(expected.name()) });
    }
    let undefined = || match read.dimension {
        Dimension::SkyAngle => "add units.distance, and units.mass or units.length",
        _ => "add units.mass or units.length",
    };
    let value = of(read).ok_or_else(|| {
        node.fault(format!("{} has no value in the units of this scene", read.text.trim()), undefined())
    })?;
    in_range(node, value)
}

/// Reads a length in scene units.
pub fn length(node: &Node) -> Parsed<f64> {
    measured(node, &[Dimension::Length, Dimension::SkyAngle], |read| read.value)
}

/// Reads a length greater than 0.
pub fn positive_length(node: &Node) -> Parsed<f64> {
    fitting(length, "a length above 0", |x| x > 0.0)(node)
}

/// Reads a length that is 0 or greater.
pub fn not_negative_length(node: &Node) -> Parsed<f64> {
    fitting(length, "a length of 0 or above", |x| x >= 0.0)(node)
}

/// Reads a mass greater than 0, as the length GM/c² in scene units.
pub fn mass(node: &Node) -> Parsed<f64> {
    let mass = |node: &Node| measured(node, &[Dimension::Mass, Dimension::Length], |read| read.value);
    fitting(mass, "a mass above 0", |x| x > 0.0)(node)
}

/// Reads a time in scene units.
pub fn time(node: &Node) -> Parsed<f64> {
    measured(node, &[Dimension::Time], |read| read.value)
}

/// Reads a time of 0 or later, in scene units.
pub fn not_negative_time(node: &Node) -> Parsed<f64> {
    fitting(time, "a time of 0 or above", |x| x >= 0.0)(node)
}

/// Reads an angle in degrees.
pub fn angle(node: &Node) -> Parsed<f64> {
    measured(node, &[Dimension::Angle], |read| read.value)
}

/// Reads an angle above 0, in degrees.
pub fn positive_angle(node: &Node) -> Parsed<f64> {
    fitting(angle, "an angle above 0", |x| x > 0.0)(node)
}

/// Reads a string that is a number with a unit, and returns it in the unit that [`Dimension`] names.
pub fn quantity(dimension: Dimension) -> impl Fn(&Node) -> Parsed<f64> {
    move |node| {
        let read = text(node).ok().and_then(Quantity::parse);
        read.filter(|read| read.dimension == dimension).map(|read| read.si).ok_or_else(|| {
            let help = format!("write a string with one of the units {}", dimension.units());
            SpannedError { help, ..node.expected(&format!("{} with its unit", dimension.name())) }
        })
    }
}

/// Reads the wavelength of light in nanometers.
pub fn wavelength(node: &Node) -> Parsed<f64> {
    let nanometers =
        |read: &Quantity| Some(1e9 * if read.dimension == Dimension::Frequency { C / read.si } else { read.si });
    let read = |node: &Node| measured(node, &[Dimension::Length, Dimension::Frequency], nanometers);
    fitting(read, "a wavelength above 0 nm", |x| x > 0.0)(node)
}

/// Reads a number greater than 0.
pub fn positive(node: &Node) -> Parsed<f64> {
    number_where("a number above 0", |x| x > 0.0)(node)
}

/// Reads a fraction greater than 0 and at most 1.
pub fn positive_part(node: &Node) -> Parsed<f64> {
    number_where("a number above 0, at most 1", |x| x > 0.0 && x <= 1.0)(node)
}

/// Reads a number other than 0.
pub fn not_zero(node: &Node) -> Parsed<f64> {
    number_where("a number other than 0", |x| x != 0.0)(node)
}

/// Reads a number that is 0 or greater.
pub fn not_negative(node: &Node) -> Parsed<f64> {
    number_where("a number of 0 or above", |x| x >= 0.0)(node)
}

/// Reads `true` or `false`.
pub fn boolean(node: &Node) -> Parsed<bool> {
    match node.value {
        Value::Boolean(value) => Ok(value),
        _ => Err(node.expected("true or false")),
    }
}

/// Reads a whole number in the range.
pub fn whole(range: RangeInclusive<u32>) -> impl Fn(&Node) -> Parsed<u32> {
    move |node| {
        let what = format!("a whole number from {} to {}", range.start(), range.end());
        let Value::Integer(value) = node.value else {
            return Err(node.expected(&what));
        };
        match u32::try_from(value) {
            Ok(value) if range.contains(&value) => Ok(value),
            _ => Err(node.fault(format!("expected {what}, found {value}"), "")),
        }
    }
}

/// Reads an array of `N` values, each with `read`; `what` describes it.
pub fn array<T, const N: usize>(
    what: &'static str,
    read: impl Fn(&Node) -> Parsed<T>,
) -> impl Fn(&Node) -> Parsed<[T; N]> {
    let list = list(what, N..=N, read);
    move |node| list(node)?.try_into().map_err(|_| node.expected(what))
}

/// Reads a list of values, each with `read`; `count` is the range of its length, and `what` describes it.
pub fn list<T>(
    what: &'static str,
    count: RangeInclusive<usize>,
    read: impl Fn(&Node) -> Parsed<T>,
) -> impl Fn(&Node) -> Parsed<Vec<T>> {
    move |node| {
        let Value::Array(items) = &node.value else {
            return Err(node.expected(what));
        };
        let values = items.iter().map(&read).collect::<Parsed<Vec<T>>>()?;
        if count.contains(&values.len()) { Ok(values) } else { Err(node.expected(what)) }
    }
}

/// Reads three numbers.
pub fn vector(node: &Node) -> Parsed<DVec3> {
    array("three numbers, [x, y, z]", number)(node).map(DVec3::from_array)
}

/// Reads a point or a displacement: three lengths.
pub fn point(node: &Node) -> Parsed<DVec3> {
    array("three numbers, [x, y, z]", length)(node).map(DVec3::from_array)
}

/// Reads three angles in degrees.
pub fn angles(node: &Node) -> Parsed<DVec3> {
    array("three numbers, [x, y, z]", angle)(node).map(DVec3::from_array)
}

/// Reads three lengths greater than 0.
pub fn edges(node: &Node) -> Parsed<DVec3> {
    array("three numbers above 0, [x, y, z]", positive_length)(node).map(DVec3::from_array)
}

/// Reads three numbers, not all zero, and normalizes them to a unit vector.
pub fn direction(node: &Node) -> Parsed<DVec3> {
    let fault = || node.fault("a direction cannot be [0, 0, 0]", "");
    vector(node)?.try_normalize().ok_or_else(fault)
}

/// Reads three numbers greater than 0.
pub fn extents(node: &Node) -> Parsed<DVec3> {
    array("three numbers above 0, [x, y, z]", positive)(node).map(DVec3::from_array)
}

/// Reads two numbers greater than 0.
pub fn extents_2d(node: &Node) -> Parsed<DVec2> {
    array("two numbers above 0, [u, v]", positive)(node).map(DVec2::from_array)
}

/// Reads a color: linear red, green and blue.
pub fn color(node: &Node) -> Parsed<DVec3> {
    array("a color, [red, green, blue]", not_negative)(node).map(DVec3::from_array)
}

/// Reads a string.
pub fn text(node: &Node) -> Parsed<&str> {
    match &node.value {
        Value::Text(text) | Value::Quantity(Quantity { text, .. }) => Ok(text),
        _ => Err(node.expected("a string")),
    }
}

/// Reads one of the words, and returns the value that belongs to it.
pub fn word<T: Copy>(choices: &'static [(&'static str, T)]) -> impl Fn(&Node) -> Parsed<T> {
    let names: Vec<&str> = choices.iter().map(|(name, _)| *name).collect();
    move |node| choice(&names)(node).map(|chosen| choices[chosen].1)
}

/// Reads one of the words, and returns its index.
pub fn choice(names: &[&str]) -> impl Fn(&Node) -> Parsed<usize> {
    move |node| {
        let Value::Text(word) = &node.value else {
            return Err(node.expected(&format!("one of {}", names.join(", "))));
        };
        let unknown = || node.fault(format!("unknown value `{word}`"), suggest(word, names, "choices"));
        names.iter().position(|name| name == word).ok_or_else(unknown)
    }
}

/// Returns help for a name that is not among `names`: first the name that was probably meant, then all of them.
#[must_use]
pub fn suggest(name: &str, names: &[&str], kind: &str) -> String {
    let nearest = names.iter().min_by_key(|n| levenshtein(name, n));
    let near = nearest.filter(|n| levenshtein(name, n) <= 1 + name.chars().count() / 4);
    // Completes a name, such as `kerr` to `kerr-newman`.
    let begun = || names.iter().find(|n| name.len() >= 3 && (n.starts_with(name) || n.contains(&format!("-{name}"))));
    let meant = synonym(name, names).or(near.copied()).or_else(|| begun().copied());
    let list = names.join(", ");
    match meant {
        Some(nearest) => format!("use `{nearest}`; {kind}: {list}"),
        None => format!("{kind}: {list}"),
    }
}
