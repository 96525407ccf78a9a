// In grids no light falls off: they are as bright wherever a path of theirs comes.

fn grid_strength(light: GridLight, x: vec3f, lit: Lit, f: vec4f, cut: f32) -> f32 {
    return even_share(light, x, lit, f.w, cut);
}
