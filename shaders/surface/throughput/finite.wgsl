// The throughput at the end of a ray, and the limit below which it is negligible.

// A path whose throughput is below this adds nothing that a float of the image could show.
const DARK: f32 = 1e-8;

// A path that began or ended at a singularity of the index has no light.
fn finite_throughput(throughput: vec3f) -> vec3f {
    return select(vec3f(0.0), throughput, finite(Real3(throughput)));
}
