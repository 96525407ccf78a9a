// Writes the layers of bundles of light that reach the sky; 0 elsewhere, and where the bundle is unknown.

var<storage, read_write> pixel_layer_magnification: array<f32>;
var<storage, read_write> pixel_layer_bundle: array<vec3f>;

// Returns the direction of the ray at an offset from the center of a pixel, in the frame of the camera.
fn direction_near(pixel: vec2u, offset: vec2f) -> vec3f {
    return vec3f(ray_through(sampled_pixel(pixel), center_of(sampled_pixel(pixel)) + offset).d);
}

// Returns the solid angle per area of the image, in pixels, with the sign of the parity.
fn solid_angle(d: vec3f, across: vec3f, down: vec3f) -> f32 {
    return dot(d, cross(across, down));
}

// Returns the solid angle that the camera gives to the area of a pixel, by the same differences as that of the sky.
fn camera_solid_angle(pixel: vec2u, measured: MeasuredBundle) -> f32 {
    let across = direction_near(pixel, vec2f(measured.across.last, 0.0)) - direction_near(pixel, vec2f(measured.across.first, 0.0));
    let down = direction_near(pixel, vec2f(0.0, measured.down.last)) - direction_near(pixel, vec2f(0.0, measured.down.first));
    let area = (measured.across.last - measured.across.first) * (measured.down.last - measured.down.first);
    return solid_angle(direction_near(pixel, vec2f(0.0)), across, down) / area;
}

// Stores the magnification μ = J_c/J, negative if the image is mirrored, and the shape of the bundle at the sky: its angular diameters, and
// the angle of the longer one, from north (+y) to east (right ascension grows).
fn keep_bundle_layers(pixel: vec2u, measured: MeasuredBundle) {
    var magnification = 0.0;
    var shape = vec3f(0.0);
    let is_smooth = measured.across.is_smooth && measured.down.is_smooth;
    if is_smooth && (measured.own.end & END_KIND) == ESCAPED {
        let own = bundle_of(measured);
        var d = measured.own.place;
        if HAS_STARS {
            d = from_star_axes(d, side_of(measured.own.end));
        }
        let area = solid_angle(d, own.across, own.down);
        let found = camera_solid_angle(pixel, measured) / area;
        magnification = select(0.0, found, abs(found) < 1e30);
        shape = bundle_shape(d, own, abs(area));
    }
    if KEEPS_MAGNIFICATION {
        pixel_layer_magnification[place_in_tile(pixel)] = magnification;
    }
    if KEEPS_BUNDLE_SHAPE {
        pixel_layer_bundle[place_in_tile(pixel)] = shape;
    }
}

// Returns the singular values of the sides of a bundle, and the angle of the larger one.
fn bundle_shape(d: vec3f, own: Bundle, area: f32) -> vec3f {
    let a2 = dot(own.across, own.across);
    let b2 = dot(own.down, own.down);
    let ab = dot(own.across, own.down);
    let major = sqrt(0.5 * (a2 + b2) + length(vec2f(0.5 * (a2 - b2), ab)));
    let turn = 0.5 * f32(arc_tangent(Real(2.0 * ab), Real(a2 - b2)));
    let along = cos(turn) * own.across + sin(turn) * own.down;
    let east = normalize(cross(vec3f(0.0, 1.0, 0.0), d));
    let north = cross(d, east);
    let angle = f32(arc_tangent(Real(dot(along, east)), Real(dot(along, north))));
    return vec3f(major, area / max(major, 1e-30), angle - PI * floor(angle / PI));
}
