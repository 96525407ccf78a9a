//! The reference frame of an observer in curved spacetime: the directions that they see as forward, up and right.
//!
//! *Theory.* An observer of four-velocity u has three unit vectors that are orthogonal to u and to each other. The observer sees a
//! direction d along the past-directed null vector K = −u + `d_r` `e_r` + `d_u` `e_u` + `d_f` `e_f`, which includes aberration.
//!
//! *Practice.* The host computes the frame once in 64 bits. The shader input is linear in d for every metric and observer. Four-vectors
//! have three spatial components followed by the time component.

use glam::{DMat4, DVec3, DVec4};

use super::Camera;
use crate::model::{Law, Observer, Row, row};

/// Returns the observer's right, up and forward vectors by Gram–Schmidt from the scene's vectors in the order forward, up, right.
fn tetrad(metric: &DMat4, u: DVec4, [right, up, forward]: [DVec3; 3]) -> [DVec4; 3] {
    let product = |a: DVec4, b: DVec4| a.dot(*metric * b);
    let mut found: Vec<DVec4> = Vec::new();
    for axis in [forward, up, right] {
        let mut e = axis.extend(0.0);
        e += product(u, e) * u;
        for &other in &found {
            e -= product(other, e) * other;
        }
        found.push(e / product(e, e).sqrt());
    }
    [found[2], found[1], found[0]]
}

/// Returns an observer's unit vectors along the scene's `[right, up, forward]` at a position; `None` without such an observer.
pub fn frame(law: &dyn Law, x: DVec3, observer: Observer, axes: [DVec3; 3]) -> Option<[DVec4; 3]> {
    let u = law.observer(observer, x)?.ok()?;
    Some(tetrad(&law.metric(x, 0.0)?, u, axes))
}

/// Returns the uniforms for the frequency of light: components of K, which are linear in the observed direction. Under a stationary law
/// these are the two conserved components `K_t` and, around the law's axis, `K_φ`; the axis is 0 unless `turning_is_kept`. Under a law
/// that depends on t nothing is conserved, and the component is −Kᵗ, the ratio of K to the ray's velocity.
pub fn frequency(law: &dyn Law, camera: &Camera, turning_is_kept: bool) -> Option<Row> {
    let metric = law.metric(camera.position, 0.0)?;
    let axes = axes(law, camera)?;
    let linear = |of: &dyn Fn(DVec4) -> f64| {
        let [x, y, z, rest] = axes.map(of);
        (DVec3::new(x, y, z), rest)
    };
    if law.facts().changes_with_time {
        let (along, rest) = linear(&|k| -k.w);
        return Some(row! { along: Vec3(along), rest: Float(rest) });
    }
    let [center, axis] = law.equator().filter(|_| turning_is_kept).unwrap_or_default();
    let arm = law.facts().throat.map_or(camera.position - center, |throat| throat.offset(camera.position).0);
    let around = axis.cross(arm).extend(0.0);
    let (energy_along, energy_rest) = linear(&|k| metric.w_axis.dot(k));
    let (turning_along, turning_rest) = linear(&|k| around.dot(metric * k));
    Some(row! {
        energy_along: Vec3(energy_along),
        energy_rest: Float(energy_rest),
        turning_along: Vec3(turning_along),
        turning_rest: Float(turning_rest),
        axis: Vec3(axis),
    })
}

/// Returns the uniforms for the frequency of given rays, whose momentum the device computes at their starts: the axis alone. Under a law that
/// depends on t, they are 0.
pub fn frequency_of_given(law: &dyn Law, turning_is_kept: bool) -> Row {
    if law.facts().changes_with_time {
        return row! { along: Vec3(DVec3::ZERO), rest: Float(0.0) };
    }
    let [_, axis] = law.equator().filter(|_| turning_is_kept).unwrap_or_default();
    row! {
        energy_along: Vec3(DVec3::ZERO),
        energy_rest: Float(0.0),
        turning_along: Vec3(DVec3::ZERO),
        turning_rest: Float(0.0),
        axis: Vec3(axis),
    }
}

/// Returns the uniforms of the shader, or `None` if the camera uses coordinate directions.
pub fn observer(law: &dyn Law, camera: &Camera) -> Option<Row> {
    let [x, y, z, rest] = axes(law, camera)?;
    Some(row! { x: Vec4(x), y: Vec4(y), z: Vec4(z), rest: Vec4(rest) })
}

/// Returns the components of K along the scene's three axes, and its constant part −u.
fn axes(law: &dyn Law, camera: &Camera) -> Option<[DVec4; 4]> {
    let u = law.observer(camera.observer, camera.position)?.ok()?;
    let [right, up, forward] = frame(law, camera.position, camera.observer, [camera.right, camera.up, camera.forward])?;
    let along =
        |axis: DVec3| right * camera.right.dot(axis) + up * camera.up.dot(axis) + forward * camera.forward.dot(axis);
    Some([along(DVec3::X), along(DVec3::Y), along(DVec3::Z), -u])
}
