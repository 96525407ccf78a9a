// A curve is turned with the camera.

struct Axes {
    x: Real3,
    y: Real3,
    z: Real3,
}

var<uniform> axes: Axes;

fn law_axes(c: Real3) -> Real3 {
    return c.x * axes.x + c.y * axes.y + c.z * axes.z;
}
