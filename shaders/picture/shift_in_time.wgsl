// By how much light has shifted on its way, g, under a law that changes with t: its frequency as the observer at the camera sees it over
// what its source gave it. Nothing is the same all along its way, so that its momentum kU is followed: light of frequency 1 at the camera
// has k = −K^t there. Where matter of four-velocity u sent it, its frequency is u·kU.

struct Frequency {
    // −K^t is linear in the camera's direction.
    along: Real3,
    rest: Real,
}

var<uniform> frequency: Frequency;

// k at the camera, and ln of its growth up to the path's end.
var<private> ray_scale: Real;
var<private> ray_stretch: Real;
// The redshift of the surface or sky that the ray saw, if any.
var<private> seen_shift: Real;

fn note_end(p: Phase) {
    ray_stretch = p[0].w;
}

fn note_frequency(pixel: vec2u, ray: Ray) {
    ray_scale = frequency.rest + dot(frequency.along, picture_ray(pixel).d);
    seen_shift = 0.0;
}

// What sends the sky's light rests in these coordinates.
fn note_sky(ray: Ray, end: PathPoint) {
    if ray.status == ESCAPED || ray.status == MISSED {
        note_shift(end, Real4(0.0, 0.0, 0.0, 1.0));
    }
}

// What is seen rests, or moves as it is said of an object.
fn note_matter(material: Material, end: PathPoint) {
    var k = Real4(0.0, 0.0, 0.0, 1.0);
    if TRAVELS {
        add_travel(&k);
    }
    note_shift(end, k);
}

// k: four-velocity of the source, but for its length; where nothing can move so no light comes from there.
fn note_shift(end: PathPoint, k: Real4) {
    let u = k * inverseSqrt(max(-law_square_at(end.x, k, end.tau), 1e-30));
    let momentum = law_momentum_at(end.x, end.v, end.tau);
    seen_shift = real_exp(-ray_stretch) / (ray_scale * dot(u, momentum));
}
