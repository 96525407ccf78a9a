//! Reads results back; only here does the host wait for data.

use wgpu::{Buffer, BufferDescriptor, BufferUsages, CommandEncoder, CommandEncoderDescriptor, MapMode, PollType};

use crate::gpu::{Gpu, GpuError};

fn lost(error: impl std::fmt::Display) -> GpuError {
    GpuError::Lost(error.to_string())
}

/// Returns the bytes of buffers after the commands that `before` records, with one wait for all of them.
pub(super) fn read_buffers(
    gpu: &Gpu,
    buffers: &[&Buffer],
    before: impl FnOnce(&mut CommandEncoder),
) -> Result<Vec<Vec<u8>>, GpuError> {
    if buffers.is_empty() {
        return Ok(Vec::new());
    }
    let staging = gpu.device.create_buffer(&BufferDescriptor {
        label: Some("staging"),
        size: buffers.iter().map(|buffer| buffer.size()).sum(),
        usage: BufferUsages::COPY_DST | BufferUsages::MAP_READ,
        mapped_at_creation: false,
    });
    let mut encoder = gpu.device.create_command_encoder(&CommandEncoderDescriptor { label: Some("readback") });
    before(&mut encoder);
    let mut at = 0;
    for buffer in buffers {
        encoder.copy_buffer_to_buffer(buffer, 0, &staging, at, buffer.size());
        at += buffer.size();
    }
    gpu.queue.submit([encoder.finish()]);
    let bytes = mapped(gpu, &staging)?;
    let mut rest = &bytes[..];
    let part = |buffer: &&Buffer| {
        let (own, others) = rest.split_at(buffer.size() as usize);
        rest = others;
        own.to_vec()
    };
    Ok(buffers.iter().map(part).collect())
}

/// Returns the bytes of one buffer.
pub(super) fn read_buffer(
    gpu: &Gpu,
    buffer: &Buffer,
    before: impl FnOnce(&mut CommandEncoder),
) -> Result<Vec<u8>, GpuError> {
    read_buffers(gpu, &[buffer], before).map(|mut all| all.remove(0))
}

fn mapped(gpu: &Gpu, staging: &Buffer) -> Result<Vec<u8>, GpuError> {
    let (sender, receiver) = std::sync::mpsc::channel();
    staging.map_async(MapMode::Read, .., move |result| {
        // The receiver is only gone if this function has returned early with an error.
        let _ = sender.send(result);
    });
    gpu.device.poll(PollType::wait_indefinitely()).map_err(lost)?;
    receiver.recv().map_err(lost)?.map_err(lost)?;
    let bytes = staging.get_mapped_range(..).map_err(lost)?.to_vec();
    staging.unmap();
    Ok(bytes)
}
