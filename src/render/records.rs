//! What passes write for the host, read by the names that it has in WGSL.

use super::readback::read_buffer;
use crate::gpu::{Gpu, GpuError, Tile};
use crate::program::{Field, Layout, Program, Role};

/// The structs of a buffer.
pub(super) struct Records<'a> {
    layout: Option<&'a Layout>,
    bytes: Vec<u8>,
}

impl<'a> Records<'a> {
    /// Waits for the device and reads what a tile's buffer of this role holds: nothing where no pass of the program binds one.
    pub(super) fn read(gpu: &Gpu, program: &'a Program, tile: &Tile, role: &Role) -> Result<Self, GpuError> {
        let layout = program.layout(role);
        let buffer = tile.buffer(role).filter(|_| layout.is_some());
        let bytes = buffer.map(|buffer| read_buffer(gpu, buffer, |_| {})).transpose()?;
        Ok(Self { layout, bytes: bytes.unwrap_or_default() })
    }

    /// As [`read`](Self::read), and sets all of it to 0 for the next time.
    pub(super) fn take(gpu: &Gpu, program: &'a Program, tile: &Tile, role: &Role) -> Result<Self, GpuError> {
        let records = Self::read(gpu, program, tile, role)?;
        if let Some(buffer) = tile.buffer(role) {
            gpu.queue.write_buffer(buffer, 0, &vec![0; records.bytes.len()]);
        }
        Ok(records)
    }

    pub(super) fn rows(&self) -> impl Iterator<Item = Row<'_>> {
        self.layout.into_iter().flat_map(|layout| {
            let rows = self.bytes.chunks_exact(layout.span as usize);
            rows.map(move |bytes| Row { layout, bytes })
        })
    }

    /// A member, to be looked for once where there are many rows.
    pub(super) fn field(&self, name: &str) -> Option<&Field> {
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
    /// The scalars of a member.
    fn bytes_of(&self, field: &Field) -> impl Iterator<Item = &[u8]> {
        let (at, width) = (field.offset as usize, field.width as usize);
        self.bytes[at..at + width * field.components as usize].chunks_exact(width)
    }

    /// The scalars of a member; none if there is no such member.
    fn scalars(&self, name: &str) -> impl Iterator<Item = &[u8]> {
        self.layout.field(name).into_iter().flat_map(|field| self.bytes_of(field))
    }

    /// The first words of a member of 32 bits.
    pub(super) fn words<const N: usize>(&self, field: &Field) -> [u32; N] {
        let mut words = self.bytes_of(field).map(|bytes| bytes.try_into().map_or(0, u32::from_ne_bytes));
        [(); N].map(|()| words.next().unwrap_or(0))
    }

    pub(super) fn uint(&self, name: &str) -> u32 {
        self.uint_at(name, 0)
    }

    /// The entry k of an array.
    pub(super) fn uint_at(&self, name: &str, k: usize) -> u32 {
        self.scalars(name).nth(k).and_then(|bytes| bytes.try_into().ok()).map_or(0, u32::from_ne_bytes)
    }

    /// A count beyond 32 bits, of which a second member, `NAME_over`, counts how often it has run over.
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

/// A number of 32 or of 64 bits.
fn float(bytes: &[u8]) -> f64 {
    let single = || bytes.try_into().map_or(f64::NAN, |b| f32::from_ne_bytes(b).into());
    bytes.try_into().map_or_else(|_| single(), f64::from_ne_bytes)
}
