// Offsets the start of a reflected path slightly from the surface, on its own side, like the start of a path that leaves matter: if the law
// bends it back, it can meet that surface again.

fn leave_aside(surface: Surface, end: PathPoint, leg: ptr<function, Leg>) {
    if dot(surface.normal, end.v) * dot(surface.normal, (*leg).v) < 0.0 {
        let onto = end.x - surface.signed_distance * surface.normal;
        (*leg).x = lit_from(onto, surface, -vec3f(normalize(end.v)));
        (*leg).primitive = OFF_SURFACE;
    }
}
