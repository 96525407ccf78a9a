// Vertex colors, interpolated by barycentric coordinates over the triangle whose surface was evaluated last.

// A flag of a material's pattern: the pattern is multiplied by vertex colors.
const VERTEX_COLORS: u32 = 0x80000000u;

// After a vertex's normal and its u and v.
const COLOR_WORD: u32 = 5u;

// The start of the triangle's vertices, and the point's barycentric coordinates.
var<private> colored_corners: vec3u;
var<private> colored_share: vec3f;

fn note_corners(triangle: u32, share: Real3) {
    let at = TRIANGLE_WORDS * triangle;
    colored_corners = vec3u(mesh[at], mesh[at + 1u], mesh[at + 2u]) + COLOR_WORD;
    colored_share = vec3f(share);
}

// Returns the vertex color, linear.
fn vertex_color() -> vec3f {
    return colored_share.x * mesh_vector(colored_corners.x)
        + colored_share.y * mesh_vector(colored_corners.y)
        + colored_share.z * mesh_vector(colored_corners.z);
}
