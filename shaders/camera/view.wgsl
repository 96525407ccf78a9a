// Divides an image into views: one fills the image, or two eyes share it, with the left eye in the left or upper half. A pixel keeps to its
// half, wherever rounding puts its samples.

fn picture_ray(pixel: vec2u) -> CameraRay {
    return ray_through(pixel, sample_point(pixel));
}

// Returns the ray through a point of the image, in pixels, in the view of a pixel.
fn ray_through(pixel: vec2u, point: vec2f) -> CameraRay {
    if SIDE_BY_SIDE {
        let size = vec2u(frame.image.x / 2u, frame.image.y);
        let right = pixel.x >= size.x;
        return ray_of_eye(point, size, vec2u(select(0u, size.x, right), 0u), right);
    }
    if TOP_BOTTOM {
        let size = vec2u(frame.image.x, frame.image.y / 2u);
        let right = pixel.y >= size.y;
        return ray_of_eye(point, size, vec2u(0u, select(0u, size.y, right)), right);
    }
    return camera_ray(image_plane(point, frame.image));
}

// Returns the ray of one eye, in a view that begins at `corner`.
fn ray_of_eye(point: vec2f, size: vec2u, corner: vec2u, right: bool) -> CameraRay {
    return eye_ray(camera_ray(image_plane(point - vec2f(corner), size)), right);
}

// Returns the index of the view that a pixel belongs to.
fn view_of(pixel: vec2u) -> u32 {
    if SIDE_BY_SIDE {
        return u32(pixel.x >= frame.image.x / 2u);
    }
    if TOP_BOTTOM {
        return u32(pixel.y >= frame.image.y / 2u);
    }
    return 0u;
}

// Returns `true` if all corners of a pixel are in the same view.
fn corners_shared(pixel: vec2u) -> bool {
    if SIDE_BY_SIDE {
        return pixel.x + 1u != frame.image.x / 2u;
    }
    if TOP_BOTTOM {
        return pixel.y + 1u != frame.image.y / 2u;
    }
    return true;
}
