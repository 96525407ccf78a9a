//! Bentray renders scenes in which light follows curves: around black holes, through force fields, lenses and air of varying refractive
//! index, along the flow of a chaotic system, or by a custom law.
//!
//! *Usage.* Read the manual: `make manual` builds it as a web site, and `bentray help PAGE` prints each page of `manual/pages`.
//!
//! *Theory.* Weiskopf, Schafhitzel and Ertl, *GPU-based nonlinear ray tracing* (2004): a camera sets up the rays; they are integrated step
//! by step, intersected with the scene segment by segment, terminated early, and shaded once. All stages run on the GPU and keep the state
//! in pairs of textures. Formulas cite this paper as W04, Gröller, *Nonlinear ray tracing* (1995), as G95, and as T the thesis by A. A. A.
//! Al-Houni on transparent materials with varying properties, which README.md describes.
//!
//! *Differences from W04.* A segment is one accepted step, represented as a cubic arc (the chord of N steps of W04 is an option). The end
//! of a ray is found by retaking the last step to the surface. Several segments with all their stages run in one pass. Meshes have a
//! bounding volume hierarchy. The program is linked only from the modules that a scene uses.
//!
//! *Practice.* Each module imports only modules that precede it in this list:
//!
//! 1. [`progress`]: the progress of long tasks; [`document`]: TOML as written, with the location of every value;
//! 2. [`assets`]: meshes, images, profiles, grids and formulas;
//! 3. [`model`]: each kind of law, medium, material, shape, camera, falloff, method and control;
//! 4. [`scene`]: a scene as plain values, read from a file or built in code;
//! 5. [`program`]: translates scene values to WGSL, which it links, validates and reflects;
//! 6. [`gpu`]: a device and its buffers, textures and pipelines;
//! 7. [`render`]: passes as data, and the loop that runs them;
//! 8. [`measure`]: the error of a render, and the search for the fastest method that is accurate enough;
//! 9. [`output`], [`chart`], [`bench`](mod@bench): files, charts of speed against accuracy, and the measurements of the sources;
//! 10. [`cli`]: the `bentray` command.
//!
//! ```no_run
//! use bentray::{gpu::Gpu, render::{Renderer, RenderSettings}, scene::Scene};
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let scene = Scene::load("scenes/black_hole.toml".as_ref(), &[])?;
//! let gpu = Gpu::open(None)?;
//! let picture = Renderer::new(&gpu, &scene, RenderSettings::default())?.render()?;
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
