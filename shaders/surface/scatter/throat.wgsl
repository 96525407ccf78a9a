// A wormhole's throat, drawn as a sphere round each of its mouths: what comes in by one goes out by the other, in the same direction from
// it. There only the way along the radius turns round, as on a mirror.

const THROAT: u32 = 11u;

fn scatter_throat(material: Material, surface: Surface, end: PathPoint, index: u32, pixel: vec2u) -> Scattered {
    let v = end.v - (2.0 * dot(end.v, surface.across)) * surface.across;
    return Scattered(v, vec3f(1.0), false, true);
}

// To the other mouth: just outside of it, or rounding would have it met again.
fn pass_throat(kind: u32, end: ptr<function, PathPoint>) {
    if kind == THROAT {
        let x = (*end).x;
        let here = x - law.center;
        let there = x - law.other;
        let is_here = dot(here, here) < dot(there, there);
        let margin = 8.0 * LAST_PART * (law.radius + max(length(law.center), length(law.other)));
        let n = normalize(select(there, here, is_here));
        (*end).x = select(law.center, law.other, is_here) + (law.radius + margin) * n;
    }
}
