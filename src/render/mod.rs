//! The driver: passes as data, recorded and submitted, and one readback at the end.
//!
//! *Theory.* The 2004 paper's Figure 1: ray setup, then for every segment ray integration, ray–object intersection and the test
//! for termination, then local illumination. A [`Step`] is one dispatch of that; a *schedule* cuts the same stages into
//! different passes.
//!
//! *Practice.* All steps of a sample are known before the first runs. Nothing is read back until the tile is complete: indirect
//! dispatch drops the rays that have ended. Submissions are kept short, because drivers kill long ones.
//!
//! `Renderer::new` makes a scene ready for a device; `picture` renders it band by band and tile by tile, `runner` runs the steps of a tile's
//! samples that `schedule` lists, and `values` reads what they came to. `trace` and `light_paths` have rays of their own.

mod adaptive;
mod band;
mod bare;
mod batch;
mod clock;
mod cuts;
mod error;
mod grids;
mod light_grid;
mod light_paths;
mod moments;
mod noise;
mod picture;
mod plan;
mod readback;
mod records;
mod renderer;
mod runner;
mod sample;
mod schedule;
mod segments;
mod settings;
mod small;
mod start;
mod step;
mod tiles;
mod totals;
mod trace;
mod values;
mod watch;
mod window;

pub use band::{Band, Plane, Rendering};
pub use error::RenderError;
pub use grids::{Gridded, LightReport};
pub use light_grid::light_grids;
pub use light_paths::{LightPath, light_paths, shooting};
pub use noise::Noise;
pub use renderer::Renderer;
pub use schedule::{steps, usual_steps};
pub use settings::RenderSettings;
pub use start::{StartPart, StartUp};
pub use step::{Dispatch, PixelList, Step};
pub use totals::{Adaptive, Clamped, Status, Totals};
pub use trace::{PathPoint, Starts, Traced, pixel_starts, trace, trace_paths, trace_pixels};
pub use watch::{Earlier, Preview, Watch};
pub use window::Window;
