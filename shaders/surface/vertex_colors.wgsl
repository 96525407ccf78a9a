// Vertex colors, interpolated by barycentric coordinates over the triangle whose surface was asked for last.

// Set in a material's pattern: the pattern is multiplied by vertex colors.
const VERTEX_COLORS: u32 = 0x80000000u;

struct VertexColor {
    // Linear.
    color: vec3f,
}

@group(0) @binding(129) var<storage, read> vertex_colors: array<VertexColor>;

// The triangle's vertices, and the point's barycentric coordinates.
var<private> colored_corners: vec3u;
var<private> colored_share: vec3f;

fn note_corners(triangle: Triangle, share: Real3) {
    colored_corners = vec3u(triangle.a, triangle.b, triangle.c);
    colored_share = vec3f(share);
}

fn vertex_color() -> vec3f {
    return colored_share.x * vertex_colors[colored_corners.x].color
        + colored_share.y * vertex_colors[colored_corners.y].color
        + colored_share.z * vertex_colors[colored_corners.z].color;
}
