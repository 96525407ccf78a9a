//! Axes: the range of data, and the positions and labels of ticks.
//!
//! A logarithmic axis is a linear axis of decimal logarithms, whose ticks are labeled with the original numbers.

use std::ops::Range;

/// The approximate number of ticks of an axis.
const TICKS: f64 = 7.0;
/// The padding of the range beyond the data, relative to its width.
const PADDING: f64 = 0.04;

/// An axis in plot coordinates, which are data or their decimal logarithms.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Axis {
    pub label: String,
    pub range: Range<f64>,
    log: bool,
}

impl Axis {
    /// Creates an axis for the range of `values`, which are in plot coordinates.
    pub fn around(label: &str, log: bool, values: impl Iterator<Item = f64>) -> Self {
        let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(v), high.max(v)));
        let (low, high) = if low > high { (0.0, 1.0) } else { (low, high) };
        // A single value gets a range around it of about its magnitude.
        let least = 1e-9 * low.abs().max(high.abs());
        let padding =
            if high - low <= least { if low == 0.0 { 1.0 } else { 0.5 * low.abs() } } else { PADDING * (high - low) };
        Self { label: label.to_owned(), range: low - padding..high + padding, log }
    }

    /// Creates a linear axis over exactly this range.
    pub fn over(label: &str, range: Range<f64>) -> Self {
        Self { label: label.to_owned(), range, log: false }
    }

    /// Returns the extent in plot coordinates.
    pub fn span(&self) -> f64 {
        self.range.end - self.range.start
    }

    /// Widens the range to `span` around its center.
    pub fn widen(&mut self, span: f64) {
        let middle = f64::midpoint(self.range.start, self.range.end);
        self.range = middle - span / 2.0..middle + span / 2.0;
    }

    /// Returns the positions and labels of the ticks.
    pub fn ticks(&self) -> Vec<(f64, String)> {
        if !self.log {
            return linear_ticks(&self.range).into_iter().map(|at| (at, number(at))).collect();
        }
        let mut ticks = log_ticks(&self.range);
        if ticks.len() < 2 {
            let values = 10f64.powf(self.range.start)..10f64.powf(self.range.end);
            ticks = linear_ticks(&values).into_iter().map(f64::log10).collect();
        }
        ticks.into_iter().map(|at| (at, number(10f64.powf(at)))).collect()
    }
}

/// Returns the position of a value on a linear or logarithmic axis, if it has one.
pub(super) fn place(value: f64, log: bool) -> Option<f64> {
    let at = if log { value.log10() } else { value };
    at.is_finite().then_some(at)
}

/// Returns multiples of 1, 2 or 5 times a power of ten.
fn linear_ticks(range: &Range<f64>) -> Vec<f64> {
    let rough = (range.end - range.start) / TICKS;
    let decade = 10f64.powf(rough.log10().floor());
    let step =
        [1.0, 2.0, 5.0, 10.0].into_iter().map(|m| m * decade).find(|step| *step >= rough).unwrap_or(10.0 * decade);
    let first = (range.start / step).ceil() as i64;
    let last = (range.end / step).floor() as i64;
    (first..=last).map(|i| i as f64 * step).collect()
}

/// Returns powers of ten; for few decades also their multiples by 2 and 5, for many decades only some.
fn log_ticks(range: &Range<f64>) -> Vec<f64> {
    let decades = range.end - range.start;
    let every = (decades / TICKS).ceil().max(1.0) as i64;
    let within: &[f64] = if decades <= 3.0 { &[1.0, 2.0, 5.0] } else { &[1.0] };
    (range.start.floor() as i64..=range.end.ceil() as i64)
        .filter(|decade| decade.rem_euclid(every) == 0)
        .flat_map(|decade| within.iter().map(move |m| decade as f64 + m.log10()))
        .filter(|tick| range.contains(tick))
        .collect()
}

/// Formats a number to twelve digits, with an exponent if this is shorter.
fn number(value: f64) -> String {
    let tidy: f64 = format!("{value:.11e}").parse().unwrap_or(value);
    if tidy == 0.0 {
        "0".into()
    } else if (1e-3..1e6).contains(&tidy.abs()) {
        format!("{tidy}")
    } else {
        format!("{tidy:e}")
    }
}
