//! The reader of `rays.lighting` and `[path_tracing]`.

use crate::document::reader::TableReader;
use crate::document::values::{boolean, whole, word};
use crate::model::Law;
use crate::scene::{Light, PathTracing};

/// Reads the settings of path tracing, if the scene uses it.
pub fn read(root: &TableReader, rays: Option<&TableReader>, law: Option<&dyn Law>) -> Option<PathTracing> {
    let follows =
        rays.is_some_and(|rays| rays.or("lighting", false, word(&[("direct", false), ("path-tracing", true)])));
    if let (true, Some(rays), Some(why)) = (follows, rays, law.and_then(|law| law.facts().ignores_direction)) {
        let problem = format!("path tracing is not available under this law: {why}");
        rays.fault(&["lighting"], problem, "use lighting = \"direct\"");
    }
    let usual = PathTracing::default();
    let mut paths = usual;
    if let Some(table) = root.subtable("path_tracing", "path_tracing") {
        if !follows {
            let help = "set lighting = \"path-tracing\" in [rays], or remove [path_tracing]";
            table.fault(&[], "[path_tracing] requires lighting = \"path-tracing\"", help);
        }
        paths.max_depth = table.optional("max_depth", whole(0..=1_000_000));
        paths.rr_depth = table.or("rr_depth", usual.rr_depth, whole(1..=1_000_000));
        paths.light_sampling = table.or("light_sampling", usual.light_sampling, boolean);
        paths.guiding = table.or("guiding", usual.guiding, boolean);
        paths.seed = table.or("seed", usual.seed, whole(0..=u32::MAX));
        table.finish();
    }
    follows.then_some(paths)
}

/// Reports lights that no path can hit.
pub fn refuse(root: &TableReader, lights: &[Light]) {
    if !lights.is_empty() {
        let problem = "path tracing cannot reach lights without a surface";
        let help = "replace each light by a small sphere of an emissive material, or use lighting = \"direct\"";
        root.fault(&["lights"], problem, help);
    }
}
