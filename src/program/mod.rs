//! Translation of a scene to its program: the WGSL modules that it needs, linked into one module per pass, validated and reflected.
//!
//! *Theory.* `shaders/` has one file for each implementation of a contract, and its README lists them. The requirements of a scene
//! are determined once, as [`Features`]. From them follow one file per contract, and constants by which the linker selects between
//! variants that differ in a line; switches between several shapes, materials and falloffs are generated. The program contains nothing
//! that the scene does not use ("model no more than a scene needs"), and a test checks it.
//!
//! *Practice.* [`Program::new`] plans, links and validates in a few milliseconds. Nothing in this module depends on a GPU.

mod analysis;
mod bindings;
mod copies;
mod declarations;
mod error;
mod expressions;
mod features;
mod fold;
mod formula;
mod generated;
mod inline;
mod interface;
mod interval;
mod layer;
mod link;
mod linked;
mod location;
mod loop_counts;
mod lower;
mod matter;
mod matter_bounds;
mod names;
mod onward_parts;
mod options;
mod parts;
mod picture_parts;
mod plan;
mod profile;
mod reflect;
mod region_parts;
mod regions;
mod scopes;
mod selections;
mod shared_surfaces;
mod short_lists;
mod signature;
mod skies;
mod sources;
mod spacetime;
mod structure;
#[cfg(test)]
mod tests;
mod tokens;
mod unit;
mod unroll;
mod user_wgsl;
mod validate;
mod volumes;

pub use analysis::Analysis;
pub use error::ProgramError;
pub use features::{Features, Margin};
pub use options::{Mode, Pass, PathEnds, ProgramOptions, RaySkipping, Schedule};

pub use generated::{all_shots, solid_code, solid_codes};
pub use interface::{Access, Role, SceneValue, Slot, StatePart};
pub use layer::{CROSSINGS, Layer, LayerKind};
pub use link::{link, link_all};
pub use linked::LinkedProgram;
pub use location::Location;
pub use parts::{ShaderModule, all_parts, constant, part};
pub use plan::plan;
pub use profile::{DeviceProfile, LoopBudget};
pub use reflect::{Binding, BindingKind, BlockMember, Field, Layout, Reflection, element_bytes, reflect};
pub use regions::{Motion, Obstacle, Region, RegionKind, Regions};
pub use shared_surfaces::Touching;
pub use structure::{Extent, PARTS, Search, Structure};
pub use unit::{Author, Parts, Unit};
pub use validate::validated;

use crate::scene::Scene;
use reflect::reflect_pass;

/// A scene's passes, linked and reflected, in the order in which they first run.
#[derive(Debug, Clone)]
pub struct Program {
    /// The WGSL and the interface of each pass.
    pub passes: Vec<(Pass, LinkedProgram, Reflection)>,
    /// The modules that the passes are linked from.
    parts: Parts,
    /// The features that the scene requires.
    pub features: Features,
}

impl Program {
    /// Creates the program of `scene` for a choice of schedule and output; `extent` is the size of its acceleration structure.
    ///
    /// # Errors
    ///
    /// Returns [`ProgramError::TooManyItems`] if the scene has too many primitives, or another error if its own WGSL is invalid.
    pub fn new(
        scene: &Scene,
        analysis: &Analysis,
        options: &ProgramOptions,
        extent: Extent,
    ) -> Result<Self, ProgramError> {
        Self::after(None, scene, analysis, options, extent)
    }

    /// Creates a program as [`new`](Self::new) does, and reuses the passes of the previous program `before` if they have the same modules.
    ///
    /// # Errors
    ///
    /// Returns the errors of [`new`](Self::new).
    pub fn after(
        before: Option<&Self>,
        scene: &Scene,
        analysis: &Analysis,
        options: &ProgramOptions,
        extent: Extent,
    ) -> Result<Self, ProgramError> {
        extent.check(&analysis.structure)?;
        let suspends = options.device.loop_budget.is_some() && extent.is_long(scene, &analysis.regions);
        let features = Features { suspends, ..Features::of(scene, options, analysis) };
        let parts = plan(scene, analysis, &features)?;
        let wanted = features.passes();
        let is_same = |other: &&Self| other.parts == parts && other.passes.iter().map(|(pass, ..)| pass).eq(&wanted);
        let passes = match before.filter(is_same) {
            Some(other) => other.passes.clone(),
            None => made(&parts, &wanted)?,
        };
        Ok(Self { passes, parts, features })
    }

    /// Returns the bindings of all passes; a binding of several passes occurs several times.
    pub fn bindings(&self) -> impl Iterator<Item = &Binding> {
        self.passes.iter().flat_map(|(_, _, reflection)| &reflection.bindings)
    }

    /// Returns the layout of the buffer with this role, if a pass binds one.
    #[must_use]
    pub fn layout(&self, role: &Role) -> Option<&Layout> {
        self.bindings().filter(|binding| binding.role == *role).find_map(|binding| match &binding.kind {
            BindingKind::Uniform(layout) | BindingKind::Storage { layout, .. } => Some(layout),
            _ => None,
        })
    }

    /// Returns `true` if the passes of both programs are equal, so that pipelines compiled for one run the other.
    #[must_use]
    pub fn runs_as(&self, other: &Self) -> bool {
        self.passes.len() == other.passes.len()
            && self.passes.iter().zip(&other.passes).all(|(a, b)| a.0 == b.0 && a.1.source == b.1.source)
    }
}

/// Links and reflects the passes.
fn made(parts: &Parts, wanted: &[Pass]) -> Result<Vec<(Pass, LinkedProgram, Reflection)>, ProgramError> {
    let entries: Vec<&str> = wanted.iter().map(|pass| pass.entry()).collect();
    let linked = link_all(parts, &entries)?;
    wanted
        .iter()
        .zip(linked)
        .map(|(&pass, linked)| {
            let reflection = reflect_pass(&linked)?;
            Ok((pass, linked, reflection))
        })
        .collect()
}
