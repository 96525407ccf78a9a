// For each object its bit in the set of regions, or NO_BIT.

@group(0) @binding(111) var<storage, read> object_bits: array<u32>;

const NO_BIT: u32 = 32u;
