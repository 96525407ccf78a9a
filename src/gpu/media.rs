//! Packs the values of media and absorption, by the names of their members in WGSL.

use glam::DVec3;

use super::source::Uploads;
use crate::model::Value::{self, Float, Uint};
use crate::model::{Absorption, Medium, Row};
use crate::program::{Region, constant};

impl Uploads<'_> {
    /// Returns the rows of `absorptions`: one for each region, followed by one for the surrounding space.
    pub(super) fn absorptions(&self) -> Vec<Row> {
        let none = Absorption { tolerance: 1.0, ..Absorption::even(DVec3::ONE) };
        let objects = &self.scene.objects;
        let of_object = |object: usize| objects[object].interior()?.absorption.as_deref();
        // Formulas are counted in the order of the file, whatever the order of the regions.
        let formulas = |objects: usize| (0..objects).filter_map(of_object).filter_map(Absorption::formulas).count();
        let row = |absorption: Option<&Absorption>, before: usize| {
            let absorption = absorption.unwrap_or(&none);
            let code = constant("absorption/density", &absorption.kind().to_uppercase()) as u32;
            let kind = vec![("kind".into(), Uint(code))];
            [absorption.values(formulas(before)), kind].concat()
        };
        let regions = self.geometry.analysis.regions.regions.iter();
        let of_regions = regions.map(|region| row(of_object(region.object), region.object));
        of_regions.chain([row(self.scene.absorption.as_ref(), objects.len())]).collect()
    }

    /// Returns the rows of `regions`.
    pub(super) fn regions(&self) -> Vec<[(&'static str, Value); 5]> {
        let regions = &self.geometry.analysis.regions;
        let row = |region: &Region| {
            [
                ("kind", Uint(region.kind.unwrap_or(0) as u32)),
                ("place", Uint(region.place as u32)),
                ("primitive", Uint(self.geometry.primitive(region.object))),
                ("start", Uint(u32::from(self.starts_in(region.object)))),
                ("radius", Float(region.radius)),
            ]
        };
        regions.regions.iter().map(row).collect()
    }

    /// Returns `true` if the camera's rays start inside this mesh. For analytic shapes every ray determines this itself.
    fn starts_in(&self, object: usize) -> bool {
        let object = &self.scene.objects[object];
        let camera = self.scene.camera.as_ref().filter(|_| !self.program.features.mode.is_given());
        object.shape.mesh().is_some() && camera.is_some_and(|camera| object.contains(camera.position))
    }

    fn of_kind(&self, kind: usize) -> impl Iterator<Item = &dyn Medium> {
        let kind = self.geometry.analysis.regions.kinds.get(kind);
        kind.into_iter().flat_map(|kind| kind.media.iter().map(|medium| &**medium))
    }

    /// Returns the rows of the media of a kind.
    pub(super) fn media(&self, kind: usize) -> Vec<Row> {
        let mut first = 0;
        let row = |medium: &dyn Medium| {
            let values = medium.values(first);
            first += (medium.points().len() + medium.facts().samples.len()) as u32;
            values
        };
        self.of_kind(kind).map(row).collect()
    }

    /// Returns the points of the profiles in the media of a kind.
    pub(super) fn profiles(&self, kind: usize) -> Vec<Row> {
        self.of_kind(kind).flat_map(Medium::points).collect()
    }

    /// Returns the samples of the grids in the media of a kind.
    pub(super) fn index_samples(&self, kind: usize) -> Vec<f32> {
        self.of_kind(kind).flat_map(|medium| medium.facts().samples.iter().copied()).collect()
    }
}
