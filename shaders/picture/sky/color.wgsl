// A sky of one color.

struct Sky {
    color: vec3f,
}

var<uniform> sky: Sky;

fn sky_radiance(way: vec3f) -> vec3f {
    return sky.color;
}
