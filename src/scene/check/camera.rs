//! `[camera]`: where rays start.

use crate::scene::document::Node;
use crate::scene::document::reader::TableReader;
use crate::scene::document::values::{Read, array, direction, number_where, positive, vector, word};
use crate::scene::{Camera, CameraKind, Corners, FlowOrder, Frame, Law, Stereo, StereoLayout};
use glam::DVec3;

#[derive(Clone, Copy)]
enum Name {
    Pinhole,
    Plane,
    Fisheye,
    Panorama,
}

const NAMES: &[(&str, Name)] =
    &[("pinhole", Name::Pinhole), ("plane", Name::Plane), ("fisheye", Name::Fisheye), ("panorama", Name::Panorama)];

/// None if there is no camera, or one that cannot be used. `size` is the picture's.
pub fn read(root: &TableReader, law: Option<&Law>, size: [u32; 2]) -> Option<Camera> {
    let table = root.subtable("camera", "camera")?;
    let name = table.decide("kind", Name::Pinhole, word(NAMES, &[]));
    let kind = name.and_then(|name| kind(&table, name));
    let position = table.required("position", "[0, 2, 15]", vector);
    let look_at = table.or("look_at", DVec3::ZERO, vector);
    let up = table.or("up", DVec3::Y, direction);
    let frames = &[("coordinate", Frame::Coordinate), ("static", Frame::Static)];
    let frame = table.or("frame", Frame::Coordinate, word(frames, &[]));
    if frame == Frame::Static && law.is_some_and(|law| !matches!(law, Law::Schwarzschild { .. })) {
        table.fault(
            &["frame"],
            "the static frame needs law.kind = \"schwarzschild\"",
            "leave `frame` out: under other laws both frames are the same",
        );
    }
    let stereo = stereo(&table, size);
    let camera = position.and_then(|position| {
        let [forward, right, up] = axes(&table, position, look_at, up)?;
        Some(Camera { position, forward, right, up, kind: kind?, frame, stereo })
    });
    if let (Some(camera), Some(law)) = (&camera, law) {
        check_against_law(&table, camera, law);
    }
    table.finish();
    camera
}

fn kind(table: &TableReader, name: Name) -> Option<CameraKind> {
    Some(match name {
        Name::Pinhole => {
            let angle = number_where("an angle between 0 and 180 degrees", |x| x > 0.0 && x < 180.0);
            CameraKind::Pinhole { fov: table.or("fov", 50.0, angle) }
        }
        Name::Plane => CameraKind::Plane { height: table.required("height", "10", positive)? },
        Name::Fisheye => {
            // Beyond that f32 has no place for the middle of a turn.
            let angle = number_where("an angle above 0 and up to 1000000 degrees", |x| x > 0.0 && x <= 1e6);
            let choices = &[("black", Corners::Black), ("transparent", Corners::Transparent)];
            let corners = table.or("corners", Corners::Black, word(choices, &[]));
            CameraKind::Fisheye { fov: table.or("fov", 180.0, angle), corners }
        }
        Name::Panorama => CameraKind::Panorama { fov: table.or("fov", [360.0, 180.0], sides) },
    })
}

/// A panorama's angles, across and upwards.
fn sides(node: &Node) -> Read<[f64; 2]> {
    let angles: [f64; 2] = array("two angles in degrees, [across, upwards]", positive)(node)?;
    if angles[0] > 360.0 || angles[1] > 180.0 {
        let problem = format!("expected angles of up to [360, 180] degrees, found {angles:?}");
        return Err(node.fault(problem, "that is all there is to see, from end to end"));
    }
    Ok(angles)
}

/// None if there is one eye, or two that cannot be used.
fn stereo(table: &TableReader, [width, height]: [u32; 2]) -> Option<Stereo> {
    let stereo = table.subtable("stereo", "camera.stereo")?;
    let separation = stereo.required("separation", "0.065", positive);
    let layouts = &[("side-by-side", StereoLayout::SideBySide), ("top-bottom", StereoLayout::TopBottom)];
    let layout = stereo.or("layout", StereoLayout::SideBySide, word(layouts, &[]));
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

fn check_against_law(table: &TableReader, camera: &Camera, law: &Law) {
    let eyes = camera.eyes();
    let who = if camera.stereo.is_some() { "an eye of the camera" } else { "the camera" };
    match law {
        Law::Schwarzschild { mass, center, .. } => {
            let r = eyes.iter().map(|eye| eye.distance(*center)).fold(f64::INFINITY, f64::min);
            if r <= 2.0 * mass {
                let problem = format!("{who} is inside the horizon: r = {r:.4} ≤ 2M = {}", 2.0 * mass);
                table.fault(&["position"], problem, "move it away from the hole");
            }
        }
        Law::Sources(sources) => {
            let inside = |source: &&crate::scene::Source| {
                source.capture > 0.0 && eyes.iter().any(|eye| eye.distance(source.position) <= source.capture)
            };
            if let Some(source) = sources.iter().find(inside) {
                let [x, y, z] = source.position.to_array();
                let problem =
                    format!("{who} is inside the capture radius {} of the source at [{x}, {y}, {z}]", source.capture);
                table.fault(&["position"], problem, "move it away from the source");
            }
        }
        Law::Medium(medium) if medium.index(camera.position) == Some(0.0) => {
            table.fault(
                &["position"],
                "the index is 0 at the camera, where no light comes",
                "move it to where n is above 0",
            );
        }
        Law::Flow { order: FlowOrder::Velocity, .. } if !matches!(camera.kind, CameraKind::Plane { .. }) => table
            .fault(
                &["kind"],
                "a camera at one point sees nothing in a flow of order 1: all rays from there follow the same orbit",
                "use kind = \"plane\" here, or order = 2 in [law]",
            ),
        _ => {}
    }
}
