// Layered air with a measured profile: n as a function of the height above the origin, a cubic between neighboring points, constant below
// the first point and above the last.

struct Medium {
    origin: Real3,
    up: Real3,
    // The index of its first point in `profile`, and the number of its points.
    first: u32,
    points: u32,
}

var<uniform> media: array<Medium, MEDIA_COUNT>;

// A point, and the cubic from there to the next: n + t (slope + t (bend + t twist)), t being the height above the point.
struct ProfilePoint {
    height: Real,
    n: Real,
    slope: Real,
    bend: Real,
    twist: Real,
}

var<storage, read> profile: array<ProfilePoint>;

// Returns the last point that is not above y, or the first one; the very last point has no cubic.
fn profile_piece(y: Real) -> u32 {
    var low = media[place].first;
    var high = low + media[place].points - 1u;
    while high - low > 1u {
        let middle = (low + high) / 2u;
        if profile[middle].height <= y {
            low = middle;
        } else {
            high = middle;
        }
    }
    return low;
}

fn profile_height(x: Real3) -> Real {
    return dot(x - media[place].origin, media[place].up);
}

// Returns n and dn/dy.
fn profile_index(x: Real3) -> Real2 {
    let y = profile_height(x);
    let low = profile[media[place].first];
    let high = profile[media[place].first + media[place].points - 1u];
    let point = profile[profile_piece(y)];
    let t = y - point.height;
    let n = point.n + t * (point.slope + t * (point.bend + t * point.twist));
    let slope = point.slope + t * (2.0 * point.bend + 3.0 * t * point.twist);
    let inside = select(Real2(high.n, 0.0), Real2(n, slope), y < high.height);
    return select(Real2(low.n, 0.0), inside, y > low.height);
}

fn medium_index(x: Real3) -> Real {
    return profile_index(x).x;
}

// Returns ∇(n²/2).
fn medium_pull(x: Real3) -> Real3 {
    let n = profile_index(x);
    return (n.x * n.y) * media[place].up;
}

// Returns the characteristic length of the index: between two points their distance, outside the profile that plus the distance to its
// first or last point.
fn medium_length(x: Real3) -> Real {
    let y = profile_height(x);
    let k = profile_piece(y);
    let low = profile[k].height;
    let high = profile[k + 1u].height;
    return high - low + max(max(low - y, y - high), 0.0);
}
