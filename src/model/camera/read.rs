//! `[camera]`: where rays start.

use glam::DVec3;

use super::{Camera, KINDS, Stereo, StereoLayout};
use crate::document::Node;
use crate::document::reader::TableReader;
use crate::document::values::{Read, boolean, direction, number, positive, vector, word};
use crate::model::law::OBSERVER_PART;
use crate::model::{CameraFrame, Law, Order};

/// None if there is no camera, or one that cannot be used. `size` is the picture's.
pub(crate) fn read(root: &TableReader, law: Option<&dyn Law>, size: [u32; 2]) -> Option<Camera> {
    let table = root.subtable("camera", "camera")?;
    let projection = KINDS.chosen(&table).and_then(|read| read(&table));
    let position = table.required("position", "[0, 2, 15]", vector);
    let look_at = table.or("look_at", DVec3::ZERO, vector);
    let up = table.or("up", DVec3::Y, direction);
    let frame = match table.or("frame", CameraFrame::Coordinate, word(&CameraFrame::WORDS)) {
        CameraFrame::Moving(_) => {
            CameraFrame::Moving(table.required("velocity", "[0.5, 0, 0]", slower_than_light).unwrap_or_default())
        }
        frame => frame,
    };
    if frame != CameraFrame::Coordinate && law.is_some_and(|law| law.frame_part(frame).is_none()) {
        let (problem, help) = match frame {
            CameraFrame::Static => (
                "the static frame needs a law of a hole or a spacetime",
                "leave `frame` out: under other laws both frames are the same",
            ),
            _ => ("such an observer needs a law of a hole, or a \"metric\"", "leave `frame` out"),
        };
        table.fault(&["frame"], problem, help);
    }
    let time = table.or("time", 0.0, number);
    let shift = table.or("shift", false, boolean);
    if shift && law.is_some_and(|law| frame == CameraFrame::Coordinate || law.momentum_parts().is_empty()) {
        let problem = "light has a frequency only for an observer, and by a law that says it";
        let help = "choose a `frame`, with a law of a hole, of a wormhole or by a line element";
        table.fault(&["shift"], problem, help);
    }
    let stereo = stereo(&table, size);
    let camera = position.and_then(|position| {
        let [forward, right, up] = axes(&table, position, look_at, up)?;
        Some(Camera { position, forward, right, up, projection: projection?, frame, time, shift, stereo })
    });
    if let (Some(camera), Some(law)) = (&camera, law) {
        let then = law.later(time);
        check_against_law(&table, camera, then.as_deref().unwrap_or(law));
    }
    table.finish();
    camera
}

fn slower_than_light(node: &Node) -> Read<DVec3> {
    let velocity = vector(node)?;
    if velocity.length() < 1.0 { Ok(velocity) } else { Err(node.fault("the velocity must be below 1, light's", "")) }
}

/// None if there is one eye, or two that cannot be used.
fn stereo(table: &TableReader, [width, height]: [u32; 2]) -> Option<Stereo> {
    let stereo = table.subtable("stereo", "camera.stereo")?;
    let separation = stereo.required("separation", "0.065", positive);
    let layouts = &[("side-by-side", StereoLayout::SideBySide), ("top-bottom", StereoLayout::TopBottom)];
    let layout = stereo.or("layout", StereoLayout::SideBySide, word(layouts));
    let convergence = stereo.optional("convergence", positive);
    stereo.finish();
    let (side, pixels) = match layout {
        StereoLayout::SideBySide => ("wide", width),
        StereoLayout::TopBottom => ("high", height),
    };
    if pixels % 2 == 1 {
        let problem = format!("a picture that is {pixels} pixels {side} has no halves for two views");
        table.fault(&["stereo"], problem, "give image.size an even number there");
    }
    Some(Stereo { separation: separation?, layout, convergence })
}

/// Forward, right and up, orthonormal.
fn axes(table: &TableReader, position: DVec3, look_at: DVec3, up: DVec3) -> Option<[DVec3; 3]> {
    let Some(forward) = (look_at - position).try_normalize() else {
        let problem = "the camera looks at its own position";
        let help = "look_at, by default [0, 0, 0], must differ from position";
        table.fault(&["look_at", "position"], problem, help);
        return None;
    };
    let right = forward.cross(up);
    if right.length() < 1e-9 {
        let problem = "`up` is parallel to the view";
        let help = "choose another `up`, for example [0, 0, 1]";
        table.fault(&["up", "look_at", "position"], problem, help);
        return None;
    }
    let right = right.normalize();
    Some([forward, right, right.cross(forward)])
}

fn check_against_law(table: &TableReader, camera: &Camera, law: &dyn Law) {
    if !camera.is_at_one_place() && (camera.shift || law.frame_part(camera.frame) == Some(OBSERVER_PART)) {
        let help = "leave `frame` and `shift` out, or use a camera of one eye";
        table.fault(&["frame"], "an observer is at one place, and rays start at more", help);
    }
    let who = if camera.stereo.is_some() { "an eye of the camera" } else { "the camera" };
    // A plane's rays start all over it: those at such a place are captured, and the others are not.
    let eyes = if camera.projection.is_from_a_point() { camera.eyes() } else { Vec::new() };
    let refused = |eye: &DVec3| law.refuses_eye(*eye).or_else(|| law.observer(camera.frame, *eye)?.err());
    if let Some([problem, help]) = eyes.iter().find_map(refused) {
        table.fault(&["position"], format!("{who} {problem}"), help);
    }
    if let Some(why) = law.ignores_direction().filter(|_| camera.projection.is_from_a_point()) {
        let help = match law.order() {
            Order::Flow => "use kind = \"plane\" here, or order = 2 in [law]",
            Order::Place | Order::General => "use kind = \"plane\" here",
        };
        table.fault(&["kind"], format!("a camera at one point sees nothing under this law: {why}"), help);
    }
}
