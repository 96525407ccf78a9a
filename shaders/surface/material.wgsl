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

// A place on a surface as light finds it.
struct Lit {
    x: vec3f,
    // Where what reaches it comes from: off the surface, on the viewer's side.
    start: Real3,
    // Both unit vectors, the view's towards the viewer.
    normal: vec3f,
    view: vec3f,
}

var<storage, read> materials: array<Material>;
