// The skies of a wormhole's two sides: a ray sees that of the mouth which it ends nearer to.

var<private> is_beyond: bool;

fn note_side(x: Real3) {
    is_beyond = distance(x, law.other) < distance(x, law.center);
}

fn sky_radiance(d: vec3f) -> vec3f {
    if is_beyond {
        return beyond_sky_radiance(d);
    }
    return near_sky_radiance(d);
}
