// Lights whose light was deposited in voxels on its way (G95 §6, the grid of light directions): a surface receives −F·n from all paths, as
// long as all come from its front.

fn lit_by_grid(material: Material, color: vec3f, lit: Lit) -> vec3f {
    var sum = vec3f(0.0);
    for (var i = 0u; i < arrayLength(&grid_lights); i++) {
        let light = grid_lights[i];
        let x = (vec3f(lit.x) - light.lo) / light.h;
        // Uses bricks if there are any at the position of the lookup.
        let fine = f32(light.refine);
        let near = x + LIGHT_OFF / fine * lit.normal;
        let refined = light_brick_at(light, near) != 0u;
        let cut = select(1.0, fine, refined);
        let f = light_between(light, x, lit.normal, cut);
        let strength = length(f.xyz);
        if strength > 0.0 {
            let answer = light.color * blinn_phong(material, color, -f.xyz / strength, lit.normal, lit.view);
            sum += grid_strength(light, x, lit, f, cut) * answer;
        }
    }
    return sum;
}

// Interpolates trilinearly between the centers of parts, off a surface at x. A part that the surface cuts received light only in front of
// it.
fn light_between(light: GridLight, x: vec3f, normal: vec3f, cut: f32) -> vec4f {
    let surface = x * cut - 0.5;
    let at = surface + LIGHT_OFF * normal;
    let corner = floor(at);
    let part = at - corner;
    let across = abs(normal.x) + abs(normal.y) + abs(normal.z);
    var sum = vec4f(0.0);
    var open = 0.0;
    for (var k = 0u; k < 8u; k++) {
        let by = vec3f(vec3u(k & 1u, (k >> 1u) & 1u, k >> 2u));
        let shares = mix(1.0 - part, part, by);
        let share = shares.x * shares.y * shares.z;
        sum += share * light_in(light, corner + by, cut);
        open += share * clamp(0.5 + dot(corner + by - surface, normal) / across, 0.0, 1.0);
    }
    return sum / open;
}

// Returns the strength of a light: proportional to the number of its paths if it falls off with distance, else equal wherever a path of it
// comes.
fn grid_strength(light: GridLight, x: vec3f, lit: Lit, f: vec4f, cut: f32) -> f32 {
    if GRIDS_ALL_FALL {
        return length(f.xyz);
    }
    if !GRIDS_FALL {
        return even_share(light, x, lit, f.w, cut);
    }
    return select(even_share(light, x, lit, f.w, cut), length(f.xyz), light.falls == 1u);
}

// The fraction of the expected fluence at which a position is in shadow, and the fraction above that at which it is fully lit.
const SHADE: f32 = 0.25;
const FADE: f32 = 0.5;

// Returns the fluence at x, in units of voxels, as a share of the fluence at the brightest position around or on a straight path, whichever
// is less.
fn even_share(light: GridLight, x: vec3f, lit: Lit, fluence: f32, cut: f32) -> f32 {
    let way = lit.x - light.position;
    let expected = min(1.0 / dot(way, way), brightest_around(light, x + 1.5 / cut * lit.normal, cut));
    return clamp((fluence / expected - SHADE) / FADE, 0.0, 1.0);
}

// Returns the greatest fluence around a position: near a shadow the fluence outside it, and where light is spread widely or focused about
// the local one.
fn brightest_around(light: GridLight, x: vec3f, cut: f32) -> f32 {
    let corner = floor(x * cut);
    var most = 0.0;
    for (var k = 0u; k < 27u; k++) {
        let by = vec3f(vec3u(k % 3u, (k / 3u) % 3u, k / 9u)) - 1.0;
        most = max(most, light_in(light, corner + by, cut).w);
    }
    return most;
}
