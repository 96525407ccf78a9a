//! The reader of `[ambient]`, which sets the ambient occlusion.

use crate::document::reader::TableReader;
use crate::document::values::{number_where, positive_length, word};
use crate::scene::optics::Optics;
use crate::scene::{Occlusion, TransparentShadows};

/// Reports laws and segments that ambient occlusion does not support.
fn check_law(table: &TableReader, optics: &Optics, chords: bool) {
    let help = "use rays = \"straight\"";
    if let Some(why) = optics.law.and_then(|law| law.facts().ignores_direction) {
        table.fault(&["rays"], format!("occlusion rays cannot follow this law: {why}"), help);
    }
    if optics.law.is_some_and(|law| law.facts().throat.is_some()) {
        table.fault(&["rays"], "occlusion rays cannot pass through a wormhole", help);
    }
    if chords {
        table.fault(&["rays"], "occlusion rays along the law require arcs, and these rays are chords", help);
    }
}

/// Reads the ambient occlusion; returns `None` without the table.
pub fn read(root: &TableReader, optics: &Optics, chords: bool) -> Option<Occlusion> {
    let table = root.subtable("ambient", "ambient")?;
    if optics.paths.is_some() {
        table.fault(
            &[],
            "[ambient] cannot be combined with path tracing, which computes indirect light",
            "remove [ambient]",
        );
    }
    let fraction = number_where("a number from 0 to 1", |x| (0.0..=1.0).contains(&x));
    let along_law = table.or("rays", false, word(&[("straight", false), ("law", true)]));
    if along_law {
        check_law(&table, optics, chords);
    }
    let occlusion = Occlusion {
        along_law: along_law && optics.bends(),
        distance: table.optional("distance", positive_length),
        floor: table.or("floor", 0.0, fraction),
        clear: if along_law {
            TransparentShadows::Closed
        } else {
            table.or("transparent", TransparentShadows::Closed, word(&TransparentShadows::WORDS))
        },
    };
    table.finish();
    Some(occlusion)
}
