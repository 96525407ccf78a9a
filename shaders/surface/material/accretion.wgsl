// A thin accretion disk on circular orbits and in infall, which radiates like black bodies (Page and Thorne 1974).

const ACCRETION: u32 = 10u;

struct Equator {
    center: Real3,
    // The logarithm of the first orbit's distance from the axis; the others are uniformly spaced.
    first: Real,
    axis: Real3,
    per_orbit: Real,
}

var<uniform> equator: Equator;
struct DiscOrbit {
    // The components of the four-velocity: outwards, azimuthal and in time.
    u: vec3f,
    // √(F/F_most), which goes to 0 smoothly at the ISCO.
    light: f32,
}

var<storage, read> orbits: array<DiscOrbit>;

const ORBITS: u32 = 8192u;

fn from_axis(x: Real3) -> Real3 {
    let d = x - equator.center;
    return d - dot(d, equator.axis) * equator.axis;
}

fn orbit_at(rho: Real) -> DiscOrbit {
    let place = clamp((real_log(rho) - equator.first) / equator.per_orbit, 0.0, Real(ORBITS - 1u));
    let first = min(u32(place), ORBITS - 2u);
    let a = orbits[first];
    let b = orbits[first + 1u];
    let part = f32(place - Real(first));
    return DiscOrbit(mix(a.u, b.u, part), mix(a.light, b.light, part));
}

// Returns u of the matter at x.
fn matter_accretion(x: Real3) -> Real4 {
    let out = from_axis(x);
    let rho = length(out);
    let u = orbit_at(rho).u;
    return Real4((Real(u.x) * out + Real(u.y) * cross(equator.axis, out)) / rho, Real(u.z));
}

// The flux F is proportional to the fourth power of temperature. Without a temperature the disk is white, with its bolometric brightness.
fn radiance_accretion(material: Material, color: vec3f, lit: Lit) -> vec3f {
    let heat = sqrt(orbit_at(length(from_axis(Real3(lit.x)))).light) * color_shift();
    let white = vec3f(heat * heat * heat * heat);
    return color * material.brightness * select(black_body_color(material.temperature * heat, material.temperature), white, material.temperature == 0.0);
}
