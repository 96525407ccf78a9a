// A path that is reflected begins a little off the surface, on its own side, as one that leaves matter: where the law bends it back it
// meets that surface again.

fn leave_aside(surface: Surface, end: PathPoint, leg: ptr<function, Leg>) {
    if dot(surface.across, end.v) * dot(surface.across, (*leg).v) < 0.0 {
        let onto = end.x - surface.gap * surface.across;
        (*leg).x = lit_from(onto, surface, -vec3f(normalize(end.v)));
        (*leg).primitive = OFF_SURFACE;
    }
}
