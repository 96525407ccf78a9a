//! The reader of `[animation]`: values of the scene that change from frame to frame.
//!
//! *Theory.* A frame is the scene with the value of each track substituted for its key, exactly as by `--set`. Every numeric value can
//! therefore be animated, and a frame can be rendered again as a still. Between two keyframes a value is linear or *smooth*: a cubic whose
//! slope at a keyframe is the slope between its neighbors (Catmull–Rom), and zero at both ends.
//!
//! *Practice.* Tracks are read even if no frame is requested, so that every command reports their errors. Their values are checked when
//! they are read, like all others, and an error is located at the track's value.

use crate::document::reader::{Reader, TableReader};
use crate::document::values::{Parsed, number, number_where, text, whole, word};
use crate::document::{Document, Node, Quantity, Span, SpannedError, Value, names};

/// The contents of `[animation]`.
pub struct Tracks {
    pub frames: u32,
    /// The number of frames per second.
    pub rate: f64,
    /// The fraction of the frame interval during which the shutter is open.
    pub shutter: f64,
    /// The largest number of shutter samples of one frame.
    pub moments: u32,
    all: Vec<Track>,
}

/// A table `[[animation.tracks]]`.
struct Track {
    key: String,
    place: Span,
    /// The names that lead to the key.
    path: Vec<String>,
    /// The frames in ascending order; `values` has one value for each.
    at: Vec<f64>,
    values: Vec<Node>,
    smooth: bool,
}

/// Reads the table; returns `None` without it or after an error.
pub fn read(root: &TableReader) -> Option<Tracks> {
    let table = root.subtable("animation", "animation")?;
    let frames = table.required("frames", "48", whole(1..=1_000_000));
    let rate =
        table.or("rate", 24.0, number_where("frames per second, from 0.1 to 1000", |x| (0.1..=1000.0).contains(&x)));
    let shutter = number_where("a fraction of the frame interval, from 0 to 1", |x| (0.0..=1.0).contains(&x));
    let shutter = table.or("shutter", 0.0, shutter);
    let moments = table.or("shutter_samples", 64, power_of_two);
    let mut tracks: Vec<Track> = Vec::new();
    for one in table.subtables("tracks", "animation.tracks") {
        let Some(track) = track(one, frames.unwrap_or(1)) else { continue };
        if tracks.iter().any(|other| other.path == track.path) {
            table.reader.fault(SpannedError {
                place: track.place,
                problem: format!("`{}` already has a track", track.key),
                help: "put all values of the key into one track".to_owned(),
            });
        }
        tracks.push(track);
    }
    table.finish();
    Some(Tracks { frames: frames?, rate, shutter, moments, all: tracks })
}

fn track(table: TableReader, frames: u32) -> Option<Track> {
    let key = table.required("key", "\"camera.position\"", |node| Ok((path(node)?, node)));
    let values = table.required("values", "[[0, 2, 15], [5, 2, 14]]", values);
    let count = values.as_ref().map_or(0, Vec::len);
    let last = f64::from(frames - 1);
    let evenly = (0..count).map(|i| last * i as f64 / (count.max(2) - 1) as f64).collect();
    let at = table.or("keyframes", evenly, |node| ascending(node, count));
    let smooth = table.or("interpolation", false, word(&[("linear", false), ("smooth", true)]));
    table.finish();
    let ((path, node), values) = (key?, values?);
    Some(Track { key: path.join("."), place: node.place, path, at, values, smooth })
}

/// The largest number of shutter samples of a frame, because each requires a separate scene.
const MOST_MOMENTS: u32 = 1024;

fn power_of_two(node: &Node) -> Parsed<u32> {
    let moments = whole(2..=MOST_MOMENTS)(node)?;
    if moments.is_power_of_two() { Ok(moments) } else { Err(node.expected("a power of two, 2 to 1024")) }
}

/// Reads the names of a key that can be set.
fn path(node: &Node) -> Parsed<Vec<String>> {
    let help = "use names joined by dots, as in --set: camera.position, objects.0.radius";
    let path = names(text(node)?).ok_or_else(|| node.fault("not a valid key", help))?;
    if path[0] == "animation" {
        return Err(node.fault("[animation] cannot animate its own keys", help));
    }
    Ok(path)
}

/// Reads numbers, or arrays of numbers with equal shapes.
fn values(node: &Node) -> Parsed<Vec<Node>> {
    let Value::Array(items) = &node.value else {
        return Err(node.expected("an array with a value for each keyframe"));
    };
    let Some(first) = items.first() else {
        return Err(node.fault("a track requires at least one value", ""));
    };
    for item in items {
        numbers(item)?;
        if !same_shape(first, item) {
            let problem = "this value and the first value of the track have different shapes or kinds of units";
            return Err(item.fault(problem, ""));
        }
    }
    Ok(items.clone())
}

fn numbers(node: &Node) -> Parsed<()> {
    match &node.value {
        Value::Array(items) => items.iter().try_for_each(numbers),
        Value::Integer(_) | Value::Float(_) => number(node).map(|_| ()),
        Value::Quantity(_) => Ok(()),
        _ => Err(node.expected("a number or an array of numbers, because other values cannot be interpolated")),
    }
}

fn same_shape(a: &Node, b: &Node) -> bool {
    match (&a.value, &b.value) {
        (Value::Array(a), Value::Array(b)) => a.len() == b.len() && a.iter().zip(b).all(|(a, b)| same_shape(a, b)),
        (Value::Quantity(a), Value::Quantity(b)) => a.dimension == b.dimension,
        (Value::Array(_) | Value::Quantity(_), _) | (_, Value::Array(_) | Value::Quantity(_)) => false,
        _ => true,
    }
}

/// Reads one frame per value, in ascending order.
fn ascending(node: &Node, count: usize) -> Parsed<Vec<f64>> {
    let Value::Array(items) = &node.value else {
        return Err(node.expected("an array of frame numbers"));
    };
    let at = items.iter().map(number).collect::<Parsed<Vec<f64>>>()?;
    if count > 0 && at.len() != count {
        return Err(node.fault(format!("{} keyframes for {count} values", at.len()), "give one keyframe per value"));
    }
    match at.windows(2).position(|pair| pair[0] >= pair[1]) {
        Some(i) => Err(items[i + 1].fault("keyframes must ascend", format!("use a frame after {}", at[i]))),
        None => Ok(at),
    }
}

/// Substitutes the values of a frame, or of a time between two, into the document; `frame_of` returns the frame of each track from its key.
/// Errors of the tracks are reported when the whole document is read.
pub fn apply(document: &mut Document, frame_of: &dyn Fn(&str) -> f64) {
    let tracks = read(&Reader::new(document, &[]).root());
    for track in tracks.iter().flat_map(|tracks| &tracks.all) {
        let value = track.value(frame_of(&track.key));
        document.animate(&track.path, value, track.place);
    }
}

impl Tracks {
    /// Returns the animated keys.
    pub fn keys(&self) -> Vec<String> {
        self.all.iter().map(|track| track.key.clone()).collect()
    }
}

impl Track {
    fn value(&self, frame: f64) -> Node {
        let next = self.at.partition_point(|at| *at <= frame);
        let around = [next.saturating_sub(2), next.saturating_sub(1), next, next + 1];
        let around = around.map(|i| i.min(self.at.len() - 1));
        let ([_, from, to, _], at) = (around, around.map(|i| self.at[i]));
        if next == 0 || from == to {
            return floats(&self.values[from]);
        }
        let weights = if self.smooth { smooth(at, frame) } else { linear(at, frame) };
        mixed(around.map(|i| &self.values[i]), weights)
    }
}

/// Returns the weights of four values around a frame, at the frames `at`; only the two adjacent ones are not zero.
fn linear([_, from, to, _]: [f64; 4], frame: f64) -> [f64; 4] {
    let t = (frame - from) / (to - from);
    [0.0, 1.0 - t, t, 0.0]
}

/// Returns the weights of the cubic Hermite spline with slopes (v₂ − v₀)/(t₂ − t₀) and (v₃ − v₁)/(t₃ − t₁), and 0 at an end.
fn smooth([before, from, to, after]: [f64; 4], frame: f64) -> [f64; 4] {
    let (span, t) = (to - from, (frame - from) / (to - from));
    let slope = |exists: bool, across: f64, basis: f64| if exists { span * basis / across } else { 0.0 };
    let first = slope(before < from, to - before, t * (1.0 - t) * (1.0 - t));
    let second = slope(to < after, after - from, t * t * (t - 1.0));
    let rise = t * t * (3.0 - 2.0 * t);
    [-first, 1.0 - rise - second, rise + first, second]
}

/// Returns the weighted sum of four values with equal shapes, at the location of the second.
fn mixed(nodes: [&Node; 4], weights: [f64; 4]) -> Node {
    let sum = |of: &dyn Fn(&Node) -> f64| -> f64 {
        let terms = nodes.into_iter().zip(weights).filter(|(_, weight)| *weight != 0.0);
        terms.map(|(node, weight)| weight * of(node)).sum()
    };
    let value = match &nodes[1].value {
        Value::Array(items) => {
            let item = |i: usize| mixed(nodes.map(|node| item_of(node, i)), weights);
            Value::Array((0..items.len()).map(item).collect())
        }
        Value::Quantity(read) => {
            let of = |node: &Node, value: fn(&Quantity) -> f64| match &node.value {
                Value::Quantity(read) => value(read),
                _ => f64::NAN,
            };
            let si = sum(&|node| of(node, |read| read.si));
            let value = read.value.map(|_| sum(&|node| of(node, |read| read.value.unwrap_or(f64::NAN))));
            Value::Quantity(Quantity { text: format!("{si:e} in SI units"), si, value, ..read.clone() })
        }
        _ => Value::Float(sum(&plain)),
    };
    Node { place: nodes[1].place, value }
}

fn item_of(node: &Node, i: usize) -> &Node {
    match &node.value {
        Value::Array(items) => &items[i],
        _ => node,
    }
}

fn floats(node: &Node) -> Node {
    mixed([node; 4], [0.0, 1.0, 0.0, 0.0])
}

fn plain(node: &Node) -> f64 {
    match node.value {
        Value::Integer(value) => value as f64,
        Value::Float(value) => value,
        // Tracks contain no other values.
        _ => f64::NAN,
    }
}
