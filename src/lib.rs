//! Bentray renders scenes in which light does not travel straight: round black holes, in fields of force, through air whose
//! index varies, along the flow of a chaotic system.
//!
//! *Theory.* Weiskopf, Schafhitzel and Ertl, *GPU-based nonlinear ray tracing* (2004): rays set up by a camera, integrated
//! step by step, tested against the scene segment by segment, ended early, shaded once; all on the GPU, the state ping-ponging
//! between textures. Formulas cite it as W04, and Gröller's *Nonlinear ray tracing* (1995) as G95.
//!
//! *Changes from the paper.* A segment is one accepted step as a cubic arc (the paper's chord of N steps is an option); ends
//! come from retaking the last step to the surface; several segments with all their stages run in one pass; meshes have a
//! hierarchy; and the program is linked from the parts that a scene uses, so that nothing else is in it.
//!
//! *Practice.* Modules import one way, each from those before it:
//!
//! 1. [`scene`]: TOML files to plain values;
//! 2. [`program`]: values to WGSL, linked, validated and reflected;
//! 3. [`gpu`]: a device, and what lies on it;
//! 4. [`render`]: passes as data, and the loop that runs them;
//! 5. [`measure`]: how right a render is, and which method makes it so in the least time;
//! 6. [`output`], [`chart`], [`bench`](mod@bench): files, speed against accuracy, and the sources' own measurements;
//! 7. [`cli`]: the `bentray` command.
//!
//! ```no_run
//! use bentray::{gpu::Gpu, render::{Renderer, RenderSettings}, scene::Scene};
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let scene = Scene::load("scenes/black_hole.toml".as_ref(), &[])?;
//! let gpu = Gpu::open(None)?;
//! let picture = Renderer::new(&gpu, &scene, RenderSettings::default())?.picture()?;
//! println!("{}", picture.totals);
//! # Ok(())
//! # }
//! ```

pub mod assets;
pub mod bench;
pub mod chart;
pub mod cli;
pub mod document;
pub mod error;
pub mod gpu;
pub mod measure;
pub mod model;
pub mod output;
pub mod program;
pub mod render;
pub mod scene;
