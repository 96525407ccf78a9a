// Computes the light from the surface that a ray hit. Normals face the viewer.

fn seen_at(ray: Ray, hit: Hit) -> Seen {
    let end = path_end(ray, hit);
    if !HAS_OBJECTS {
        return Seen(end, vec3f(0.0), vec3f(0.0), 0u);
    }
    if ray.status != HIT {
        return Seen(end, vec3f(0.0), vec3f(0.0), 0u);
    }
    let surface = hit_surface(hit.primitive, end.x);
    let view = vec3f(-normalize(end.v));
    let normal = vec3f(surface.normal);
    // The geometric normal determines the visible side, because the winding of a mesh's triangles may not agree with its normals.
    let seen_side = dot(normal, view) * dot(normal, surface.shading_normal);
    let shading_normal = select(-surface.shading_normal, surface.shading_normal, seen_side >= 0.0);
    let material = materials[surface.material];
    if OCCLUDES_ALONG_LAW {
        note_arrival(end);
    }
    if KNOWS_SHIFT {
        note_matter(material, end);
    }
    if KEEPS_FOOTPRINTS {
        note_place(surface.object, surface.uv);
    }
    let lit = Lit(vec3f(end.x), lit_from(end.x, surface, view), shading_normal, view);
    let color = surface_radiance(material, pattern_color(material, surface.uv), lit);
    return Seen(end, color, shading_normal, surface.object + 1u);
}

// Returns the position where the ray ended, and the object that it hit.
fn recorded_at(ray: Ray, hit: Hit) -> Recorded {
    let end = path_end(ray, hit);
    if !HAS_OBJECTS {
        return Recorded(end, 0u);
    }
    if ray.status != HIT {
        return Recorded(end, 0u);
    }
    return Recorded(end, hit_surface(hit.primitive, end.x).object + 1u);
}
