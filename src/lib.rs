//! Bentray renders scenes in which light does not travel in straight lines: around black holes, through fields of force, through
//! lenses and air of varying index, along the flow of a chaotic system, or by a law of the user's own.
//!
//! *To use it*, read the [`guide`]: a page for each subject, which `bentray help TOPIC` prints too.
//!
//! *Theory.* Weiskopf, Schafhitzel and Ertl, *GPU-based nonlinear ray tracing* (2004): rays set up by a camera, integrated
//! step by step, tested against the scene segment by segment, ended early, shaded once; all on the GPU, the state ping-ponging
//! between textures. Formulas cite it as W04, Gröller's *Nonlinear ray tracing* (1995) as G95, and as T the thesis of A. A. A.
//! Al-Houni on transparent materials with varying properties, of which README.md says what is known.
//!
//! *Changes from the paper.* A segment is one accepted step as a cubic arc (the paper's chord of N steps is an option); ends
//! come from retaking the last step to the surface; several segments with all their stages run in one pass; meshes have a
//! hierarchy; and the program is linked from the parts that a scene uses, so that nothing else is in it.
//!
//! *Practice.* Modules import one way, each from those before it:
//!
//! 1. [`progress`]: how far long work has come; [`document`]: TOML as written, every value with its place;
//! 2. [`assets`]: meshes, pictures, profiles, grids and formulas;
//! 3. [`model`]: everything known of each kind of law, medium, material, shape, camera, fall-off, method and control;
//! 4. [`scene`]: a scene as plain values, from a file or made in code;
//! 5. [`program`]: values to WGSL, linked, validated and reflected;
//! 6. [`gpu`]: a device, and what lies on it;
//! 7. [`render`]: passes as data, and the loop that runs them;
//! 8. [`measure`]: how right a render is, and which method makes it so in the least time;
//! 9. [`output`], [`chart`], [`bench`](mod@bench): files, speed against accuracy, and the sources' own measurements;
//! 10. [`cli`]: the `bentray` command.
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

#![cfg_attr(not(test), deny(clippy::print_stdout, clippy::print_stderr))]

pub use glam;

pub mod assets;
pub mod bench;
pub mod chart;
pub mod cli;
pub mod document;
pub mod error;
pub mod gpu;
pub mod guide;
pub mod measure;
pub mod model;
pub mod output;
pub mod program;
pub mod progress;
pub mod render;
pub mod scene;
