//! Compiles linked programs to pipelines, with the bind group layouts that naga reflected.

use std::error::Error;
use std::num::NonZeroU64;

use rayon::prelude::*;
use wgpu::{
    BindGroupLayoutDescriptor, BindGroupLayoutEntry, BindingType, BufferBindingType, ComputePipelineDescriptor,
    ErrorFilter, PipelineCompilationOptions, PipelineLayoutDescriptor, ShaderModule, ShaderModuleDescriptor,
    ShaderRuntimeChecks, ShaderSource, ShaderStages, StorageTextureAccess, TextureFormat, TextureSampleType,
    TextureViewDimension,
};

use super::compiled::Division;
use super::device::{GROUP_WIDTH, LANE_PIXELS};
use super::{Gpu, GpuError, Pipeline, adapters};
use crate::program::{Binding, BindingKind, Features, Layout, LinkedProgram, Pass, Program, Reflection};

/// All passes of a program.
#[derive(Debug)]
pub struct Pipelines {
    passes: Vec<(Pass, Pipeline)>,
    /// The division of their pixels.
    pub division: Division,
}

impl Pipelines {
    /// Compiles the passes of the program in parallel for the device and for images of this width and height; rejects programs that exceed
    /// the limits of the device.
    ///
    /// # Errors
    ///
    /// Returns [`GpuError::NoDouble`] if a pass computes in 64 bits and the device does not, [`GpuError::Limit`] if a pass exceeds a limit
    /// of the device, and [`GpuError::Pass`] if the driver rejects a pass.
    pub fn new(gpu: &Gpu, program: &Program, size: [u32; 2]) -> Result<Self, GpuError> {
        let division = division(gpu, size, &program.features);
        let stage = gpu.progress.counted("compiling pass", program.passes.len());
        let made = |(pass, linked, reflection): &(Pass, LinkedProgram, Reflection)| {
            let pipeline = Pipeline::new(gpu, linked, reflection, division)?;
            stage.advance(1.0);
            Ok((*pass, pipeline))
        };
        Ok(Self { passes: program.passes.par_iter().map(made).collect::<Result<_, GpuError>>()?, division })
    }

    /// Returns the pipeline of `pass`, if the program has it.
    #[must_use]
    pub fn get(&self, pass: Pass) -> Option<&Pipeline> {
        self.passes.iter().find(|(p, _)| *p == pass).map(|(_, pipeline)| pipeline)
    }

    /// Returns all passes.
    pub fn iter(&self) -> impl Iterator<Item = &(Pass, Pipeline)> {
        self.passes.iter()
    }
}

impl Pipeline {
    /// Compiles one linked program for this division of pixels, unless it is cached.
    ///
    /// # Errors
    ///
    /// Returns the errors of [`Pipelines::new`].
    pub fn new(
        gpu: &Gpu,
        linked: &LinkedProgram,
        reflection: &Reflection,
        division: Division,
    ) -> Result<Self, GpuError> {
        if let Some(compiled) = gpu.compiled.find(&linked.source, division) {
            return Ok(compiled);
        }
        let pipeline = Self::compile(gpu, linked, reflection, division)?;
        gpu.compiled.keep(&linked.source, division, &pipeline);
        Ok(pipeline)
    }

    fn compile(
        gpu: &Gpu,
        linked: &LinkedProgram,
        reflection: &Reflection,
        division: Division,
    ) -> Result<Self, GpuError> {
        if reflection.doubles && !gpu.f64 {
            let there = adapters().into_iter().filter(|adapter| adapter.f64).map(|adapter| adapter.info.name).collect();
            return Err(GpuError::NoDouble { device: gpu.info.name.clone(), there });
        }
        check_limits(gpu, reflection)?;
        let entries: Vec<_> = reflection.bindings.iter().map(entry).collect::<Result<_, _>>()?;
        let label = Some(linked.entry.as_str());
        let scope = gpu.device.push_error_scope(ErrorFilter::Validation);
        let layout = gpu.device.create_bind_group_layout(&BindGroupLayoutDescriptor { label, entries: &entries });
        let module = module(gpu, linked);
        let pipeline_layout = gpu.device.create_pipeline_layout(&PipelineLayoutDescriptor {
            label,
            bind_group_layouts: &[Some(&layout)],
            immediate_size: 0,
        });
        let mut known =
            vec![(GROUP_WIDTH, f64::from(division.group[0])), (LANE_PIXELS, f64::from(division.lane_pixels))];
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
            let first: Option<&dyn Error> = Some(&error);
            let sources = std::iter::successors(first, |error: &&dyn Error| (*error).source());
            let reason = sources.map(ToString::to_string).collect::<Vec<_>>().join(": ");
            return Err(GpuError::Pass { pass: linked.entry.clone(), reason });
        }
        Ok(Self { pipeline, layout, bindings: reflection.bindings.clone() })
    }
}

/// Creates the shader module of a linked program. wgpu bounds every loop by a counter of two words, which costs GPUs up to a third of their
/// registers; bentray's own programs do without, and a user's WGSL keeps the counters.
fn module(gpu: &Gpu, linked: &LinkedProgram) -> ShaderModule {
    let source = ShaderSource::Wgsl(linked.source.as_str().into());
    let descriptor = ShaderModuleDescriptor { label: Some(&linked.entry), source };
    if !linked.is_own() {
        return gpu.device.create_shader_module(descriptor);
    }
    let checks = ShaderRuntimeChecks { force_loop_bounding: false, ..ShaderRuntimeChecks::checked() };
    // SAFETY: every loop of `shaders/` and of generated code ends: it counts up to a length, walks a structure without cycles, or stops
    // when the budget of steps is spent. All other checks stay on.
    #[allow(unsafe_code)]
    unsafe {
        gpu.device.create_shader_module_trusted(descriptor, checks)
    }
}

/// Returns the division of images of this width and height.
fn division(gpu: &Gpu, [width, height]: [u32; 2], features: &Features) -> Division {
    let pixels = u64::from(width) * u64::from(height);
    let profile = &gpu.profile;
    let random = || profile.random_lane_pixels(pixels, features.keeps_taken);
    let lane_pixels = if features.follows_paths { random() } else { profile.lane_pixels };
    Division { group: narrowed(gpu.group, width), lane_pixels }
}

/// Returns a workgroup of equal area that is no wider than an image of `width` pixels requires, because pixels beyond the edge are idle.
fn narrowed([across, down]: [u32; 2], width: u32) -> [u32; 2] {
    let narrow = across.min(width.max(1).checked_next_power_of_two().unwrap_or(across));
    [narrow, across * down / narrow]
}

fn check_limits(gpu: &Gpu, reflection: &Reflection) -> Result<(), GpuError> {
    let pass = &reflection.entry;
    let limits = &gpu.limits;
    gpu.check(
        "max_storage_textures_per_shader_stage",
        &format!("storage textures in one pass (`{pass}`)"),
        u64::from(limits.max_storage_textures_per_shader_stage),
        reflection.count(|kind| matches!(kind, BindingKind::StorageTexture(_))) as u64,
    )?;
    gpu.check(
        "max_storage_buffers_per_shader_stage",
        &format!("storage buffers in one pass (`{pass}`)"),
        u64::from(limits.max_storage_buffers_per_shader_stage),
        reflection.count(|kind| matches!(kind, BindingKind::Storage { .. })) as u64,
    )?;
    gpu.check(
        "max_sampled_textures_per_shader_stage",
        &format!("textures in one pass (`{pass}`)"),
        u64::from(limits.max_sampled_textures_per_shader_stage),
        reflection.count(|kind| matches!(kind, BindingKind::Texture(_))) as u64,
    )
}

fn entry(binding: &Binding) -> Result<BindGroupLayoutEntry, GpuError> {
    let unknown = |what: &dyn std::fmt::Debug| GpuError::Layout {
        binding: binding.name.clone(),
        problem: format!("the driver does not support {what:?}"),
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
        BindingKind::StorageTexture(format) => BindingType::StorageTexture {
            access: StorageTextureAccess::WriteOnly,
            format: texture_format(*format).ok_or_else(|| unknown(format))?,
            view_dimension: TextureViewDimension::D2,
        },
    };
    Ok(BindGroupLayoutEntry { binding: binding.number, visibility: ShaderStages::COMPUTE, ty, count: None })
}

/// Returns the texture format for a storage binding of this format.
pub(super) fn texture_format(format: naga::StorageFormat) -> Option<TextureFormat> {
    Some(match format {
        naga::StorageFormat::R32Uint => TextureFormat::R32Uint,
        naga::StorageFormat::R32Float => TextureFormat::R32Float,
        naga::StorageFormat::Rgba32Float => TextureFormat::Rgba32Float,
        naga::StorageFormat::Rgba16Float => TextureFormat::Rgba16Float,
        _ => return None,
    })
}
