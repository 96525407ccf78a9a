//! G95 Table 2 for one scene: rays along a curve, as a tree of boxes or in steps, against an object hierarchy, a grid or no structure.
//!
//! *Practice.* Helices cross boxes in a cube; more boxes are smaller, so that they fill an equal volume. Steps are chords as in G95, with a
//! length that keeps them as close to the curve as the pieces of the tree. The whole image is timed.

use std::fmt::Write as _;

use super::times::device_time;
use super::{Bench, Table, Times, own_scene};
use crate::output::plot::{Chart, Series};
use crate::render::{RenderError, RenderSettings, Renderer};
use crate::scene::Scene;

const COUNTS: [u32; 5] = [10, 100, 1_000, 10_000, 100_000];
/// The largest number of boxes without an acceleration structure.
const MOST_UNSTRUCTURED: u32 = 1_000;
/// The largest distance of chords from the curve, in scene units.
const OFF: f64 = 1e-4;

/// An intersection method: the name in G95 or an addition, its keys, and whether it has a structure.
struct Way {
    name: &'static str,
    keys: String,
    structured: bool,
}

fn ways() -> [Way; 6] {
    // The second derivative of the helix is 4: a chord over h has a distance of h²/2.
    let step = (2.0 * OFF).sqrt();
    let steps =
        format!("method = \"rk4\"\nstep = {step}\nsegment = \"chord\"\nsteps_per_segment = 1\nscaled_step = 1e3\n");
    let tree = format!("arc_tolerance = {OFF}\n");
    let way = |name, structure: &str, keys: &str| Way {
        name,
        keys: format!("acceleration = \"{structure}\"\n{keys}"),
        structured: structure != "none",
    };
    [
        way("bvh/hier", "bvh", &tree),
        way("sub/hier", "grid", &tree),
        way("none/hier", "none", &tree),
        way("bvh/iter", "bvh", &steps),
        way("sub/iter", "grid", &steps),
        way("none/iter", "none", &steps),
    ]
}

/// Returns the times by number of boxes and method, and relative to bvh/hier, with a chart.
pub(super) fn curves(bench: &Bench) -> Result<(Table, Chart), RenderError> {
    let header = "boxes | rays / objects | device (s) | spread | microseconds per ray | relative to bvh/hier";
    let mut table = Table::new("curves", "Rays along helices", header);
    let mut series: Vec<Series> = Vec::new();
    let size = bench.size.map(|side| (side / 4).max(8));
    let rays = f64::from(size[0]) * f64::from(size[1]);
    for count in COUNTS {
        let used: Vec<Way> = ways().into_iter().filter(|way| way.structured || count <= MOST_UNSTRUCTURED).collect();
        let scenes = used.iter().map(|way| scene(size, count, &way.keys)).collect::<Result<Vec<_>, _>>()?;
        let mut renderers = scenes
            .iter()
            .map(|scene| Renderer::new(bench.gpu, scene, RenderSettings::default()))
            .collect::<Result<Vec<_>, _>>()?;
        let mut runs: Vec<_> =
            renderers.iter_mut().map(|renderer| || Ok(device_time(&renderer.render()?.totals))).collect();
        let times = Times::all_by_turns(bench.repeats, &mut runs)?;
        let first = times[0].median;
        for (way, times) in used.iter().zip(&times) {
            let each = 1e6 * times.median / rays;
            let numbers = [times.median, times.spread, each, times.median / first].map(Into::into);
            table.rows.push([count.into(), way.name.into()].into_iter().chain(numbers).collect());
            Series::extend(&mut series, way.name, [f64::from(count), each]);
        }
    }
    Ok((table, Chart::logarithmic("Rays along helices", ["boxes", "microseconds per ray"], series)))
}

fn scene([width, height]: [u32; 2], count: u32, keys: &str) -> Result<Scene, RenderError> {
    let mut text = format!(
        "[image]\nsize = [{width}, {height}]\n[camera]\nkind = \"orthographic\"\nposition = [0, -6, 0]\nup = [0, 0, 1]\nheight = 8\n\
         [law]\nkind = \"parametric\"\nx = \"cos(2*t)\"\ny = \"t\"\nz = \"sin(2*t)\"\nt = [0, 12]\n\
         [rays]\nbounding_sphere = {{ radius = 15 }}\nmax_segments = 2000\n{keys}\
         [materials.m]\ndiffuse = [0.8, 0.6, 0.4]\n[[lights]]\nkind = \"point\"\nposition = [10, -20, 20]\n"
    );
    // The boxes fill a thirtieth of a cube of side 10, at points of Roberts's R3 sequence.
    let side = 10.0 * (1.0 / (30.0 * f64::from(count))).cbrt();
    for i in 0..count {
        let at =
            [0.819_172_513_396, 0.671_043_606_703, 0.549_700_477_901].map(|r| (f64::from(i) * r).fract() * 10.0 - 5.0);
        // Writing to a String cannot fail.
        let _ = writeln!(
            text,
            "[[objects]]\nshape = \"box\"\ncenter = {at:?}\nsize = [{side}, {side}, {side}]\nmaterial = \"m\""
        );
    }
    own_scene(&text)
}
