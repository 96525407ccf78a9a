//! The requirements of volumes and of light at given frequencies on a scene.

use glam::{BVec3, DMat3, DVec3};

use crate::document::reader::TableReader;
use crate::model::law::Observer;
use crate::model::volume::Flow;
use crate::model::{Camera, Law, Object, Radiation, Volume};

/// The properties of the scene that affect the light of volumes.
pub struct Rest<'a> {
    pub law: Option<&'a dyn Law>,
    pub camera: Option<&'a Camera>,
    pub objects: &'a [Object],
}

/// Checks volumes, for rays in `chords`, for path tracing `by_paths`, and for `adaptive` sampling.
pub fn check(
    root: &TableReader,
    (volumes, radiation): (&[Volume], Option<&Radiation>),
    rest: &Rest,
    [chords, by_paths, adaptive]: [bool; 3],
) {
    let Some(law) = rest.law.filter(|_| !volumes.is_empty()) else { return };
    if chords {
        root.fault(&["volumes"], "volumes require arcs, and these rays are chords", "use segment = \"arc\"");
    }
    for (i, volume) in volumes.iter().enumerate() {
        check_grids(root, law, (i, volume));
    }
    let has_frequency = !law.facts().momentum_parts.is_empty();
    let has_interiors = rest.objects.iter().any(|object| object.interior().is_some());
    let is_moving = |volume: &Volume| volume.flow != Flow::Observer(Observer::Static);
    if has_interiors && (volumes.iter().any(is_moving) || !law.facts().is_straight) {
        let problem = "with interiors, volumes require matter at rest and straight rays outside";
        root.fault(&["volumes"], problem, "remove the interiors, or use flow = \"static\" and law.kind = \"straight\"");
    }
    if radiation.is_some() {
        check_frequencies(root, rest, [by_paths, adaptive]);
    }
    let sees_no_shift = |camera: &Camera| camera.observer == Observer::Coordinate && !camera.is_parallel();
    if has_frequency
        && !has_interiors
        && rest.camera.is_some_and(sees_no_shift)
        && (radiation.is_some() && !law.facts().is_straight || volumes.iter().any(is_moving))
    {
        let problem = "the frequency of light is defined for an observer, and this camera has none";
        root.fault(&["camera"], problem, "add observer = \"static\", or another observer, to [camera]");
    }
}

/// Checks that the grids of a volume cover its region.
fn check_grids(root: &TableReader, law: &dyn Law, (i, volume): (usize, &Volume)) {
    let Some([lo, hi]) = volume.bounds() else { return };
    let is_by_law = law.equator().filter(|_| !law.facts().momentum_parts.is_empty());
    let (axes, origin) =
        is_by_law.map_or((DMat3::IDENTITY, volume.center()), |[center, _]| (law.formula_axes(), center));
    let corner = |c: u32| DVec3::select(BVec3::new(c & 1 == 1, c & 2 == 2, c & 4 == 4), hi, lo);
    for grid in &volume.grids {
        let slack = 1e-6 * (grid.end() - grid.origin);
        let is_outside = |q: DVec3| q.cmplt(grid.origin - slack).any() || q.cmpgt(grid.end() + slack).any();
        if (0..8).any(|c| is_outside(axes.transpose() * (corner(c) - origin))) {
            let (lo, hi) = (lo - origin, hi - origin);
            let problem = format!(
                "volumes[{i}] reaches from {lo} to {hi} in the coordinates of its formulas, and a grid of it only from {} to {}",
                grid.origin,
                grid.end()
            );
            root.fault(&["volumes"], problem, "choose a smaller shape, or `min` and `max` of the grid that contain it");
        }
    }
}

fn check_frequencies(root: &TableReader, rest: &Rest, [by_paths, adaptive]: [bool; 2]) {
    if by_paths {
        let help = "remove [radiation], or use lighting = \"direct\"";
        root.fault(&["radiation"], "`radiation` cannot be combined with path tracing", help);
    }
    if adaptive {
        let help = "remove image.adaptive, and set image.samples";
        root.fault(&["radiation"], "`radiation` cannot be combined with adaptive sampling", help);
    }
    if rest.camera.is_some_and(|camera| camera.redshift) {
        let help = "remove camera.redshift: intensities always include the redshift";
        root.fault(&["camera"], "`redshift` applies to colors, and cannot be combined with [radiation]", help);
    }
}
