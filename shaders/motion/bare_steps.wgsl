// Takes steps in the scene's coordinates and does nothing else.

fn bare_steps(ray: Ray, most: u32) -> Ray {
    var next = ray;
    for (var i = 0u; i < most; i++) {
        if is_spent() {
            break;
        }
        next = accepted_step(next);
    }
    return next;
}
