// Writes the layers of bundles of light that reach the sky; 0 elsewhere, and where the bundle is unknown.

var<storage, read_write> pixel_layer_magnification: array<f32>;
var<storage, read_write> pixel_layer_bundle: array<vec3f>;

// Returns the direction of the ray at an offset from the center of a pixel, in the frame of the camera.
fn direction_near(pixel: vec2u, offset: vec2f) -> Real3 {
    return ray_through(sampled_pixel(pixel), center_of(sampled_pixel(pixel)) + offset).d;
}

// Returns the solid angle per area of the image, in pixels, with the sign of the parity.
fn solid_angle(d: Real3, across: Real3, down: Real3) -> Real {
    return dot(d, cross(across, down));
}

// Returns the change of the camera's direction per pixel along an axis, by the same differences as that of the sky.
fn camera_slope(pixel: vec2u, axis: vec2f, weights: vec4f) -> Real3 {
    let own = direction_near(pixel, vec2f(0.0));
    return Real(weights.x) * (direction_near(pixel, -2.0 * axis) - own) + Real(weights.y) * (direction_near(pixel, -axis) - own)
        + Real(weights.z) * (direction_near(pixel, axis) - own) + Real(weights.w) * (direction_near(pixel, 2.0 * axis) - own);
}

// Stores the magnification μ = J_c/J, negative if the image is mirrored, and the shape of the bundle at the sky: its angular diameters, and
// the angle of the longer one, from north (+y) to east (right ascension grows).
fn keep_bundle_layers(pixel: vec2u, coarse: MeasuredBundle) {
    var magnification = 0.0;
    var shape = vec3f(0.0);
    let place = place_in_tile(pixel);
    let across = finer_slope(place, 1u, coarse.across);
    let down = finer_slope(place, frame.size.x, coarse.down);
    let measured = MeasuredBundle(coarse.own, across, down);
    if across.is_smooth && down.is_smooth && (measured.own.end & END_KIND) == ESCAPED {
        let area = solid_angle(measured.own.place, across.change, down.change);
        let x = camera_slope(pixel, vec2f(1.0, 0.0), across.weights);
        let y = camera_slope(pixel, vec2f(0.0, 1.0), down.weights);
        let found = f32(solid_angle(direction_near(pixel, vec2f(0.0)), x, y) / area);
        magnification = select(0.0, found, abs(found) < 1e30);
        var d = vec3f(measured.own.place);
        if HAS_STARS {
            d = from_star_axes(d, side_of(measured.own.end));
        }
        shape = bundle_shape(d, bundle_of(measured), abs(f32(area)));
    }
    if KEEPS_MAGNIFICATION {
        pixel_layer_magnification[place] = magnification;
    }
    if KEEPS_BUNDLE_SHAPE {
        pixel_layer_bundle[place] = shape;
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
