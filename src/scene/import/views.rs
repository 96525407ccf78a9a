//! The import of cameras: the first becomes the scene's, and the others are written as comments.

use glam::DVec3;

use super::Extent;
use super::text::{Left, number, vector};
use crate::assets::json::Camera;
use crate::assets::{Gltf, Placed};

/// The placement and projection of a camera.
struct View {
    name: String,
    position: DVec3,
    forward: DVec3,
    up: DVec3,
    /// The keys of its projection.
    kind: String,
    /// The aspect ratio: width divided by height.
    aspect: f64,
}

/// Returns the tables of the camera and of its image, and the positions of all cameras, at least one.
pub(super) fn cameras(file: &Gltf, nodes: &[Placed], extent: &Extent, left: &mut Left) -> (String, Vec<DVec3>) {
    let mut views: Vec<View> = Vec::new();
    for placed in nodes {
        let Some(camera) = placed.node.camera.and_then(|index| file.root.get(index)) else { continue };
        let names = [&placed.node.name, &camera.name].into_iter().flatten().next();
        let name = names.cloned().unwrap_or_else(|| format!("node {}", placed.number));
        match view(placed, camera, &name) {
            Some(view) => views.push(view),
            None => left.out("cameras without a valid projection", &name),
        }
    }
    if views.is_empty() {
        left.added("a camera that shows the whole scene, because the file has none");
        let forward = -DVec3::new(0.6, 0.4, 1.0).normalize();
        let (position, kind) = (extent.center() - 3.0 * extent.radius() * forward, "fov = 45\n".to_owned());
        views.push(View { name: "camera".to_owned(), position, forward, up: DVec3::Y, kind, aspect: 4.0 / 3.0 });
    }
    let distance = |view: &View| (extent.center() - view.position).dot(view.forward).max(extent.radius());
    let table = |view: &View| {
        let at = view.position + distance(view) * view.forward;
        let (position, at, up) = (vector(view.position), vector(at), vector(view.up));
        format!("[camera]\n{}position = {position}\nlook_at = {at}\nup = {up}\n", view.kind)
    };
    let width = (600.0 * views[0].aspect).round().clamp(1.0, 65_536.0);
    let mut text = format!("[image]\nsize = [{width}, 600]\nsamples = 4\n\n{}", table(&views[0]));
    for other in &views[1..] {
        left.out("cameras other than the first, which become comments in the scene", &other.name);
        let lines: Vec<String> = table(other).lines().map(|line| format!("# {line}")).collect();
        text.extend([format!("\n# The camera {}:\n{}\n", other.name.replace(char::is_control, " "), lines.join("\n"))]);
    }
    (text, views.iter().map(|view| view.position).collect())
}

fn view(placed: &Placed, camera: &Camera, name: &str) -> Option<View> {
    let (kind, aspect) = match (&camera.perspective, &camera.orthographic) {
        (Some(perspective), _) => {
            let fov = f64::from(perspective.yfov).to_degrees();
            let kind = (fov > 0.0 && fov < 180.0).then(|| format!("fov = {}\n", number(fov)))?;
            (kind, perspective.aspect_ratio.map_or(4.0 / 3.0, f64::from))
        }
        (None, Some(plane)) => {
            let (width, height) = (2.0 * f64::from(plane.xmag), 2.0 * f64::from(plane.ymag));
            let kind = (height > 0.0).then(|| format!("kind = \"orthographic\"\nheight = {}\n", number(height)))?;
            (kind, width / height)
        }
        (None, None) => return None,
    };
    let [up, back] = [placed.world.matrix3.y_axis, placed.world.matrix3.z_axis].map(DVec3::try_normalize);
    let (forward, position) = (-back?, placed.world.translation);
    let aspect = if aspect > 0.0 { aspect } else { 4.0 / 3.0 };
    Some(View { name: name.to_owned(), position, forward, up: up?, kind, aspect })
}
