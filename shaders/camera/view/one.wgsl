// One view fills the picture.

fn picture_ray(pixel: vec2u) -> CameraRay {
    return camera_ray(image_plane(sample_point(pixel), frame.image));
}

// Are the corners of a pixel of the picture all of its own view?
fn corners_shared(pixel: vec2u) -> bool {
    return true;
}
