//! Compiled passes, kept for programs that have them too.

use std::collections::VecDeque;
use std::sync::{Mutex, PoisonError};

use wgpu::{BindGroupLayout, ComputePipeline};

use crate::program::Binding;

/// A pass that can be dispatched.
#[derive(Debug, Clone)]
pub struct Pipeline {
    /// wgpu's pipeline.
    pub pipeline: ComputePipeline,
    /// The layout of its only group.
    pub layout: BindGroupLayout,
    /// What it binds, in order of number.
    pub bindings: Vec<Binding>,
}

/// How many are kept: those of a few programs.
const KEPT: usize = 16;

/// The passes compiled last, by their WGSL.
#[derive(Debug, Default)]
pub(super) struct Compiled(Mutex<VecDeque<(String, u32, Pipeline)>>);

impl Compiled {
    /// The pass whose WGSL this is, with workgroups of so many pixels across, if it was compiled lately: a method that is tried has most passes of the picture's own program.
    pub(super) fn find(&self, source: &str, across: u32) -> Option<Pipeline> {
        let compiled = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let mut compiled = compiled.iter();
        compiled.find(|(kept, width, _)| kept == source && *width == across).map(|(.., pipeline)| pipeline.clone())
    }

    /// Keeps a pass, in place of the oldest.
    pub(super) fn keep(&self, source: &str, across: u32, pipeline: &Pipeline) {
        let mut compiled = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        compiled.truncate(KEPT - 1);
        compiled.push_front((source.to_owned(), across, pipeline.clone()));
    }
}
