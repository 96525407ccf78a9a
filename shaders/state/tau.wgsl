// Sums the parameter of the path. If paths end by it, in 32 bits, the rounding error of each sum is kept (Knuth's two-sum): thousands of
// short steps would each lose up to half of the sum's last digit. The error is stored between passes in W.

fn later(ray: Ray, passed: Real) -> Ray {
    var next = ray;
    if COMPENSATES_TAU {
        let more = opaque(passed + ray.rest);
        next.tau = opaque(ray.tau + more);
        let added = opaque(next.tau - ray.tau);
        next.rest = opaque((ray.tau - opaque(next.tau - added)) + (more - added));
    } else {
        // One by one: otherwise compilers may sum several steps differently in different programs.
        next.tau = opaque(ray.tau + passed);
    }
    return next;
}
