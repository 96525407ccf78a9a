//! Choosing and opening a device.

use wgpu::{
    Adapter, AdapterInfo, Backends, Device, DeviceDescriptor, DeviceType, Features, Instance, InstanceDescriptor,
    InstanceFlags, Limits, Queue,
};

use super::GpuError;
use super::compiled::Compiled;
use super::quiet::quietly;
use crate::program::{DeviceProfile, constant};
use crate::progress::Progress;

/// The numbers of `shaders/state/active.wgsl` that a device may have its own of.
pub(super) const GROUP_WIDTH: &str = "GROUP_WIDTH";
pub(super) const LANE_PIXELS: &str = "LANE_PIXELS";

/// An open device.
#[derive(Debug)]
pub struct Gpu {
    /// wgpu's device.
    pub device: Device,
    /// Its only queue.
    pub queue: Queue,
    /// What it is.
    pub info: AdapterInfo,
    /// All that it can do: the device is opened with the adapter's own limits, and programs are checked against them.
    pub limits: Limits,
    /// Can passes be timed?
    pub timestamps: bool,
    /// Does WGSL have f64 there?
    pub f64: bool,
    /// Width and height of the block of pixels that one workgroup takes.
    pub group: [u32; 2],
    /// What programs and passes have to know of it.
    pub profile: DeviceProfile,
    /// Where work on it reports how far it has come; unless [`Gpu::reporting`] says otherwise, to nobody.
    pub progress: Progress,
    pub(super) compiled: Compiled,
}

/// One line of `bentray devices`.
#[derive(Debug, Clone)]
pub struct AdapterReport {
    /// Name, kind, driver and backend.
    pub info: AdapterInfo,
    /// Can passes be timed?
    pub timestamps: bool,
    /// Does WGSL have f64 there?
    pub f64: bool,
    /// What programs and passes have to know of it.
    pub profile: DeviceProfile,
    /// The largest side of a texture.
    pub texture_side: u32,
    /// The largest storage buffer, in bytes.
    pub storage_buffer: u64,
    /// Storage textures that one pass may bind.
    pub storage_textures: u32,
}

fn instance() -> Instance {
    // wgpu would validate every indirect dispatch by a pass of its own, which doubles the cost of a small one; our shaders
    // clamp their own counts.
    let flags = InstanceFlags::empty().with_env();
    let backends = Backends::VULKAN | Backends::METAL | Backends::DX12;
    Instance::new(InstanceDescriptor { flags, backends, ..InstanceDescriptor::new_without_display_handle() })
}

/// What the machine has, best first: discrete GPUs, integrated ones, virtual ones, CPUs.
fn found() -> Vec<Adapter> {
    let mut all = quietly(|| pollster::block_on(instance().enumerate_adapters(Backends::all())));
    all.sort_by_key(|adapter| match adapter.get_info().device_type {
        DeviceType::DiscreteGpu => 0,
        DeviceType::IntegratedGpu => 1,
        DeviceType::VirtualGpu => 2,
        DeviceType::Other => 3,
        DeviceType::Cpu => 4,
    });
    all
}

/// What is known of a device by what it is. Any processor is taken to run programs as Mesa does.
fn profile(device: &AdapterInfo) -> DeviceProfile {
    if device.device_type == DeviceType::Cpu {
        DeviceProfile::cpu(device.subgroup_max_size)
    } else {
        DeviceProfile::GPU
    }
}

/// Every adapter and what it can do, in the order in which they would be chosen.
#[must_use]
pub fn adapters() -> Vec<AdapterReport> {
    let report = |adapter: &Adapter| {
        let (features, limits) = (adapter.features(), adapter.limits());
        AdapterReport {
            profile: profile(&adapter.get_info()),
            info: adapter.get_info(),
            timestamps: features.contains(Features::TIMESTAMP_QUERY),
            f64: features.contains(Features::SHADER_F64),
            texture_side: limits.max_texture_dimension_2d,
            storage_buffer: limits.max_storage_buffer_binding_size,
            storage_textures: limits.max_storage_textures_per_shader_stage,
        }
    };
    found().iter().map(report).collect()
}

/// Returns `true` if a device's name contains `name` (in any case), or if there is no `name`.
pub(super) fn is_called(device: &AdapterInfo, name: Option<&str>) -> bool {
    name.is_none_or(|name| device.name.to_lowercase().contains(&name.to_lowercase()))
}

impl Gpu {
    /// The device, with the driver and its version: on another one bits may differ.
    #[must_use]
    pub fn words(&self) -> String {
        let AdapterInfo { name, device_type, backend, driver, driver_info, .. } = &self.info;
        format!("{name} ({device_type:?}, {backend}), {driver} {driver_info}")
    }

    /// The best device, or the first whose name contains `name` (in any case).
    pub fn open(name: Option<&str>) -> Result<Self, GpuError> {
        let all = found();
        let adapter = all.iter().find(|adapter| is_called(&adapter.get_info(), name)).ok_or_else(|| match name {
            Some(wanted) if !all.is_empty() => GpuError::NoSuchDevice {
                wanted: wanted.to_owned(),
                there: all.iter().map(|adapter| adapter.get_info().name).collect(),
            },
            _ => GpuError::NoDevice,
        })?;
        let info = adapter.get_info();
        let limits = adapter.limits();
        let features = adapter.features() & (Features::TIMESTAMP_QUERY | Features::SHADER_F64);
        let descriptor = DeviceDescriptor {
            label: Some("bentray"),
            required_features: features,
            required_limits: limits.clone(),
            ..DeviceDescriptor::default()
        };
        let (device, queue) = pollster::block_on(adapter.request_device(&descriptor))
            .map_err(|error| GpuError::Refused { device: info.name.clone(), reason: error.to_string() })?;
        let timestamps = features.contains(Features::TIMESTAMP_QUERY);
        let f64 = features.contains(Features::SHADER_F64);
        let profile = profile(&info);
        let number = |name| constant("state/active", name) as u32;
        let across = profile.group_width.unwrap_or(number(GROUP_WIDTH));
        let group = [across, number("GROUP") / across];
        let (progress, compiled) = (Progress::default(), Compiled::default());
        Ok(Self { device, queue, info, limits, timestamps, f64, group, profile, progress, compiled })
    }

    /// Returns the device with all work on it reported to `progress`.
    #[must_use]
    pub fn reporting(self, progress: Progress) -> Self {
        Self { progress, ..self }
    }

    /// An error if `needed` is more than the device allows.
    pub fn check(&self, limit: &'static str, what: &str, allowed: u64, needed: u64) -> Result<(), GpuError> {
        if needed <= allowed {
            return Ok(());
        }
        Err(GpuError::Limit { device: self.info.name.clone(), limit, what: what.to_owned(), allowed, needed })
    }
}
