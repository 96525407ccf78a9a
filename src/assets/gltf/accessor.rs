//! Numbers in buffers: checked accessors, and their elements one after the other.

use std::borrow::Cow;

use gltf_json::accessor::{ComponentType, Type};
use gltf_json::validation::Checked::Valid;
use gltf_json::{Accessor, Index, buffer::View};

use super::Gltf;
use crate::assets::format_error::FormatError;

/// The elements of an accessor, all of which exist.
pub(in crate::assets) struct Elements<'a> {
    bytes: Cow<'a, [u8]>,
    /// The number of bytes from one element to the next.
    stride: usize,
    kind: ComponentType,
    is_normalized: bool,
    /// The number of elements.
    pub count: usize,
}

impl Elements<'_> {
    /// Returns the numbers of an element; missing numbers are 0.
    pub fn numbers<const N: usize>(&self, element: usize) -> [f32; N] {
        let size = self.kind.size();
        let start = element * self.stride;
        let mut values = [0.0; N];
        for (i, value) in values.iter_mut().enumerate() {
            *value = self.number(start + i * size);
        }
        values
    }

    fn number(&self, at: usize) -> f32 {
        let whole = |value: i32, largest: f32| {
            if self.is_normalized { (value as f32 / largest).max(-1.0) } else { value as f32 }
        };
        match self.kind {
            ComponentType::I8 => whole(i8::from_le_bytes(self.bytes_at(at)).into(), 127.0),
            ComponentType::U8 => whole(u8::from_le_bytes(self.bytes_at(at)).into(), 255.0),
            ComponentType::I16 => whole(i16::from_le_bytes(self.bytes_at(at)).into(), 32_767.0),
            ComponentType::U16 => whole(u16::from_le_bytes(self.bytes_at(at)).into(), 65_535.0),
            ComponentType::U32 => u32::from_le_bytes(self.bytes_at(at)) as f32,
            ComponentType::F32 => f32::from_le_bytes(self.bytes_at(at)),
        }
    }

    /// Returns `true` if the numbers are fractions: floating point, or normalized integers.
    pub fn are_fractions(&self) -> bool {
        self.is_normalized || self.kind == ComponentType::F32
    }

    /// Returns the integer of an element.
    pub fn index(&self, element: usize) -> u32 {
        let at = element * self.stride;
        match self.kind {
            ComponentType::U8 | ComponentType::I8 => u8::from_le_bytes(self.bytes_at(at)).into(),
            ComponentType::U16 | ComponentType::I16 => u16::from_le_bytes(self.bytes_at(at)).into(),
            ComponentType::U32 | ComponentType::F32 => u32::from_le_bytes(self.bytes_at(at)),
        }
    }

    fn bytes_at<const N: usize>(&self, at: usize) -> [u8; N] {
        self.bytes.get(at..).and_then(|rest| rest.first_chunk()).copied().unwrap_or([0; N])
    }
}

impl Gltf {
    /// Returns the elements of an accessor, which must have one of these types; `of` names the object that contains the index.
    pub(in crate::assets) fn elements(
        &self,
        index: Index<Accessor>,
        types: &[Type],
        of: &str,
    ) -> Result<Elements<'_>, FormatError> {
        let accessor = self.get(index, "accessors", of)?;
        let name = format!("accessors[{}]", index.value());
        let (Valid(component), Valid(of_type)) = (&accessor.component_type, &accessor.type_) else {
            return Err(FormatError(format!("{name} has an invalid `type` or `componentType`")));
        };
        if !types.contains(of_type) {
            return Err(FormatError(format!("{name} is of type {of_type:?}, and {of} requires {:?}", types[0])));
        }
        let size = component.0.size() * of_type.multiplicity();
        let mut elements = Elements {
            bytes: Cow::Borrowed(&[]),
            stride: size,
            kind: component.0,
            is_normalized: accessor.normalized,
            count: usize::try_from(accessor.count.0).unwrap_or(usize::MAX),
        };
        match accessor.buffer_view {
            Some(view) => {
                let start = accessor.byte_offset.unwrap_or_default().0;
                let bytes;
                (elements.stride, bytes) = self.run(view, start, accessor.count.0, size, &name)?;
                elements.bytes = Cow::Borrowed(bytes);
            }
            // All elements except those of `sparse` are 0: their number must not exceed the bytes in the file.
            None if elements.count > self.bytes.len() => {
                let (count, has) = (elements.count, self.bytes.len());
                return Err(FormatError(format!(
                    "{name} has {count} elements and no buffer view, and the file has {has} bytes"
                )));
            }
            None => elements.bytes = Cow::Owned(vec![0; elements.count * size]),
        }
        self.replace(accessor, &mut elements, size, &name)?;
        Ok(elements)
    }

    /// Returns the stride, and the bytes from the first element on, of `count` elements of `size` bytes in a view.
    fn run(
        &self,
        view: Index<View>,
        start: u64,
        count: u64,
        size: usize,
        of: &str,
    ) -> Result<(usize, &[u8]), FormatError> {
        let (described, bytes) = self.view(view, of)?;
        let stride = described.byte_stride.map_or(size, |stride| stride.0).max(size);
        let length =
            count.checked_sub(1).map_or(Some(0), |more| more.checked_mul(stride as u64)?.checked_add(size as u64));
        let end = length.and_then(|length| start.checked_add(length)).filter(|end| *end <= bytes.len() as u64);
        match end {
            Some(end) => Ok((stride, &bytes[start as usize..end as usize])),
            None => Err(FormatError(format!(
                "{of} requires {count} elements of {size} bytes, {stride} apart, from byte {start}, and \
                 bufferViews[{}] has {} bytes",
                view.value(),
                bytes.len()
            ))),
        }
    }

    /// Writes the elements of `sparse` to their positions.
    fn replace(&self, accessor: &Accessor, elements: &mut Elements, size: usize, of: &str) -> Result<(), FormatError> {
        let Some(sparse) = &accessor.sparse else { return Ok(()) };
        let Valid(kind) = &sparse.indices.component_type else {
            return Err(FormatError(format!("{of}.sparse.indices has an invalid `componentType`")));
        };
        let (count, of) = (sparse.count.0, format!("{of}.sparse"));
        let (start, width) = (sparse.indices.byte_offset.0, kind.0.size());
        let (stride, bytes) = self.run(sparse.indices.buffer_view, start, count, width, &of)?;
        let indices =
            Elements { bytes: bytes.into(), stride, kind: kind.0, is_normalized: false, count: count as usize };
        let (from, values) = self.run(sparse.values.buffer_view, sparse.values.byte_offset.0, count, size, &of)?;
        let stride = elements.stride;
        let bytes = elements.bytes.to_mut();
        for i in 0..indices.count {
            let place = indices.index(i) as usize;
            if place >= elements.count {
                return Err(FormatError(format!("{of} replaces element {place}, and there are {}", elements.count)));
            }
            bytes[place * stride..place * stride + size].copy_from_slice(&values[i * from..i * from + size]);
        }
        Ok(())
    }
}
