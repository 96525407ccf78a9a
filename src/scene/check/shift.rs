//! Light that is shifted, and matter that orbits: what a scene needs for them.

use glam::DVec3;

use crate::document::reader::TableReader;
use crate::model::{Camera, Filter, Law, Material, matter};

/// What else than the camera stands in light's way, and matter's.
pub struct Rest<'a> {
    pub law: Option<&'a dyn Law>,
    pub materials: &'a [Material],
    pub filter: Option<&'a Filter>,
    pub paths: bool,
    /// How far orbits go out.
    pub reach: f64,
}

pub fn check(root: &TableReader, camera: Option<&Camera>, rest: &Rest) {
    if camera.is_some_and(|camera| camera.shift) {
        if rest.paths {
            root.fault(&["camera"], "the shift of light is of pictures without paths", "leave camera.shift out");
        } else if rest.filter.is_some_and(|filter| filter.glow != DVec3::ZERO) {
            let problem = "light that space adds has no frequency of its own";
            root.fault(&["camera"], problem, "leave camera.shift out, or `glow` in law.filter");
        }
    }
    let Some(material) = rest.materials.iter().find(|material| material.surface.orbits()) else { return };
    let name = &material.name;
    if rest.paths {
        let help = "leave transport out, or use kind = \"blackbody\"";
        root.fault(&["materials"], format!("`{name}` orbits, and paths see nothing that does"), help);
    } else if rest.law.is_some_and(|law| matter::innermost_stable(law, rest.reach).is_none()) {
        let problem = format!("`{name}` orbits, and this law has no innermost stable orbit within rays.bound");
        root.fault(&["materials"], problem, "use law.kind = \"kerr-newman\", or a hole by its line element");
    }
}
