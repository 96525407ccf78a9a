//! Bands of rows: the channels of their layers, and the check that they are complete and in order.

use std::path::PathBuf;

use super::{FileSettings, OutputError};
use crate::program::{Layer, LayerKind};
use crate::render::{Band, Plane};

/// Returns the names of a layer's channels in an EXR file, in component order.
#[must_use]
pub const fn channels(layer: Layer) -> &'static [&'static str] {
    match layer {
        Layer::Depth => &["Z"],
        Layer::Segments => &["segments"],
        Layer::Position => &["position.X", "position.Y", "position.Z"],
        Layer::Normal => &["normal.X", "normal.Y", "normal.Z"],
        Layer::Object => &["id.object"],
        Layer::Status => &["id.status"],
        Layer::Steps => &["steps"],
        Layer::Redshift => &["redshift"],
        Layer::Samples => &["samples"],
        Layer::StandardError => &["standard_error"],
        Layer::Accumulated => &["accumulated.R", "accumulated.G", "accumulated.B"],
        Layer::LuminanceM2 => &["luminance_m2"],
        Layer::ImageOrder => &["image_order.0", "image_order.1", "image_order.2"],
        Layer::CrossingRadius => &["crossing_radius.0", "crossing_radius.1", "crossing_radius.2", "crossing_radius.3"],
        Layer::CrossingAzimuth => {
            &["crossing_azimuth.0", "crossing_azimuth.1", "crossing_azimuth.2", "crossing_azimuth.3"]
        }
        Layer::CrossingTime => &["crossing_time.0", "crossing_time.1", "crossing_time.2", "crossing_time.3"],
        Layer::CrossingRedshift => {
            &["crossing_redshift.0", "crossing_redshift.1", "crossing_redshift.2", "crossing_redshift.3"]
        }
        Layer::CrossingAngle => &["crossing_angle.0", "crossing_angle.1", "crossing_angle.2", "crossing_angle.3"],
        Layer::Intensity(k) => FREQUENCIES[0][(k % 8) as usize],
        Layer::OpticalDepth(k) => FREQUENCIES[1][(k % 8) as usize],
        Layer::MeanRedshift(k) => FREQUENCIES[2][(k % 8) as usize],
        Layer::Magnification => &["magnification"],
        Layer::Bundle => &["bundle.major", "bundle.minor", "bundle.angle"],
        Layer::Way => &["way.X", "way.Y", "way.Z"],
    }
}

/// The channels of layers of frequencies, by index.
const FREQUENCIES: [[&[&str]; 8]; 3] = [
    [
        &["intensity.0"],
        &["intensity.1"],
        &["intensity.2"],
        &["intensity.3"],
        &["intensity.4"],
        &["intensity.5"],
        &["intensity.6"],
        &["intensity.7"],
    ],
    [
        &["optical_depth.0"],
        &["optical_depth.1"],
        &["optical_depth.2"],
        &["optical_depth.3"],
        &["optical_depth.4"],
        &["optical_depth.5"],
        &["optical_depth.6"],
        &["optical_depth.7"],
    ],
    [
        &["mean_redshift.0"],
        &["mean_redshift.1"],
        &["mean_redshift.2"],
        &["mean_redshift.3"],
        &["mean_redshift.4"],
        &["mean_redshift.5"],
        &["mean_redshift.6"],
        &["mean_redshift.7"],
    ],
];

/// Returns the channels of a file in order.
pub(super) fn channel_names(settings: &FileSettings) -> Vec<&'static str> {
    let own = settings.layers.iter().flat_map(|layer| channels(*layer).iter().copied());
    let mut names: Vec<&str> = ["R", "G", "B"].into_iter().chain(settings.alpha.then_some("A")).chain(own).collect();
    names.sort_unstable();
    names
}

/// An array of an image file, with the shape of the image.
#[derive(Debug, Clone, Copy)]
pub(super) struct ArrayKind {
    /// `color`, `alpha` or the name of the layer.
    pub name: &'static str,
    /// The number of components.
    pub count: usize,
    /// Is `true` if the values are unsigned whole numbers, not floats; both have 32 bits.
    pub is_whole: bool,
    /// Is `true` if the values are lengths.
    pub is_length: bool,
}

/// Returns the arrays of a file: color, alpha if it has any, and its layers.
pub(super) fn arrays(settings: &FileSettings) -> Vec<ArrayKind> {
    let float = |name, count| ArrayKind { name, count, is_whole: false, is_length: false };
    let alpha = settings.alpha.then_some(float("alpha", 1));
    let layers = settings.layers.iter().map(|layer| ArrayKind {
        name: layer.name(),
        count: channels(*layer).len(),
        is_whole: layer.kind() == LayerKind::Id,
        is_length: matches!(layer, Layer::Depth | Layer::Position | Layer::CrossingRadius),
    });
    std::iter::once(float("color", 3)).chain(alpha).chain(layers).collect()
}

/// Returns the bytes of each component, in native byte order.
pub(super) fn components(plane: &Plane) -> Vec<&[u8]> {
    match plane {
        Plane::Scalar(plane) => vec![bytemuck::cast_slice(plane)],
        Plane::Vector(planes) => planes.iter().map(|p| bytemuck::cast_slice(p)).collect(),
        Plane::Crossings(planes) => planes.iter().map(|p| bytemuck::cast_slice(p)).collect(),
        Plane::Id(plane) => vec![bytemuck::cast_slice(plane)],
    }
}

fn suits(plane: &Plane, layer: Layer) -> bool {
    let kind = match plane {
        Plane::Scalar(_) => LayerKind::Scalar,
        Plane::Vector(_) => LayerKind::Vector,
        Plane::Crossings(_) => LayerKind::Crossings,
        Plane::Id(_) => LayerKind::Id,
    };
    kind == layer.kind()
}

/// Returns why `band` is not the one at row `next` of an image of `size` with `alpha` and `layers`, if it is not.
fn problem(band: &Band, next: u32, [width, height]: [u32; 2], alpha: bool, layers: &[Layer]) -> Option<String> {
    if band.first_row != next {
        return Some(format!("the next row is {next}; write bands in order"));
    }
    if band.width != width || band.rows == 0 || band.rows > height - next {
        return Some(format!(
            "it has {}x{} pixels, but a width of {width} and a height from 1 to {} are expected",
            band.width,
            band.rows,
            height - next
        ));
    }
    let bytes = width as usize * band.rows as usize * size_of::<f32>();
    if band.color.iter().any(|c| size_of_val(c.as_slice()) != bytes) {
        return Some("a color plane does not have one value per pixel".into());
    }
    if alpha && band.alpha.as_ref().is_none_or(|a| size_of_val(a.as_slice()) != bytes) {
        return Some("the alpha plane is missing, or does not have one value per pixel".into());
    }
    layers.iter().find_map(|&layer| {
        let Some(plane) = band.layer(layer) else {
            return Some(format!("the {layer:?} plane is missing"));
        };
        let whole = suits(plane, layer) && components(plane).iter().all(|c| c.len() == bytes);
        (!whole).then(|| format!("the {layer:?} plane is of the wrong kind or length"))
    })
}

/// The count of rows of an image, or of the part that a file stores.
#[derive(Debug)]
pub(super) struct Rows {
    pub path: PathBuf,
    pub size: [u32; 2],
    pub alpha: bool,
    pub layers: Vec<Layer>,
    next: u32,
}

impl Rows {
    pub fn new(path: PathBuf, size: [u32; 2], alpha: bool, layers: Vec<Layer>) -> Self {
        Self { path, size, alpha, layers, next: 0 }
    }

    /// Counts a band, if it is the next one and has the image's planes.
    pub fn accept(&mut self, band: &Band) -> Result<(), OutputError> {
        if let Some(problem) = problem(band, self.next, self.size, self.alpha, &self.layers) {
            return Err(OutputError::Band { path: self.path.clone(), row: band.first_row, problem });
        }
        self.count(band.rows);
        Ok(())
    }

    /// Returns the bits of a band, for each component of each of the [`arrays`].
    pub fn bits<'a>(&self, band: &'a Band) -> Vec<Vec<&'a [u32]>> {
        let color = band.color.iter().map(|plane| bytemuck::cast_slice(plane)).collect();
        let alpha = band.alpha.iter().filter(|_| self.alpha).map(|plane| vec![bytemuck::cast_slice(plane)]);
        let layers = self.layers.iter().filter_map(|layer| band.layer(*layer).map(components));
        let layers = layers.map(|planes| planes.into_iter().map(bytemuck::cast_slice).collect());
        std::iter::once(color).chain(alpha).chain(layers).collect()
    }

    /// Counts rows that are certainly the next ones.
    pub fn count(&mut self, rows: u32) {
        self.next += rows;
    }

    /// Returns `true` if the last row has been counted.
    pub fn is_complete(&self) -> bool {
        self.next == self.size[1]
    }

    /// Returns an error if rows are missing.
    pub fn complete(&self) -> Result<(), OutputError> {
        if self.is_complete() {
            return Ok(());
        }
        Err(OutputError::Incomplete { path: self.path.clone(), rows: self.next, height: self.size[1] })
    }
}
