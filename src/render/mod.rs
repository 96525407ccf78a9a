//! Drives a render: records and submits passes, which are data, and reads the result back once at the end.
//!
//! *Theory.* Figure 1 of W04: ray setup; then, for every segment, ray integration, ray–object intersection and the termination test;
//! finally local illumination. A [`Step`] is one dispatch of these stages; a *schedule* divides the same stages into different passes.
//!
//! *Practice.* All steps of a sample are known before the first one runs. The host waits for no value until the tile is complete: indirect
//! dispatch drops terminated rays. Counts of the rays that are left arrive meanwhile, and end the recording of empty passes. Submissions
//! are short, because drivers abort long ones.
//!
//! `Prepared` is a scene with its program and data on a device, `tile` a part of the image on it, and `runner` runs
//! the steps of a tile's samples, which `schedule` lists. Three types use them: [`Renderer`] renders images band by band and tile by tile,
//! and `values` reads the results; [`Tracer`] follows single rays; [`LightTracer`] and `light_grid` follow light from its sources.

mod adaptive;
mod band;
mod batch;
mod clock;
mod crossings;
mod error;
mod grids;
mod lens_map;
mod light_grid;
mod light_paths;
mod live_rays;
mod mapping;
mod moments;
mod noise;
mod paths;
mod picture;
mod plan;
mod prepared;
mod quality;
mod radiation;
mod ray_tiles;
mod readback;
mod records;
mod renderer;
mod row_bands;
mod run;
mod runner;
mod sample;
mod schedule;
mod segments;
mod settings;
mod start;
mod step;
mod steps_only;
mod submission_size;
mod tile;
mod tiling;
mod time_estimate;
mod totals;
mod trace;
mod traced;
mod values;
mod watch;
mod window;

pub use band::{Band, Plane, Rendering};
pub use crossings::{Crossing, Crossings};
pub use error::RenderError;
pub use grids::{GridSource, LightReport};
pub use lens_map::{END_VALUES, EndValue, LensMap, MapRound};
pub use light_grid::light_grids;
pub use light_paths::{LightPath, LightTracer, light_paths};
pub use noise::Noise;
pub use paths::{pixel_starts, trace_paths};
pub use quality::{Adaptive, Clamped, StarImages};
pub use radiation::{FrequencyReport, FrequencyTotals, frequency_reports};
pub use renderer::Renderer;
pub use schedule::{steps, usual_steps};
pub use settings::RenderSettings;
pub use start::{StartPart, StartUp};
pub use step::{Dispatch, PixelList, Step};
pub use totals::{Status, Totals};
pub use trace::{Starts, Tracer, Transferred, trace, trace_pixels};
pub use traced::{PathPoint, Traced};
pub use watch::{EarlierSamples, Preview, Watch};
pub use window::Window;
