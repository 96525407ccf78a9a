//! Reads results back; only here does the host wait for data.

use std::ops::Deref;
use std::sync::{Arc, Mutex};

use wgpu::{
    Buffer, BufferDescriptor, BufferUsages, BufferView, CommandEncoder, CommandEncoderDescriptor, MAP_ALIGNMENT,
    MapMode,
};

use crate::gpu::{Gpu, GpuError};

/// The largest number of free buffers that a device keeps.
const MOST_FREE: usize = 4;

fn lost(error: impl std::fmt::Display) -> GpuError {
    GpuError::Lost(error.to_string())
}

/// The bytes of a buffer, where the device wrote them.
#[derive(Debug)]
pub(super) struct Bytes {
    view: BufferView,
    // Dropped after the view, which must be gone when the buffer is used again.
    _staging: Arc<Staging>,
}

impl Deref for Bytes {
    type Target = [u8];

    fn deref(&self) -> &[u8] {
        &self.view
    }
}

/// A buffer that the host reads, taken from the device's free ones and returned to them: a driver needs milliseconds for a new one.
#[derive(Debug)]
struct Staging {
    buffer: Buffer,
    free: Arc<Mutex<Vec<Buffer>>>,
}

impl Staging {
    fn of(gpu: &Gpu, size: u64) -> Self {
        let free = gpu.staging.clone();
        let fits = |buffer: &Buffer| (size..=size.saturating_mul(2)).contains(&buffer.size());
        let found = free.lock().ok().and_then(|mut all| {
            let place = all.iter().position(fits)?;
            Some(all.remove(place))
        });
        let usage = BufferUsages::COPY_DST | BufferUsages::MAP_READ;
        let descriptor = BufferDescriptor { label: Some("staging"), size, usage, mapped_at_creation: false };
        Self { buffer: found.unwrap_or_else(|| gpu.device.create_buffer(&descriptor)), free }
    }
}

impl Drop for Staging {
    fn drop(&mut self) {
        self.buffer.unmap();
        if let Ok(mut free) = self.free.lock() {
            free.push(self.buffer.clone());
            let excess = free.len().saturating_sub(MOST_FREE);
            free.drain(..excess);
        }
    }
}

/// Returns the bytes of buffers after the commands that `before` records, with one wait for all of them. They stay where the device wrote
/// them: an image has many, and each is read once or never.
pub(super) fn read_buffers(
    gpu: &Gpu,
    buffers: &[&Buffer],
    before: impl FnOnce(&mut CommandEncoder),
) -> Result<Vec<Bytes>, GpuError> {
    if buffers.is_empty() {
        return Ok(Vec::new());
    }
    let mut size = 0;
    let ranges: Vec<_> = buffers
        .iter()
        .map(|buffer| {
            let start = size;
            size += buffer.size().next_multiple_of(MAP_ALIGNMENT);
            start..start + buffer.size()
        })
        .collect();
    let staging = Arc::new(Staging::of(gpu, size));
    let mut encoder = gpu.device.create_command_encoder(&CommandEncoderDescriptor { label: Some("readback") });
    before(&mut encoder);
    for (buffer, range) in buffers.iter().zip(&ranges) {
        encoder.copy_buffer_to_buffer(buffer, 0, &staging.buffer, range.start, buffer.size());
    }
    let submission = gpu.submit(encoder);
    let (sender, receiver) = std::sync::mpsc::channel();
    staging.buffer.map_async(MapMode::Read, .., move |result| {
        // The receiver is only gone if this function has returned early with an error.
        let _ = sender.send(result);
    });
    gpu.wait(submission)?;
    receiver.recv().map_err(lost)?.map_err(lost)?;
    let bytes = |range| {
        let view = staging.buffer.get_mapped_range(range).map_err(lost)?;
        Ok(Bytes { view, _staging: staging.clone() })
    };
    ranges.into_iter().map(bytes).collect()
}

/// Returns the bytes of one buffer.
pub(super) fn read_buffer(
    gpu: &Gpu,
    buffer: &Buffer,
    before: impl FnOnce(&mut CommandEncoder),
) -> Result<Bytes, GpuError> {
    read_buffers(gpu, &[buffer], before).map(|mut all| all.remove(0))
}
