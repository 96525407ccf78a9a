// By how much light has shifted on its way, g: its frequency as the observer at the camera sees it over what its source gave it. Light of
// frequency 1 at the camera has momentum K there. K_t is the same all along its way, and so is K_φ about an axis that the law is the same
// around. Where matter of four-velocity u sent it, its frequency is u·K.
//
// At the path's end its velocity gives K but for a factor, which follows from K_t and K_φ: together they are 0 for no light outside a
// horizon, though near one both are small beside the rest of K, and inside an ergosphere K_t may be 0 or below. What u has along ∂t and
// ∂φ needs no factor, so that the shift of matter in orbit is as right as the place where it is seen.

struct Frequency {
    // K_t and K_φ are linear in the camera's direction.
    energy_along: Real3,
    energy_rest: Real,
    turning_along: Real3,
    turning_rest: Real,
    // The axis of φ; 0 where K_φ is not kept.
    axis: Real3,
}

var<uniform> frequency: Frequency;

// K_t and K_φ.
var<private> ray_kept: Real2;
// The redshift of the surface or sky that the ray saw, if any.
var<private> seen_shift: Real;

// What sends the sky's light is at rest, far away.
fn note_frequency(pixel: vec2u, ray: Ray) {
    let d = picture_ray(pixel).d;
    ray_kept = Real2(frequency.energy_rest + dot(frequency.energy_along, d), frequency.turning_rest + dot(frequency.turning_along, d));
    seen_shift = select(0.0, 1.0 / ray_kept.x, ray.status == ESCAPED || ray.status == MISSED);
}

fn note_matter(material: Material, end: PathPoint) {
    let u = surface_matter(material, end.x);
    let momentum = law_momentum(end.x, end.v);
    // ∂φ, and 1 over the square of its length in coordinates, by which K_φ weighs as much as K_t.
    let around = cross(frequency.axis, law_arm(end.x));
    let weight = 1.0 / max(dot(around, around), 1e-30);
    let known = Real2(momentum.w, dot(around, momentum.xyz));
    let weighed = Real2(known.x, weight * known.y);
    let factor = dot(weighed, ray_kept) / dot(weighed, known);
    let turning = weight * dot(around, u.xyz);
    let other = u.xyz - turning * around;
    seen_shift = 1.0 / (u.w * ray_kept.x + turning * ray_kept.y + factor * dot(other, momentum.xyz));
}

// u of what is at rest, or moves as it is said of an object; where nothing can move so no light comes from there.
fn matter_at_rest(x: Real3) -> Real4 {
    var k = Real4(0.0, 0.0, 0.0, 1.0);
    if TRAVELS {
        add_travel(&k);
    }
    return k * inverseSqrt(max(-law_square(x, k), 1e-30));
}
