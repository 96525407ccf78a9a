//! Converts host values to the bytes that WGSL expects, by the layouts that naga reflected, so that no struct is declared twice.

use naga::ScalarKind;

use super::GpuError;
use crate::model::Value;
use crate::program::Layout;

/// Returns the scalars of a value as bytes, `width` bytes each.
fn scalars(value: Value, width: u32) -> (ScalarKind, Vec<u8>) {
    let floats = |values: &[f64]| {
        let bytes = |v: &f64| if width == 8 { v.to_ne_bytes().to_vec() } else { (*v as f32).to_ne_bytes().to_vec() };
        (ScalarKind::Float, values.iter().flat_map(bytes).collect())
    };
    let uints = |values: &[u32]| (ScalarKind::Uint, bytemuck::cast_slice(values).to_vec());
    match value {
        Value::Float(v) => floats(&[v]),
        Value::Vec2(v) => floats(&v.to_array()),
        Value::Vec3(v) => floats(&v.to_array()),
        Value::Vec4(v) => floats(&v.to_array()),
        Value::Uint(v) => uints(&[v]),
        Value::Uint2(v) => uints(&v),
        Value::Uint3(v) => uints(&v),
        Value::Uint4(v) => uints(&v),
    }
}

/// Returns the bytes of `rows`, each one element of `layout` as (member, value) in any order; every member must be given.
///
/// # Errors
///
/// Returns [`GpuError::Layout`] if a row has a member of another type than the layout, lacks a member, or has a member that the layout
/// lacks.
pub fn pack<N: AsRef<str>, R: AsRef<[(N, Value)]>>(
    binding: &str,
    layout: &Layout,
    rows: impl IntoIterator<Item = R>,
) -> Result<Vec<u8>, GpuError> {
    let mut bytes = Vec::new();
    // All rows name their members in the order of the first row.
    let mut places: Option<Vec<usize>> = None;
    for row in rows {
        let row = row.as_ref();
        let order = match &places {
            Some(order) => order,
            None => places.insert(order(binding, layout, row, true)?),
        };
        put(binding, layout, row, order, &mut bytes)?;
    }
    Ok(bytes)
}

/// Packs rows like [`pack`], for a record that several kinds share; members that a row omits are 0.
pub fn pack_shared<N: AsRef<str>, R: AsRef<[(N, Value)]>>(
    binding: &str,
    layout: &Layout,
    rows: impl IntoIterator<Item = R>,
) -> Result<Vec<u8>, GpuError> {
    let mut bytes = Vec::new();
    for row in rows {
        let row = row.as_ref();
        put(binding, layout, row, &order(binding, layout, row, false)?, &mut bytes)?;
    }
    Ok(bytes)
}

fn wrong(binding: &str, problem: String) -> GpuError {
    GpuError::Layout { binding: binding.to_owned(), problem }
}

/// Appends an element, with its members at the indices `order` of the layout.
fn put<N: AsRef<str>>(
    binding: &str,
    layout: &Layout,
    row: &[(N, Value)],
    order: &[usize],
    bytes: &mut Vec<u8>,
) -> Result<(), GpuError> {
    let start = bytes.len();
    bytes.resize(start + layout.span as usize, 0);
    for ((name, value), place) in row.iter().zip(order) {
        let field = &layout.fields[*place];
        let (kind, own) = scalars(*value, field.width);
        if kind != field.scalar || own.len() != (field.components * field.width) as usize {
            return Err(wrong(binding, format!("`{}` is {value:?} on the host but {field:?} in WGSL", name.as_ref())));
        }
        let at = start + field.offset as usize;
        bytes[at..at + own.len()].copy_from_slice(&own);
    }
    Ok(())
}

/// Returns the index in the layout of each member of the row.
fn order<N: AsRef<str>>(
    binding: &str,
    layout: &Layout,
    row: &[(N, Value)],
    whole: bool,
) -> Result<Vec<usize>, GpuError> {
    let place = |name: &str| layout.fields.iter().position(|field| field.name == name);
    let found = |(name, _): &(N, Value)| {
        let name = name.as_ref();
        place(name).ok_or_else(|| wrong(binding, format!("WGSL has no member `{name}`")))
    };
    let order = row.iter().map(found).collect::<Result<Vec<_>, _>>()?;
    let mut missing = layout.fields.iter().enumerate().filter(|(i, _)| !order.contains(i));
    match missing.next().filter(|_| whole) {
        Some((_, field)) => Err(wrong(binding, format!("the member `{}` has no value", field.name))),
        None => Ok(order),
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use crate::program::Field;

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
        assert!(missing.contains("`a` has no value"), "{missing}");
        let unknown = pack("x", &layout(), [[("c", Value::Uint(7))]]).unwrap_err().to_string();
        assert!(unknown.contains("no member `c`"), "{unknown}");
        let kind = pack("x", &layout(), [[("b", Value::Float(7.0)), ("a", Value::Vec3(DVec3::ONE))]]).unwrap_err();
        assert!(kind.to_string().contains("`b` is Float"), "{kind}");
    }
}
