// All space is one region, with one medium if it has any.

const place: u32 = 0u;
