// What surfaces are made of: one record for all kinds, of which each kind reads its own members.

struct Material {
    // The color, or the first of a pattern's two.
    color: vec3f,
    kind: u32,
    second_color: vec3f,
    pattern: u32,
    // How often a pattern repeats along u and v.
    repeat: vec2f,
    image: u32,
    // Of an object that light goes through: its bit in the set of regions.
    bit: u32,
    specular: vec3f,
    // Of the highlight, or of the lobe about the mirror's direction; 0 where the surface is smooth.
    exponent: f32,
    emission: vec3f,
    ambient: f32,
    // What an emissive surface reflects of other light.
    diffuse: vec3f,
    // Of what radiates by its temperature: kelvins, and the luminance.
    temperature: f32,
    brightness: f32,
    // The same about the refracted direction, and the width of microfacets' slopes.
    transmit_exponent: f32,
    roughness: f32,
    // Its place among the fans.
    fan: u32,
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
