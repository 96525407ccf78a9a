//! Packs the values of a scene's uniforms, by the names of their members in WGSL.

use glam::{DMat3, DVec3};

use super::source::Uploads;
use super::structure::Grid;
use crate::model::Value::{self, Uint};
use crate::model::law::Observer;
use crate::model::volume::Flow;
use crate::model::{Binding, Radiation, Row, matter, row, volume};
use crate::program::constant;
use crate::scene::{Scene, Segment, Sky, Splitting, TransparentShadows};

/// The longest angle, in radians, over which orbits are interpolated with this error; it falls with the sixth power of the angle.
const LONGEST_ARC: f64 = 0.6;
const ARC_ERROR: f64 = 1e-6;

impl Uploads<'_> {
    /// Returns the values that a scene has once, each as one struct.
    pub(super) fn uniforms(&self) -> Vec<Binding> {
        let Scene { image, output, rays, sky, sky_other_side: beyond, .. } = self.scene;
        let side = f64::from(image.samples).sqrt();
        // A pixel of an adaptive image may be done after its first samples.
        let first = image.adaptive.map(|_| constant("pass/refine", "FIRST_SAMPLES").sqrt());
        let columns = side.ceil() as u32;
        let paths = rays.path_tracing.unwrap_or_default();
        let depth = paths.max_depth.unwrap_or(u32::MAX);
        let most = output.clamp.unwrap_or(f64::from(f32::MAX));
        let refinement = row! {
            tolerance: Float(image.adaptive.unwrap_or(0.0)),
            most: Uint(image.samples),
            gain: Float(output.exposure.exp2()),
        };
        let one = Binding::one;
        let mut all = vec![
            one(
                "bound",
                row! { center: Vec3(rays.bounding_sphere.center), radius: Float(rays.bounding_sphere.radius) },
            ),
            one("sampling", row! { grid: Uint2([columns, image.samples.div_ceil(columns)]) }),
            one("sample_share", row! { side: Float(first.unwrap_or(side).recip()) }),
            one("refinement", refinement),
            one("transport", row! { depth: Uint(depth), roulette: Uint(paths.rr_depth), seed: Uint(paths.seed) }),
            one("spectrum", row! { wavelength: Float(1e-3 * rays.wavelength) }),
            one("brightest", row! { radiance: Float(most) }),
            one("ambient", self.ambient()),
            one("limit", row! { length: Float(rays.max_parameter.unwrap_or(f64::MAX)) }),
            one("sky", sky_row(sky)),
        ];
        if self.program.features.volumes.transfers {
            all.push(one("transfer", self.transfer()));
        }
        if !self.scene.volumes.is_empty() {
            let is_by_law = self.scene.places_volumes_by_law();
            all.push(volume::grids(&self.scene.volumes));
            all.push(volume::regions(&self.scene.volumes, |own| if is_by_law { DVec3::ZERO } else { own.center() }));
        }
        match rays.segment {
            Segment::Chord { steps } => all.push(one("chord", row! { steps: Uint(steps) })),
            Segment::Arc { tolerance } => {
                let (lo, hi) = self.geometry.bounds();
                all.push(one("arc", row! { tolerance: Float(tolerance), lo: Vec3(lo), hi: Vec3(hi) }));
                all.push(one("moving_arcs", row! { tolerance: Float(tolerance) }));
            }
        }
        if let Splitting::Enumerated(depth) = rays.max_splits {
            all.push(one("branching", row! { depth: Uint(depth) }));
        }
        all.extend(beyond.as_ref().map(|sky| one("beyond_sky", sky_row(sky))));
        all.extend(self.geometry.structure.grid.as_ref().map(|grid| {
            let Grid { lo, hi, cell, count, .. } = grid;
            one("grid_space", row! { lo: Vec3(*lo), hi: Vec3(*hi), cell: Vec3(*cell), count: Uint3(*count) })
        }));
        all
    }

    /// Returns the members of `transfer`.
    fn transfer(&self) -> Row {
        let radiation = self.scene.radiation.as_ref();
        let axes = self.scene.law.formula_axes();
        let tolerance = radiation.map_or(Radiation::COLOR_TOLERANCE, Radiation::tolerance);
        row! {
            // Media have their own tolerances.
            tolerance: Float(if self.scene.volumes.is_empty() { 1.0 } else { tolerance }),
            arc: Float(LONGEST_ARC * (tolerance / ARC_ERROR).powf(1.0 / 6.0).min(1.0)),
            horizon: Float(self.scene.horizon().map_or(0.0, |horizon| horizon.radius)),
            edge: Float(self.scene.matter_reach().map_or(0.0, f64::recip)),
            time: Float(self.scene.camera.as_ref().map_or(0.0, |camera| camera.time)),
            white: Float(radiation.map_or(1.0, |radiation| radiation.white) / self.scene.intensity_unit().unwrap_or(1.0)),
            last_prograde: Vec3(self.last_stable(Observer::ProgradeOrbit)),
            last_retrograde: Vec3(self.last_stable(Observer::RetrogradeOrbit)),
            first: Vec3(axes.x_axis),
            second: Vec3(axes.y_axis),
            third: Vec3(axes.z_axis),
        }
    }

    /// Returns the last stable orbit that some volume's matter follows.
    fn last_stable(&self, sense: Observer) -> DVec3 {
        let is_followed = self.scene.volumes.iter().any(|volume| volume.flow == Flow::Observer(sense));
        let outer = 1e3 * self.scene.horizon().map_or(1.0, |horizon| horizon.radius);
        let last = is_followed.then(|| matter::last_stable(self.scene.law.as_ref(), outer, sense));
        last.flatten().map_or(DVec3::ZERO, |orbit| DVec3::new(orbit.rho, orbit.energy, orbit.momentum))
    }

    /// Returns the members of `ambient`: the range of occlusion (by default the diameter of the bounding sphere), its floor and its
    /// shadows.
    fn ambient(&self) -> Row {
        let occlusion = self.scene.occlusion.as_ref();
        let along_law = occlusion.is_some_and(|occlusion| occlusion.along_law);
        // Along the law, a path may orbit before it escapes.
        let across = if along_law { f64::from(f32::MAX) } else { 2.0 * self.scene.rays.bounding_sphere.radius };
        let distance = occlusion.and_then(|occlusion| occlusion.distance).unwrap_or(across);
        let floor = occlusion.map_or(0.0, |occlusion| occlusion.floor);
        let shadows = self.shadow_code(occlusion.map_or(TransparentShadows::Open, |occlusion| occlusion.clear));
        row! { distance: Float(distance), floor: Float(floor), shadows: Uint(shadows) }
    }
}

/// Returns the members of `sky`.
fn sky_row(sky: &Sky) -> Row {
    match sky {
        Sky::Color(color) => row! { color: Vec3(*color) },
        Sky::Transparent => row! { color: Vec3(DVec3::ZERO) },
        Sky::Equirectangular(image, intensity, rotation) => {
            let own: Row = row! { intensity: Float(*intensity), image: Uint(*image as u32) };
            [own, axes(rotation)].concat()
        }
        Sky::Faces(faces, intensity, rotation) => {
            let [px, nx, py, ny, pz, nz] = faces.map(|face| face as u32);
            let own: Row =
                row! { faces: Uint4([px, nx, py, ny]), more_faces: Uint2([pz, nz]), intensity: Float(*intensity) };
            [own, axes(rotation)].concat()
        }
    }
}

/// Returns the axes of a map in the scene.
fn axes(rotation: &DMat3) -> Row {
    row! { first: Vec3(rotation.x_axis), second: Vec3(rotation.y_axis), third: Vec3(rotation.z_axis) }
}

/// Returns the members of `schedule`.
#[must_use]
pub fn schedule_values(max_segments: u32, segments: u32) -> [(&'static str, Value); 2] {
    // Without a mask, a terminated ray runs to the end of the pass; no path may have more than `max_segments`.
    let segments = segments.min(max_segments);
    [("max_segments", Uint(max_segments)), ("segments", Uint(segments))]
}
