// Applies absorption along the path of a ray and along straight lines to lights. Media may emit: d(L/n²)/ds = ε/n² − σ L/n², with ε and σ
// constant over a piece.

// True on a straight line, which has the direction and length `line_way` and is a step of size 1.
var<private> on_line: bool;
var<private> line_start: Real3;
var<private> line_way: Real3;
// The optical depth so far.
var<private> line_depth: vec3f;

// Returns the transmittance along `way`, in the medium at its start.
fn filtered_share(start: Real3, way: Real3) -> vec3f {
    on_line = true;
    line_start = start;
    line_way = way;
    line_depth = vec3f(0.0);
    absorption_part(Phase(), 1.0);
    on_line = false;
    return exp(-line_depth);
}

fn track_place(p: Phase, h: Real) -> Real4 {
    if WEAKENS_LINES {
        if on_line {
            return Real4(line_start + h * line_way, length(line_way));
        }
    }
    return path_place(p, h);
}

fn track_pace(p: Phase) -> Real {
    if WEAKENS_LINES {
        if on_line {
            return length(line_way);
        }
    }
    return path_pace(p);
}

// Media add no emission to the light of a light source.
fn take_piece(absorption: Absorption, x: Real3, depth: vec4f) {
    if WEAKENS_LINES {
        if on_line {
            line_depth += depth.xyz;
            return;
        }
    }
    pass_piece(absorption, x, depth);
}

fn pass_piece(absorption: Absorption, x: Real3, depth: vec4f) {
    if !SEES_GLOW {
        scale_throughput(exp(-depth.xyz));
        return;
    }
    // (1 − e⁻ᵃ)/a, by its series where the difference would lose all digits.
    let a = depth.xyz;
    let share = select((1.0 - exp(-a)) / max(a, vec3f(1e-30)), 1.0 - a * (0.5 - a / 6.0), a < vec3f(1e-2));
    if glow_counts {
        gather(depth.w * share * absorption.emission, x);
    }
    scale_throughput(exp(-a));
}
