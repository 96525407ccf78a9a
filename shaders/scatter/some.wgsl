// From some surfaces rays go on: the pass that scatters them looks at all that met one.

fn goes_on(code: u32) -> bool {
    return code == HIT;
}
