//! The reader of `sky.stars`: a file, or a table with a file.

use glam::DMat3;

use crate::assets::Files;
use crate::document::reader::TableReader;
use crate::document::values::{not_negative, number, number_where};
use crate::document::{Node, Value};
use crate::model::{Camera, Law};
use crate::scene::{Precision, Rays, Stars};

/// The diameter of a star's disk, in degrees.
const USUAL_SIZE: f64 = 2e-4;

/// Reads the stars of a sky, if it has any.
pub(super) fn read(sky: &TableReader, rotation: DMat3, files: &mut Files) -> Option<Stars> {
    let node = sky.node("stars")?;
    if let Value::Text(_) = node.value {
        return stars(Some(node), None, (sky, rotation), files);
    }
    let table = sky.reader.open("sky.stars", node)?;
    let file = table.required_node("file", "\"stars.csv\"");
    let stars = stars(file, Some(&table), (sky, rotation), files);
    table.finish();
    stars
}

fn stars(
    file: Option<&Node>,
    table: Option<&TableReader>,
    (sky, rotation): (&TableReader, DMat3),
    files: &mut Files,
) -> Option<Stars> {
    let size = number_where("an angle above 0, at most 1 degree", |x| x > 0.0 && x <= 1.0);
    let intensity = table.map_or(1.0, |table| table.or("intensity", 1.0, not_negative));
    let limit = table.map_or(f64::INFINITY, |table| table.or("limit", f64::INFINITY, number));
    let size = table.map_or(USUAL_SIZE, |table| table.or("size", USUAL_SIZE, size)).to_radians();
    let catalog = files.catalog(sky.reader, file?)?;
    Some(Stars { catalog, intensity, limit, rotation, size })
}

/// The origins of the rays between which stars are found.
pub(super) struct Sight<'r> {
    pub law: Option<&'r dyn Law>,
    pub camera: Option<&'r Camera>,
    pub rays: Option<&'r Rays>,
}

/// Reports scenes in which rays cannot show where a star is, or how bright.
pub(super) fn check(root: &TableReader, stars: &[Option<Stars>; 2], sight: &Sight, has_radiation: bool) {
    if stars.iter().all(Option::is_none) {
        return;
    }
    let fault = |problem: &str, help: &str| root.fault_within("sky", "stars", problem.to_owned(), help.to_owned());
    if has_radiation {
        fault("`stars` have colors, and [radiation] has frequencies", "remove [radiation] or `stars`");
    }
    let rays = sight.rays;
    if rays.is_some_and(|rays| rays.path_tracing.is_some()) {
        fault(
            "`stars` cannot be combined with path tracing: random paths never meet a point",
            "use lighting = \"direct\"",
        );
    }
    if rays.is_some_and(|rays| rays.precision == Precision::Half) {
        fault("`stars` require directions of more than 16 bits", "use rays.precision = \"f32\"");
    }
    let Some(law) = sight.law else { return };
    if law.facts().ignores_direction.is_some() {
        fault("`stars` require a law of light: here all rays through a point have one direction", "remove `stars`");
    }
    if law.facts().is_straight && sight.camera.is_some_and(Camera::is_parallel) {
        fault(
            "`stars` require rays in different directions: the rays of this camera are parallel and stay parallel",
            "use camera.kind = \"pinhole\"",
        );
    }
}
