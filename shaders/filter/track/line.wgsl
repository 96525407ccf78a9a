// What is filtered is the light on a ray's own path, and that which comes straight from a light.

// True on a straight line, which is `line_way` long and a step of size 1.
var<private> on_line: bool;
var<private> line_start: Real3;
var<private> line_way: Real3;
// The optical depth so far.
var<private> line_depth: vec3f;

// What is left of light along `way`, in the medium that it is in.
fn filtered_share(start: Real3, way: Real3) -> vec3f {
    on_line = true;
    line_start = start;
    line_way = way;
    line_depth = vec3f(0.0);
    filter_part(Phase(), 1.0);
    on_line = false;
    return exp(-line_depth);
}

fn track_place(p: Phase, h: Real) -> Real4 {
    if on_line {
        return Real4(line_start + h * line_way, length(line_way));
    }
    return path_place(p, h);
}

fn track_pace(p: Phase) -> Real {
    if on_line {
        return length(line_way);
    }
    return path_pace(p);
}

// Media add nothing to a light's light.
fn take_piece(filter_at: Filter, x: Real3, depth: vec4f) {
    if on_line {
        line_depth += depth.xyz;
    } else {
        pass_piece(filter_at, x, depth);
    }
}
