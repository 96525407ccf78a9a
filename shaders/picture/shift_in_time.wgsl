// Computes the redshift factor g of light under a law that depends on t: its frequency as the observer at the camera sees it divided by its
// frequency at the source. There are no constants of motion, so that its momentum kU is followed: light of frequency 1 at the camera has k
// = −K^t there. If matter of four-velocity u emitted it, its frequency is u·kU.

struct Frequency {
    // −K^t is linear in the camera's direction.
    along: Real3,
    rest: Real,
}

var<uniform> frequency: Frequency;

// k at the camera, and the logarithm of its growth up to the end of the path.
var<private> ray_scale: Real;
var<private> ray_stretch: Real;
// The redshift of the surface or sky that the ray saw, if any.
var<private> seen_shift: Real;
// dx/dλ divided by the velocity, where matter emits the light.
var<private> matter_scale: Real;

fn note_end(p: Phase) {
    ray_stretch = p[0].w;
}

fn kept_stretch() -> f32 {
    return f32(ray_stretch);
}

fn restore_stretch(stretch: f32) {
    ray_stretch = stretch;
}

fn note_frequency(pixel: vec2u, ray: Ray) {
    seen_shift = 0.0;
    note_kept(pixel);
}

fn note_kept(pixel: vec2u) {
    if IS_GIVEN {
        note_given(pixel);
        return;
    }
    ray_scale = frequency.rest + dot(frequency.along, picture_ray(sampled_pixel(pixel)).d);
}

// The frequency of a given ray is 1 for an observer at its start, at rest in these coordinates.
fn note_given(pixel: vec2u) {
    let start = arrived(picture_ray(sampled_pixel(pixel)));
    let momentum = law_momentum_at(start.x, path_velocity(law_start(start.x, start.d)[1].xyz), 0.0);
    ray_scale = sqrt(max(-law_square_at(start.x, Real4(0.0, 0.0, 0.0, 1.0), 0.0), 0.0)) / momentum.w;
}

// The source of the sky's light is at rest in these coordinates.
fn note_sky(ray: Ray, end: PathPoint) {
    if ray.status == ESCAPED || ray.status == MISSED {
        note_shift(end, Real4(0.0, 0.0, 0.0, 1.0));
    }
}

// The matter that is seen is at rest, or moves as the scene specifies for an object.
fn note_matter(material: Material, end: PathPoint) {
    var k = Real4(0.0, 0.0, 0.0, 1.0);
    if TRAVELS {
        add_travel(&k);
    }
    note_shift(end, k);
}

// k: the four-velocity of the source, up to its length; if no object can move so, no light comes from there.
fn note_shift(end: PathPoint, k: Real4) {
    let u = k * inverseSqrt(max(-law_square_at(end.x, k, end.tau), 1e-30));
    let momentum = law_momentum_at(end.x, end.v, end.tau);
    if KEEPS_CROSSINGS {
        matter_scale = real_exp(ray_stretch) * ray_scale;
    }
    seen_shift = real_exp(-ray_stretch) / (ray_scale * dot(u, momentum));
}
