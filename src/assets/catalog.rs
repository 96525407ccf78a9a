//! Star catalogs: directions, magnitudes and colors of stars from a file.

use std::fmt;
use std::path::Path;

use super::star_table::{Star, StarTable};
use crate::document::{Diagnostic, SceneError, read_text};

/// The stars of a file, in its order.
#[derive(Clone, PartialEq)]
pub struct Catalog {
    /// The name of the file.
    pub name: String,
    /// All stars.
    pub stars: Vec<Star>,
    /// `true` if every right ascension is at most 24, so that hours may have been meant.
    pub may_be_hours: bool,
}

impl fmt::Debug for Catalog {
    /// Writes the name and the number of stars.
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Self { name, stars, may_be_hours } = self;
        f.debug_struct("Catalog")
            .field("name", name)
            .field("stars", &stars.len())
            .field("may_be_hours", may_be_hours)
            .finish()
    }
}

/// The largest number of stars.
const MOST: usize = 1 << 24;
impl Catalog {
    /// Reads a file.
    ///
    /// # Errors
    ///
    /// Returns [`SceneError::Read`] if the file cannot be read, and otherwise the errors of [`parse`](Self::parse).
    pub fn load(path: &Path) -> Result<Self, SceneError> {
        Self::parse(&read_text(path)?, path)
    }

    /// Reads the text of a file; `path` names it in errors.
    ///
    /// # Errors
    ///
    /// Returns [`SceneError::Diagnostics`] if a column is missing or a value is invalid.
    pub fn parse(text: &str, path: &Path) -> Result<Self, SceneError> {
        let read = StarTable::new(text, path)?.read()?;
        let stars: Vec<&[Star]> = read.iter().map(|rows| &*rows.stars).collect();
        let stars = stars.concat();
        if stars.len() > MOST {
            let (problem, help) =
                (format!("more than {MOST} stars, found {}", stars.len()), "leave out the faintest".into());
            return Err(SceneError::Diagnostics(vec![Diagnostic::of(path, text, &text[..0], problem, help)]));
        }
        Ok(Self {
            name: path.file_name().unwrap_or_default().to_string_lossy().into_owned(),
            may_be_hours: read.iter().all(|rows| rows.may_be_hours),
            stars,
        })
    }

    /// Returns a message if hours may have been meant.
    #[must_use]
    pub fn warning(&self) -> Option<String> {
        /// The number of stars that are not all within 24 degrees by chance.
        const MANY: usize = 100;
        let (name, is_so) = (&self.name, self.may_be_hours && self.stars.len() >= MANY);
        is_so.then(|| {
            format!(
                "{name}: every `ra` is at most 24; degrees are expected, so name the column `ra_h` if these are hours"
            )
        })
    }

    /// Returns the memory that the stars take, in bytes.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        (self.stars.len() * size_of::<Star>()) as u64
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::super::star_table::temperature;
    use super::*;

    fn parsed(text: &str) -> Catalog {
        Catalog::parse(text, Path::new("s.csv")).unwrap()
    }

    #[test]
    fn columns_have_the_names_of_public_catalogs() {
        let of = |head: &str, row: &str| parsed(&format!("{head}\n{row}\n")).stars;
        let expected = of("ra,dec,mag,b_v", "90,0,1.5,0.65");
        assert!((expected[0].direction - DVec3::NEG_X).length() < 1e-15);
        for (head, row) in [
            ("# a catalog\nRA_h;DEC;Vmag;B-V;name", "6;0;1.5;;Sol"),
            ("name\traj2000\tdej2000\tmag\tci", "\"a, b\"\t 90 \t0\t1.5\t"),
        ] {
            assert_eq!(of(head, row), expected, "{head}");
        }
    }

    #[test]
    fn mistakes_have_places() {
        let place = |text: &str| match Catalog::parse(text, Path::new("s.csv")) {
            Err(SceneError::Diagnostics(all)) => all.iter().map(|one| (one.line, one.column)).collect::<Vec<_>>(),
            other => panic!("{text}: {other:?}"),
        };
        assert_eq!(place("ra,dec,vt\n1,2,3\n"), [(1, 1)]);
        assert_eq!(
            place("# a\nra,dec,mag,name\n# b\n\n1,123,3,c\n1,2,3,\"d, e\"\n\"1\", 2, x,\"f\"\n"),
            [(5, 3), (7, 9)]
        );
        assert_eq!(place("ra,dec,mag\n1,2,3\n1,123.4,3\nnan,1,2\n1,2,inf\n1,2\n"), [(3, 3), (4, 1), (5, 5), (6, 1)]);
    }

    #[test]
    fn parts_of_a_file_have_all_rows_in_order() {
        let row = |i: u32| {
            format!("{:.4},{:.4},{:.4}", f64::from(i % 3600) / 10.0, f64::from(i % 900) / 10.0, f64::from(i) * 1e-4)
        };
        let text = |end: &str| format!("ra,dec,mag{end}{}", (0..150_000).map(|i| row(i) + end).collect::<String>());
        let stars = parsed(&text("\n")).stars;
        assert_eq!(stars.len(), 150_000);
        assert!(stars.windows(2).all(|pair| pair[0].magnitude < pair[1].magnitude));
        assert_eq!(stars, parsed(&text("\r\n")).stars);
        assert_eq!(stars, parsed(&text("\n").replacen("mag", "\"mag\"", 1)).stars);
    }

    #[test]
    fn hours_that_are_called_degrees_are_noticed() {
        let of = |step: f64| {
            let rows = (0..200).map(|i| format!("{},0,1\n", f64::from(i) * step));
            parsed(&format!("ra,dec,mag\n{}", rows.collect::<String>())).warning()
        };
        assert_eq!([of(0.12).is_some(), of(1.2).is_some()], [true, false]);
    }

    #[test]
    fn blue_stars_are_hot() {
        let kelvins = [-0.4, 0.0, 0.65, 1.5, f64::NAN].map(|index| temperature(Some(index).filter(|x| !x.is_nan())));
        assert!((kelvins[2] - 5_780.0).abs() < 30.0, "{}", kelvins[2]);
        assert!(kelvins.windows(2).take(3).all(|pair| pair[0] > pair[1]));
        assert_eq!(kelvins[4].to_bits(), kelvins[2].to_bits());
    }
}
