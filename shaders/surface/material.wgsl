// What surfaces are made of: one record for all kinds, of which each kind reads its own part.

struct Material {
    // The colour, or the first of a pattern's two.
    color: vec3f,
    kind: u32,
    second_color: vec3f,
    pattern: u32,
    specular: vec3f,
    shininess: f32,
    emission: vec3f,
    ambient: f32,
    // How often a pattern repeats along u and v.
    repeat: vec2f,
    image: u32,
    // Of an object that light goes through: its bit in the set of regions.
    bit: u32,
}

@group(0) @binding(134) var<storage, read> materials: array<Material>;
