//! Timing passes on the device.

use std::time::Duration;

use wgpu::{
    BufferDescriptor, BufferUsages, CommandEncoder, ComputePassTimestampWrites, QuerySet, QuerySetDescriptor, QueryType,
};

use super::readback::read_buffer;
use crate::gpu::{Gpu, GpuError};

/// The stages that are timed apart.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Stage {
    Setup,
    Advance,
    Scatter,
    Shade,
}

/// Timestamp queries in sets of as many as wgpu allows, for any number of passes.
#[derive(Debug)]
pub(super) struct Clock {
    sets: Vec<QuerySet>,
    stages: Vec<Stage>,
    enabled: bool,
    /// Is scattering timed apart from advancing? That takes a pass of the encoder for each round, which costs more than the round
    /// where nothing lives.
    pub(super) fine: bool,
}

const QUERIES: u32 = wgpu::QUERY_SET_MAX_QUERIES;

impl Clock {
    pub(super) fn new(gpu: &Gpu) -> Self {
        Self { sets: Vec::new(), stages: Vec::new(), enabled: gpu.timestamps, fine: false }
    }

    /// For measurements.
    pub(super) fn fine(gpu: &Gpu) -> Self {
        Self { fine: true, ..Self::new(gpu) }
    }

    /// Where the next pass of this stage writes its times.
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

    /// Seconds by stage, once all passes are done.
    pub(super) fn read(&self, gpu: &Gpu) -> Result<Option<[Duration; 4]>, GpuError> {
        if !self.enabled {
            return Ok(None);
        }
        let mut sums = [0.0_f64; 4];
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
            for (pair, stage) in times.chunks_exact(2).zip(stages) {
                let ticks = pair[1].saturating_sub(pair[0]) as f64;
                sums[*stage as usize] += ticks * f64::from(gpu.queue.get_timestamp_period()) * 1e-9;
            }
        }
        Ok(Some(sums.map(Duration::from_secs_f64)))
    }
}
