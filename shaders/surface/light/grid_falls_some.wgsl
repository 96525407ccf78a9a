// In grids some lights fall off.

fn grid_strength(light: GridLight, x: vec3f, lit: Lit, f: vec4f, cut: f32) -> f32 {
    return select(even_share(light, x, lit, f.w, cut), length(f.xyz), light.falls == 1u);
}
