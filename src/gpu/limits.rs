//! Whether a device can hold a scene's meshes, before it is opened.

use super::{AdapterReport, Geometry, GpuError};
use crate::program::{BindingKind, Program};

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
            "corners" | "triangles" => geometry.triangles.len(),
            "vertices" => geometry.vertices.len(),
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
