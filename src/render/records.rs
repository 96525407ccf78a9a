//! Reads the values that passes write for the host, by their names in WGSL.

use rayon::prelude::*;

use super::readback::{Bytes, read_buffers};
use crate::gpu::{Gpu, GpuError, Tile};
use crate::program::{Field, Layout, Program, Role};

/// The layout of the records that a program does not write.
static NO_LAYOUT: Layout = Layout { fields: Vec::new(), span: 1, count: None };

/// The structs of a buffer.
pub(super) struct Records<'a> {
    layout: Option<&'a Layout>,
    bytes: Option<Bytes>,
}

impl<'a> Records<'a> {
    /// Waits for the device and reads the tile's buffer with this role; the result is empty if no pass of the program binds one.
    pub(super) fn read(gpu: &Gpu, program: &'a Program, tile: &Tile, role: &Role) -> Result<Self, GpuError> {
        let [records] = Self::read_all(gpu, program, tile, [role])?;
        Ok(records)
    }

    /// Reads several buffers like [`read`](Self::read), with one wait for all of them.
    pub(super) fn read_all<const N: usize>(
        gpu: &Gpu,
        program: &'a Program,
        tile: &Tile,
        roles: [&Role; N],
    ) -> Result<[Self; N], GpuError> {
        let layouts = roles.map(|role| program.layout(role).filter(|_| tile.buffer(role).is_some()));
        let bound = roles.iter().zip(layouts).filter(|(_, layout)| layout.is_some());
        let buffers: Vec<_> = bound.filter_map(|(role, _)| tile.buffer(role)).collect();
        let mut read = read_buffers(gpu, &buffers, |_| {})?.into_iter();
        let mut bytes = |layout: Option<_>| layout.and_then(|_| read.next());
        Ok(layouts.map(|layout| Self { layout, bytes: bytes(layout) }))
    }

    /// Reads a buffer like [`read`](Self::read), and then sets it to 0.
    pub(super) fn take(gpu: &Gpu, program: &'a Program, tile: &Tile, role: &Role) -> Result<Self, GpuError> {
        let records = Self::read(gpu, program, tile, role)?;
        if let Some(buffer) = tile.buffer(role) {
            gpu.queue.write_buffer(buffer, 0, &vec![0; records.bytes().len()]);
        }
        Ok(records)
    }

    pub(super) fn rows(&self) -> impl Iterator<Item = Row<'_>> {
        self.layout.into_iter().flat_map(|layout| {
            let rows = self.bytes().chunks_exact(layout.span as usize);
            rows.map(move |bytes| Row { layout, bytes })
        })
    }

    pub(super) fn par_rows(&self) -> impl IndexedParallelIterator<Item = Row<'_>> {
        // Without a layout there are no bytes.
        let layout = self.layout.unwrap_or(&NO_LAYOUT);
        self.bytes().par_chunks_exact(layout.span as usize).map(move |bytes| Row { layout, bytes })
    }

    /// Returns the number of structs.
    pub(super) fn count(&self) -> usize {
        self.layout.map_or(0, |layout| self.bytes().len() / layout.span as usize)
    }

    /// Returns a function of the struct's number and the component, which returns a word of a 32-bit member; `None` if there is no such
    /// member.
    pub(super) fn column<'s>(&'s self, name: &str) -> Option<impl Fn(usize, usize) -> u32 + Sync + use<'s, 'a>> {
        let (span, offset) = (self.layout?.span as usize, self.field(name)?.offset as usize);
        let words: &[u32] = bytemuck::cast_slice(self.bytes());
        let (span, offset) = (span / 4, offset / 4);
        Some(move |row: usize, k: usize| words[row * span + offset + k])
    }

    /// Returns the bytes of all structs, as on the device.
    pub(super) fn bytes(&self) -> &[u8] {
        self.bytes.as_deref().unwrap_or_default()
    }

    /// Returns the offset of a scalar of a 32-bit member of a struct in the bytes; `None` if there is no such member.
    pub(super) fn offset(&self, row: usize, name: &str, k: usize) -> Option<usize> {
        Some(row * self.layout?.span as usize + self.field(name)?.offset as usize + 4 * k)
    }

    /// Returns a member, which callers should look up once for many rows.
    pub(super) fn field(&self, name: &str) -> Option<&'a Field> {
        self.layout?.field(name)
    }
}

/// A struct as bytes.
#[derive(Clone, Copy)]
pub(super) struct Row<'a> {
    layout: &'a Layout,
    bytes: &'a [u8],
}

impl Row<'_> {
    /// Returns the scalars of a member.
    fn bytes_of(&self, field: &Field) -> impl Iterator<Item = &[u8]> {
        let (at, width) = (field.offset as usize, field.width as usize);
        self.bytes[at..at + width * field.components as usize].chunks_exact(width)
    }

    /// Returns the scalars of a member; none if there is no such member.
    fn scalars(&self, name: &str) -> impl Iterator<Item = &[u8]> {
        self.layout.field(name).into_iter().flat_map(|field| self.bytes_of(field))
    }

    /// Returns the first words of a 32-bit member.
    pub(super) fn words<const N: usize>(&self, field: &Field) -> [u32; N] {
        let mut words = self.bytes_of(field).map(|bytes| bytes.try_into().map_or(0, u32::from_ne_bytes));
        [(); N].map(|()| words.next().unwrap_or(0))
    }

    /// Returns the first word of a member; 0 if there is no such member.
    pub(super) fn word(&self, field: Option<&Field>) -> u32 {
        field.map_or(0, |field| self.words::<1>(field)[0])
    }

    /// Returns the first numbers of a member; NaN if there is no such member.
    pub(super) fn numbers<const N: usize>(&self, field: Option<&Field>) -> [f64; N] {
        let mut scalars = field.into_iter().flat_map(|field| self.bytes_of(field)).map(float);
        [(); N].map(|()| scalars.next().unwrap_or(f64::NAN))
    }

    pub(super) fn uint(&self, name: &str) -> u32 {
        self.uint_at(name, 0)
    }

    /// Returns the entry k of an array.
    pub(super) fn uint_at(&self, name: &str, k: usize) -> u32 {
        self.scalars(name).nth(k).and_then(|bytes| bytes.try_into().ok()).map_or(0, u32::from_ne_bytes)
    }

    /// Returns a count of more than 32 bits; a second member, `NAME_over`, counts its overflows.
    pub(super) fn wide(&self, name: &str) -> u64 {
        u64::from(self.uint(name)) + (u64::from(self.uint(&format!("{name}_over"))) << 32)
    }

    pub(super) fn float(&self, name: &str) -> f64 {
        self.scalars(name).next().map_or(f64::NAN, float)
    }

    pub(super) fn vector(&self, name: &str) -> [f64; 3] {
        let mut scalars = self.scalars(name).map(float);
        [(); 3].map(|()| scalars.next().unwrap_or(f64::NAN))
    }
}

/// Returns a 32-bit or 64-bit number.
fn float(bytes: &[u8]) -> f64 {
    let single = || bytes.try_into().map_or(f64::NAN, |b| f32::from_ne_bytes(b).into());
    bytes.try_into().map_or_else(|_| single(), f64::from_ne_bytes)
}
