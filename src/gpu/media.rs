//! The values of media, by the names of their members in WGSL.

use super::source::Source;
use crate::model::Value::{self, Float, Uint};
use crate::model::{Medium, Row};
use crate::program::Region;

impl Source<'_> {
    /// The rows of `regions`.
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

    /// Do the camera's rays start inside of this mesh? Where an analytic shape is concerned every ray finds out for itself.
    fn starts_in(&self, object: usize) -> bool {
        let object = &self.scene.objects[object];
        let camera = self.scene.camera.as_ref().filter(|_| !self.program.choice.purpose.is_given());
        object.shape.mesh().is_some() && camera.is_some_and(|camera| object.contains(camera.position))
    }

    fn of_kind(&self, kind: usize) -> impl Iterator<Item = &dyn Medium> {
        let kind = self.geometry.analysis.regions.kinds.get(kind);
        kind.into_iter().flat_map(|kind| kind.media.iter().map(|medium| &**medium))
    }

    /// Of the media of a kind.
    pub(super) fn media(&self, kind: usize) -> Vec<Row> {
        let mut first = 0;
        let row = |medium: &dyn Medium| {
            let values = medium.values(first);
            first += (medium.points().len() + medium.samples().len()) as u32;
            values
        };
        self.of_kind(kind).map(row).collect()
    }

    /// Of the profiles in them.
    pub(super) fn profiles(&self, kind: usize) -> Vec<Row> {
        self.of_kind(kind).flat_map(Medium::points).collect()
    }

    /// Of the grids in them.
    pub(super) fn index_samples(&self, kind: usize) -> Vec<f32> {
        self.of_kind(kind).flat_map(|medium| medium.samples().iter().copied()).collect()
    }
}
