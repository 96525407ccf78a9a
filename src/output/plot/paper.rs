//! What a plot is drawn on: SVG or pixels, by the extension of the file's name.
//!
//! The layout is the same on both, since the library guesses the width of text and asks neither.

use std::{io, path::Path};

use plotters::prelude::{DrawingBackend, SVGBackend};
use plotters_backend::{BackendColor, BackendCoord, BackendStyle, BackendTextStyle, DrawingErrorKind};

use super::{CANVAS, Drawn, OutputError, raster::Raster, words};

/// The formats of a plot.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Format {
    Svg,
    Png,
}

impl Format {
    /// The format that the name of a file asks for.
    pub fn of(path: &Path) -> Result<Self, OutputError> {
        let extension = path.extension().map(|e| e.to_string_lossy().to_ascii_lowercase());
        match extension.as_deref() {
            Some("svg") => Ok(Self::Svg),
            Some("png") => Ok(Self::Png),
            _ => Err(OutputError::PlotFormat { path: path.to_owned() }),
        }
    }

    /// The bytes of a file with what `draw` has drawn.
    pub fn paint(self, draw: impl FnOnce(Paper) -> Drawn<()>) -> Drawn<Vec<u8>> {
        match self {
            Self::Svg => {
                let mut svg = String::new();
                draw(Paper::Svg(SVGBackend::with_string(&mut svg, CANVAS)))?;
                Ok(svg.into_bytes())
            }
            Self::Png => {
                let mut raster = Raster::new(CANVAS)?;
                draw(Paper::Png(&mut raster))?;
                raster.encode().map_err(words)
            }
        }
    }
}

/// The backend of a plot.
pub(super) enum Paper<'a> {
    Svg(SVGBackend<'a>),
    Png(&'a mut Raster),
}

type Done = Result<(), DrawingErrorKind<io::Error>>;

impl DrawingBackend for Paper<'_> {
    type ErrorType = io::Error;

    fn get_size(&self) -> (u32, u32) {
        CANVAS
    }

    fn ensure_prepared(&mut self) -> Done {
        Ok(())
    }

    fn present(&mut self) -> Done {
        match self {
            Self::Svg(svg) => svg.present(),
            Self::Png(_) => Ok(()),
        }
    }

    fn draw_pixel(&mut self, (x, y): BackendCoord, color: BackendColor) -> Done {
        self.draw_rect((x, y), (x + 1, y + 1), &color, true)
    }

    fn draw_line<S: BackendStyle>(&mut self, from: BackendCoord, to: BackendCoord, style: &S) -> Done {
        match self {
            Self::Svg(svg) => svg.draw_line(from, to, style),
            Self::Png(raster) => raster.stroke([from, to], style),
        }
    }

    fn draw_rect<S: BackendStyle>(&mut self, from: BackendCoord, to: BackendCoord, style: &S, fill: bool) -> Done {
        match self {
            Self::Svg(svg) => svg.draw_rect(from, to, style, fill),
            Self::Png(raster) => raster.rectangle(from, to, style, fill),
        }
    }

    fn draw_path<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(&mut self, path: I, style: &S) -> Done {
        match self {
            Self::Svg(svg) => svg.draw_path(path, style),
            Self::Png(raster) => raster.stroke(path, style),
        }
    }

    fn fill_polygon<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(&mut self, path: I, style: &S) -> Done {
        match self {
            Self::Svg(svg) => svg.fill_polygon(path, style),
            Self::Png(raster) => raster.polygon(path, style),
        }
    }

    fn draw_circle<S: BackendStyle>(&mut self, center: BackendCoord, radius: u32, style: &S, fill: bool) -> Done {
        match self {
            Self::Svg(svg) => svg.draw_circle(center, radius, style, fill),
            Self::Png(raster) => raster.circle(center, radius, style, fill),
        }
    }

    fn draw_text<S: BackendTextStyle>(&mut self, text: &str, style: &S, at: BackendCoord) -> Done {
        match self {
            Self::Svg(svg) => svg.draw_text(text, style, at),
            Self::Png(raster) => raster.text(text, style, at),
        }
    }
}
