//! `[ambient]`: how ambient light is shut out.

use crate::document::reader::TableReader;
use crate::document::values::{number_where, positive, word};
use crate::scene::{Clear, Occlusion};

/// None without the table.
pub fn read(root: &TableReader, paths: bool) -> Option<Occlusion> {
    let table = root.subtable("ambient", "ambient")?;
    if paths {
        table.fault(
            &[],
            "paths have no ambient light: they find what reaches a place by themselves",
            "leave [ambient] out",
        );
    }
    let fraction = number_where("a number from 0 to 1", |x| (0.0..=1.0).contains(&x));
    let occlusion = Occlusion {
        distance: table.optional("distance", positive),
        floor: table.or("floor", 0.0, fraction),
        clear: table.or("clear", Clear::Closed, word(&Clear::WORDS)),
    };
    table.finish();
    Some(occlusion)
}
