//! Chooses and opens a device.

use std::sync::atomic::{AtomicU64, Ordering::Relaxed};
use std::sync::{Arc, Mutex};

use wgpu::{
    Adapter, AdapterInfo, Backends, Buffer, CommandEncoder, Device, DeviceDescriptor, DeviceType, Features, Instance,
    InstanceDescriptor, InstanceFlags, Limits, PollType, Queue, SubmissionIndex,
};

use super::GpuError;
use super::compiled::{Compiled, Division};
use super::driver_messages::quietly;
use crate::program::{DeviceProfile, constant};
use crate::progress::Progress;

/// The constants of `shaders/state/active.wgsl` that a device may override.
pub(super) const GROUP_WIDTH: &str = "GROUP_WIDTH";
pub(super) const LANE_PIXELS: &str = "LANE_PIXELS";

/// An open device.
#[derive(Debug)]
pub struct Gpu {
    /// wgpu's device.
    pub device: Device,
    /// Its only queue.
    pub queue: Queue,
    /// The name, kind, driver and backend of the adapter.
    pub info: AdapterInfo,
    /// The limits of the adapter, with which the device is opened; programs are checked against them.
    pub limits: Limits,
    /// `true` if passes can be timed.
    pub timestamps: bool,
    /// `true` if WGSL supports `f64` on this device.
    pub f64: bool,
    /// The width and height of the block of pixels of one workgroup.
    pub group: [u32; 2],
    /// The profile of the device, which programs and passes depend on.
    pub profile: DeviceProfile,
    /// The receiver of progress reports; nobody, unless set by [`Gpu::reporting`].
    pub progress: Progress,
    pub(super) compiled: Compiled,
    /// The numbers of submissions and waits so far.
    traffic: [AtomicU64; 2],
    /// Free buffers that the host can read.
    pub(crate) staging: Arc<Mutex<Vec<Buffer>>>,
}

/// One line of `bentray devices`.
#[derive(Debug, Clone)]
pub struct AdapterReport {
    /// The name, kind, driver and backend.
    pub info: AdapterInfo,
    /// `true` if passes can be timed.
    pub timestamps: bool,
    /// `true` if WGSL supports `f64` on this device.
    pub f64: bool,
    /// The profile of the device, which programs and passes depend on.
    pub profile: DeviceProfile,
    /// The largest side of a texture, in texels.
    pub texture_side: u32,
    /// The size of the largest storage buffer, in bytes.
    pub storage_buffer: u64,
    /// The number of storage textures that one pass may bind.
    pub storage_textures: u32,
}

fn instance() -> Instance {
    // wgpu would validate every indirect dispatch by a separate pass, which doubles the cost of a small dispatch; the shaders clamp the
    // counts themselves.
    let flags = InstanceFlags::empty().with_env();
    let backends = Backends::VULKAN | Backends::METAL | Backends::DX12;
    Instance::new(InstanceDescriptor { flags, backends, ..InstanceDescriptor::new_without_display_handle() })
}

/// Returns all adapters, best first: discrete GPUs, integrated GPUs, virtual GPUs, CPUs.
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

/// Returns the profile of a device. Every CPU is assumed to run programs like Mesa's software driver.
fn profile(device: &AdapterInfo) -> DeviceProfile {
    match device.device_type {
        DeviceType::Cpu => DeviceProfile::cpu(device.subgroup_max_size),
        DeviceType::DiscreteGpu => DeviceProfile::discrete(),
        _ => DeviceProfile::GPU,
    }
}

/// Returns every adapter with its capabilities, in order of preference.
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
    /// Returns the default division of pixels on this device.
    #[must_use]
    pub fn division(&self) -> Division {
        Division { group: self.group, lane_pixels: self.profile.lane_pixels }
    }

    /// Returns the name of the device with its driver and version; on another device results may differ in their last bits.
    #[must_use]
    pub fn words(&self) -> String {
        let AdapterInfo { name, device_type, backend, driver, driver_info, .. } = &self.info;
        format!("{name} ({device_type:?}, {backend}), {driver} {driver_info}")
    }

    /// Opens the best device, or the first one whose name contains `name` (in any case). Discrete GPUs come first, then integrated GPUs,
    /// virtual GPUs and CPUs.
    ///
    /// # Errors
    ///
    /// Returns [`GpuError::NoDevice`] if there is no device, [`GpuError::NoSuchDevice`] if none has this name, and [`GpuError::Refused`] if
    /// the driver cannot open it.
    ///
    /// # Examples
    ///
    /// ```no_run
    /// use bentray::gpu::Gpu;
    ///
    /// let gpu = Gpu::open(Some("llvmpipe"))?;
    /// println!("{}", gpu.words());
    /// # Ok::<(), bentray::gpu::GpuError>(())
    /// ```
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
        let (traffic, staging) = Default::default();
        Ok(Self { device, queue, info, limits, timestamps, f64, group, profile, progress, compiled, traffic, staging })
    }

    /// Returns the device with all work on it reported to `progress`.
    #[must_use]
    pub fn reporting(self, progress: Progress) -> Self {
        Self { progress, ..self }
    }

    /// Submits the recorded commands.
    pub(crate) fn submit(&self, encoder: CommandEncoder) -> SubmissionIndex {
        self.traffic[0].fetch_add(1, Relaxed);
        self.queue.submit([encoder.finish()])
    }

    /// Waits for the end of a submission.
    pub(crate) fn wait(&self, submission: SubmissionIndex) -> Result<(), GpuError> {
        self.traffic[1].fetch_add(1, Relaxed);
        let wait = PollType::Wait { submission_index: Some(submission), timeout: None };
        self.device.poll(wait).map_err(|error| GpuError::Lost(error.to_string()))?;
        if self.progress.is_cancelled() { Err(GpuError::Cancelled) } else { Ok(()) }
    }

    /// Returns the numbers of submissions and of waits for their ends since the device was opened.
    #[must_use]
    pub fn traffic(&self) -> [u64; 2] {
        self.traffic.each_ref().map(|count| count.load(Relaxed))
    }

    /// Returns an error if `needed` is more than the device allows.
    pub(crate) fn check(&self, limit: &'static str, what: &str, allowed: u64, needed: u64) -> Result<(), GpuError> {
        if needed <= allowed {
            return Ok(());
        }
        Err(GpuError::Limit { device: self.info.name.clone(), limit, what: what.to_owned(), allowed, needed })
    }
}
