//! Caches compiled passes for later programs that contain them.

use std::collections::VecDeque;
use std::sync::{Mutex, PoisonError};

use wgpu::{BindGroupLayout, ComputePipeline};

use crate::program::Binding;

/// The division of an image's pixels among workgroups and their invocations.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Division {
    /// The size of a workgroup in pixels, across and down.
    pub group: [u32; 2],
    /// The number of pixels that one invocation of the pass `whole` follows.
    pub lane_pixels: u32,
}

/// A pass that can be dispatched.
#[derive(Debug, Clone)]
pub struct Pipeline {
    /// wgpu's pipeline.
    pub pipeline: ComputePipeline,
    /// The layout of its only group.
    pub layout: BindGroupLayout,
    /// The bindings of the pass, in order of their numbers.
    pub bindings: Vec<Binding>,
}

/// The number of passes in the cache, which suffices for a few programs.
const KEPT: usize = 16;

/// The most recently compiled passes, by their WGSL.
#[derive(Debug, Default)]
pub(super) struct Compiled(Mutex<VecDeque<(String, Division, Pipeline)>>);

impl Compiled {
    /// Returns the pass with this WGSL and division of pixels, if it is cached. A trial method shares most passes with the
    /// image's program.
    pub(super) fn find(&self, source: &str, division: Division) -> Option<Pipeline> {
        let compiled = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let mut compiled = compiled.iter();
        compiled.find(|(kept, of, _)| kept == source && *of == division).map(|(.., pipeline)| pipeline.clone())
    }

    /// Adds a pass to the cache and removes the oldest one.
    pub(super) fn keep(&self, source: &str, division: Division, pipeline: &Pipeline) {
        let mut compiled = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        compiled.truncate(KEPT - 1);
        compiled.push_front((source.to_owned(), division, pipeline.clone()));
    }
}
