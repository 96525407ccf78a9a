// The skies of the two sides of a wormhole: a ray sees the sky of the mouth that its end is nearer to.

var<private> is_beyond: bool;

fn note_side(x: Real3) {
    is_beyond = distance(x, law.other) < distance(x, law.center);
}

fn sky_radiance(way: vec3f) -> vec3f {
    if is_beyond {
        return beyond_sky_radiance(way);
    }
    return near_sky_radiance(way);
}
