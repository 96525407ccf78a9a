// How matter moves: its four-velocity, and the frequency of light to it. By symmetry, most matter moves along ∂t and ∂φ alone: then K_t and
// K_φ suffice, which are known exactly.

// The metric along ∂t and ∂φ, and the determinant g_tt g_φφ − g_tφ², which is negative and goes to 0 at a horizon and on the axis.
struct Turning {
    tt: Real,
    mixed: Real,
    own: Real,
    determinant: Real,
}

// Returns the frequency of light to matter of four-velocity uᵗ (∂t + Ω ∂φ).
fn shift_of_rate(spot: Spot, g: Turning, rate: Real) -> Real {
    let square = -(g.tt + rate * (2.0 * g.mixed + rate * g.own));
    return possible(square) * (spot.energy + rate * spot.turning);
}

// Returns the frequency of light to matter with u_φ = −l u_t, which moves around the axis.
fn shift_of_momentum(spot: Spot, g: Turning, l: Real) -> Real {
    let square = (g.own + l * (2.0 * g.mixed + l * g.tt)) / -g.determinant;
    let along = g.own + l * g.mixed;
    let around = -(g.mixed + l * g.tt);
    return possible(square) * (spot.energy * along + spot.turning * around) / -g.determinant;
}

// Returns the frequency of light to matter that orbits around the axis at the distance R = r sin θ. Within the last stable orbit it falls with
// the energy and the angular momentum of that, where it can.
fn shift_of_orbit(spot: Spot, distance: Real, sense: Real, last: Real3) -> Real {
    if law_axial(distance) < last.x {
        let u = law_falling(spot.x, last.y, last.z);
        if !is_not_a_number(u.w + u.x) {
            return shift_of_velocity(spot, u);
        }
    }
    return shift_of_rate(spot, law_turning(spot), law_orbiting(distance, sense));
}

// Returns the frequency of light to matter at rest.
fn shift_at_rest(spot: Spot) -> Real {
    if FOLLOWS_SHIFT {
        return possible(-law_square_at(spot.x, Real4(0.0, 0.0, 0.0, 1.0), spot.tau)) * spot.energy;
    }
    return possible(-law_square(spot.x, Real4(0.0, 0.0, 0.0, 1.0))) * spot.energy;
}

// Returns the frequency of light to matter with a four-velocity, of which the last component is the time.
fn shift_of_velocity(spot: Spot, u: Real4) -> Real {
    return dot(spot.momentum, u.xyz) + spot.energy * u.w;
}

// Returns the frequency of light to matter that moves relative to the Eulerian observer, with the length of v as its speed.
fn shift_of_boost(spot: Spot, v: Real3) -> Real {
    let speed2 = dot(v, v);
    let length2 = law_square(spot.x, Real4(v, 0.0));
    let stretched = sqrt(speed2 / max(length2, 1e-30));
    let own = shift_of_velocity(spot, law_eulerian(spot.x));
    return possible(1.0 - speed2) * (own + stretched * dot(spot.momentum, v));
}

// Returns 1/√a, and not a number if matter cannot move so.
fn possible(a: Real) -> Real {
    return select(not_a_number(), inverseSqrt(max(a, 1e-36)), a > 0.0);
}
