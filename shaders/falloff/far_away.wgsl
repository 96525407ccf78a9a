// Further than any scene reaches.
const FAR_AWAY: f32 = 1e30;
