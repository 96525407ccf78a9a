// Aims at the sky's picture: into the cells of a globe, as often as they are brighter than the whole sky is in the mean (Karlík et al. 2019).
// What is even is left to the surface's own rays, which find it as well.

const SKY_COLUMNS: u32 = 512u;
const SKY_ROWS: u32 = 256u;

// Sums of what cells are above the mean, over that of all. The globe lies as an equirectangular picture does.
struct SkyCells {
    // Radiance times solid angle, of all colours together.
    total: f32,
    // Up to the end of each row, from the top.
    rows: array<f32, SKY_ROWS>,
    // Along each row.
    cells: array<f32, SKY_ROWS * SKY_COLUMNS>,
}

var<storage, read> sky_cells: SkyCells;

fn sky_brightness(vertex: PathVertex) -> f32 {
    return sky_cells.total;
}

// One number chooses the row, the other the column; stretched to what is left of them, both choose the place in the cell.
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

// The sum before a row, and what the row adds.
fn sky_row(row: u32) -> vec2f {
    let before = select(0.0, sky_cells.rows[max(row, 1u) - 1u], row > 0u);
    return vec2f(before, sky_cells.rows[row] - before);
}

// The same of a cell in its row.
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
