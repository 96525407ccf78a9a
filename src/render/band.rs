//! Stores rows of an image in host memory: the output of finished tiles, and the input of file writers.

use rayon::prelude::*;

use super::{RenderError, Totals};
use crate::program::{CROSSINGS, Layer, LayerKind, Margin};

/// Returns the bits of a component of a pixel.
pub(super) type Words<'w> = dyn Fn(usize, usize) -> u32 + Sync + 'w;

/// The values of a layer, row by row.
#[derive(Debug, Clone, PartialEq)]
pub enum Plane {
    /// One number per pixel.
    Scalar(Vec<f32>),
    /// Three numbers per pixel, by component.
    Vector([Vec<f32>; 3]),
    /// A number for each of the first crossings of translucent surfaces, by crossing.
    Crossings([Vec<f32>; CROSSINGS]),
    /// One integer per pixel.
    Id(Vec<u32>),
}

/// A range of complete rows of the rendered window.
#[derive(Debug, Clone, PartialEq)]
pub struct Band {
    /// The first row, counted from the top of the window.
    pub first_row: u32,
    /// The number of rows.
    pub rows: u32,
    /// The width of the window, in pixels.
    pub width: u32,
    /// The mean of the samples: linear red, green and blue.
    pub color: [Vec<f32>; 3],
    /// The fraction of samples that show something (the colors are premultiplied by it); `None` if all do.
    pub alpha: Option<Vec<f32>>,
    /// The requested layers, in the order of the settings.
    pub layers: Vec<(Layer, Plane)>,
}

/// Bands that are joined in order.
#[derive(Debug, Default)]
pub(super) struct Bands {
    /// The joined bands; `None` before the first.
    pub whole: Option<Band>,
}

impl Bands {
    /// Returns a function that appends a band.
    pub fn sink(&mut self) -> impl FnMut(Band) -> Result<(), RenderError> {
        |band| {
            match &mut self.whole {
                Some(whole) => whole.append(band),
                None => self.whole = Some(band),
            }
            Ok(())
        }
    }
}

/// A whole image in memory, for tests and comparisons.
#[derive(Debug, Clone, PartialEq)]
pub struct Rendering {
    /// All rows of the image in one band.
    pub band: Band,
    /// The totals of the render.
    pub totals: Totals,
}

/// The location of a tile in the rows of a band.
pub(super) struct TilePlace {
    pub left: u32,
    /// The width of the tile with its margin, in pixels.
    pub width: u32,
    pub margin: Margin,
}

impl TilePlace {
    /// Copies the values of a tile's pixels without its margin into complete rows of planes, on all cores. `values` receives the number of
    /// the pixel in the tile.
    pub fn put<T: Send, const N: usize>(
        &self,
        planes: [&mut [T]; N],
        width: u32,
        values: impl Fn(usize) -> [T; N] + Sync,
    ) {
        let own = self.left as usize..(self.left + self.width - self.margin.total()) as usize;
        let mut rows = planes.map(|plane| plane.chunks_mut(width as usize));
        let rows: Vec<[&mut [T]; N]> = std::iter::from_fn(|| {
            let row = rows.each_mut().map(Iterator::next);
            row.iter().all(Option::is_some).then(|| row.map(Option::unwrap_or_default))
        })
        .collect();
        rows.into_par_iter().enumerate().for_each(|(y, mut row)| {
            let before = self.margin.before as usize;
            for (x, pixel) in own.clone().zip((y + before) * self.width as usize + before..) {
                for (plane, value) in row.iter_mut().zip(values(pixel)) {
                    plane[x] = value;
                }
            }
        });
    }

    /// Copies a layer into the band. `words` receives the number of the pixel in the tile, and the component.
    pub fn put_layer(&self, layer: Layer, band: &mut Band, words: &Words) {
        let (width, pixels) = (band.width, band.width as usize * band.rows as usize);
        let at = if let Some(at) = band.layers.iter().position(|(l, _)| *l == layer) {
            at
        } else {
            band.layers.push((layer, empty_plane(layer, pixels)));
            band.layers.len() - 1
        };
        let float = |pixel: usize, k| f32::from_bits(words(pixel, k));
        match &mut band.layers[at].1 {
            Plane::Scalar(values) => self.put([values], width, |pixel| [float(pixel, 0)]),
            Plane::Id(values) => self.put([values], width, |pixel| [words(pixel, 0)]),
            Plane::Vector(values) => {
                let planes = values.each_mut().map(Vec::as_mut_slice);
                self.put(planes, width, |pixel| [0, 1, 2].map(|k| float(pixel, k)));
            }
            Plane::Crossings(values) => {
                let planes = values.each_mut().map(Vec::as_mut_slice);
                self.put(planes, width, |pixel| std::array::from_fn(|k| float(pixel, k)));
            }
        }
    }
}

fn empty_plane(layer: Layer, pixels: usize) -> Plane {
    match layer.kind() {
        LayerKind::Scalar => Plane::Scalar(vec![0.0; pixels]),
        LayerKind::Vector => Plane::Vector([vec![0.0; pixels], vec![0.0; pixels], vec![0.0; pixels]]),
        LayerKind::Crossings => Plane::Crossings(std::array::from_fn(|_| vec![0.0; pixels])),
        LayerKind::Id => Plane::Id(vec![0; pixels]),
    }
}

impl Band {
    /// Returns the plane of a layer, if the band has it.
    #[must_use]
    pub fn layer(&self, layer: Layer) -> Option<&Plane> {
        self.layers.iter().find_map(|(l, plane)| (*l == layer).then_some(plane))
    }

    pub(crate) fn append(&mut self, below: Self) {
        self.rows += below.rows;
        let planes = self.color.iter_mut().chain(&mut self.alpha);
        for (channel, more) in planes.zip(below.color.into_iter().chain(below.alpha)) {
            channel.extend(more);
        }
        for ((_, plane), (_, more)) in self.layers.iter_mut().zip(below.layers) {
            match (plane, more) {
                (Plane::Scalar(values), Plane::Scalar(more)) => values.extend(more),
                (Plane::Id(values), Plane::Id(more)) => values.extend(more),
                (Plane::Vector(values), Plane::Vector(more)) => {
                    values.iter_mut().zip(more).for_each(|(values, more)| values.extend(more));
                }
                (Plane::Crossings(values), Plane::Crossings(more)) => {
                    values.iter_mut().zip(more).for_each(|(values, more)| values.extend(more));
                }
                _ => {}
            }
        }
    }
}
