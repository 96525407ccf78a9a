// A segment is the chord over N steps (W04 §3.2), or fewer where the path is over before.

struct Chord {
    steps: u32,
}

var<uniform> chord: Chord;

fn follow_segment(ray: ptr<function, Ray>) -> Segment {
    let start = (*ray).phase;
    for (var i = 0u; i < chord.steps; i++) {
        if path_over(*ray) {
            break;
        }
        *ray = accepted_step(*ray);
    }
    let end = (*ray).phase;
    return Segment(start[0].xyz, start[1].xyz, end[0].xyz, end[1].xyz, 0.0);
}

// The last step of the segment that starts here.
fn last_step(ray: Ray) -> LastStep {
    var before = ray;
    var next = ray;
    for (var i = 0u; i < chord.steps; i++) {
        if path_over(next) {
            break;
        }
        before = next;
        next = accepted_step(next);
    }
    return LastStep(before.phase, before.tau, own_size(before, next), next.phase, next.tau);
}
