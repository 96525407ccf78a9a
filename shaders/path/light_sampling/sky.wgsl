// Samples the environment map: directions in the cells of a sphere, with a frequency proportional to the excess of their brightness over
// the mean of the whole sky (Karlík et al. 2019). The uniform part is left to the surface's own rays, which find it equally well.

const SKY_COLUMNS: u32 = 512u;
const SKY_ROWS: u32 = 256u;

// Cumulative sums of the excess of cells over the mean, divided by the total. The sphere has the layout of an equirectangular environment
// map.
struct SkyCells {
    // Radiance times solid angle, summed over the colors.
    total: f32,
    // The sums up to the end of each row, from the top.
    rows: array<f32, SKY_ROWS>,
    // The sums along each row.
    cells: array<f32, SKY_ROWS * SKY_COLUMNS>,
}

var<storage, read> sky_cells: SkyCells;

fn sky_brightness(vertex: PathVertex) -> f32 {
    return sky_cells.total;
}

// One number chooses the row, the other the column; rescaled, both choose the point in the cell.
fn sky_way(vertex: PathVertex, total: f32, u: vec2f) -> vec3f {
    var row = 0u;
    for (var half = SKY_ROWS / 2u; half > 0u; half /= 2u) {
        row += select(0u, half, sky_cells.rows[row + half - 1u] <= u.x);
    }
    var column = 0u;
    for (var half = SKY_COLUMNS / 2u; half > 0u; half /= 2u) {
        column += select(0u, half, sky_cells.cells[row * SKY_COLUMNS + column + half - 1u] <= u.y);
    }
    let down = sky_row(row);
    let across = sky_column(row, column);
    let at = clamp((u - vec2f(down.x, across.x)) / max(vec2f(down.y, across.y), vec2f(1e-30)), vec2f(0.0), vec2f(1.0));
    let polar = f32(PI) * (f32(row) + at.x) / f32(SKY_ROWS);
    let around = 2.0 * f32(PI) * ((f32(column) + at.y) / f32(SKY_COLUMNS) - 0.5);
    return vec3f(sin(polar) * sin(around), cos(polar), -sin(polar) * cos(around));
}

// Returns the sum before a row, and the row's part.
fn sky_row(row: u32) -> vec2f {
    let before = select(0.0, sky_cells.rows[max(row, 1u) - 1u], row > 0u);
    return vec2f(before, sky_cells.rows[row] - before);
}

// Returns the sum before a cell in its row, and the cell's part.
fn sky_column(row: u32, column: u32) -> vec2f {
    let at = row * SKY_COLUMNS + column;
    let before = select(0.0, sky_cells.cells[max(at, 1u) - 1u], column > 0u);
    return vec2f(before, sky_cells.cells[at] - before);
}

fn sky_density(vertex: PathVertex, total: f32, d: vec3f) -> f32 {
    let across = length(d.xz);
    let u = 0.5 + f32(arc_tangent(Real(d.x), Real(-d.z))) / (2.0 * f32(PI));
    let v = 0.5 - f32(arc_tangent(Real(d.y), Real(across))) / f32(PI);
    let column = min(u32(u * f32(SKY_COLUMNS)), SKY_COLUMNS - 1u);
    let row = min(u32(v * f32(SKY_ROWS)), SKY_ROWS - 1u);
    let cell = 2.0 * f32(PI) * f32(PI) * max(across, 1e-6) / f32(SKY_ROWS * SKY_COLUMNS);
    return sky_row(row).y * sky_column(row, column).y / cell;
}
