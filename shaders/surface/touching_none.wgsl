// No surface lies on another: what a ray meets has its own object behind it, and no more.

fn met_surface(met: ptr<function, Hit>, x: Real3) -> Surface {
    return hit_surface((*met).primitive, x);
}

fn set_beyond(own: u32, surface: Surface, x: Real3) -> u32 {
    return inside ^ own;
}
