// Objects that move: round an axis at an even rate, or straight on. Each is seen where it was when light left it: a ray that has gone for τ
// meets it at t − τ. What it is tested against is its rest, the place that it has at t = 0; there places of the ray come by undoing its way.

struct Travel {
    center: Real3,
    // dφ/dt about the axis.
    turning: Real,
    axis: Real3,
    // How far it has turned when the picture is taken.
    angle: Real,
    velocity: Real3,
    // A primitive.
    item: u32,
    // How far it has gone by then.
    offset: Real3,
    // Of a ball about the centre that holds it wherever it turns, or of one about its own middle.
    reach: Real,
    // That middle, at rest, and its ball's radius.
    middle: Real3,
    radius: Real,
}

var<uniform> travels: array<Travel, TRAVEL_COUNT>;

// Of the place of a path that surfaces are asked for: its τ and velocity.
var<private> met_tau: Real;
var<private> met_velocity: Real3;
// What was asked for last moves so there, by t.
var<private> met_travel: Real3;

fn note_passage(p: Phase, tau: Real) {
    met_tau = tau;
    met_velocity = path_velocity(p[1].xyz);
}

// A vector turned about the axis, by the angle's cosine and sine.
fn turned(own: Travel, d: Real3, turn: Real2) -> Real3 {
    let along = dot(d, own.axis) * own.axis;
    return along + turn.y * (d - along) + turn.x * cross(own.axis, d);
}

// The sine and the cosine of how far it has turned.
fn travel_turn(own: Travel, tau: Real) -> Real2 {
    return real_sin_cos(own.angle - own.turning * tau);
}

fn travel_offset(own: Travel, tau: Real) -> Real3 {
    return own.center + own.offset - tau * own.velocity;
}

// Where at rest is what is at x there.
fn resting_place(own: Travel, x: Real3, tau: Real) -> Real3 {
    let turn = travel_turn(own, tau);
    return own.center + turned(own, x - travel_offset(own, tau), Real2(-turn.x, turn.y));
}

// The travel of a primitive, or TRAVEL_COUNT.
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
    surface.across = turned(own, surface.across, turn);
    surface.normal = vec3f(turned(own, Real3(surface.normal), turn));
    met_travel = own.velocity + own.turning * cross(own.axis, x - travel_offset(own, met_tau));
    return surface;
}

// Of a four-velocity, but for its length: what the surface that was asked for last has of it.
fn add_travel(k: ptr<function, Real4>) {
    *k += Real4(met_travel, 0.0);
}
