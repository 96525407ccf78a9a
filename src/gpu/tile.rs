//! What lives as long as one tile of a picture: the state of its rays in slots that ping-pong, and what passes hand to the next.

use std::collections::{BTreeMap, BTreeSet};

use wgpu::{
    BindGroup, BindGroupDescriptor, BindGroupEntry, BindingResource, Buffer, BufferBinding, BufferDescriptor,
    BufferUsages, Extent3d, Texture, TextureDescriptor, TextureDimension, TextureFormat, TextureUsages,
    TextureViewDescriptor,
};

use super::pipeline::{PER_PASS, Pipeline, Pipelines, texture_format};
use super::{Gpu, GpuError, SceneBuffers};
use crate::program::{BindingKind, Linked, Pass, Program, Reflection};

/// Bytes between the parts that passes see of a buffer: any device's alignment.
pub const TURN_STRIDE: u64 = 256;

/// Which slots of the state a pass reads and writes, and which lists of pixels.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Slots {
    /// Read as `x_in`, `v_in`.
    pub input: usize,
    /// Written as `x_out`, `v_out`.
    pub output: usize,
    /// Read as `x_start`.
    pub start: usize,
    /// Read as `x_end`.
    pub end: usize,
    /// The lists that are read and written: 0 and 1 are of the living, from [`OPEN`] on two of the open pixels, and from [`WANTED`]
    /// on two of those that want more samples.
    pub list: [usize; 2],
}

/// The arguments of dispatches over each list.
const LIVING: [&str; 6] = ["active_0", "active_1", "active_2", "active_3", "active_4", "active_5"];

/// The parts of the buffers of which each pass sees its own.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Parts {
    /// Of what differs between steps.
    pub turns: u64,
    /// Of each list of the living.
    pub living: u64,
    /// Of each list of the open pixels.
    pub open: u64,
}

/// The first of the two lists of the pixels that have a path left.
pub const OPEN: usize = 2;
/// The first of the two lists of the pixels that want more samples.
pub const WANTED: usize = 4;

impl Slots {
    /// From those of a sample's first round those of another: the lists of open pixels take turns.
    #[must_use]
    pub fn in_round(self, round: u32) -> Self {
        let is_open = |list: usize| (OPEN..WANTED).contains(&list);
        let turned = |list: usize| if is_open(list) { OPEN + (list + round as usize) % 2 } else { list };
        Self { list: self.list.map(turned), ..self }
    }
}

/// Where a pass finds a binding: names of the state's slots depend on the pass, all others are their own.
fn resource_name(name: &str, slots: Slots) -> String {
    let Some((base, role)) = name.rsplit_once('_') else {
        return name.to_owned();
    };
    match (base, role) {
        ("x" | "v" | "clock" | "error", "in") => format!("{base}_{}", slots.input),
        ("x" | "v" | "clock" | "error", "out") => format!("{base}_{}", slots.output),
        ("x" | "v", "start") => format!("{base}_{}", slots.start),
        ("x" | "v", "end") => format!("{base}_{}", slots.end),
        ("list" | "active", "in") => format!("{base}_{}", slots.list[0]),
        ("list" | "active", "out") => format!("{base}_{}", slots.list[1]),
        _ => name.to_owned(),
    }
}

/// What one pixel costs on the device.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Memory {
    /// Each texture and list of the state, with its bytes a pixel.
    pub items: Vec<(String, u64)>,
}

impl Memory {
    /// Bytes a pixel, all together.
    #[must_use]
    pub fn bytes_per_pixel(&self) -> u64 {
        self.items.iter().map(|(_, bytes)| bytes).sum()
    }

    /// Bytes a pixel of the item that takes most.
    #[must_use]
    pub fn largest_item(&self) -> u64 {
        self.items.iter().map(|(_, bytes)| *bytes).max().unwrap_or(0).max(4)
    }
}

/// Everything that `program` allocates for each pixel, whatever the number of segments.
#[must_use]
pub fn memory(program: &Program, slots: usize) -> Memory {
    let textures = textures(program, slots).into_iter().map(|(name, format)| (name, texel_bytes(format)));
    let buffers = state_buffers(program, slots).into_iter().map(|(name, bytes)| (name, u64::from(bytes)));
    let lists = lists(program).into_iter().map(|name| (name, 4));
    Memory { items: textures.chain(buffers).chain(lists).collect() }
}

fn texel_bytes(format: TextureFormat) -> u64 {
    u64::from(format.block_copy_size(None).unwrap_or(0))
}

/// The textures that passes write, by name.
fn textures(program: &Program, slots: usize) -> BTreeMap<String, TextureFormat> {
    let mut all = BTreeMap::new();
    for binding in program.passes.iter().flat_map(|(_, _, reflection)| &reflection.bindings) {
        let BindingKind::StorageTexture { format, .. } = binding.kind else { continue };
        let Some(format) = texture_format(format) else { continue };
        for output in 0..slots {
            let roles = Slots { input: 0, output, start: 0, end: 0, list: [0; 2] };
            all.insert(resource_name(&binding.name, roles), format);
        }
    }
    all
}

/// The buffers that hold the state where no texture can, with their bytes a pixel: what passes write to a slot's role.
fn state_buffers(program: &Program, slots: usize) -> BTreeMap<String, u32> {
    let mut all = BTreeMap::new();
    for binding in program.passes.iter().flat_map(|(_, _, reflection)| &reflection.bindings) {
        let BindingKind::Storage { layout, read_only: false } = &binding.kind else { continue };
        for output in 0..slots {
            let name = resource_name(&binding.name, Slots { input: 0, output, start: 0, end: 0, list: [0; 2] });
            if ["taken", "moments"].contains(&name.as_str())
                || (name != binding.name && !name.starts_with("list_") && !name.starts_with("active_"))
            {
                all.insert(name, layout.span);
            }
        }
    }
    all
}

fn lists(program: &Program) -> Vec<String> {
    let lists = |(pass, _, reflection): &(Pass, Linked, Reflection)| {
        reflection.bindings.iter().any(|binding| binding.name == "list_out").then_some(match pass {
            Pass::Shade => OPEN,
            Pass::Refine => WANTED,
            _ => 0,
        })
    };
    let firsts: BTreeSet<usize> = program.passes.iter().filter_map(lists).collect();
    firsts.into_iter().flat_map(|first| [first, first + 1]).map(|list| format!("list_{list}")).collect()
}

/// A tile's textures and buffers.
#[derive(Debug)]
pub struct Tile {
    /// Width and height in pixels.
    pub size: [u32; 2],
    textures: BTreeMap<String, Texture>,
    buffers: BTreeMap<String, Buffer>,
}

impl Tile {
    /// Allocates a tile of `size` pixels for `program`, with so many slots of state.
    pub fn new(gpu: &Gpu, program: &Program, size: [u32; 2], slots: usize, parts: &Parts) -> Result<Self, GpuError> {
        let side = u64::from(size[0].max(size[1]));
        let allowed = u64::from(gpu.limits.max_texture_dimension_2d);
        gpu.check("max_texture_dimension_2d", "pixels along one side of a tile", allowed, side)?;
        let mut tile = Self { size, textures: BTreeMap::new(), buffers: BTreeMap::new() };
        for (name, format) in textures(program, slots) {
            let texture = gpu.device.create_texture(&TextureDescriptor {
                label: Some(&name),
                size: Extent3d { width: size[0], height: size[1], depth_or_array_layers: 1 },
                mip_level_count: 1,
                sample_count: 1,
                dimension: TextureDimension::D2,
                format,
                usage: TextureUsages::STORAGE_BINDING | TextureUsages::TEXTURE_BINDING | TextureUsages::COPY_SRC,
                view_formats: &[],
            });
            tile.textures.insert(name, texture);
        }
        let pixels = u64::from(size[0]) * u64::from(size[1]);
        for (name, bytes) in state_buffers(program, slots) {
            tile.add_buffer(gpu, &name, u64::from(bytes) * pixels, BufferUsages::STORAGE)?;
        }
        for name in lists(program) {
            tile.add_buffer(gpu, &name, 4 * pixels, BufferUsages::STORAGE)?;
        }
        for (list, name) in LIVING.into_iter().enumerate() {
            let parts = match list {
                ..OPEN => parts.living,
                OPEN..WANTED => parts.open,
                _ => 1,
            };
            tile.add_buffer(gpu, name, TURN_STRIDE * parts, BufferUsages::STORAGE | BufferUsages::INDIRECT)?;
        }
        tile.add_buffer(gpu, "dispatch", TURN_STRIDE * parts.turns, BufferUsages::UNIFORM)?;
        tile.add_buffer(gpu, "frame", 64, BufferUsages::UNIFORM)?;
        tile.add_buffer(gpu, "tally", 128, BufferUsages::STORAGE)?;
        if program.passes.iter().any(|(pass, ..)| *pass == Pass::Refine) {
            tile.add_buffer(gpu, "refined", 8, BufferUsages::STORAGE)?;
        }
        Ok(tile)
    }

    /// Adds a buffer that passes find by `name`.
    pub fn add_buffer(&mut self, gpu: &Gpu, name: &str, size: u64, usage: BufferUsages) -> Result<(), GpuError> {
        if usage.contains(BufferUsages::STORAGE) {
            let allowed = gpu.limits.max_storage_buffer_binding_size.min(gpu.limits.max_buffer_size);
            gpu.check("max_storage_buffer_binding_size", &format!("bytes in one buffer (`{name}`)"), allowed, size)?;
        }
        let usage = usage | BufferUsages::COPY_DST | BufferUsages::COPY_SRC;
        let buffer =
            gpu.device.create_buffer(&BufferDescriptor { label: Some(name), size, usage, mapped_at_creation: false });
        self.buffers.insert(name.to_owned(), buffer);
        Ok(())
    }

    /// A buffer of the tile.
    #[must_use]
    pub fn buffer(&self, name: &str) -> Option<&Buffer> {
        self.buffers.get(name)
    }

    /// The arguments of dispatches over a list.
    #[must_use]
    pub fn living(&self, list: usize) -> Option<&Buffer> {
        self.buffer(LIVING[list])
    }

    /// A texture of the tile.
    #[must_use]
    pub fn texture(&self, name: &str) -> Option<&Texture> {
        self.textures.get(name)
    }

    /// The bind group of a pass that uses these slots.
    pub fn bind_group(
        &self,
        gpu: &Gpu,
        pipeline: &Pipeline,
        scene: &SceneBuffers,
        slots: Slots,
    ) -> Result<BindGroup, GpuError> {
        let missing = |binding: &str| GpuError::Layout {
            binding: binding.to_owned(),
            problem: "no resource of this name was made".to_owned(),
        };
        let mut views = Vec::new();
        for binding in &pipeline.bindings {
            let name = resource_name(&binding.name, slots);
            let texture = self.textures.get(&name).or_else(|| scene.textures.get(&name));
            views.push((name, texture.map(|texture| texture.create_view(&TextureViewDescriptor::default()))));
        }
        let entries = pipeline.bindings.iter().zip(&views).map(|(binding, (name, view))| {
            let resource = if let Some(view) = view {
                BindingResource::TextureView(view)
            } else {
                let buffer = self.buffers.get(name).or_else(|| scene.buffers.get(name)).ok_or_else(|| missing(name))?;
                let part = PER_PASS.contains(&binding.name.as_str());
                let size = if part { std::num::NonZeroU64::new(16) } else { None };
                BindingResource::Buffer(BufferBinding { buffer, offset: 0, size })
            };
            Ok(BindGroupEntry { binding: binding.number, resource })
        });
        let entries = entries.collect::<Result<Vec<_>, GpuError>>()?;
        let descriptor = BindGroupDescriptor { label: None, layout: &pipeline.layout, entries: &entries };
        Ok(gpu.device.create_bind_group(&descriptor))
    }

    /// How many of a pass's bindings are parts of per-pass buffers, each wanting an offset.
    #[must_use]
    pub fn offsets(pipelines: &Pipelines, pass: Pass) -> Vec<&'static str> {
        let bindings = pipelines.get(pass).map_or(&[][..], |pipeline| &pipeline.bindings);
        bindings.iter().filter_map(|binding| PER_PASS.iter().copied().find(|name| *name == binding.name)).collect()
    }
}
