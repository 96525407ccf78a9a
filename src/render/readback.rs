//! Reading results back: the only places where the host waits for data.

use wgpu::{
    Buffer, BufferDescriptor, BufferUsages, CommandEncoder, CommandEncoderDescriptor, MapMode, PollType,
    TexelCopyBufferInfo, TexelCopyBufferLayout, Texture,
};

use crate::gpu::{Gpu, GpuError};

fn lost(error: impl std::fmt::Display) -> GpuError {
    GpuError::Lost(error.to_string())
}

/// The bytes of `buffer`, after what `before` records.
pub(super) fn read_buffer(
    gpu: &Gpu,
    buffer: &Buffer,
    before: impl FnOnce(&mut CommandEncoder),
) -> Result<Vec<u8>, GpuError> {
    let staging = staging(gpu, buffer.size());
    let mut encoder = gpu.device.create_command_encoder(&CommandEncoderDescriptor { label: Some("readback") });
    before(&mut encoder);
    encoder.copy_buffer_to_buffer(buffer, 0, &staging, 0, buffer.size());
    gpu.queue.submit([encoder.finish()]);
    mapped(gpu, &staging)
}

/// The texels of `texture` (of whole words), row by row without padding.
pub(super) fn read_texture(gpu: &Gpu, texture: &Texture) -> Result<Vec<u32>, GpuError> {
    let texel = texture.format().block_copy_size(None).unwrap_or(4);
    let row = texture.width() * texel;
    let padded = row.next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);
    let staging = staging(gpu, u64::from(padded) * u64::from(texture.height()));
    let mut encoder = gpu.device.create_command_encoder(&CommandEncoderDescriptor { label: Some("readback") });
    let layout = TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(padded), rows_per_image: None };
    encoder.copy_texture_to_buffer(
        texture.as_image_copy(),
        TexelCopyBufferInfo { buffer: &staging, layout },
        texture.size(),
    );
    gpu.queue.submit([encoder.finish()]);
    let bytes = mapped(gpu, &staging)?;
    let rows = bytes.chunks_exact(padded as usize);
    Ok(rows.flat_map(|r| bytemuck::pod_collect_to_vec::<u8, u32>(&r[..row as usize])).collect())
}

fn staging(gpu: &Gpu, size: u64) -> Buffer {
    gpu.device.create_buffer(&BufferDescriptor {
        label: Some("staging"),
        size,
        usage: BufferUsages::COPY_DST | BufferUsages::MAP_READ,
        mapped_at_creation: false,
    })
}

fn mapped(gpu: &Gpu, staging: &Buffer) -> Result<Vec<u8>, GpuError> {
    let (sender, receiver) = std::sync::mpsc::channel();
    staging.map_async(MapMode::Read, .., move |result| {
        // The receiver only goes if this function has returned, after an error of its own.
        let _ = sender.send(result);
    });
    gpu.device.poll(PollType::wait_indefinitely()).map_err(lost)?;
    receiver.recv().map_err(lost)?.map_err(lost)?;
    let bytes = staging.get_mapped_range(..).map_err(lost)?.to_vec();
    staging.unmap();
    Ok(bytes)
}
