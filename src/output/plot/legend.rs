//! The legend: a column next to the plot, with a line for each series.

use kurbo::Point;

use super::canvas::{Align, CANVAS, Canvas, text_width};
use super::style::Style;

/// The margin around the plot and the legend in pixels.
pub(super) const MARGIN: f64 = 30.0;
const ROW_HEIGHT: f64 = 44.0;
/// The length of the sample line before a name.
const SAMPLE: f64 = 90.0;
const GAP: f64 = 14.0;
/// The number of rows that fit between the margins.
const ROWS: usize = ((CANVAS[1] as f64 - 2.0 * MARGIN) / ROW_HEIGHT) as usize;
/// The largest number of characters of a line.
const LONGEST: usize = 28;

/// The contents of the legend: names with the styles that they explain, and lines of plain text below.
#[derive(Debug, Clone, Default)]
pub(super) struct Legend {
    pub entries: Vec<(String, Style)>,
    pub notes: Vec<String>,
}

impl Legend {
    /// Creates a legend for series of these names; `missing` of their points have no position in the plot.
    pub fn of<'a>(names: impl Iterator<Item = &'a String>, missing: usize) -> Self {
        Self {
            entries: names.enumerate().map(|(i, name)| (name.clone(), Style::of(i))).collect(),
            notes: match missing {
                0 => Vec::new(),
                1 => vec!["1 point cannot be shown".into()],
                n => vec![format!("{n} points cannot be shown")],
            },
        }
    }

    /// Returns the left edge of the column in pixels, or the canvas's edge if it is empty.
    pub fn left(&self) -> f64 {
        let names = self.entries.iter().map(|(name, _)| text_width(&shortened(name)) + SAMPLE + GAP);
        let notes = self.notes.iter().map(|note| text_width(&shortened(note)));
        let widest = names.chain(notes).reduce(f64::max);
        f64::from(CANVAS[0]) - widest.map_or(0.0, |width| width.ceil() + MARGIN)
    }

    /// Draws the column at the right edge of the canvas.
    pub fn draw(&self, canvas: &mut Canvas) {
        let mut at = Point::new(self.left(), MARGIN + ROW_HEIGHT / 2.0);
        let room = ROWS - self.notes.len();
        let crowded = self.entries.len() > room;
        let shown = if crowded { room - 1 } else { self.entries.len() };
        for (name, look) in &self.entries[..shown] {
            look.join(canvas, [at, at + (SAMPLE, 0.0)]);
            look.mark(canvas, at + (SAMPLE / 2.0, 0.0));
            canvas.write(&shortened(name), at + (SAMPLE + GAP, 0.0), Align::Start);
            at.y += ROW_HEIGHT;
        }
        let rest = crowded.then(|| format!("and {} more", self.entries.len() - shown));
        for line in rest.iter().chain(&self.notes) {
            canvas.write(&shortened(line), at, Align::Start);
            at.y += ROW_HEIGHT;
        }
    }
}

fn shortened(line: &str) -> String {
    if line.chars().count() <= LONGEST {
        return line.to_owned();
    }
    line.chars().take(LONGEST - 1).chain(['…']).collect()
}
