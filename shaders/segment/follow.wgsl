// Follows one segment, and finds the last step of a path. A segment is one accepted step; or the chord over N steps (W04 §3.2), or over
// fewer if the path ends before.

struct Chord {
    steps: u32,
}

var<uniform> chord: Chord;

fn follow_segment(ray: ptr<function, Ray>) -> Segment {
    let start = (*ray).phase;
    if HAS_CHORDS {
        for (var i = 0u; i < chord.steps; i++) {
            if path_over(*ray) {
                break;
            }
            *ray = accepted_step(*ray);
        }
        let end = (*ray).phase;
        return Segment(start[0].xyz, start[1].xyz, end[0].xyz, end[1].xyz, 0.0);
    }
    if TRANSFERS_ORBITS {
        *ray = lit_step(*ray);
    } else {
        *ray = accepted_step(*ray);
    }
    let end = (*ray).phase;
    return Segment(start[0].xyz, path_velocity(start[1].xyz), end[0].xyz, path_velocity(end[1].xyz), (*ray).taken);
}

var<private> kept_end: Ray;

fn keep_end(next: Ray) {
    kept_end = next;
}

// Returns the last step: stored if the same pass looks for the end of the path, and otherwise retaken from the start of the segment.
fn last_step(ray: Ray) -> LastStep {
    if KEEPS_LAST {
        return LastStep(ray.phase, ray.tau, own_size(ray, kept_end), kept_end.phase, kept_end.tau);
    }
    if HAS_CHORDS {
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
    let next = accepted_step(ray);
    return LastStep(ray.phase, ray.tau, own_size(ray, next), next.phase, next.tau);
}
