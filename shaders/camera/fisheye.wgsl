// All rays start at one place, at angles from `forward` that grow evenly from the middle of the picture to the rim of a disk in
// it: an equidistant fisheye, which may go past the point behind it and round again. Outside the disk there are no rays.

struct Camera {
    position: Real3,
    forward: Real3,
    right: Real3,
    up: Real3,
    // The picture's half width and half height, where the shorter of them is 1.
    sides: Real2,
    // From the middle to the rim, in quarter turns.
    quarters: Real,
}

var<uniform> camera: Camera;

// point: on the image plane, x to the right and y up, both in [-1, 1].
fn camera_ray(point: Real2) -> CameraRay {
    let p = point * camera.sides;
    let rho = length(p);
    let turned = quarters_sin_cos(rho * camera.quarters);
    // (x, y)/ρ is the azimuth's cosine and sine. In the middle they are anything, and sin θ is 0.
    let outwards = turned.x / select(rho, Real(1.0), rho == 0.0);
    let d = turned.y * camera.forward + outwards * (p.x * camera.right + p.y * camera.up);
    return CameraRay(camera.position, d, select(ALIVE, OUTSIDE, rho > 1.0));
}
