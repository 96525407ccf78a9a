// Looks for the stars in a part of a cell of the grid.

// Returns the directions at the corners of a square part of the cell.
fn part_corners(at: vec2f, side: f32) -> array<vec3f, 4> {
    return array<vec3f, 4>(
        patch_way(at),
        patch_way(at + vec2f(side, 0.0)),
        patch_way(at + vec2f(0.0, side)),
        patch_way(at + vec2f(side)),
    );
}

// Returns (p × q)·s. Differences of close directions are exact, and neighboring cells compute those on a common edge in the same way, so
// that exactly one of them contains the star.
fn wound(p: vec3f, q: vec3f, s: vec3f) -> f32 {
    return dot(cross(p - s, q - s), s);
}

// The position of a star in a part of the cell, if it is there: the weights of three corners.
struct InPart {
    there: bool,
    at: vec2f,
}

// Looks for a star in the two triangles of a part: above and below the diagonal from the first to the last corner, or in the one triangle
// that three rays span. An edge that contains the star counts as one to its left.
fn in_part(corners: array<vec3f, 4>, s: vec3f) -> InPart {
    let ab = wound(corners[0], corners[1], s);
    let ac = wound(corners[0], corners[2], s);
    let bd = wound(corners[1], corners[3], s);
    let cd = wound(corners[2], corners[3], s);
    let ad = wound(corners[0], corners[3], s);
    let bc = wound(corners[1], corners[2], s);
    let abd = (ab >= 0.0) == (bd >= 0.0) && (ad >= 0.0) != (ab >= 0.0);
    let adc = (ac >= 0.0) == (cd >= 0.0) && (ad >= 0.0) != (ac >= 0.0);
    let bcd = (bc >= 0.0) == (cd >= 0.0) && (bd >= 0.0) != (bc >= 0.0);
    let abc = (ab >= 0.0) == (bc >= 0.0) && (ac >= 0.0) != (ab >= 0.0);
    var upper = abd;
    var lower = adc;
    if corner_missing < 4u {
        upper = abd && corner_missing == 2u;
        lower = adc && corner_missing == 1u;
    }
    // The weights of the corners, which have one sign.
    var weights = select(vec4f(-cd, 0.0, ad, -ac), vec4f(bd, -ad, 0.0, ab), upper);
    var there = upper || lower;
    if corner_missing == 0u {
        weights = vec4f(0.0, cd, -bd, bc);
        there = bcd;
    }
    if corner_missing == 3u {
        weights = vec4f(bc, -ac, ab, 0.0);
        there = abc;
    }
    let at = vec2f(weights.y + weights.w, weights.z + weights.w) / (weights.x + weights.y + weights.z + weights.w);
    return InPart(there, select(vec2f(0.5), at, abs(at) <= vec2f(1.0)));
}

// Adds the images in a square part of the cell.
fn scan_part(origin: vec2f, side: f32) {
    let corners = part_corners(origin, side);
    var faces = faces_of(corners, 0.0);
    loop {
        let face = min(firstTrailingBit(faces), 5u);
        scan_face(face, corners, origin, side);
        faces &= faces - 1u;
        continuing {
            break if faces == 0u;
        }
    }
}

fn scan_face(face: u32, corners: array<vec3f, 4>, origin: vec2f, side: f32) {
    var scan = star_scan(face, face_box(face, corners, cell_sky.buckets, 0.0), cell_sky);
    loop {
        // Proceeds to the next star that the part contains.
        var found = InPart(false, vec2f(0.0));
        var way: vec3f;
        loop {
            if scan.star < scan.until {
                way = normalize(from_face(face, star_list[scan.star].xy));
                found = in_part(corners, way);
                scan.star++;
            } else {
                scan = next_row(scan, cell_sky.buckets);
            }
            continuing {
                break if found.there || scan_ended(scan);
            }
        }
        if found.there {
            add_image(star_at(scan.star - 1u), way, origin + side * found.at);
        }
        continuing {
            break if scan_ended(scan);
        }
    }
}
