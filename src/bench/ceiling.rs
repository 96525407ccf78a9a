//! The limits of the device, measured by kernels that do nothing else.
//!
//! *Practice.* These three kernels bind a separate buffer and texture, and are timed from submission to completion. Each runs in as many
//! copies at once as make the overhead negligible and fill the device.

use std::time::{Duration, Instant};

use wgpu::{
    BindGroupDescriptor, BindGroupEntry, BindingResource, BufferDescriptor, BufferUsages, CommandEncoderDescriptor,
    ComputePassDescriptor, Extent3d, Texture, TextureDescriptor, TextureDimension, TextureFormat, TextureUsages,
};

use super::{Bench, Table, Times};
use crate::gpu::{GpuError, Pipeline};
use crate::program::{Binding, BindingKind, Parts, ProgramError, Unit, constant, link, part, reflect};
use crate::render::RenderError;

/// The number of invocations of the arithmetic kernel.
const INVOCATIONS: u32 = 1 << 16;
/// The shortest time of a measurement.
const SHORTEST: Duration = Duration::from_millis(20);
/// The largest number of copies of a kernel in one dispatch on any device.
const MOST_COPIES: u32 = 65_535;
/// The width and height of the texture, whose texels have 16 bytes.
const SIDE: u32 = 2048;
/// The number of chains of the arithmetic kernel, and of floating-point operations per link.
const CHAINS: f64 = 16.0;
const OPERATIONS: f64 = 2.0;

/// Measures fused multiply-adds, and reads and writes of texels.
pub(super) fn ceilings(bench: &Bench) -> Result<Table, RenderError> {
    let mut table = Table::new("ceilings", "Peak rates of the device", "what | rate | unit | spread");
    let iterations = constant("device_speed/multiply_add", "ITERATIONS");
    let operations = f64::from(INVOCATIONS) * CHAINS * OPERATIONS * iterations;
    let bytes = 16.0 * f64::from(SIDE) * f64::from(SIDE);
    let squares = [SIDE / 8, SIDE / 8];
    let kernels = [
        ("multiply_add", "multiply-adds in registers", "GFLOP/s", operations, [INVOCATIONS / 64, 1]),
        ("texture_read", "reading texels of 128 bits", "GB/s", bytes, squares),
        ("texture_write", "writing texels of 128 bits", "GB/s", bytes, squares),
    ];
    let texture = texture(bench);
    for (name, what, unit, amount, groups) in kernels {
        let kernel = Kernel::new(bench, name, &texture)?;
        let copies = kernel.copies(groups)?;
        let times = Times::of(bench.repeats, || Ok(kernel.run(groups, copies)?))?;
        let rate = f64::from(copies) * amount / times.median * 1e-9;
        table.rows.push(vec![what.into(), rate.into(), unit.into(), times.spread.into()]);
    }
    Ok(table)
}

/// Arithmetic that keeps the device busy, because an idle one lowers its clock.
pub(super) struct WarmUp<'a> {
    kernel: Kernel<'a>,
    copies: u32,
}

impl<'a> WarmUp<'a> {
    /// The number of workgroups of a copy.
    const GROUPS: [u32; 2] = [INVOCATIONS / 64, 1];

    /// Compiles the kernel and finds the number of its copies.
    pub(super) fn new(bench: &'a Bench) -> Result<Self, RenderError> {
        let kernel = Kernel::new(bench, "multiply_add", &texture(bench))?;
        let copies = kernel.copies(Self::GROUPS)?;
        Ok(Self { kernel, copies })
    }

    /// Keeps the device busy for a while.
    pub(super) fn run(&self) -> Result<(), GpuError> {
        self.kernel.run(Self::GROUPS, self.copies).map(|_| ())
    }
}

fn texture(bench: &Bench) -> Texture {
    bench.gpu.device.create_texture(&TextureDescriptor {
        label: Some("texels"),
        size: Extent3d { width: SIDE, height: SIDE, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: TextureDimension::D2,
        format: TextureFormat::Rgba32Float,
        usage: TextureUsages::TEXTURE_BINDING | TextureUsages::STORAGE_BINDING,
        view_formats: &[],
    })
}

/// A kernel of `shaders/device_speed/`.
struct Kernel<'a> {
    bench: &'a Bench<'a>,
    pipeline: Pipeline,
    group: wgpu::BindGroup,
}

impl<'a> Kernel<'a> {
    fn new(bench: &'a Bench, name: &str, texture: &Texture) -> Result<Self, RenderError> {
        let device = &bench.gpu.device;
        let file = format!("device_speed/{name}");
        let unit = Unit::from(part(&file).ok_or(ProgramError::NoPart(file))?);
        let linked = link(&Parts { shared: vec![unit], ..Parts::default() }, "ceiling")?;
        let pipeline = Pipeline::new(bench.gpu, &linked, &reflect(&linked)?, bench.gpu.division())?;
        let sums = device.create_buffer(&BufferDescriptor {
            label: Some("sums"),
            size: u64::from(4 * INVOCATIONS),
            usage: BufferUsages::STORAGE,
            mapped_at_creation: false,
        });
        let view = texture.create_view(&wgpu::TextureViewDescriptor::default());
        let resource = |binding: &Binding| match binding.kind {
            BindingKind::Storage { .. } => sums.as_entire_binding(),
            _ => BindingResource::TextureView(&view),
        };
        let entry = |binding: &Binding| BindGroupEntry { binding: binding.number, resource: resource(binding) };
        let entries: Vec<BindGroupEntry> = pipeline.bindings.iter().map(entry).collect();
        let layout = &pipeline.layout;
        let group = device.create_bind_group(&BindGroupDescriptor { label: Some(name), layout, entries: &entries });
        Ok(Self { bench, pipeline, group })
    }

    /// Returns the number of copies that takes long enough.
    fn copies(&self, groups: [u32; 2]) -> Result<u32, GpuError> {
        let mut copies = 1;
        while self.run(groups, copies)? < SHORTEST && copies < MOST_COPIES {
            copies = (4 * copies).min(MOST_COPIES);
        }
        Ok(copies)
    }

    fn run(&self, [x, y]: [u32; 2], copies: u32) -> Result<Duration, GpuError> {
        let gpu = self.bench.gpu;
        let started = Instant::now();
        let mut encoder = gpu.device.create_command_encoder(&CommandEncoderDescriptor { label: None });
        let mut pass = encoder.begin_compute_pass(&ComputePassDescriptor { label: None, timestamp_writes: None });
        pass.set_pipeline(&self.pipeline.pipeline);
        pass.set_bind_group(0, &self.group, &[]);
        pass.dispatch_workgroups(x, y, copies);
        drop(pass);
        gpu.wait(gpu.submit(encoder))?;
        Ok(started.elapsed())
    }
}
