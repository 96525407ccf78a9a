//! The ray diagram: its plane, its frame, and the measurements in it.

use std::path::Path;

use clap::Args;
use glam::DVec3;

use super::beams::Beam;
use super::pairs::{Pairs, numbers, vector};
use crate::error::Error;
use crate::measure::{Curve, Focus, focus, windings};
use crate::model::CharacteristicSurface;
use crate::output::plot::{CrossSection, PathLine, PathPlot, PlotRange, SurfaceKind, plot_paths};
use crate::render::{PathPoint, Status};
use crate::scene::{CutPlane, Scene};

/// Options for the content of a diagram, and for measurements in it
#[derive(Debug, Args)]
pub(super) struct DiagramOptions {
    /// Plane of the diagram: x, y or z (the axis perpendicular to it, through the start of the first ray), z=25, or
    /// "normal=[1,0,1] point=[0,0,0]". By default the plane that contains the paths, else the two axes along which they extend most
    #[arg(long, value_name = "PLANE", value_parser = Cut::parse)]
    cut: Option<Cut>,
    /// Visible part of the plane: "[left, right, bottom, top]" in scene units, objects (their bounding box, enlarged by half) or all
    /// (every path and the bounding sphere). By default objects, if the plane intersects any
    #[arg(long, value_name = "FRAME", value_parser = parse_frame)]
    view: Option<PlotRange>,
    /// Find and mark where the rays of each fan, bundle or file come closest together, and measure how far apart they are there
    #[arg(long)]
    pub focus: bool,
    /// Measure the number of turns of each path about "[x, y, z]", counterclockwise in the diagram, and write it
    #[arg(long, value_name = "POINT", value_parser = vector)]
    pub windings: Option<DVec3>,
    /// Draw the flow's attractor behind the paths: the long-term orbit of the first ray, over TIME
    #[arg(long, value_name = "TIME", num_args = 0..=1, default_missing_value = "100", value_parser = parse_time, requires = "plot")]
    pub attractor: Option<f64>,
}

fn parse_time(text: &str) -> Result<f64, String> {
    let time = text.parse().ok().filter(|time: &f64| (0.0..=1e6).contains(time) && *time > 0.0);
    time.ok_or_else(|| format!("expected a number > 0 and at most 1000000, found `{text}`"))
}

/// The value of `--cut`.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Cut {
    normal: DVec3,
    /// A point of the plane, if one was given.
    point: Option<DVec3>,
}

impl Cut {
    fn parse(text: &str) -> Result<Self, String> {
        let axis = |name: &str| match name.trim() {
            "x" => Some(DVec3::X),
            "y" => Some(DVec3::Y),
            "z" => Some(DVec3::Z),
            _ => None,
        };
        if let Some(normal) = axis(text) {
            return Ok(Self { normal, point: None });
        }
        if let Some((normal, at)) = text.split_once('=').and_then(|(name, at)| Some((axis(name)?, at))) {
            let at = at.trim().parse().ok().filter(|at: &f64| at.abs() <= 1e30);
            let at = at.ok_or_else(|| format!("expected a number, as in `z=2.5`, found `{text}`"))?;
            return Ok(Self { normal, point: Some(normal * at) });
        }
        if !text.contains('=') {
            return Err(format!(
                "expected x, y, z, one of them with a number (z=2.5), or a normal and a point, found `{text}`"
            ));
        }
        let pairs = Pairs::read(text, &["normal", "point"], "normal=[1,0,1] point=[0,0,0]")?;
        let normal = pairs.vector("normal")?;
        if normal == DVec3::ZERO {
            return Err("`normal` is zero, so it has no direction".to_owned());
        }
        let point = pairs.get("point").map(|_| pairs.vector("point")).transpose()?;
        Ok(Self { normal, point })
    }
}

fn parse_frame(text: &str) -> Result<PlotRange, String> {
    match text.trim() {
        "all" => Ok(PlotRange::All),
        "objects" => Ok(PlotRange::Objects),
        _ => match numbers(text) {
            Some(sides @ [left, right, bottom, top]) if left < right && bottom < top => Ok(PlotRange::Given(sides)),
            Some(_) => Err(format!("expected left < right and bottom < top, found `{text}`")),
            None => Err(format!("expected all, objects, or four numbers [left, right, bottom, top], found `{text}`")),
        },
    }
}

/// Rays that belong together: those of a file, a fan or a bundle.
#[derive(Debug)]
pub(super) struct Group {
    /// The name of the group, for messages.
    pub name: String,
    /// The number of rays.
    pub count: usize,
}

/// Traced rays, ready to be drawn.
pub(super) struct Diagram<'a> {
    options: &'a DiagramOptions,
    groups: &'a [Group],
    lines: Vec<PathLine<'static>>,
    plane: CutPlane,
}

impl DiagramOptions {
    /// Returns the plane that the user requested, if any.
    pub fn asked_plane(&self, beams: &[Beam], given: &[[f64; 6]]) -> Option<CutPlane> {
        let cut = self.cut?;
        let first = beams.first().map(Beam::from).or(given.first().map(|&[x, y, z, ..]| DVec3::new(x, y, z)));
        CutPlane::new(cut.point.or(first).unwrap_or_default(), cut.normal)
    }

    /// Creates a diagram of paths, in the requested plane or else in the plane of the paths.
    pub fn of<'a>(
        &'a self,
        asked: Option<CutPlane>,
        groups: &'a [Group],
        paths: &[(Status, Vec<PathPoint>)],
    ) -> Diagram<'a> {
        let line =
            |(status, path): &(Status, Vec<PathPoint>)| PathLine { curve: Curve::of(path), status: status.name() };
        let lines: Vec<PathLine> = paths.iter().map(line).collect();
        let plane = asked.unwrap_or_else(|| plane_of(&lines));
        Diagram { options: self, groups, lines, plane }
    }
}

impl Diagram<'_> {
    /// Measures, prints and draws the requested values.
    pub fn finish(self, scene: &Scene, plot: Option<&Path>, attractor: Option<Curve>) -> Result<(), Error> {
        let foci = if self.options.focus { self.foci() } else { Vec::new() };
        let turns = self.options.windings.map(|about| (about, self.turns(about)));
        let Some(path) = plot else { return Ok(()) };
        let surfaces = surfaces(scene, &self.plane);
        let range = self.options.view.unwrap_or(PlotRange::Objects);
        let bound = Some((scene.rays.bounding_sphere.center, scene.rays.bounding_sphere.radius));
        let plot = PathPlot {
            range,
            surfaces,
            bound,
            foci,
            windings: turns,
            attractor,
            ..PathPlot::new(self.plane, self.lines)
        };
        Ok(plot_paths(path, &plot)?)
    }

    /// Finds the focus of every group, from its rays that passed the scene, and prints it.
    fn foci(&self) -> Vec<Focus> {
        let mut foci = Vec::new();
        let mut rest = &self.lines[..];
        for group in self.groups {
            let (lines, after) = rest.split_at(group.count);
            rest = after;
            let lost = [Status::Captured, Status::Failed, Status::Stalled].map(Status::name);
            let through = lines.iter().filter(|line| !lost.contains(&line.status));
            let curves: Vec<Curve> = through.map(|line| line.curve.clone()).collect();
            let Some(found) = focus(&curves) else {
                tell!(
                    "no focus of {}, because fewer than two rays pass through the scene or all stay parallel",
                    group.name
                );
                continue;
            };
            let [x, y, z] = (found.place + DVec3::ZERO).to_array();
            let how = if found.real { "" } else { " (virtual: the rays are extended as straight lines)" };
            let (count, spread) = (curves.len(), found.spread);
            tell!("focus of {}: [{x:.6}, {y:.6}, {z:.6}], spread {spread:.3e} of {count} rays{how}", group.name);
            foci.push(found);
        }
        foci
    }

    fn turns(&self, about: DVec3) -> Vec<f64> {
        let turns: Vec<f64> = self.lines.iter().map(|line| windings(&line.curve, about, &self.plane)).collect();
        let [x, y, z] = about.to_array();
        tell!("{:>8}{:>18}  about [{x}, {y}, {z}]", "ray", "turns");
        for (i, (turns, line)) in turns.iter().zip(&self.lines).enumerate() {
            tell!("{i:>8}{turns:>18.9}  {}", line.status);
        }
        turns
    }
}

/// Returns the plane of the paths, else the plane of the two axes along which they extend most, through the middle of their starts.
fn plane_of(lines: &[PathLine]) -> CutPlane {
    let points: Vec<DVec3> = lines.iter().flat_map(|line| line.curve.flattened()).collect();
    if let Some(plane) = CutPlane::fit(&points) {
        return plane;
    }
    let (low, high) =
        points.iter().fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(low, high), p| (low.min(*p), high.max(*p)));
    let extent = high - low;
    // If extents are equal, the later axis is dropped.
    let least = (0..3).fold(2, |least, axis| if extent[axis] < extent[least] { axis } else { least });
    let starts = || lines.iter().filter_map(|line| line.curve.0.first()).map(|arc| arc[0]);
    let middle = starts().sum::<DVec3>() / starts().count().max(1) as f64;
    let [right, up] = match least {
        0 => [DVec3::Y, DVec3::Z],
        1 => [DVec3::X, DVec3::Z],
        _ => [DVec3::X, DVec3::Y],
    };
    CutPlane { point: middle, right, up }
}

/// Returns the cross sections of a scene with the plane, filled ones first.
fn surfaces(scene: &Scene, plane: &CutPlane) -> Vec<CrossSection> {
    let objects = scene.objects.iter().map(|object| {
        let kind = if object.interior().is_some() { SurfaceKind::Medium } else { SurfaceKind::Opaque };
        CrossSection { kind, outlines: object.cut(plane) }
    });
    let landmark = |landmark: CharacteristicSurface| {
        let outline = landmark.cut(plane)?;
        let kind = if landmark.captures { SurfaceKind::Capture } else { SurfaceKind::Limit };
        Some(CrossSection { kind: kind(landmark.name), outlines: vec![outline] })
    };
    let landmarks = scene.law.landmarks().into_iter().filter_map(landmark);
    landmarks.chain(objects).filter(|surface| !surface.outlines.is_empty()).collect()
}
