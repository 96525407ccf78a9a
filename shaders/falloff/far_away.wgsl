// Further than any scene reaches.
const FAR_AWAY: Real = 1e30;
