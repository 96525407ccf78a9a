// The material of surfaces: one record for all kinds, of which each kind reads its own members.

struct Material {
    // The color, or the first of a pattern's two colors.
    color: vec3f,
    kind: u32,
    second_color: vec3f,
    pattern: u32,
    // The number of repetitions of a pattern along u and v.
    repeat: vec2f,
    image: u32,
    // The bit of a transparent object in the set of regions.
    bit: u32,
    specular: vec3f,
    // The exponent of the highlight, or of the lobe about the mirror direction; 0 for a smooth surface.
    exponent: f32,
    emission: vec3f,
    ambient: f32,
    // The diffuse color of an emissive surface.
    diffuse: vec3f,
    // The temperature of a thermal emitter, in kelvins, and its luminance.
    temperature: f32,
    brightness: f32,
    // The exponent about the refracted direction, and the width of the distribution of microfacet slopes.
    transmit_exponent: f32,
    roughness: f32,
    // The index in the list of ray splitters.
    fan: u32,
}

// A position on a surface, for the computation of its light.
struct Lit {
    x: vec3f,
    // The origin of shadow rays: off the surface, on the viewer's side.
    start: Real3,
    // Unit vectors; the view points towards the viewer.
    normal: vec3f,
    view: vec3f,
}

var<storage, read> materials: array<Material>;
