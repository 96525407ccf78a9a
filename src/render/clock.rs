//! Times passes on the device.
//!
//! *Idea.* The time of a pass is measured from the end of the previous pass to its own end; an empty pass precedes the first one of a
//! submission. Beginnings are written but not read: Mesa's software driver takes a timestamp only when a flush follows, which need not
//! happen between the beginning of a pass and its first dispatch, whose time was then lost. The next beginning, or the end of the
//! submission, flushes an end. Another thread of the driver then takes it, which on a busy core is late by up to the time of the next pass.
//! A copy of the timestamp waits for it, so on a CPU each timestamp is copied after its pass.

use std::time::Duration;

use wgpu::{
    Buffer, BufferDescriptor, BufferUsages, CommandEncoder, ComputePassTimestampWrites, DeviceType, QuerySet,
    QuerySetDescriptor, QueryType,
};

use super::readback::read_buffer;
use crate::gpu::{Gpu, GpuError};
use crate::program::Pass;

/// The stages that are timed separately.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Stage {
    /// No stage: the pass whose end the first pass of a submission is timed from.
    Start,
    Setup,
    Advance,
    Intersect,
    Scatter,
    Shade,
}

impl Stage {
    /// Returns the stage to time. Later rounds are timed as one, because timing a pass may cost more than the pass.
    pub(super) fn of(pass: Pass, round: u32, apart: bool) -> Self {
        match pass {
            _ if round > 0 => Self::Advance,
            Pass::Setup => Self::Setup,
            Pass::Intersect if apart => Self::Intersect,
            Pass::Scatter if apart => Self::Scatter,
            Pass::Shade
            | Pass::Reshade
            | Pass::Record
            | Pass::Refine
            | Pass::MeasureBundles
            | Pass::FindStars
            | Pass::LightStars
            | Pass::GatherStars => Self::Shade,
            _ => Self::Advance,
        }
    }
}

/// Timestamp queries for any number of passes, in sets of the largest size that wgpu allows.
#[derive(Debug)]
pub(super) struct Clock {
    sets: Vec<QuerySet>,
    stages: Vec<Stage>,
    enabled: bool,
    /// The buffer that timestamps are copied to, if the device must wait for them.
    awaited: Option<Buffer>,
    /// `true` if intersecting and scattering are timed separately from advancing.
    pub(super) apart: bool,
}

const QUERIES: u32 = wgpu::QUERY_SET_MAX_QUERIES;

impl Clock {
    pub(super) fn new(gpu: &Gpu, apart: bool) -> Self {
        let waits = gpu.timestamps && gpu.info.device_type == DeviceType::Cpu;
        let awaited = waits.then(|| {
            let (label, usage) = (Some("timestamp"), BufferUsages::QUERY_RESOLVE);
            gpu.device.create_buffer(&BufferDescriptor { label, size: 8, usage, mapped_at_creation: false })
        });
        Self { sets: Vec::new(), stages: Vec::new(), enabled: gpu.timestamps, awaited, apart }
    }

    /// Returns the queries to which the next pass of this stage writes its times.
    pub(super) fn next(&mut self, gpu: &Gpu, stage: Stage) -> Option<ComputePassTimestampWrites<'_>> {
        if !self.enabled {
            return None;
        }
        let index = 2 * self.stages.len() as u32 % QUERIES;
        if index == 0 {
            let descriptor = QuerySetDescriptor { label: None, ty: QueryType::Timestamp, count: QUERIES };
            let set = gpu.device.create_query_set(&descriptor);
            self.sets.push(set);
        }
        self.stages.push(stage);
        Some(ComputePassTimestampWrites {
            query_set: self.sets.last()?,
            beginning_of_pass_write_index: Some(index),
            end_of_pass_write_index: Some(index + 1),
        })
    }

    /// Waits for the end of the most recently recorded pass, if the device requires it.
    pub(super) fn settle(&self, encoder: &mut CommandEncoder) {
        if let (Some(set), Some(buffer)) = (self.sets.last(), &self.awaited) {
            let last = 2 * (self.stages.len() as u32 - 1) % QUERIES + 1;
            encoder.resolve_query_set(set, last..last + 1, buffer, 0);
        }
    }

    /// Returns the time of each stage, once all passes are done.
    pub(super) fn read(&self, gpu: &Gpu) -> Result<Option<[Duration; 5]>, GpuError> {
        if !self.enabled {
            return Ok(None);
        }
        let mut ends = Vec::with_capacity(self.stages.len());
        for (set, stages) in self.sets.iter().zip(self.stages.chunks(QUERIES as usize / 2)) {
            let count = 2 * stages.len() as u32;
            let buffer = gpu.device.create_buffer(&BufferDescriptor {
                label: Some("timestamps"),
                size: u64::from(8 * count),
                usage: BufferUsages::QUERY_RESOLVE | BufferUsages::COPY_SRC,
                mapped_at_creation: false,
            });
            let resolve = |encoder: &mut CommandEncoder| encoder.resolve_query_set(set, 0..count, &buffer, 0);
            let bytes = read_buffer(gpu, &buffer, resolve)?;
            let times: Vec<u64> = bytemuck::pod_collect_to_vec(&bytes);
            ends.extend(times.chunks_exact(2).map(|pair| pair[1]));
        }
        let mut sums = [0.0_f64; 6];
        for (ends, stage) in ends.windows(2).zip(self.stages.iter().skip(1)) {
            let ticks = ends[1].saturating_sub(ends[0]) as f64;
            sums[*stage as usize] += ticks * f64::from(gpu.queue.get_timestamp_period()) * 1e-9;
        }
        let [_, stages @ ..] = sums.map(Duration::from_secs_f64);
        Ok(Some(stages))
    }
}
