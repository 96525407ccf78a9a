//! The requirements of redshift and of orbiting matter on a scene.

use glam::DVec3;

use crate::document::reader::{Reader, TableReader};
use crate::document::{Span, SpannedError};
use crate::model::{Absorption, Camera, Law, Material, Object, matter};

/// The properties of the scene, except the camera, that affect the light and the orbits of matter.
pub struct Rest<'a> {
    pub law: Option<&'a dyn Law>,
    pub materials: &'a [Material],
    pub absorption: Option<&'a Absorption>,
    pub paths: bool,
    /// The largest radius of orbits.
    pub reach: f64,
}

pub fn check(root: &TableReader, camera: Option<&Camera>, rest: &Rest) {
    if camera.is_some_and(|camera| camera.redshift) {
        if rest.paths {
            root.fault(&["camera"], "`redshift` cannot be combined with path tracing", "remove camera.redshift");
        } else if rest.absorption.is_some_and(|absorption| absorption.emission != DVec3::ZERO) {
            let problem = "the frequency of light that space emits is not defined";
            root.fault(&["camera"], problem, "remove camera.redshift, or `emission` in law.absorption");
        }
    }
    let Some(material) = rest.materials.iter().find(|material| material.surface.facts().orbits) else { return };
    let name = &material.name;
    if rest.paths {
        let help = "use lighting = \"direct\", or kind = \"blackbody\"";
        root.fault(&["materials"], format!("`{name}` is orbiting matter, which path tracing does not support"), help);
    } else if rest.law.is_some_and(|law| matter::innermost_stable(law, rest.reach).is_none()) {
        let problem = format!(
            "`{name}` is orbiting matter, and this law has no innermost stable orbit (ISCO) within rays.bounding_sphere"
        );
        root.fault(
            &["materials"],
            problem,
            "use law.kind = \"kerr-newman\", or a black hole defined by its line element",
        );
    }
}

/// Checks that orbiting matter is in the plane of its orbits.
pub fn check_discs(reader: &Reader, placed: &[(Span, Object)], materials: &[Material], law: &dyn Law) {
    /// The largest sine of the angle between the two planes, and the largest distance between them relative to the size of the disk.
    const OFF: f64 = 1e-3;
    let Some([center, axis]) = law.equator() else { return };
    for (place, object) in placed {
        let is_flat = object.solid().lists.as_ref().is_some_and(|lists| lists.flat);
        let Some(material) = object.material().and_then(|i| materials.get(i)).filter(|_| is_flat) else { continue };
        let map = object.transform.0;
        let across = map.matrix3.x_axis.cross(map.matrix3.z_axis).normalize_or_zero();
        let height = (map.translation - center).dot(axis).abs();
        if material.surface.facts().orbits && (across.cross(axis).length() > OFF || height > OFF * object.ball().1) {
            reader.fault(SpannedError {
                place: *place,
                problem: format!(
                    "`{}` orbits the axis of the law, and this object is not perpendicular to that axis",
                    material.name
                ),
                help: format!("move it into the plane through {center} with the normal {axis}: see law.axis"),
            });
        }
    }
}
