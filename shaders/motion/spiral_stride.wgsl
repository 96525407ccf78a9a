// Chooses steps of a spiral among objects, which it can meet at any of its unlimited number of turns. It meets an object only at the
// object's distance from the center and on the object's side of it; up to there nothing needs a test, however many turns that takes. Each
// object is represented by a bounding sphere, from which the plane of the ray cuts a disk of radius ρ, at a distance D from the center and
// an angle φ ahead of the ray. Within the ring (D − ρ to D + ρ) and the window (φ ± arcsin ρ/D) of the disk the ray moves in arcs, which
// are tested like any others.

struct Obstacle {
    center: Real3,
    radius: Real,
    // The index of the medium that contains it.
    place: u32,
}

var<uniform> obstacles: array<Obstacle, OBSTACLE_COUNT>;

// The turn of an arc in radians, approximately: a cubic arc follows it to about 1e-5 of its distance from the center.
const ARC: Real = 0.25;
// The margin of rings and windows against rounding.
const WIDER: Real = 1e-4;
const NEVER: Real = 1e30;

// Returns σ until the distance from the center is r; 0 if it is r already.
fn climb_to(s: Spiral, r: Real) -> Real {
    return log_ratio(r, s.r) / s.climb;
}

// Returns σ until the ray may hit an object in a sphere.
fn way_to(s: Spiral, ball: Obstacle) -> Real {
    let d = ball.center - media[place].center;
    let x = dot(d, s.n);
    let y = dot(d, s.t);
    let aside = d - x * s.n - y * s.t;
    let disk2 = ball.radius * ball.radius * (1.0 + WIDER) - dot(aside, aside);
    let disk = sqrt(max(disk2, 0.0));
    let away = sqrt(x * x + y * y);
    let low = max((away - disk) * (1.0 - WIDER), 1e-30);
    let high = (away + disk) * (1.0 + WIDER);
    let rises = s.climb > 0.0;
    let below = s.r < low;
    let above = s.r > high;
    let behind = select(below, above, rises) || (s.climb == 0.0 && (below || above));
    let before = select(above, below, rises) && s.climb != 0.0;
    let ring = select(0.0, climb_to(s, select(high, low, rises)), before);
    let window = select(PI, arc_tangent(disk, sqrt(max(away * away - disk * disk, 0.0))) + 0.01, away > disk);
    // The angle past the start of the window, against the turn: inside the window, or still to go.
    let past = next_turn(s.swing * ring - arc_tangent(y, x) + window, false);
    let ahead = (2.0 * PI - past) / max(s.swing, 1e-30);
    let way = select(ring + ahead, ring, past <= 2.0 * window);
    let gone = way > climb_to(s, select(low, high, rises)) && s.climb != 0.0;
    return select(way, NEVER, disk2 <= 0.0 || behind || gone);
}

fn spiral_stride(p: Phase) -> Stride {
    if IS_EMPTY {
        return leap_stride(spiral_of(p));
    }
    if !LEAPS {
        return Stride(ARC, false);
    }
    let s = spiral_of(p);
    // To the sphere around the center that contains no surface of the object itself, or into the center.
    let rise = climb_to(s, here().radius);
    let fall = climb_to(s, 0.5 * media[place].capture);
    var way = select(select(fall, rise, s.climb > 0.0), NEVER, s.climb == 0.0);
    way = select(way, way - 0.5 * ARC, s.climb > 0.0);
    for (var i = 0u; i < OBSTACLE_COUNT; i++) {
        way = min(way, select(NEVER, way_to(s, obstacles[i]), obstacles[i].place == place));
    }
    let free = way > ARC && way < NEVER;
    return Stride(select(ARC, way, free), free);
}

// Returns one step to the surface of the sphere around the center, or to the radius at which the ray is captured: ln(R/r)/sin ψ, without
// trigonometry. A ray on an exact circle does not move.
fn leap_stride(s: Spiral) -> Stride {
    let rise = log_ratio(here().radius, s.r);
    let fall = log_ratio(s.r, 0.5 * media[place].capture);
    let sigma = select(fall, rise, s.climb > 0.0) / abs(s.climb);
    return Stride(select(0.0, max(sigma, 0.0), s.climb != 0.0), false);
}
