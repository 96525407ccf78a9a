// Objects in motion: rotation around an axis at a constant rate, or uniform linear motion. Each is seen where it was when light left it: a
// ray that has traveled for τ meets it at t − τ. The ray is tested in the rest frame of the object, its position at t = 0, into which
// positions of the ray are transformed.

struct Travel {
    center: Real3,
    // dφ/dt about the axis.
    turning: Real,
    axis: Real3,
    // The angle of rotation at the time of the camera.
    angle: Real,
    velocity: Real3,
    // The primitive that moves.
    item: u32,
    // The displacement at that time.
    offset: Real3,
    // The radius of a sphere around the center that contains the whole orbit, or of a bounding sphere of the object.
    reach: Real,
    // The center of that bounding sphere, at rest, and its radius.
    middle: Real3,
    radius: Real,
}

var<uniform> travels: array<Travel, TRAVEL_COUNT>;

// The τ and velocity of the path at the position where surfaces are evaluated.
var<private> met_tau: Real;
var<private> met_velocity: Real3;
// The velocity there, by t, of the surface that was evaluated last.
var<private> met_travel: Real3;

fn note_passage(p: Phase, tau: Real) {
    met_tau = tau;
    met_velocity = path_velocity(p[1].xyz);
}

// Returns a vector rotated about the axis, by the sine and cosine of the angle.
fn turned(own: Travel, d: Real3, turn: Real2) -> Real3 {
    let along = dot(d, own.axis) * own.axis;
    return along + turn.y * (d - along) + turn.x * cross(own.axis, d);
}

// Returns the sine and cosine of the rotation angle.
fn travel_turn(own: Travel, tau: Real) -> Real2 {
    return real_sin_cos(own.angle - own.turning * tau);
}

fn travel_offset(own: Travel, tau: Real) -> Real3 {
    return own.center + own.offset - tau * own.velocity;
}

// Returns the position at rest of the point of the object that is at x at that time.
fn resting_place(own: Travel, x: Real3, tau: Real) -> Real3 {
    let turn = travel_turn(own, tau);
    return own.center + turned(own, x - travel_offset(own, tau), Real2(-turn.x, turn.y));
}

// Returns the index of a primitive's motion, or TRAVEL_COUNT.
fn travel_of(primitive: u32) -> u32 {
    var found = TRAVEL_COUNT;
    for (var i = 0u; i < TRAVEL_COUNT; i++) {
        found = select(found, i, travels[i].item == primitive);
    }
    return found;
}

fn hit_surface(primitive: u32, x: Real3) -> Surface {
    let i = travel_of(primitive);
    met_travel = Real3(0.0);
    if i == TRAVEL_COUNT {
        return resting_surface(primitive, x);
    }
    let own = travels[i];
    var surface = resting_surface(primitive, resting_place(own, x, met_tau));
    let turn = travel_turn(own, met_tau);
    surface.normal = turned(own, surface.normal, turn);
    surface.shading_normal = vec3f(turned(own, Real3(surface.shading_normal), turn));
    met_travel = own.velocity + own.turning * cross(own.axis, x - travel_offset(own, met_tau));
    return surface;
}

// Adds the motion of the surface that was evaluated last to a four-velocity, up to its length.
fn add_travel(k: ptr<function, Real4>) {
    *k += Real4(met_travel, 0.0);
}
