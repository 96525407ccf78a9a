// An equidistant fisheye camera: all rays start at one point, at angles from `forward` that grow linearly from the center of the image to
// the rim of a disk in it. The angle may exceed 180 degrees. There are no rays outside the disk.

struct Camera {
    position: Real3,
    forward: Real3,
    right: Real3,
    up: Real3,
    // The half width and half height of the image, in units of the shorter of them.
    sides: Real2,
    // The angle from the center to the rim, in quarter turns.
    quarters: Real,
}

var<uniform> camera: Camera;

// Returns the ray through `point` on the image plane: x to the right and y up, both in [-1, 1].
fn camera_ray(point: Real2) -> CameraRay {
    let p = point * camera.sides;
    let rho = length(p);
    let turned = quarters_sin_cos(rho * camera.quarters);
    // (x, y)/ρ is the azimuth's cosine and sine. At the center they are arbitrary, because sin θ is 0.
    let outwards = turned.x / select(rho, Real(1.0), rho == 0.0);
    let d = turned.y * camera.forward + outwards * (p.x * camera.right + p.y * camera.up);
    return CameraRay(camera.position, d, select(ALIVE, OUTSIDE, rho > 1.0));
}
