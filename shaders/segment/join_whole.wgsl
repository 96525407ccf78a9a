// A straight path begins where its ray does: at the camera, or on a surface that it went on from, and what is behind that is not
// hit.

fn overlap() -> Real {
    return 0.0;
}
