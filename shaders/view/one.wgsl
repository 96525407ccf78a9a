// One view fills the picture.

fn picture_ray(pixel: vec2u) -> CameraRay {
    return camera_ray(image_plane(sample_point(pixel), frame.image));
}
