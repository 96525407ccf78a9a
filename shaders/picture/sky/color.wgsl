// One colour all round.

struct Sky {
    color: vec3f,
}

@group(0) @binding(163) var<uniform> sky: Sky;

fn sky_radiance(d: vec3f) -> vec3f {
    return sky.color;
}
