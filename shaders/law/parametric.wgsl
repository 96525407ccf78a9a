// Rays along a parametric curve of the scene, x(t), y(t), z(t) (G95 §2.3): the curve is the same for every ray, shifted so that it passes
// through the ray's position. A state carries tau, which is t from the beginning of the curve.

struct ParametricCurve {
    // The vector from the position that is given for a ray to the ray's start.
    offset: Real3,
    // The value of t there.
    first: Real,
}

var<uniform> law: ParametricCurve;

// The axes of the curve: the camera's, or the scene's.
struct Axes {
    x: Real3,
    y: Real3,
    z: Real3,
}

var<uniform> axes: Axes;

fn law_axes(c: Real3) -> Real3 {
    if !TURNS_WITH_CAMERA {
        return c;
    }
    return c.x * axes.x + c.y * axes.y + c.z * axes.z;
}

// Returns position and velocity, before the shift.
fn ray_curve(tau: Real) -> mat2x3<Real> {
    let c = curve_point(law.first + tau);
    return mat2x3<Real>(law_axes(c[0]), law_axes(c[1]));
}

fn law_start(x: Real3, v: Real3) -> Phase {
    return Phase(Real4(x + law.offset, 0.0), Real4(ray_curve(0.0)[1], 0.0));
}

fn law_acceleration_by_time(x: Real3, v: Real3, tau: Real) -> Real3 {
    return law_axes(curve_pull(law.first + tau));
}

// Returns the t in which the curve turns by one radian, but at most an eighth of its whole range.
fn law_scale(p: Phase) -> Real {
    let turn = length(curve_pull(law.first + p[1].w));
    return min(length(p[1].xyz) / max(turn, 1e-30), 0.125 * limit.length);
}
