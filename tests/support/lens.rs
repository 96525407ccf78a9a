//! Rows of `tables/lenses.tsv`: rays through media inside objects, and their scenes.

use bentray::scene::{Bound, Scene};
use glam::DVec3;

/// A ray and its expected path.
#[derive(Debug, Clone)]
pub struct Lens {
    /// The name of the row.
    pub name: &'static str,
    /// The object, as lines of its table in a scene file.
    pub object: String,
    /// The bounding sphere, which contains the object and the start of the ray.
    pub bound: Bound,
    /// The start of the ray.
    pub origin: DVec3,
    /// The direction at the start, of any length.
    pub direction: DVec3,
    /// The outcome.
    pub fate: Fate,
    /// The point at which it enters the object, with its direction inside, unless it starts inside.
    pub entry: Option<(DVec3, DVec3)>,
    /// The reflectance of the surface there, if known.
    pub entry_reflectance: Option<f64>,
    /// The point at which it meets the surface from inside, with its direction there.
    pub exit: Option<(DVec3, DVec3)>,
    /// Its direction after that.
    pub onward: Option<DVec3>,
    /// The reflectance of the surface there.
    pub exit_reflectance: Option<f64>,
    /// The angle around the center inside, in radians.
    pub swept: Option<f64>,
    /// The effect of one rounding of the input to 32 bits on position and direction; 0 if not computed.
    pub sensitivity: [f64; 2],
}

/// The outcome for a ray inside an object.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Fate {
    /// It leaves.
    Exit,
    /// It is totally reflected at the first surface that it meets from inside.
    Total,
    /// It winds into the center.
    Centre,
}

/// Returns the rows of a table without its head, cut into columns.
pub fn columns(table: &'static str) -> impl Iterator<Item = Vec<&'static str>> {
    table.lines().filter(|line| !line.starts_with('#')).map(|line| line.split('\t').collect())
}

/// Returns three numbers, or `None` for a dash.
pub fn vector(text: &str) -> Option<DVec3> {
    let mut words = text.split(' ').map(str::parse);
    (text != "-").then(|| DVec3::from([(); 3].map(|()| words.next().unwrap().unwrap())))
}

/// Returns a number, or `None` for a dash.
pub fn number(text: &str) -> Option<f64> {
    (text != "-").then(|| text.parse().unwrap())
}

/// Returns every row.
pub fn lenses() -> Vec<Lens> {
    let given = |text| vector(text).unwrap();
    let row = |row: Vec<&'static str>| Lens {
        name: row[0],
        object: row[1].replace(';', "\n"),
        bound: Bound { center: given(row[2]), radius: row[2].rsplit(' ').next().unwrap().parse().unwrap() },
        origin: given(row[3]),
        direction: given(row[4]),
        fate: match row[5] {
            "exit" => Fate::Exit,
            "total" => Fate::Total,
            "centre" => Fate::Centre,
            other => panic!("{}: {other}", row[0]),
        },
        entry: vector(row[6]).zip(vector(row[7])),
        entry_reflectance: number(row[8]),
        exit: vector(row[9]).zip(vector(row[10])),
        onward: vector(row[11]),
        exit_reflectance: number(row[12]),
        swept: number(row[13]),
        sensitivity: [row[14], row[15]].map(|text| number(text).unwrap_or(0.0)),
    };
    columns(include_str!("../tables/lenses.tsv")).map(row).collect()
}

/// Returns the object of the row in air, as a scene file; `rays` are further lines of its [rays].
pub fn lens_scene(lens: &Lens, rays: &str) -> String {
    let ([x, y, z], radius) = (lens.bound.center.to_array(), lens.bound.radius);
    format!(
        "[rays]\n{rays}\nbounding_sphere = {{ center = [{x:?}, {y:?}, {z:?}], radius = {radius:?} }}\n[[objects]]\n{}\n",
        lens.object
    )
}

impl Lens {
    /// Returns the scene of the row as the tracer needs it.
    pub fn scene(&self) -> Scene {
        super::scene(&lens_scene(self, ""))
    }

    /// Returns the point at which the ray finally leaves the bounding sphere, with its unit direction there.
    pub fn end(&self) -> Option<(DVec3, DVec3)> {
        let (Fate::Exit, Some((x, _)), Some(d)) = (self.fate, self.exit, self.onward) else { return None };
        let from = x - self.bound.center;
        let ahead = -from.dot(d) + (from.dot(d).powi(2) + self.bound.radius.powi(2) - from.length_squared()).sqrt();
        Some((x + ahead * d, d))
    }
}
