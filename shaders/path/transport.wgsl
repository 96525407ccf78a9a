// The settings of path tracing.

struct Transport {
    // The number of scatterings after which a path is cut.
    depth: u32,
    // The number of scatterings after which Russian roulette begins.
    roulette: u32,
    seed: u32,
}

var<uniform> transport: Transport;
