// Computes the redshift factor g of light: its frequency as the observer at the camera sees it divided by its frequency at the source.
// Light of frequency 1 at the camera has momentum K there. K_t is constant along its path, and so is K_φ about an axis of symmetry of the
// law. If matter of four-velocity u emitted it, its frequency is u·K.
//
// At the end of the path the velocity gives K up to a factor, which follows from K_t and K_φ: outside a horizon they are never both 0, but
// near one both are small compared with the rest of K, and inside an ergosphere K_t may be 0 or negative. The parts of u along ∂t and ∂φ
// need no factor, so that the redshift of orbiting matter is as accurate as its position.

struct Frequency {
    // K_t and K_φ are linear in the camera's direction.
    energy_along: Real3,
    energy_rest: Real,
    turning_along: Real3,
    turning_rest: Real,
    // The axis of φ; 0 if K_φ is not conserved.
    axis: Real3,
}

var<uniform> frequency: Frequency;

// K_t and K_φ.
var<private> ray_kept: Real2;
// The redshift of the surface or sky that the ray saw, if any.
var<private> seen_shift: Real;
// dx/dλ divided by the velocity, where matter emits the light.
var<private> matter_scale: Real;

fn note_kept(pixel: vec2u) {
    if IS_GIVEN {
        note_given(pixel);
        return;
    }
    if IS_PARALLEL {
        note_given(pixel);
        return;
    }
    let d = picture_ray(sampled_pixel(pixel)).d;
    ray_kept = Real2(frequency.energy_rest + dot(frequency.energy_along, d), frequency.turning_rest + dot(frequency.turning_along, d));
}

// The source of the sky's light is static, far away.
fn note_frequency(pixel: vec2u, ray: Ray) {
    note_kept(pixel);
    seen_shift = select(0.0, 1.0 / ray_kept.x, ray.status == ESCAPED || ray.status == MISSED);
}

// The frequency of a given ray is 1 for a static observer at its start, or at infinity if it comes from there, or from a camera with
// parallel rays.
fn note_given(pixel: vec2u) {
    let own = picture_ray(sampled_pixel(pixel));
    let start = arrived(own);
    let momentum = law_momentum(start.x, path_velocity(law_start(start.x, start.d)[1].xyz));
    var clock: Real = 1.0;
    if all(start.x == own.x) && !IS_PARALLEL {
        clock = sqrt(max(-law_square(start.x, Real4(0.0, 0.0, 0.0, 1.0)), 0.0));
    }
    ray_kept = (clock / momentum.w) * Real2(momentum.w, dot(cross(frequency.axis, law_arm(start.x)), momentum.xyz));
}

fn note_matter(material: Material, end: PathPoint) {
    let u = surface_matter(material, end.x);
    let momentum = law_momentum(end.x, end.v);
    // ∂φ, and the inverse of its squared coordinate length, which gives K_φ and K_t equal weight.
    let around = cross(frequency.axis, law_arm(end.x));
    let weight = 1.0 / max(dot(around, around), 1e-30);
    let known = Real2(momentum.w, dot(around, momentum.xyz));
    let weighed = Real2(known.x, weight * known.y);
    let factor = dot(weighed, ray_kept) / dot(weighed, known);
    if KEEPS_CROSSINGS {
        matter_scale = factor;
    }
    let turning = weight * dot(around, u.xyz);
    let other = u.xyz - turning * around;
    seen_shift = 1.0 / (u.w * ray_kept.x + turning * ray_kept.y + factor * dot(other, momentum.xyz));
}

// Returns u of an object that is static or moves as the scene specifies; if no object can move so, no light comes from there.
fn matter_at_rest(x: Real3) -> Real4 {
    var k = Real4(0.0, 0.0, 0.0, 1.0);
    if TRAVELS {
        add_travel(&k);
    }
    return k * inverseSqrt(max(-law_square(x, k), 1e-30));
}
