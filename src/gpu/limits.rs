//! Checks whether a device can hold a scene's meshes, before it is opened.

use super::device::is_called;
use super::{AdapterReport, Geometry, GpuError, adapters, mesh};
use crate::assets::{Capacity, Held};
use crate::program::{BindingKind, Program, element_bytes};

/// The number of triangles that every device holds: WebGPU guarantees a buffer of 128 MiB, and rays are tested against 48 bytes per
/// triangle.
const ALWAYS: u64 = 1 << 20;

/// Returns the number of triangles that a mesh may have on the best device, or on the first one whose name contains `device`. Triangle
/// indices have 32 bits; [`check_meshes`] checks whether a scene that was read fits.
#[must_use]
pub fn mesh_capacity(device: Option<&str>) -> Capacity {
    let wanted = device.map(str::to_owned);
    Capacity::new(ALWAYS, move || {
        let report = adapters().into_iter().find(|report| is_called(&report.info, wanted.as_deref()))?;
        let each = element_bytes("shape/triangle", "corners").ok()?;
        Some(Held { triangles: report.storage_buffer / u64::from(each), device: report.info.name })
    })
}

/// Checks that a device can hold the buffers that grow with a scene's meshes, as their upload would.
///
/// # Errors
///
/// Returns the limit that is too low.
pub fn check_meshes(program: &Program, geometry: &Geometry, device: &AdapterReport) -> Result<(), GpuError> {
    let allowed = device.storage_buffer;
    for binding in program.bindings() {
        let BindingKind::Storage { layout, .. } = &binding.kind else { continue };
        let count = match binding.name.as_str() {
            "corners" => geometry.triangles.len(),
            "mesh" => mesh::count(geometry, program.features.has_vertex_colors),
            "items" => geometry.structure.items.len(),
            "nodes" => geometry.nodes().count(),
            _ => continue,
        };
        let needed = count as u64 * u64::from(layout.span);
        if needed > allowed {
            return Err(GpuError::Limit {
                device: device.info.name.clone(),
                limit: "max_storage_buffer_binding_size",
                what: format!("bytes in one buffer (`{}`)", binding.name),
                allowed,
                needed,
            });
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::program::ProgramOptions;
    use crate::scene::Scene;

    #[test]
    fn a_triangle_takes_the_bytes_that_programs_of_meshes_bind() {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("a.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").unwrap();
        let text = "[camera]\nposition = [0, 0, 5]\n[rays]\nbounding_sphere = { radius = 9 }\n[materials.m]\n[[objects]]\nshape = \"mesh\"\n\
                    file = \"a.obj\"\nmaterial = \"m\"\n";
        let scene = Scene::parse(text, &folder.path().join("scene.toml"), &[]).unwrap();
        let geometry = Geometry::new(&scene);
        let program = Program::new(&scene, &geometry.analysis, &ProgramOptions::default(), geometry.extent()).unwrap();
        let bound = program.bindings().find(|binding| binding.name == "corners").map(|binding| binding.kind.clone());
        let Some(BindingKind::Storage { layout, .. }) = bound else { panic!("{bound:?}") };
        assert_eq!(element_bytes("shape/triangle", "corners").unwrap(), layout.span);
        assert!(ALWAYS * u64::from(layout.span) <= 128 << 20);
        assert!(element_bytes("shape/triangle", "nothing").is_err());
    }
}
