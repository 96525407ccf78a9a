//! Linked programs as pipelines; their bind group layouts are what naga reflected.

use std::num::NonZeroU64;

use wgpu::{
    Backend, BindGroupLayoutDescriptor, BindGroupLayoutEntry, BindingType, BufferBindingType,
    ComputePipelineDescriptor, ErrorFilter, PipelineCompilationOptions, PipelineLayoutDescriptor,
    ShaderModuleDescriptor, ShaderSource, ShaderStages, StorageTextureAccess, TextureFormat, TextureSampleType,
    TextureViewDimension,
};

use super::device::{GROUP_WIDTH, LANE_PIXELS};
use super::{Gpu, GpuError, Pipeline, adapters};
use crate::program::{Binding, BindingKind, Layout, Linked, Pass, Program, Reflection, Role};

/// The read-write textures that one pass may bind on Metal. Pipelines with more are reported to be refused when they are made, on
/// devices for which wgpu gives the limit 32 (gfx-rs/wgpu#10006).
pub const METAL_READ_WRITE_TEXTURES: usize = 8;

/// Every pass of a program.
#[derive(Debug)]
pub struct Pipelines {
    passes: Vec<(Pass, Pipeline)>,
    /// The pixels of a workgroup, across and down.
    pub group: [u32; 2],
}

impl Pipelines {
    /// Compiles the program for the device, and for pictures of this width; refuses what exceeds the device's limits.
    pub fn new(gpu: &Gpu, program: &Program, width: u32) -> Result<Self, GpuError> {
        let group = narrowed(gpu.group, width);
        let stage = gpu.progress.counted("compiling pass", program.passes.len());
        let made = |(pass, linked, reflection): &(Pass, Linked, Reflection)| {
            let pipeline = Pipeline::new(gpu, linked, reflection, group[0])?;
            stage.advance(1.0);
            Ok((*pass, pipeline))
        };
        Ok(Self { passes: program.passes.iter().map(made).collect::<Result<_, GpuError>>()?, group })
    }

    /// The pipeline of `pass`, if the program has it.
    #[must_use]
    pub fn get(&self, pass: Pass) -> Option<&Pipeline> {
        self.passes.iter().find(|(p, _)| *p == pass).map(|(_, pipeline)| pipeline)
    }

    /// All passes.
    pub fn iter(&self) -> impl Iterator<Item = &(Pass, Pipeline)> {
        self.passes.iter()
    }
}

impl Pipeline {
    /// Compiles one linked program, with workgroups of so many pixels across, unless it was compiled lately.
    pub fn new(gpu: &Gpu, linked: &Linked, reflection: &Reflection, across: u32) -> Result<Self, GpuError> {
        if let Some(compiled) = gpu.compiled.find(&linked.source, across) {
            return Ok(compiled);
        }
        let pipeline = Self::compile(gpu, linked, reflection, across)?;
        gpu.compiled.keep(&linked.source, across, &pipeline);
        Ok(pipeline)
    }

    fn compile(gpu: &Gpu, linked: &Linked, reflection: &Reflection, across: u32) -> Result<Self, GpuError> {
        if reflection.doubles && !gpu.f64 {
            let there = adapters().into_iter().filter(|adapter| adapter.f64).map(|adapter| adapter.info.name).collect();
            return Err(GpuError::NoDouble { device: gpu.info.name.clone(), there });
        }
        check_limits(gpu, reflection)?;
        if gpu.info.backend == Backend::Metal {
            check_metal(&gpu.info.name, reflection)?;
        }
        let entries: Vec<_> = reflection.bindings.iter().map(entry).collect::<Result<_, _>>()?;
        let label = Some(linked.entry.as_str());
        let scope = gpu.device.push_error_scope(ErrorFilter::Validation);
        let layout = gpu.device.create_bind_group_layout(&BindGroupLayoutDescriptor { label, entries: &entries });
        let source = ShaderSource::Wgsl(linked.source.as_str().into());
        let module = gpu.device.create_shader_module(ShaderModuleDescriptor { label, source });
        let pipeline_layout = gpu.device.create_pipeline_layout(&PipelineLayoutDescriptor {
            label,
            bind_group_layouts: &[Some(&layout)],
            immediate_size: 0,
        });
        let mut known = vec![(GROUP_WIDTH, f64::from(across)), (LANE_PIXELS, f64::from(gpu.profile.lane_pixels))];
        known.retain(|(known, _)| reflection.overrides.iter().any(|name| name == known));
        let compilation_options =
            PipelineCompilationOptions { constants: &known, ..PipelineCompilationOptions::default() };
        let pipeline = gpu.device.create_compute_pipeline(&ComputePipelineDescriptor {
            label,
            layout: Some(&pipeline_layout),
            module: &module,
            entry_point: label,
            compilation_options,
            cache: None,
        });
        if let Some(error) = pollster::block_on(scope.pop()) {
            return Err(GpuError::Pass { pass: linked.entry.clone(), reason: error.to_string() });
        }
        Ok(Self { pipeline, layout, bindings: reflection.bindings.clone() })
    }
}

/// A workgroup of as many pixels that is no wider than it has to be: what lies beyond a picture's edge idles.
fn narrowed([across, down]: [u32; 2], width: u32) -> [u32; 2] {
    let narrow = across.min(width.max(1).checked_next_power_of_two().unwrap_or(across));
    [narrow, across * down / narrow]
}

fn check_limits(gpu: &Gpu, reflection: &Reflection) -> Result<(), GpuError> {
    let count = |is: fn(&BindingKind) -> bool| reflection.bindings.iter().filter(|b| is(&b.kind)).count() as u64;
    let pass = &reflection.entry;
    let limits = &gpu.limits;
    gpu.check(
        "max_storage_textures_per_shader_stage",
        &format!("storage textures in one pass (`{pass}`)"),
        u64::from(limits.max_storage_textures_per_shader_stage),
        count(|kind| matches!(kind, BindingKind::StorageTexture { .. })),
    )?;
    gpu.check(
        "max_storage_buffers_per_shader_stage",
        &format!("storage buffers in one pass (`{pass}`)"),
        u64::from(limits.max_storage_buffers_per_shader_stage),
        count(|kind| matches!(kind, BindingKind::Storage { .. })),
    )?;
    gpu.check(
        "max_sampled_textures_per_shader_stage",
        &format!("textures in one pass (`{pass}`)"),
        u64::from(limits.max_sampled_textures_per_shader_stage),
        count(|kind| matches!(kind, BindingKind::Texture(_))),
    )
}

/// An error if the program binds more read-write textures than Metal takes.
fn check_metal(device: &str, reflection: &Reflection) -> Result<(), GpuError> {
    let (needed, allowed) = (reflection.read_write_textures(), METAL_READ_WRITE_TEXTURES);
    if needed <= allowed {
        return Ok(());
    }
    let splits = reflection.bindings.iter().any(|binding| binding.role == Role::Kept("branches"));
    let remedy = if splits {
        "use rays.branches = \"random\", which keeps less for each pixel, or another device"
    } else {
        "keep less for each pixel (alpha, adaptive sampling, footprints, clamping, the layer of orders), or use another device"
    };
    Err(GpuError::ReadWriteTextures {
        device: device.to_owned(),
        pass: reflection.entry.clone(),
        allowed,
        needed,
        remedy,
    })
}

fn entry(binding: &Binding) -> Result<BindGroupLayoutEntry, GpuError> {
    let unknown = |what: &dyn std::fmt::Debug| GpuError::Layout {
        binding: binding.name.clone(),
        problem: format!("the driver does not know {what:?}"),
    };
    let sized = |ty, bytes: u64| BindingType::Buffer {
        ty,
        has_dynamic_offset: binding.role.is_per_dispatch(),
        min_binding_size: NonZeroU64::new(bytes),
    };
    let buffer = |ty, layout: &Layout| sized(ty, u64::from(layout.span) * u64::from(layout.count.unwrap_or(1)));
    let ty = match &binding.kind {
        BindingKind::Uniform(layout) => buffer(BufferBindingType::Uniform, layout),
        BindingKind::Block { span, .. } => sized(BufferBindingType::Uniform, u64::from(*span)),
        BindingKind::Storage { layout, read_only } => {
            buffer(BufferBindingType::Storage { read_only: *read_only }, layout)
        }
        BindingKind::Texture(kind) => BindingType::Texture {
            sample_type: match kind {
                naga::ScalarKind::Float => TextureSampleType::Float { filterable: false },
                naga::ScalarKind::Uint => TextureSampleType::Uint,
                other => return Err(unknown(other)),
            },
            view_dimension: TextureViewDimension::D2,
            multisampled: false,
        },
        BindingKind::StorageTexture { format, reads } => BindingType::StorageTexture {
            access: if *reads { StorageTextureAccess::ReadWrite } else { StorageTextureAccess::WriteOnly },
            format: texture_format(*format).ok_or_else(|| unknown(format))?,
            view_dimension: TextureViewDimension::D2,
        },
    };
    Ok(BindGroupLayoutEntry { binding: binding.number, visibility: ShaderStages::COMPUTE, ty, count: None })
}

/// The texture that a storage binding of this format is of.
pub(super) fn texture_format(format: naga::StorageFormat) -> Option<TextureFormat> {
    Some(match format {
        naga::StorageFormat::R32Uint => TextureFormat::R32Uint,
        naga::StorageFormat::R32Float => TextureFormat::R32Float,
        naga::StorageFormat::Rgba32Float => TextureFormat::Rgba32Float,
        naga::StorageFormat::Rgba16Float => TextureFormat::Rgba16Float,
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::program::{Parts, Unit, link, reflect};

    /// A pass with so many read-write textures, one more that it only writes, and that of this name.
    fn pass(count: usize, name: &str) -> Reflection {
        let texture = |k: usize, name: &str, access: &str| {
            format!("@group(0) @binding({k}) var {name}: texture_storage_2d<r32uint, {access}>;\n")
        };
        let names: Vec<String> =
            (0..count).map(|k| if k == 0 { name.to_owned() } else { format!("kept_{k}_a") }).collect();
        let declared = names.iter().enumerate().map(|(k, own)| texture(k, own, "read_write"));
        let copied = names.iter().map(|own| format!("textureStore({own}, vec2u(), textureLoad({own}, vec2u()));\n"));
        let (declared, copied) = (declared.collect::<Vec<_>>().concat(), copied.collect::<Vec<_>>().concat());
        let text = format!(
            "{}{declared}@compute @workgroup_size(1) fn shade() {{\ntextureStore(written, vec2u(), vec4u());\n{copied}}}\n",
            texture(100, "written", "write")
        );
        let parts = Parts { shared: vec![Unit::user("a.wgsl", text)], ..Parts::default() };
        reflect(&link(&parts, "shade").unwrap()).unwrap()
    }

    #[test]
    fn metals_read_write_textures_are_counted() {
        assert_eq!(pass(11, "status").read_write_textures(), 11);
        assert!(check_metal("Apple M1", &pass(8, "branches")).is_ok());
        for (name, remedy) in
            [("branches", "use rays.branches = \"random\""), ("status", "keep less for each pixel (alpha")]
        {
            let said = check_metal("Apple M1", &pass(9, name)).unwrap_err().to_string();
            let start = "Apple M1: pass `shade` of this scene needs 9 read-write textures, and Metal allows 8 (gfx-rs/wgpu#10006)";
            assert!(said.starts_with(start) && said.contains(remedy), "{said}");
        }
    }
}
