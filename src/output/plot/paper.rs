//! What a plot is drawn on: SVG or pixels, by the extension of the file's name.
//!
//! The layout is the same on both, since the library guesses the width of text and asks neither.

use std::{io, path::Path};

use plotters::prelude::DrawingBackend;
use plotters_backend::{BackendColor, BackendCoord, BackendStyle, BackendTextStyle, DrawingErrorKind};

use super::{CANVAS, Drawn, OutputError, figure::Figure, raster::Raster, vector::Vector, words};

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
                let mut vector = Vector::new(CANVAS);
                draw(Paper::Svg(&mut vector))?;
                Ok(vector.encode().into_bytes())
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
    Svg(&'a mut Vector),
    Png(&'a mut Raster),
}

type Done = Result<(), DrawingErrorKind<io::Error>>;

impl Paper<'_> {
    pub fn figure(&mut self, figure: &Figure) {
        match self {
            Self::Svg(vector) => vector.figure(figure),
            Self::Png(raster) => raster.figure(figure),
        }
    }
}

impl DrawingBackend for Paper<'_> {
    type ErrorType = io::Error;

    fn get_size(&self) -> (u32, u32) {
        CANVAS
    }

    fn ensure_prepared(&mut self) -> Done {
        Ok(())
    }

    fn present(&mut self) -> Done {
        Ok(())
    }

    fn draw_pixel(&mut self, (x, y): BackendCoord, color: BackendColor) -> Done {
        self.draw_rect((x, y), (x + 1, y + 1), &color, true)
    }

    fn draw_line<S: BackendStyle>(&mut self, from: BackendCoord, to: BackendCoord, style: &S) -> Done {
        match self {
            Self::Svg(vector) => vector.line(from, to, style),
            Self::Png(raster) => raster.stroke([from, to], style),
        }
        Ok(())
    }

    fn draw_rect<S: BackendStyle>(&mut self, from: BackendCoord, to: BackendCoord, style: &S, fill: bool) -> Done {
        match self {
            Self::Svg(vector) => vector.rectangle(from, to, style, fill),
            Self::Png(raster) => raster.rectangle(from, to, style, fill),
        }
        Ok(())
    }

    fn draw_path<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(&mut self, path: I, style: &S) -> Done {
        match self {
            Self::Svg(vector) => vector.stroke(path, style),
            Self::Png(raster) => raster.stroke(path, style),
        }
        Ok(())
    }

    fn fill_polygon<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(&mut self, path: I, style: &S) -> Done {
        match self {
            Self::Svg(vector) => vector.polygon(path, style),
            Self::Png(raster) => raster.polygon(path, style),
        }
        Ok(())
    }

    fn draw_circle<S: BackendStyle>(&mut self, center: BackendCoord, radius: u32, style: &S, fill: bool) -> Done {
        match self {
            Self::Svg(vector) => vector.circle(center, radius, style, fill),
            Self::Png(raster) => raster.circle(center, radius, style, fill),
        }
        Ok(())
    }

    fn draw_text<S: BackendTextStyle>(&mut self, text: &str, style: &S, at: BackendCoord) -> Done {
        match self {
            Self::Svg(vector) => vector.text(text, style, at),
            Self::Png(raster) => raster.text(text, style, at)?,
        }
        Ok(())
    }
}
