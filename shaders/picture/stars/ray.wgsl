// The skies with stars that the rays of the grid reach.

// A catalog, oriented in a scene.
struct StarSky {
    // The axes of the catalog in the scene.
    first: vec3f,
    second: vec3f,
    third: vec3f,
    // The number of buckets along the edge of a face of the cube; 0 if this sky has no stars.
    buckets: u32,
    // The positions of its first bucket, star and mean in their lists.
    first_bucket: u32,
    first_mean: u32,
    // The radius of a star's disk, in radians, which limits the brightness on critical curves.
    radius: f32,
    // The mean radiance of the whole sky.
    mean: vec3f,
}

// The light of stars in each pixel, of all branches of the grid.
var<storage, read_write> pixel_starlight: array<vec3f>;
var<storage, read> star_skies: array<StarSky>;

// Returns a direction of the scene in the axes of a catalog.
fn in_star_axes(d: Real3, side: u32) -> Real3 {
    let own = star_skies[side];
    return Real3(dot(Real3(own.first), d), dot(Real3(own.second), d), dot(Real3(own.third), d));
}

fn from_star_axes(d: vec3f, side: u32) -> vec3f {
    let own = star_skies[side];
    return d.x * own.first + d.y * own.second + d.z * own.third;
}

// Returns the end of the ray of a pixel if it reaches a sky with stars, else 0.
fn star_end(place: u32) -> u32 {
    let end = grid_rays[place].end;
    return select(0u, end, (end & END_KIND) == ESCAPED && star_skies[side_of(end)].buckets > 0u);
}

fn star_sky(end: u32) -> StarSky {
    return star_skies[side_of(end)];
}
