//! `[camera]`: where rays start.

use crate::scene::document::reader::TableReader;
use crate::scene::document::values::{direction, number_where, positive, vector, word};
use crate::scene::{Camera, CameraKind, FlowOrder, Frame, Law};
use glam::DVec3;

#[derive(Clone, Copy)]
enum Name {
    Pinhole,
    Plane,
}

/// None if there is no camera, or one that cannot be used.
pub fn read(root: &TableReader, law: Option<&Law>) -> Option<Camera> {
    let table = root.subtable("camera", "camera")?;
    let names = &[("pinhole", Name::Pinhole), ("plane", Name::Plane)];
    let name = table.decide("kind", Name::Pinhole, word(names, &["fisheye", "panorama"]));
    let kind = name.and_then(|name| match name {
        Name::Pinhole => {
            let angle = number_where("an angle between 0 and 180 degrees", |x| x > 0.0 && x < 180.0);
            let fov = table.or("fov", 50.0, angle);
            Some(CameraKind::Pinhole { fov })
        }
        Name::Plane => {
            let height = table.required("height", "10", positive)?;
            Some(CameraKind::Plane { height })
        }
    });
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
    let camera = position.and_then(|position| {
        let [forward, right, up] = axes(&table, position, look_at, up)?;
        Some(Camera { position, forward, right, up, kind: kind?, frame })
    });
    if let (Some(camera), Some(law)) = (&camera, law) {
        check_against_law(&table, camera, law);
    }
    table.finish();
    camera
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
    match law {
        Law::Schwarzschild { mass, center, .. } => {
            let r = camera.position.distance(*center);
            if r <= 2.0 * mass {
                let problem = format!("the camera is inside the horizon: r = {r:.4} ≤ 2M = {}", 2.0 * mass);
                table.fault(&["position"], problem, "move it away from the hole");
            }
        }
        Law::Sources(sources) => {
            let inside = |source: &&crate::scene::Source| {
                source.capture > 0.0 && camera.position.distance(source.position) <= source.capture
            };
            if let Some(source) = sources.iter().find(inside) {
                let [x, y, z] = source.position.to_array();
                let problem = format!(
                    "the camera is inside the capture radius {} of the source at [{x}, {y}, {z}]",
                    source.capture
                );
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
        Law::Flow { order: FlowOrder::Velocity, .. } if matches!(camera.kind, CameraKind::Pinhole { .. }) => table
            .fault(
                &["kind"],
                "a pinhole camera in a flow of order 1 sees nothing: all rays from one point follow the same orbit",
                "use kind = \"plane\" here, or order = 2 in [law]",
            ),
        _ => {}
    }
}
