// Among other objects: a spiral can meet one at any of its turns, of which there is no limit. But only where it is as far from
// the centre as the object, and on the object's side of the centre; up to there nothing needs to be looked at, however many
// turns that takes. Each object stands for a ball around it, and the ray's plane cuts a disk of radius ρ from that, at a
// distance D from the centre and an angle φ onward from the ray. Within the disk's ring (D − ρ to D + ρ) and its window
// (φ ± arcsin ρ/D) the ray goes in arcs, which are tested as any others are.

struct Obstacle {
    center: Real3,
    radius: Real,
    // Which medium it is in.
    place: u32,
}

var<uniform> obstacles: array<Obstacle, OBSTACLE_COUNT>;

// Radians, about: what a cubic arc follows to some 1e-5 of its distance from the centre.
const ARC: Real = 0.25;
// By what rings and windows are widened against rounding.
const WIDER: Real = 1e-4;
const NEVER: Real = 1e30;

// σ until the distance from the centre is r; 0 where it is that already.
fn climb_to(s: Spiral, r: Real) -> Real {
    return log_ratio(r, s.r) / s.climb;
}

// σ until the ray may meet what is in a ball.
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
    // From the window's beginning, against the turn: within it, or so far still to go.
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
    // To the sphere about the centre that holds no surface of the object itself, or into the middle.
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

// One step to the sphere about the centre that the object is, or into the middle where the ray is captured: ln(R/r)/sin ψ, with no
// trigonometry at all. An exact circle goes nowhere.
fn leap_stride(s: Spiral) -> Stride {
    let rise = log_ratio(here().radius, s.r);
    let fall = log_ratio(s.r, 0.5 * media[place].capture);
    let sigma = select(fall, rise, s.climb > 0.0) / abs(s.climb);
    return Stride(select(0.0, max(sigma, 0.0), s.climb != 0.0), false);
}
