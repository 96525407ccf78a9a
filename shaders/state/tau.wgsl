// The path's parameter. Where paths end by it, in 32 bits, it is summed with what each sum rounds away (Knuth's two-sum): thousands of short
// steps would each lose up to half of the sum's last digit. What is left is kept between passes in W.

fn later(ray: Ray, passed: Real) -> Ray {
    var next = ray;
    if COMPENSATES_TAU {
        let more = opaque(passed + ray.rest);
        next.tau = opaque(ray.tau + more);
        let added = opaque(next.tau - ray.tau);
        next.rest = opaque((ray.tau - opaque(next.tau - added)) + (more - added));
    } else {
        // One by one: compilers may sum up those of several steps otherwise where a program goes on otherwise.
        next.tau = opaque(ray.tau + passed);
    }
    return next;
}
