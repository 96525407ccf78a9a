// Nothing captures rays.

fn law_captured(x: vec3f, v: vec3f) -> bool {
    return false;
}

fn capture_gap(x: vec3f) -> vec4f {
    return vec4f(0.0);
}
