// By how much light has shifted on its way, g: its frequency as the observer at the camera sees it over what its source gave it. Light of
// frequency 1 at the camera has momentum K there, and K_t is the same all along its way. Where matter of four-velocity u sent it, its
// frequency is u·K.

struct Frequency {
    // K_t is linear in the camera's direction.
    along: Real3,
    rest: Real,
}

@group(0) @binding(168) var<uniform> frequency: Frequency;

var<private> ray_energy: Real;
// Of what the ray saw, if it saw anything.
var<private> seen_shift: Real;

// What sends the sky's light is at rest, far away.
fn note_frequency(pixel: vec2u, ray: Ray) {
    ray_energy = frequency.rest + dot(frequency.along, picture_ray(pixel).d);
    seen_shift = select(0.0, 1.0 / ray_energy, ray.status == ESCAPED || ray.status == MISSED);
}

fn note_matter(material: Material, end: PathPoint) {
    let momentum = law_momentum(end.x, normalize(end.v));
    seen_shift = momentum.w / (ray_energy * dot(surface_matter(material, end.x), momentum));
}

// u of what is at rest, or moves as it is said of an object; where nothing can move so no light comes from there.
fn matter_at_rest(x: Real3) -> Real4 {
    var k = Real4(0.0, 0.0, 0.0, 1.0);
    add_travel(&k);
    return k * inverseSqrt(max(-law_square(x, k), 1e-30));
}
