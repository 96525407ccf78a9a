//! The reader of `[units]`, and the conversion of numbers with units.

use crate::document::reader::{Reader, TableReader};
use crate::document::values::{Parsed, fitting, quantity};
use crate::document::{C, Dimension, Document, Node, Units};

/// Converts the numbers with units in the document, if it has `[units]`; errors of the table are reported when the whole document is read.
pub fn resolve(document: &mut Document) {
    let units = read(&Reader::new(document, &[]).root());
    if let Some(units) = units {
        document.resolve_units(&units);
    }
}

/// Reads the table; returns `None` without it.
pub fn read(root: &TableReader) -> Option<Units> {
    let table = root.subtable("units", "units")?;
    let length = match table.one_of(&["mass", "length"]) {
        Some(("mass", node)) => table.reader.accept(above_0(Dimension::Mass)(node)).map(|mass| mass / (C * C)),
        Some((_, node)) => table.reader.accept(above_0(Dimension::Length)(node)),
        None => None,
    };
    let distance = table.optional("distance", above_0(Dimension::Length));
    if distance.is_some() && !table.gives("mass") && !table.gives("length") {
        let problem = "`distance` requires the unit of length of the scene";
        table.fault(&["distance"], problem, "add `mass`, such as \"4.3e6 Msun\", or `length`, such as \"1 km\"");
    }
    table.finish();
    Some(Units { length, distance })
}

/// Reads a quantity greater than 0, in the unit that [`Dimension`] names.
fn above_0(dimension: Dimension) -> impl Fn(&Node) -> Parsed<f64> {
    fitting(quantity(dimension), "a value above 0", |x| x > 0.0 && x.is_finite())
}
