//! The reader of `[camera]`.

use glam::{DVec3, DVec4};

use super::{Camera, Event, KINDS, Path, Stereo, StereoLayout, WorldlineError, fall};
use crate::document::reader::TableReader;
use crate::document::values::{
    Parsed, boolean, direction, length, not_negative_time, point, positive_length, time, vector, word,
};
use crate::document::{Node, SpannedError, Value};
use crate::model::law::OBSERVER_PART;
use crate::model::{Law, Observer, Order};

/// Reads the camera; returns `None` after an error. `size` is the size of the image in pixels.
pub(crate) fn read(root: &TableReader, law: Option<&dyn Law>, size: [u32; 2]) -> Option<Camera> {
    let table = root.subtable("camera", "camera")?;
    let projection = KINDS.chosen(&table).and_then(|read| read(&table));
    let seat = seat(&table, law);
    let frame = seat.as_ref().map_or(Observer::Coordinate, |seat| seat.frame);
    let look_at = table.or("look_at", DVec3::ZERO, point);
    let up = table.or("up", DVec3::Y, direction);
    let shift = table.or("redshift", false, boolean);
    let hues = shift && table.or("color_shift", false, word(&[("kept", false), ("black-body", true)]));
    if shift && law.is_some_and(|law| frame == Observer::Coordinate || law.facts().momentum_parts.is_empty()) {
        let problem = "`redshift` requires an observer, and a law that defines the frequency of light";
        let help = "set `observer`, and use the law of a black hole or wormhole, or kind = \"metric\"";
        table.fault(&["redshift"], problem, help);
    }
    let stereo = stereo(&table, size);
    let camera = seat.and_then(|Seat { position, frame, time }| {
        let [forward, right, up] = axes(&table, position, look_at, up)?;
        Some(Camera {
            position,
            forward,
            distance: position.distance(look_at),
            right,
            up,
            projection: projection?,
            observer: frame,
            time,
            redshift: shift,
            color_shift: hues,
            stereo,
        })
    });
    if let (Some(camera), Some(law)) = (&camera, law) {
        let then = law.seen(None, camera.time);
        check_against_law(&table, camera, then.as_deref().unwrap_or(law));
    }
    table.finish();
    camera
}

/// The position, frame and time of the observer.
struct Seat {
    position: DVec3,
    frame: Observer,
    time: f64,
}

fn seat(table: &TableReader, law: Option<&dyn Law>) -> Option<Seat> {
    if let Some(node) = table.node("worldline") {
        return on_worldline(table, node, law);
    }
    let position = table.required("position", "[0, 2, 15]", point);
    let frame = frame(table, law);
    let time = table.or("time", 0.0, time);
    let proper = table.optional("proper_time", not_negative_time);
    let seat = Seat { position: position?, frame, time };
    match proper {
        Some(proper) => after_fall(table, seat, law?, proper),
        None => Some(seat),
    }
}

fn frame(table: &TableReader, law: Option<&dyn Law>) -> Observer {
    let frame = match table.or("observer", Observer::Coordinate, word(&Observer::WORDS)) {
        Observer::Boosted(_) => {
            Observer::Boosted(table.required("velocity", "[0.5, 0, 0]", slower_than_light).unwrap_or_default())
        }
        frame => frame,
    };
    if frame != Observer::Coordinate && law.is_some_and(|law| law.frame_part(frame).is_none()) {
        let (problem, help) = match frame {
            Observer::Static => (
                "observer = \"static\" requires the law of a black hole or a spacetime",
                "remove `observer`; under other laws, the static and the coordinate frame are the same",
            ),
            _ => (
                "this observer requires the law of a black hole, or law.kind = \"metric\"",
                "use observer = \"static\", or remove `observer`",
            ),
        };
        table.fault(&["observer"], problem, help);
    }
    frame
}

/// Returns the state of a freely falling observer after the proper time `proper`.
fn after_fall(table: &TableReader, seat: Seat, law: &dyn Law, proper: f64) -> Option<Seat> {
    if seat.frame == Observer::Coordinate {
        let help = "set `observer`, which defines the initial motion";
        table.fault(&["proper_time"], "`proper_time` requires an observer", help);
        return None;
    }
    let then = law.seen(None, seat.time);
    let law = then.as_deref().unwrap_or(law);
    // Other code reports an invalid start.
    let Some(Ok(u)) = law.observer(seat.frame, seat.position) else { return Some(seat) };
    match fall(law, Event { x: seat.position, t: 0.0, u }, proper) {
        Ok(event) => {
            let frame = Observer::Boosted(event.velocity(law)?);
            Some(Seat { position: event.x, frame, time: seat.time + event.t })
        }
        Err(end) => {
            let problem = format!("the observer's path ends at proper time {end:.4}");
            table.fault(&["proper_time"], problem, "use a smaller `proper_time`");
            None
        }
    }
}

/// Reads `worldline`: rows of t, x, y and z.
fn on_worldline(table: &TableReader, node: &Node, law: Option<&dyn Law>) -> Option<Seat> {
    let proper = table.or("proper_time", 0.0, not_negative_time);
    let Value::Array(items) = &node.value else {
        table.reader.fault(node.expected("an array of [t, x, y, z]"));
        return None;
    };
    let points: Option<Vec<DVec4>> = items.iter().map(|item| table.reader.accept(event(item))).collect();
    if items.len() < 2 {
        table
            .reader
            .fault(node.fault("a worldline requires at least two events", "for example [[0, 9, 0, 0], [20, 5, 0, 0]]"));
        return None;
    }
    let (points, law) = (points?, law?);
    if law.metric(points[0].truncate(), 0.0).is_none() {
        let help = "use the law of a black hole or wormhole, or law.kind = \"metric\" or \"straight\"";
        table.fault(&["worldline"], "observers are not defined under this law", help);
        return None;
    }
    let (fault, help) = match Path::through(points).and_then(|path| path.after(law, proper)) {
        Ok(event) => {
            let frame = Observer::Boosted(event.velocity(law)?);
            return Some(Seat { position: event.x, frame, time: event.t });
        }
        Err(WorldlineError::NotLater(i)) => (items[i].fault("this event is not later than the previous event", ""), ""),
        Err(WorldlineError::TooFast(i)) => (
            items[i].fault("the observer would reach this event at the speed of light or faster", ""),
            "increase the time of this event",
        ),
        Err(WorldlineError::Ends(end)) => {
            let node = table.node("proper_time").unwrap_or(node);
            (
                node.fault(format!("the worldline ends at proper time {end:.6}"), ""),
                "use a smaller `proper_time`, or add events",
            )
        }
    };
    table.reader.fault(SpannedError { help: help.to_owned(), ..fault });
    None
}

/// Reads t, x, y and z, and returns x, y, z and t.
fn event(node: &Node) -> Parsed<DVec4> {
    let expected = || node.expected("[t, x, y, z]");
    let Value::Array(items) = &node.value else { return Err(expected()) };
    let [t, x, y, z] = &items[..] else { return Err(expected()) };
    Ok(DVec4::new(length(x)?, length(y)?, length(z)?, time(t)?))
}

fn slower_than_light(node: &Node) -> Parsed<DVec3> {
    let velocity = vector(node)?;
    if velocity.length() < 1.0 {
        Ok(velocity)
    } else {
        Err(node.fault("the velocity must be below 1, the speed of light", ""))
    }
}

/// Reads the pair of eyes; returns `None` for a single eye or after an error.
fn stereo(table: &TableReader, [width, height]: [u32; 2]) -> Option<Stereo> {
    let stereo = table.subtable("stereo", "camera.stereo")?;
    let separation = stereo.required("separation", "0.065", positive_length);
    let layouts = &[("side-by-side", StereoLayout::SideBySide), ("top-bottom", StereoLayout::TopBottom)];
    let layout = stereo.or("layout", StereoLayout::SideBySide, word(layouts));
    let convergence = stereo.optional("convergence", positive_length);
    stereo.finish();
    let (side, pixels) = match layout {
        StereoLayout::SideBySide => ("wide", width),
        StereoLayout::TopBottom => ("high", height),
    };
    if pixels % 2 == 1 {
        let problem = format!("an image {pixels} pixels {side} cannot be divided into two equal views");
        table.fault(&["stereo"], problem, "use an even number in image.size");
    }
    Some(Stereo { separation: separation?, layout, convergence })
}

/// Returns the orthonormal vectors forward, right and up.
fn axes(table: &TableReader, position: DVec3, look_at: DVec3, up: DVec3) -> Option<[DVec3; 3]> {
    let Some(forward) = (look_at - position).try_normalize() else {
        let problem = "the camera looks at its own position";
        let help = "change `look_at`, by default [0, 0, 0], or `position`";
        table.fault(&["look_at", "position"], problem, help);
        return None;
    };
    let right = forward.cross(up);
    if right.length() < 1e-9 {
        let problem = "`up` is parallel to the viewing direction";
        let help = "choose another `up`, for example [0, 0, 1]";
        table.fault(&["up", "look_at", "position"], problem, help);
        return None;
    }
    let right = right.normalize();
    Some([forward, right, right.cross(forward)])
}

fn check_against_law(table: &TableReader, camera: &Camera, law: &dyn Law) {
    if !camera.is_at_one_place() && (camera.redshift || law.frame_part(camera.observer) == Some(OBSERVER_PART)) {
        let help = "remove `observer` and `redshift`, or use a camera with a single viewpoint";
        table.fault(&["observer"], "an observer requires a single viewpoint, and this camera has several", help);
    }
    let who = if camera.stereo.is_some() { "an eye of the camera" } else { "the camera" };
    // Rays of an orthographic camera start all over a plane; only those inside a capture region are captured.
    let eyes = if camera.projection.is_from_a_point() { camera.eyes() } else { Vec::new() };
    let refused = |eye: &DVec3| law.refuses_eye(*eye).or_else(|| law.observer(camera.observer, *eye)?.err());
    if let Some([problem, help]) = eyes.iter().find_map(refused) {
        table.fault(&["position"], format!("{who} {problem}"), help);
    }
    if let Some(why) = law.facts().ignores_direction.filter(|_| camera.projection.is_from_a_point()) {
        let help = match law.facts().order {
            Order::Flow => "use kind = \"orthographic\" here, or order = 2 in [law]",
            Order::Place | Order::General => "use kind = \"orthographic\" here",
        };
        table.fault(&["kind"], format!("a camera at one point cannot be used under this law: {why}"), help);
    }
}
