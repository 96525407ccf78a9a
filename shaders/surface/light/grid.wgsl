// Lights whose light was left in voxels on its way (G95 §6, his grid of light directions): what a surface receives of all paths is −F·n, as
// long as all come from its front.

fn lit_by_grid(material: Material, color: vec3f, lit: Lit) -> vec3f {
    var sum = vec3f(0.0);
    for (var i = 0u; i < arrayLength(&grid_lights); i++) {
        let light = grid_lights[i];
        let x = (vec3f(lit.x) - light.lo) / light.h;
        // In bricks as far as there are any where the light is looked for.
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

// Trilinear between the middles of parts, off a surface at x. Of a part that it cuts, light had only what lies before it.
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
