//! Host values as the bytes that WGSL expects, by the layouts that naga reflected: no mirror of any struct to keep in step.

use glam::{DVec2, DVec3, DVec4};
use naga::ScalarKind;

use super::GpuError;
use crate::program::{Field, Layout};

/// A member's value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Value {
    /// f32 or f64, as WGSL has it; so are the vectors of them.
    Float(f64),
    /// u32.
    Uint(u32),
    /// vec2f.
    Vec2(DVec2),
    /// vec3f.
    Vec3(DVec3),
    /// vec4f.
    Vec4(DVec4),
    /// vec2u.
    Uint2([u32; 2]),
    /// vec3u.
    Uint3([u32; 3]),
    /// vec4u.
    Uint4([u32; 4]),
}

impl Value {
    /// Its scalars as bytes, in numbers of so many bytes each.
    fn bytes(self, width: u32) -> (ScalarKind, Vec<u8>) {
        let floats = |values: &[f64]| {
            let bytes =
                |v: &f64| if width == 8 { v.to_ne_bytes().to_vec() } else { (*v as f32).to_ne_bytes().to_vec() };
            (ScalarKind::Float, values.iter().flat_map(bytes).collect())
        };
        let uints = |values: &[u32]| (ScalarKind::Uint, bytemuck::cast_slice(values).to_vec());
        match self {
            Self::Float(v) => floats(&[v]),
            Self::Vec2(v) => floats(&v.to_array()),
            Self::Vec3(v) => floats(&v.to_array()),
            Self::Vec4(v) => floats(&v.to_array()),
            Self::Uint(v) => uints(&[v]),
            Self::Uint2(v) => uints(&v),
            Self::Uint3(v) => uints(&v),
            Self::Uint4(v) => uints(&v),
        }
    }
}

/// The bytes of `rows`, each one element of `layout` as (member, value) in any order; every member must be given.
pub fn pack<R: AsRef<[(&'static str, Value)]>>(
    binding: &str,
    layout: &Layout,
    rows: impl IntoIterator<Item = R>,
) -> Result<Vec<u8>, GpuError> {
    let wrong = |problem: String| GpuError::Layout { binding: binding.to_owned(), problem };
    let mut bytes = Vec::new();
    // All rows name their members in the order of the first.
    let mut places: Option<Vec<usize>> = None;
    for row in rows {
        let row = row.as_ref();
        let order = match &places {
            Some(order) => order,
            None => places.insert(order(layout, row).map_err(wrong)?),
        };
        let start = bytes.len();
        bytes.resize(start + layout.span as usize, 0);
        for ((name, value), place) in row.iter().zip(order) {
            let field = &layout.fields[*place];
            let (kind, value_bytes) = value.bytes(field.width);
            if kind != field.scalar || value_bytes.len() != (field.components * field.width) as usize {
                return Err(wrong(format!("`{name}` is {value:?} here and {field:?} in WGSL")));
            }
            let at = start + field.offset as usize;
            bytes[at..at + value_bytes.len()].copy_from_slice(&value_bytes);
        }
    }
    Ok(bytes)
}

/// For each member of the row its place in the layout.
fn order(layout: &Layout, row: &[(&'static str, Value)]) -> Result<Vec<usize>, String> {
    let place = |name: &str| layout.fields.iter().position(|field| field.name == name);
    let order = row
        .iter()
        .map(|(name, _)| place(name).ok_or_else(|| format!("WGSL has no member `{name}`")))
        .collect::<Result<Vec<_>, _>>()?;
    let missing: Vec<&Field> =
        layout.fields.iter().enumerate().filter(|(i, _)| !order.contains(i)).map(|(_, field)| field).collect();
    if let Some(field) = missing.first() {
        return Err(format!("the member `{}` was given no value", field.name));
    }
    Ok(order)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn layout() -> Layout {
        let field =
            |name: &str, offset, scalar, components| Field { name: name.into(), offset, scalar, width: 4, components };
        Layout {
            fields: vec![field("a", 0, ScalarKind::Float, 3), field("b", 12, ScalarKind::Uint, 1)],
            span: 16,
            count: None,
        }
    }

    #[test]
    fn members_go_where_wgsl_has_them() {
        let rows = [[("b", Value::Uint(7)), ("a", Value::Vec3(DVec3::new(1.0, 2.0, 3.0)))]];
        let bytes = pack("x", &layout(), rows).unwrap();
        assert_eq!(bytemuck::pod_collect_to_vec::<u8, u32>(&bytes)[3], 7);
        assert_eq!(bytemuck::pod_collect_to_vec::<u8, f32>(&bytes)[..3], [1.0, 2.0, 3.0]);
    }

    #[test]
    fn every_slip_is_refused() {
        let missing = pack("x", &layout(), [[("b", Value::Uint(7))]]).unwrap_err().to_string();
        assert!(missing.contains("`a` was given no value"), "{missing}");
        let unknown = pack("x", &layout(), [[("c", Value::Uint(7))]]).unwrap_err().to_string();
        assert!(unknown.contains("no member `c`"), "{unknown}");
        let kind = pack("x", &layout(), [[("b", Value::Float(7.0)), ("a", Value::Vec3(DVec3::ONE))]]).unwrap_err();
        assert!(kind.to_string().contains("`b` is Float"), "{kind}");
    }
}
