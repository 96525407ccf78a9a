// Path tracing (T 4.3): a sample is one path, which continues from every surface in one direction until it finds no more light. Each
// part of it is an ordinary ray, followed under the scene's law and through its media, so that nothing assumes that light is straight: no
// line of sight is ever tested.

// Replaces the primitive if a path starts just off a surface: nothing is hit before that start, and no surface is ignored.
const OFF_SURFACE: u32 = 0xfffffffeu;

// The largest probability of a path to survive Russian roulette.
const LIKELIEST: f32 = 0.95;

// The continuation of a path, if there is one.
struct Leg {
    x: Real3,
    v: Real3,
    tau: Real,
    // The surface that it leaves, or OFF_SURFACE.
    primitive: u32,
    // ALIVE, or the status with which it ends.
    code: u32,
}

// Continues the path of a ray that met a surface, and takes the light of the sky if it met none. The code after all cases is shared, because
// code under a condition also costs the time of neighboring lanes.
//
// ray: at the start of its last segment. It is returned active from the surface that it met, or with the status that ends it.
fn scatter_ray(ray: Ray, met: ptr<function, Hit>, pixel: vec2u) -> Ray {
    if carried.flight == OVER || (carried.flight == OWN && ray.status != HIT && ray.status != ESCAPED) {
        return ray;
    }
    let end = path_end(ray, *met);
    if TRANSFERS {
        if COUNTS_TRANSFER {
            note_glow();
        }
        transfer_end(pixel, ray, end);
    }
    var leg = Leg(end.x, end.v, end.tau, OFF_SURFACE, ray.status);
    if ray.status == HIT {
        leg = met_surface_leg(ray, met, end, pixel);
    } else if ray.status == ESCAPED {
        gather(sky_radiance(vec3f(normalize(end.v))), end.x);
    }
    leg = after_flight(leg, ray.status);
    var next = ray;
    next.status = leg.code;
    if leg.code == ALIVE && ray.index + 1u >= schedule.max_segments {
        next.status = EXHAUSTED;
    }
    if next.status != ALIVE {
        carried.flight = OVER;
        return next;
    }
    next.phase = opaque_phase(law_start(leg.x, leg.v));
    next.tau = opaque(leg.tau);
    next.rest = 0.0;
    next.memory = first_memory(next.phase);
    next.index += 1u;
    set_last_hit(leg.primitive);
    return next;
}

fn met_surface_leg(ray: Ray, met: ptr<function, Hit>, end: PathPoint, pixel: vec2u) -> Leg {
    let surface = met_surface(met, end.x);
    let material = materials[surface.material];
    let side = region_bits();
    let scattered = scattered_at(material, surface, end, ray.index, pixel);
    if !scattered.continues {
        return met_matter(ray, end, surface, material, pixel);
    }
    carried.scatterings += 1u;
    let dark = scale_throughput(scattered.throughput);
    let cut = dark || scattered.cut || carried.scatterings > transport.depth;
    if cut {
        enter_set(side);
    }
    var leg = Leg(end.x, scattered.v, end.tau, (*met).primitive, select(ALIVE, CUT, cut));
    if IN_PIECES {
        leave_aside(surface, end, &leg);
    }
    if KEEPS_LENGTH {
        add_length(pixel, ray.phase, end.x, end.v);
    }
    var x = leg.x;
    if HAS_THROAT {
        pass_throat(material.kind, &x);
    }
    leg.x = x;
    return leg;
}

// Continues a path on a surface that is neither transparent nor a mirror.
fn met_matter(ray: Ray, end: PathPoint, surface: Surface, material: Material, pixel: vec2u) -> Leg {
    let way = vec3f(normalize(end.v));
    let normal = select(vec3f(surface.normal), -vec3f(surface.normal), dot(vec3f(surface.normal), way) > 0.0);
    let shading_normal = select(surface.shading_normal, -surface.shading_normal, dot(surface.shading_normal, normal) < 0.0);
    let bsdf = bsdf_at(material, pattern_color(material, surface.uv));
    gather(bsdf.emission, end.x);
    let stays = Leg(end.x, end.v, end.tau, OFF_SURFACE, HIT);
    if carried.flight != OWN {
        return stays;
    }
    if carried.recorded == 0u {
        carried.recorded = 1u;
        keep_layers(pixel, ray, Seen(end, vec3f(0.0), normal, surface.object + 1u));
    }
    if all(bsdf.diffuse + bsdf.gloss <= vec3f(0.0)) {
        return stays;
    }
    if carried.scatterings >= transport.depth {
        return Leg(end.x, end.v, end.tau, OFF_SURFACE, CUT);
    }
    // Starts on the surface itself: the error of the end after a long path has nothing to do with the numbers there.
    let start = lit_from(end.x - surface.signed_distance * surface.normal, surface, -way);
    let mirror = way - 2.0 * dot(way, normal) * normal;
    let vertex = PathVertex(start, end.tau, length(end.v), normal, shading_normal, mirror, bsdf);
    let choice = path_point(pixel, CHOICE);
    let onward = sample_bsdf(vertex, path_point(pixel, DIRECTION), choice.x);
    let density = bsdf_density(vertex, onward);
    var throughput = carried.throughput * bsdf_cosine(vertex, onward) / max(density, 1e-30);
    throughput = select(vec3f(0.0), throughput, density > 0.0 && dot(onward, normal) > 0.0);
    let left = max(throughput.x, max(throughput.y, throughput.z));
    let survives = select(min(left, LIKELIEST), 1.0, carried.scatterings + 1u < transport.roulette);
    throughput = select(vec3f(0.0), throughput / max(survives, 1e-30), choice.y < survives && left > DARK);
    return left_vertex(vertex, onward, density, throughput, pixel);
}

// Returns the path's own ray from a vertex, with its throughput; `code` if that is negligible.
fn own_leg(x: Real3, v: Real3, tau: Real, throughput: vec3f, code: u32) -> Leg {
    carried.throughput = throughput;
    return Leg(x, v, tau, OFF_SURFACE, select(ALIVE, code, all(throughput <= vec3f(0.0))));
}
