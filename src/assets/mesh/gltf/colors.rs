//! Vertex colors of a primitive: `COLOR_0`, linear; alpha is ignored.

use gltf_json::accessor::Type;
use gltf_json::{Accessor, Index};

use super::Raw;
use crate::assets::format_error::FormatError;
use crate::assets::gltf::Gltf;

impl Gltf {
    /// Reads the colors of all positions from index `first` on; `of` names the attribute in error messages.
    pub(super) fn colors(
        &self,
        raw: &mut Raw,
        index: Index<Accessor>,
        first: usize,
        of: &str,
    ) -> Result<(), FormatError> {
        let colors = self.elements(index, &[Type::Vec3, Type::Vec4], of)?;
        let vertices = raw.positions.len() - first;
        if colors.count != vertices {
            return Err(FormatError(format!("{of} has {} elements, and there are {vertices} vertices", colors.count)));
        }
        if !colors.are_fractions() {
            return Err(FormatError(format!("{of} has integer components that are not `normalized`")));
        }
        for i in 0..vertices {
            // The specification requires clamping.
            let color = colors.numbers(i).map(|x: f32| f64::from(x.clamp(0.0, 1.0)));
            raw.colors.set_linear(first + i, color);
        }
        Ok(())
    }
}
