//! Gröller's comparison (G95 §4): the growth of intersection time with the number of triangles, for a hierarchy, a grid, and no structure.
//!
//! *Practice.* All sizes use one mesh: for fewer triangles it is coarsened by merging the vertices in each cell of a grid, for more its
//! triangles are subdivided. It therefore covers an equal part of the image, and only the search grows. Intersection is timed separately,
//! in dedicated passes.

use std::collections::BTreeMap;
use std::sync::Arc;
use std::time::Instant;

use glam::{IVec3, Vec2, Vec3};

use super::{Bench, Cell, Report, Table, Times, own_scene};
use crate::gpu::Geometry;
use crate::model::shape::Triangles;
use crate::output::plot::{Chart, Series};
use crate::program::{ProgramOptions, Schedule};
use crate::render::{RenderError, RenderSettings, Renderer};
use crate::scene::{Accelerate, Mesh, Scene, Vertex};

const COUNTS: [usize; 6] = [10, 100, 1_000, 10_000, 100_000, 1_000_000];
/// The largest number of triangles without an acceleration structure.
const MOST_UNSTRUCTURED: usize = 10_000;
const STRUCTURES: [(&str, Accelerate); 3] =
    [("bvh", Accelerate::Hierarchy), ("grid", Accelerate::Grid), ("none", Accelerate::None)];
/// The laws, with the divisor of the viewport's width and height in renders with a structure.
const LAWS: [(&str, &str, u32); 2] = [
    ("straight", "[law]\nkind = \"straight\"\n[rays]\nmax_segments = 2\n", 1),
    (
        "Schwarzschild",
        "[law]\nkind = \"schwarzschild\"\ncenter = [0, 0, -12]\n[rays]\nmethod = \"rk4\"\nmax_segments = 100\n",
        4,
    ),
];

/// Measures times by law, number of triangles and structure, for this mesh.
///
/// # Errors
///
/// Returns [`RenderError::NoTimes`] if the device cannot time passes, or another error if it fails.
pub fn groller(bench: &Bench, mesh: &Mesh) -> Result<Report, RenderError> {
    let header = "law | triangles | structure | intersect (s) | spread | ns per segment | build (s)";
    let mut times = Table::new("times", "Intersection only", header);
    let growth = "Intersection time with the most triangles, relative to a thousand triangles";
    let mut growth = Table::new("growth", growth, "law | structure | triangles | relative time");
    let mut plots = Vec::new();
    for ((law, keys, part), plot) in LAWS.into_iter().zip(["straight", "schwarzschild"]) {
        let mut series: BTreeMap<&str, Vec<[f64; 2]>> = BTreeMap::new();
        for wanted in COUNTS {
            let mesh = Arc::new(with_triangles(mesh, wanted));
            let count = mesh.triangles.len();
            for (name, accelerate) in STRUCTURES {
                if accelerate == Accelerate::None && wanted > MOST_UNSTRUCTURED {
                    continue;
                }
                let part = if accelerate == Accelerate::None { 32 } else { part };
                let size = bench.size.map(|side| (side / part).max(8));
                let scene = scene(size, keys, &mesh, accelerate)?;
                let found = measured(bench, &scene)?;
                series.entry(name).or_default().push([count as f64, found.each * 1e9]);
                let numbers = [found.times.median, found.times.spread, found.each * 1e9, found.build].map(Cell::from);
                times.rows.push([law.into(), (count as u32).into(), name.into()].into_iter().chain(numbers).collect());
            }
        }
        for (name, points) in &series {
            let thousand = points.iter().min_by(|a, b| away(a[0]).total_cmp(&away(b[0])));
            if let (Some(first), Some(last)) = (thousand, points.last()) {
                growth.row(&[law, name], [last[0], last[1] / first[1]]);
            }
        }
        let series = series.into_iter().map(|(name, points)| Series::new(name, points)).collect();
        let title = format!("Intersection only, {law}");
        plots.push((plot, Chart::logarithmic(title, ["triangles", "nanoseconds per segment"], series)));
    }
    let (curves, curves_chart) = super::curves::curves(bench)?;
    plots.push(("curves", curves_chart));
    let intro = "One mesh, simplified and subdivided, with the segment schedule. In Schwarzschild spacetime, the \
                 image has a quarter of the width and height; without an acceleration structure, a 32nd. Images with \
                 rays along helices have a quarter, too.";
    Ok(Report {
        name: "groller",
        title: "Acceleration structures".to_owned(),
        intro: vec![intro.to_owned()],
        tables: vec![growth, times, curves],
        plots,
    })
}

/// Returns the distance of a number of triangles from a thousand.
fn away(count: f64) -> f64 {
    (count / 1e3).ln().abs()
}

struct Measured {
    times: Times,
    /// The time per segment in seconds.
    each: f64,
    /// The time in seconds in which the host builds the structure.
    build: f64,
}

fn measured(bench: &Bench, scene: &Scene) -> Result<Measured, RenderError> {
    let started = Instant::now();
    drop(Geometry::new(scene));
    let build = started.elapsed().as_secs_f64();
    let options = ProgramOptions { schedule: Schedule::Segment, ..ProgramOptions::default() };
    let mut renderer =
        Renderer::new(bench.gpu, scene, RenderSettings { options, apart: true, ..RenderSettings::default() })?;
    let mut segments = 0;
    let slow = scene.rays.acceleration == Accelerate::None;
    let times = Times::of(if slow { 1 } else { bench.repeats }, || {
        let totals = renderer.render()?.totals;
        segments = totals.segments;
        totals.intersect().ok_or(RenderError::NoTimes)
    })?;
    Ok(Measured { times, each: times.median / segments as f64, build })
}

fn scene(
    [width, height]: [u32; 2],
    keys: &str,
    mesh: &Arc<Mesh>,
    accelerate: Accelerate,
) -> Result<Scene, RenderError> {
    let text = format!(
        "[image]\nsize = [{width}, {height}]\n[camera]\nposition = [0, 0, 14]\n{keys}bounding_sphere = {{ radius = 30 }}\n\
         [materials.m]\ndiffuse = [0.8, 0.6, 0.4]\n[[lights]]\nkind = \"point\"\nposition = [10, 10, 20]\n\
         [[objects]]\nshape = \"sphere\"\nradius = 4\nmaterial = \"m\"\n"
    );
    let mut scene = own_scene(&text)?;
    scene.objects[0].shape = Arc::new(Triangles(mesh.clone()));
    scene.rays.acceleration = accelerate;
    Ok(scene)
}

/// Returns about `wanted` triangles in the form of the mesh, in the unit sphere.
fn with_triangles(mesh: &Mesh, wanted: usize) -> Mesh {
    let (lo, hi) = mesh.vertices.iter().fold((Vec3::INFINITY, Vec3::NEG_INFINITY), |(lo, hi), vertex| {
        (lo.min(vertex.position), hi.max(vertex.position))
    });
    let (middle, radius) = (0.5 * (lo + hi), 0.5 * (hi - lo).length());
    let placed = |vertex: &Vertex| Vertex { position: (vertex.position - middle) / radius, ..*vertex };
    let own = Mesh::new(mesh.vertices.iter().map(placed).collect(), mesh.triangles.clone());
    let parts = (wanted as f64 / own.triangles.len() as f64).sqrt().ceil().max(1.0) as usize;
    cut_up(&coarsened(&own, wanted / (parts * parts)), parts)
}

/// Returns at most `most` triangles, but at least a dozen, by merging the vertices in each cell of the finest sufficient grid.
fn coarsened(mesh: &Mesh, most: usize) -> Mesh {
    if mesh.triangles.len() <= most {
        return mesh.clone();
    }
    let (mut few, mut many) = (1, 1024);
    while many - few > 1 {
        let middle = usize::midpoint(few, many);
        if merged(mesh, middle).triangles.len() <= most { few = middle } else { many = middle }
    }
    merged(mesh, few)
}

/// Merges vertices to one per cell, with `cells` along the radius of the unit sphere.
fn merged(mesh: &Mesh, cells: usize) -> Mesh {
    let mut of_cell = BTreeMap::new();
    let mut sums: Vec<(Vec3, Vec3, f32)> = Vec::new();
    let mut place = Vec::new();
    for vertex in &mesh.vertices {
        let cell: IVec3 = (vertex.position * cells as f32).floor().as_ivec3();
        let index = *of_cell.entry(cell.to_array()).or_insert(sums.len());
        if index == sums.len() {
            sums.push((Vec3::ZERO, Vec3::ZERO, 0.0));
        }
        let sum = &mut sums[index];
        *sum = (sum.0 + vertex.position, sum.1 + vertex.normal, sum.2 + 1.0);
        place.push(index as u32);
    }
    let vertex = |(x, n, count): &(Vec3, Vec3, f32)| Vertex {
        position: x / count,
        normal: n.normalize_or(Vec3::Y),
        uv: Vec2::ZERO,
    };
    let triangles = mesh.triangles.iter().map(|corners| corners.map(|i| place[i as usize]));
    let triangles = triangles.filter(|[a, b, c]| a != b && b != c && c != a);
    Mesh::new(sums.iter().map(vertex).collect(), triangles.collect())
}

/// Subdivides every triangle into n² similar ones.
fn cut_up(mesh: &Mesh, n: usize) -> Mesh {
    let (mut vertices, mut triangles) = (Vec::new(), Vec::new());
    for corners in &mesh.triangles {
        let corner = corners.map(|i| mesh.vertices[i as usize]);
        let first = vertices.len();
        // Row i has n + 1 − i vertices.
        let at = |i: usize, j: usize| (first + i * (2 * n + 3 - i) / 2 + j) as u32;
        for i in 0..=n {
            for j in 0..=n - i {
                let weights = [n - i - j, i, j].map(|k| k as f32 / n as f32);
                let mix =
                    |of: fn(&Vertex) -> Vec3| -> Vec3 { corner.iter().zip(weights).map(|(v, w)| w * of(v)).sum() };
                vertices.push(Vertex {
                    position: mix(|vertex| vertex.position),
                    normal: mix(|vertex| vertex.normal).normalize_or(Vec3::Y),
                    uv: Vec2::ZERO,
                });
                if i + j < n {
                    triangles.push([at(i, j), at(i + 1, j), at(i, j + 1)]);
                }
                if i + j + 1 < n {
                    triangles.push([at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]);
                }
            }
        }
    }
    Mesh::new(vertices, triangles)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns an octahedron around the origin, in 2592 triangles.
    fn octahedron() -> Mesh {
        let corners = [Vec3::X, Vec3::Y, Vec3::Z, Vec3::NEG_X, Vec3::NEG_Y, Vec3::NEG_Z];
        let vertex = |position: Vec3| Vertex { position, normal: position, uv: Vec2::ZERO };
        let triangles = vec![[0, 1, 2], [1, 3, 2], [3, 4, 2], [4, 0, 2], [1, 0, 5], [3, 1, 5], [4, 3, 5], [0, 4, 5]];
        cut_up(&Mesh::new(corners.map(vertex).to_vec(), triangles), 18)
    }

    fn area(mesh: &Mesh) -> f32 {
        let corner = |i: u32| mesh.vertices[i as usize].position;
        let twice = |&[a, b, c]: &[u32; 3]| (corner(b) - corner(a)).cross(corner(c) - corner(a)).length();
        0.5 * mesh.triangles.iter().map(twice).sum::<f32>()
    }

    #[test]
    fn a_mesh_keeps_its_form_at_every_size() {
        let mesh = octahedron();
        let exact = area(&with_triangles(&mesh, mesh.triangles.len()));
        let mut last = 0;
        for wanted in COUNTS {
            let made = with_triangles(&mesh, wanted.min(100_000));
            let count = made.triangles.len();
            assert!(
                count <= wanted.max(12) && count > wanted.min(100_000) / 4 && count >= last,
                "{count} for {wanted}"
            );
            if wanted >= 1000 {
                assert!((area(&made) / exact - 1.0).abs() < 0.15, "{wanted}: {}", area(&made) / exact);
            }
            assert!(made.triangles.iter().flatten().all(|&i| (i as usize) < made.vertices.len()));
            last = count;
        }
    }
}
