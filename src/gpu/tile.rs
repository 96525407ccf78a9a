//! Stores the resources of one image tile: the state of its rays in alternating slots, and the values that one pass leaves for the next.

use std::collections::{BTreeMap, BTreeSet};
use std::num::NonZeroU64;

use wgpu::{
    BindGroup, BindGroupDescriptor, BindGroupEntry, BindingResource, Buffer, BufferBinding, BufferDescriptor,
    BufferUsages, Extent3d, Texture, TextureDescriptor, TextureDimension, TextureFormat, TextureUsages, TextureView,
    TextureViewDescriptor,
};

use super::pipeline::texture_format;
use super::slots::{FRAMES, List, PixelListKind, SECTION, Sections, Selection, WORK_HEAD};
use super::{Gpu, GpuError, Pipeline, SceneBuffers};
use crate::program::{Access, Binding, BindingKind, Pass, Program, Role, Slot, constant};

/// The device memory of one pixel.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Memory {
    /// Each texture, buffer and list, with its size in bytes per pixel.
    pub items: Vec<(String, u64)>,
}

impl Memory {
    /// Returns the total, in bytes per pixel.
    #[must_use]
    pub fn bytes_per_pixel(&self) -> u64 {
        self.items.iter().map(|(_, bytes)| bytes).sum()
    }

    /// Returns the bytes per pixel that the host reads.
    #[must_use]
    pub fn read_back(&self) -> u64 {
        let read = [Role::Pixels, Role::Moments, Role::PathEnds].map(|role| role.to_string());
        self.items.iter().filter(|(name, _)| read.contains(name)).map(|(_, bytes)| bytes).sum()
    }

    /// Returns the bytes per pixel of the largest item.
    #[must_use]
    pub fn largest_item(&self) -> u64 {
        self.items.iter().map(|(_, bytes)| *bytes).max().unwrap_or(0).max(4)
    }
}

/// Returns all items that `program` allocates per pixel, which do not depend on the number of segments.
#[must_use]
pub fn memory(program: &Program) -> Memory {
    let items = per_pixel(program).into_iter().map(|item| (item.role.to_string(), item.storage.bytes()));
    let lists = lists(program).into_iter().map(|list| (format!("list_{}", list.number()), 4));
    Memory { items: items.chain(lists).collect() }
}

/// A texture or buffer with a value for every pixel.
struct PerPixel {
    role: Role,
    storage: Storage,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Storage {
    Texture(TextureFormat),
    /// A buffer with this many bytes per pixel: stored values, or the state in 64 bits.
    Buffer(u32),
}

impl Storage {
    fn bytes(self) -> u64 {
        match self {
            Self::Texture(format) => u64::from(format.block_copy_size(None).unwrap_or(0)),
            Self::Buffer(bytes) => u64::from(bytes),
        }
    }
}

/// Returns the textures and buffers that passes write for each pixel: textures first, by name.
fn per_pixel(program: &Program) -> Vec<PerPixel> {
    let mut all = BTreeMap::new();
    for Binding { kind, role, .. } in program.bindings() {
        let storage = match (kind, role) {
            (BindingKind::StorageTexture(format), _) => texture_format(*format).map(Storage::Texture),
            (
                BindingKind::Storage { layout, read_only: false },
                Role::State(..) | Role::Pixels | Role::Moments | Role::GridRays | Role::StarHeads,
            ) => Some(Storage::Buffer(layout.span)),
            (BindingKind::Storage { layout, read_only: false }, Role::PathEnds) => {
                Some(Storage::Buffer(constant("state/ends", "END_VALUES") as u32 * layout.span))
            }
            _ => None,
        };
        let Some(storage) = storage else { continue };
        let roles = match role {
            Role::State(part, Slot::Output) => {
                (0..program.features.slots).map(|slot| Role::State(*part, Slot::Fixed(slot))).collect()
            }
            role => vec![role.clone()],
        };
        for role in roles {
            let is_buffer = matches!(storage, Storage::Buffer(_));
            all.insert((is_buffer, role.to_string()), PerPixel { role, storage });
        }
    }
    all.into_values().collect()
}

/// Returns the lists that passes write, in pairs.
fn lists(program: &Program) -> Vec<List> {
    let mut written = BTreeSet::new();
    for (pass, _, reflection) in &program.passes {
        if reflection.bindings.iter().any(|binding| binding.role == Role::List(Access::Write)) {
            written.insert(match pass {
                Pass::Shade => PixelListKind::Open,
                Pass::Refine => PixelListKind::Wanted,
                _ => PixelListKind::Active,
            });
        }
    }
    written.into_iter().flat_map(List::both).collect()
}

/// The textures and buffers of a tile, by their roles.
#[derive(Debug)]
pub struct Tile {
    /// The width and height in pixels.
    pub size: [u32; 2],
    textures: BTreeMap<Role, Texture>,
    buffers: BTreeMap<Role, Buffer>,
    lists: BTreeMap<List, Buffer>,
    /// The arguments of dispatches over the lists.
    arguments: BTreeMap<List, Buffer>,
    sections: Sections,
}

/// A resource to bind.
enum Bound<'t> {
    View(TextureView),
    Buffer(&'t Buffer),
}

impl Tile {
    /// Allocates a tile of `size` pixels for `program`.
    pub(crate) fn new(gpu: &Gpu, program: &Program, size: [u32; 2], sections: &Sections) -> Result<Self, GpuError> {
        let side = u64::from(size[0].max(size[1]));
        let allowed = u64::from(gpu.limits.max_texture_dimension_2d);
        gpu.check("max_texture_dimension_2d", "pixels along one side of a tile", allowed, side)?;
        let (textures, buffers) = (BTreeMap::new(), BTreeMap::new());
        let (lists_of, arguments) = (BTreeMap::new(), BTreeMap::new());
        let mut tile = Self { size, textures, buffers, lists: lists_of, arguments, sections: *sections };
        let pixels = u64::from(size[0]) * u64::from(size[1]);
        for PerPixel { role, storage } in per_pixel(program) {
            match storage {
                Storage::Texture(format) => {
                    let texture = texture(gpu, &role.to_string(), size, format);
                    tile.textures.insert(role, texture);
                }
                Storage::Buffer(bytes) => {
                    tile.add_storage(gpu, &role, u64::from(bytes) * pixels)?;
                }
            }
        }
        for list in lists(program) {
            let label = format!("list_{}", list.number());
            tile.lists.insert(list, buffer(gpu, &label, 4 * pixels, BufferUsages::STORAGE)?);
        }
        for of in [PixelListKind::Active, PixelListKind::Open, PixelListKind::Wanted] {
            for list in List::both(of) {
                let label = format!("arguments_{}", list.number());
                let usage = BufferUsages::STORAGE | BufferUsages::INDIRECT;
                tile.arguments.insert(list, buffer(gpu, &label, SECTION * sections.of(of), usage)?);
            }
        }
        for (role, bytes) in [(Role::Parameters, SECTION * sections.parameters), (Role::Frame, SECTION * FRAMES)] {
            let uniform = buffer(gpu, &role.to_string(), bytes, BufferUsages::UNIFORM)?;
            tile.buffers.insert(role, uniform);
        }
        tile.add_storage(gpu, &Role::Tally, 128)?;
        if program.passes.iter().any(|(pass, ..)| *pass == Pass::Refine) {
            tile.add_storage(gpu, &Role::Refined, 8)?;
        }
        if program.features.has_stars {
            tile.add_storage(gpu, &Role::StarImages, sections.star_images)?;
            let counts = program.layout(&Role::StarCounts).map_or(0, |layout| layout.span);
            tile.add_storage(gpu, &Role::StarCounts, counts.into())?;
            let usage = BufferUsages::STORAGE | BufferUsages::INDIRECT;
            let work = buffer(gpu, "star_work", WORK_HEAD + 4 * pixels, usage)?;
            tile.buffers.insert(Role::StarWork(Access::Read), work);
        }
        Ok(tile)
    }

    /// Returns the number of its pixels.
    #[must_use]
    pub fn pixels(&self) -> u64 {
        u64::from(self.size[0]) * u64::from(self.size[1])
    }

    /// Returns `true` if the tile has this size and these sections.
    pub(crate) fn is_like(&self, size: [u32; 2], sections: &Sections) -> bool {
        self.size == size && self.sections == *sections
    }

    /// Adds a buffer of zeros.
    pub(crate) fn add_storage(&mut self, gpu: &Gpu, role: &Role, bytes: u64) -> Result<(), GpuError> {
        let storage = buffer(gpu, &role.to_string(), bytes, BufferUsages::STORAGE)?;
        self.buffers.insert(role.clone(), storage);
        Ok(())
    }

    /// Adds a buffer that contains `bytes`, or overwrites one of this size.
    pub(crate) fn add_input(&mut self, gpu: &Gpu, role: &Role, bytes: &[u8]) -> Result<(), GpuError> {
        let size = bytes.len() as u64;
        if self.buffer(role).is_none_or(|buffer| buffer.size() != size) {
            self.add_storage(gpu, role, size)?;
        }
        self.write(gpu, role, 0, bytes);
        Ok(())
    }

    /// Writes into a buffer of the tile, if the tile has it.
    pub fn write(&self, gpu: &Gpu, role: &Role, offset: u64, bytes: &[u8]) {
        if let Some(buffer) = self.buffer(role) {
            gpu.queue.write_buffer(buffer, offset, bytes);
        }
    }

    /// Returns a buffer of the tile.
    #[must_use]
    pub fn buffer(&self, role: &Role) -> Option<&Buffer> {
        self.buffers.get(role)
    }

    /// Returns the arguments of dispatches over a list.
    #[must_use]
    pub fn arguments(&self, list: List) -> Option<&Buffer> {
        self.arguments.get(&list)
    }

    /// Returns a texture of the tile.
    #[must_use]
    pub fn texture(&self, role: &Role) -> Option<&Texture> {
        self.textures.get(role)
    }

    /// Creates the bind group of a pass for these slots and lists.
    pub(crate) fn bind_group(
        &self,
        gpu: &Gpu,
        pipeline: &Pipeline,
        scene: &SceneBuffers,
        selection: Selection,
    ) -> Result<BindGroup, GpuError> {
        let missing = |binding: &Binding| GpuError::Layout {
            binding: binding.name.clone(),
            problem: "no resource was created".to_owned(),
        };
        let bound = |own: &Binding| self.bound(&own.role, scene, selection).ok_or_else(|| missing(own));
        let all = pipeline.bindings.iter().map(bound).collect::<Result<Vec<_>, _>>()?;
        let entries = pipeline.bindings.iter().zip(&all).map(|(binding, bound)| {
            let resource = match bound {
                Bound::View(view) => BindingResource::TextureView(view),
                Bound::Buffer(buffer) => {
                    let size = if binding.role.is_per_dispatch() { NonZeroU64::new(SECTION) } else { None };
                    BindingResource::Buffer(BufferBinding { buffer, offset: 0, size })
                }
            };
            BindGroupEntry { binding: binding.number, resource }
        });
        let entries: Vec<_> = entries.collect();
        let descriptor = BindGroupDescriptor { label: None, layout: &pipeline.layout, entries: &entries };
        Ok(gpu.device.create_bind_group(&descriptor))
    }

    fn bound<'t>(&'t self, role: &Role, scene: &'t SceneBuffers, selection: Selection) -> Option<Bound<'t>> {
        let view = |texture: &Texture| Bound::View(texture.create_view(&TextureViewDescriptor::default()));
        let own = |role: &Role| self.texture(role).map(view).or_else(|| self.buffer(role).map(Bound::Buffer));
        match role {
            Role::Uniforms(_) | Role::Scene(_) => scene.buffer(role).map(Bound::Buffer),
            Role::Picture(k) => scene.picture(*k).map(view),
            Role::State(part, slot) => own(&Role::State(*part, Slot::Fixed(selection.slots.number(*slot)))),
            Role::List(access) => self.lists.get(&selection.list(*access)).map(Bound::Buffer),
            Role::Arguments(access) => self.arguments(selection.list(*access)).map(Bound::Buffer),
            Role::StarWork(_) => own(&Role::StarWork(Access::Read)),
            role => own(role),
        }
    }
}

fn texture(gpu: &Gpu, label: &str, size: [u32; 2], format: TextureFormat) -> Texture {
    // Mesa's software driver compiles a pass once more for textures whose width or height is a power of two, such as those of small images.
    let most = gpu.limits.max_texture_dimension_2d;
    let odd = |side: u32| if gpu.profile.is_processor && side.is_power_of_two() { (side + 1).min(most) } else { side };
    let [width, height] = size.map(odd);
    gpu.device.create_texture(&TextureDescriptor {
        label: Some(label),
        size: Extent3d { width, height, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: TextureDimension::D2,
        format,
        usage: TextureUsages::STORAGE_BINDING
            | TextureUsages::TEXTURE_BINDING
            | TextureUsages::COPY_SRC
            | TextureUsages::COPY_DST,
        view_formats: &[],
    })
}

fn buffer(gpu: &Gpu, label: &str, size: u64, usage: BufferUsages) -> Result<Buffer, GpuError> {
    if usage.contains(BufferUsages::STORAGE) {
        let allowed = gpu.limits.max_storage_buffer_binding_size.min(gpu.limits.max_buffer_size);
        gpu.check("max_storage_buffer_binding_size", &format!("bytes in one buffer (`{label}`)"), allowed, size)?;
    }
    let usage = usage | BufferUsages::COPY_DST | BufferUsages::COPY_SRC;
    Ok(gpu.device.create_buffer(&BufferDescriptor { label: Some(label), size, usage, mapped_at_creation: false }))
}
