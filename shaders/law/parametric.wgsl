// Rays along a curve that the scene writes, x(t), y(t), z(t) (G95 §2.3): the same from every place, moved so that it leads through that
// place. A state carries tau, which is t from the curve's beginning.

struct ParametricCurve {
    // From the place that a ray is given to its start.
    offset: Real3,
    // t there.
    first: Real,
}

var<uniform> law: ParametricCurve;

// Whose axes the curve has: the camera's, or the scene's.
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

// Place and velocity, but for where the curve lies.
fn ray_curve(tau: Real) -> mat2x3<Real> {
    let c = curve_point(law.first + tau);
    return mat2x3<Real>(law_axes(c[0]), law_axes(c[1]));
}

fn law_start(x: Real3, v: Real3) -> Phase {
    return Phase(Real4(x + law.offset, 0.0), Real4(ray_curve(0.0)[1], 0.0));
}

fn law_pull_at(x: Real3, v: Real3, tau: Real) -> Real3 {
    return law_axes(curve_pull(law.first + tau));
}

// The t in which it turns by a radian, but no more than an eighth of all.
fn law_scale(p: Phase) -> Real {
    let turn = length(curve_pull(law.first + p[1].w));
    return min(length(p[1].xyz) / max(turn, 1e-30), 0.125 * limit.length);
}
