//! The legend: a column beside the plot, with a line for each series.

use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::{Area, CANVAS, Drawn, LABEL_SIZE, MARGIN, style::Look, write};

const ANCHOR: Pos = Pos { h_pos: HPos::Left, v_pos: VPos::Center };
const ROW_HEIGHT: i32 = 44;
/// Length of the sample of line before a name.
const SAMPLE: i32 = 90;
const GAP: i32 = 14;
/// Width of a character in parts of the font size, about: the library has no font to measure.
const CHARACTER: f64 = 0.56;
/// Rows that fit between the margins.
const ROWS: usize = ((CANVAS.1 - 2 * MARGIN) / ROW_HEIGHT as u32) as usize;
/// Characters of a line that are shown, at most.
const LONGEST: usize = 28;

/// What the legend says: names with the looks they explain, and lines of plain text below.
#[derive(Debug, Clone, Default)]
pub(super) struct Legend {
    pub entries: Vec<(String, Look)>,
    pub notes: Vec<String>,
}

impl Legend {
    /// The looks of series of these names, and how many of their points have no place in the plot.
    pub fn of<'a>(names: impl Iterator<Item = &'a String>, missing: usize) -> Self {
        Self {
            entries: names.enumerate().map(|(i, name)| (name.clone(), Look::of(i))).collect(),
            notes: match missing {
                0 => Vec::new(),
                1 => vec!["1 point has no place".into()],
                n => vec![format!("{n} points have no place")],
            },
        }
    }

    /// The width of the column in pixels; none if there is nothing to say.
    pub fn width(&self) -> u32 {
        let names = self.entries.iter().map(|(name, _)| text_width(name) + SAMPLE + GAP);
        let notes = self.notes.iter().map(|note| text_width(note));
        let widest = names.chain(notes).max();
        widest.map_or(0, |w| w as u32 + MARGIN)
    }

    /// Draws the column at the right edge of the canvas.
    pub fn draw(&self, canvas: &Area) -> Drawn<()> {
        let left = (CANVAS.0 - self.width()).cast_signed();
        let mut y = MARGIN.cast_signed() + ROW_HEIGHT / 2;
        let room = ROWS - self.notes.len();
        let crowded = self.entries.len() > room;
        let shown = if crowded { room - 1 } else { self.entries.len() };
        for (name, look) in &self.entries[..shown] {
            look.stroke(canvas, vec![(left, y), (left + SAMPLE, y)])?;
            look.mark(canvas, (left + SAMPLE / 2, y))?;
            write(canvas, &shortened(name), (left + SAMPLE + GAP, y), ANCHOR)?;
            y += ROW_HEIGHT;
        }
        let rest = crowded.then(|| format!("and {} more", self.entries.len() - shown));
        for line in rest.iter().chain(&self.notes) {
            write(canvas, &shortened(line), (left, y), ANCHOR)?;
            y += ROW_HEIGHT;
        }
        Ok(())
    }
}

/// The width of a line in pixels, about.
pub(super) fn text_width(line: &str) -> i32 {
    let characters = line.chars().count().min(LONGEST) as f64;
    (characters * CHARACTER * f64::from(LABEL_SIZE)).ceil() as i32
}

fn shortened(line: &str) -> String {
    if line.chars().count() <= LONGEST {
        return line.to_owned();
    }
    line.chars().take(LONGEST - 1).chain(['…']).collect()
}
