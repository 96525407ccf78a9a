// The transmittance of matter along straight lines to lights.

// True on a straight line, which begins at `line_start` and has the direction and length `line_way`.
var<private> on_line: bool;
var<private> line_start: Real3;
var<private> line_way: Real3;

// Returns the transmittance along `way`, in the medium at its start. Matter on a line adds no light.
fn line_share(start: Real3, way: Real3) -> vec3f {
    let kept = transferred;
    transferred = Light();
    transfer_doubts = array<Real2, CHANNELS>();
    transfer_invalid = false;
    transfer_unsettled = false;
    line_start = start;
    line_way = way;
    on_line = true;
    transfer_step(Stretch(Phase(), 1.0, 0.0, StepPolynomial()), 1.0);
    on_line = false;
    note_doubts();
    let depth = transferred.depth;
    transferred = kept;
    if transfer_unsettled {
        tally_at_once(UNSETTLED);
    }
    if transfer_invalid {
        fail_transfer();
    }
    let first = f32(transfer_exp(depth[0]));
    if IS_SPECTRAL {
        return vec3f(first);
    }
    return vec3f(first, f32(transfer_exp(depth[1])), f32(transfer_exp(depth[2])));
}
