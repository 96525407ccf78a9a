// As surface/material/phong.wgsl, with as much of the ambient light as reaches the place.

const PHONG_OCCLUDED: u32 = 7u;

fn radiance_phong_occluded(material: Material, color: vec3f, lit: Lit) -> vec3f {
    return material.emission + open_part(lit) * material.ambient * color + lit_radiance(material, color, lit);
}
