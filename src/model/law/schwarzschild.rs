//! A Schwarzschild black hole (W04 §5.4), in path form or as the full geodesic.

use std::sync::Arc;

use glam::DVec3;

use super::{HoleForm, Kind, RoundHole};
use crate::document::keys;
use crate::document::values::{direction, mass, point, word};

pub static KIND: Kind = Kind {
    name: "schwarzschild",
    keys: keys! {
        mass: "number above 0" = "1", "M, scene units (G = c = 1): the horizon is at r = 2M";
        center: "[x, y, z]" = "[0, 0, 0]", "position of the black hole";
        form: "orbit-equation | geodesic" = "orbit-equation",
            "integrated equation: the path alone, or the full geodesic with time";
        axis: "[x, y, z]" = "[0, 0, 1]", "axis of orbiting matter and observers, counterclockwise seen from its tip";
    },
    read: |table, _| {
        let forms = &[("orbit-equation", HoleForm::Path), ("geodesic", HoleForm::Geodesic)];
        Some(Arc::new(RoundHole {
            form: table.or("form", HoleForm::Path, word(forms)),
            axis: table.or("axis", DVec3::Z, direction),
            ..RoundHole::new(table.or("mass", 1.0, mass), table.or("center", DVec3::ZERO, point))
        }))
    },
};
