// What is lit is found out without fail.

fn lit_status(code: u32, otherwise: u32) -> u32 {
    return code;
}
