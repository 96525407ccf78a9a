//! A non-rotating charged black hole (Reissner–Nordström), optionally with a cosmological constant (Kottler).
//!
//! *Practice.* `kerr-newman` without spin describes the same black hole. This law is of second order and planar, and many times faster.

use std::sync::Arc;

use glam::DVec3;

use super::{HoleForm, Kind, RoundHole};
use crate::document::keys;
use crate::document::values::{direction, length, mass, number, point};

pub static KIND: Kind = Kind {
    name: "reissner-nordstrom",
    keys: keys! {
        mass: "number above 0" = "1", "M, scene units (G = c = 1)";
        charge: "number" = "0", "Q, in scene units; above M there is no horizon, and no ray is captured";
        cosmological_constant: "number" = "0",
            "Λ, in inverse scene units squared; affects the measurements of observers, not the paths of light";
        center: "[x, y, z]" = "[0, 0, 0]", "position of the black hole";
        axis: "[x, y, z]" = "[0, 0, 1]", "axis of orbiting matter and observers, counterclockwise seen from its tip";
    },
    read: |table, _| {
        let hole = RoundHole {
            mass: table.or("mass", 1.0, mass),
            charge: table.or("charge", 0.0, length),
            cosmological: table.or("cosmological_constant", 0.0, number),
            center: table.or("center", DVec3::ZERO, point),
            axis: table.or("axis", DVec3::Z, direction),
            form: HoleForm::Charged,
        };
        if hole.photon_sphere().is_some_and(|r| hole.clock(r) <= 0.0) {
            let most = hole.cosmological_most();
            table.fault(
                &["cosmological_constant"],
                "outside this black hole, no position has a static observer",
                format!("use less than {most:.6}"),
            );
        }
        Some(Arc::new(hole))
    },
};
