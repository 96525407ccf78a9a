//! The reader of `[[lights]]`.

use glam::DVec3;

use crate::document::reader::TableReader;
use crate::document::values::{color, direction, point, positive_length, whole, word};
use crate::scene::lights::PATHS;
use crate::scene::optics::Optics;
use crate::scene::{Light, LightGrid, LightSource, Shadows, TransparentShadows};

/// Reads `[[lights]]`; `reach` is the radius of the bounding sphere.
pub(super) fn read(root: &TableReader, reach: f64, optics: &Optics) -> Vec<Light> {
    let tables = root.subtables("lights", "lights");
    tables.into_iter().filter_map(|table| light(table, reach, optics)).collect()
}

const SHADOWS: &[(&str, Shadows)] = &[
    ("none", Shadows::None),
    ("straight-rays", Shadows::Straight),
    ("photon-grid", Shadows::Grid),
    ("curved-rays", Shadows::Shooting),
];

/// Reports laws and objects that the shooting method does not support.
fn check_shooting(table: &TableReader, is_point: bool, optics: &Optics) {
    if !is_point {
        let help = "use shadows = \"photon-grid\" or \"straight-rays\", or a distant point light";
        table.fault(&["shadows"], "shadows = \"curved-rays\" requires a point light", help);
    }
    if optics.objects.iter().any(|object| object.interior().is_some()) {
        let help = "use shadows = \"photon-grid\" or \"straight-rays\", or remove the interiors";
        table.fault(&["shadows"], "shadows = \"curved-rays\" does not support interiors", help);
    }
}

/// Reports laws under which light cannot be traced from a source.
fn check_aimed(table: &TableReader, optics: &Optics) {
    if let Some(why) = optics.law.and_then(|law| law.facts().refuses_sent_light) {
        let help = "use shadows = \"straight-rays\"";
        table.fault(&["shadows"], format!("shadows along curved rays are not available under this law: {why}"), help);
    }
}

fn light_grid(table: &TableReader) -> LightGrid {
    let usual = LightGrid::default();
    let voxels = table.or("voxels", usual.voxels, whole(8..=512));
    LightGrid {
        voxels,
        refine: table.or("refine", usual.refine, whole(1..=8)),
        paths: table.or("paths", LightGrid::usual_paths(voxels), whole(PATHS)),
    }
}

/// Reads a light; `reach` is the radius of the bounding sphere.
fn light(table: TableReader, reach: f64, optics: &Optics) -> Option<Light> {
    let kinds = word(&[("point", true), ("directional", false)]);
    let is_point = table.decide_required("kind", "\"point\"", kinds);
    let color = table.or("color", DVec3::ONE, color);
    let shadows = table.or("shadows", Shadows::None, word(SHADOWS));
    let source = is_point.and_then(|is_point| {
        if is_point {
            table.required("position", "[10, 10, 10]", point).map(LightSource::Point)
        } else {
            table.required("direction", "[0, -1, 0]", direction).map(LightSource::Directional)
        }
    });
    // The light of a directional source does not fall off.
    let falls =
        is_point == Some(true) && table.or("falloff", false, word(&[("none", false), ("inverse-square", true)]));
    let straight = shadows == Shadows::Straight;
    let clear = if straight {
        table.or("transparent", TransparentShadows::Open, word(&TransparentShadows::WORDS))
    } else {
        TransparentShadows::Open
    };
    let shot = shadows == Shadows::Shooting;
    let size = if shot { table.or("min_distance", 1e-3 * reach, positive_length) } else { 0.0 };
    if shot {
        check_shooting(&table, is_point == Some(true), optics);
    }
    if shadows.follows_the_law() {
        check_aimed(&table, optics);
    }
    let grid = if shadows == Shadows::Grid { light_grid(&table) } else { LightGrid::default() };
    let light =
        source.map(|source| Light { source, color, shadows, transparent: clear, falls, min_distance: size, grid });
    table.finish();
    light
}
