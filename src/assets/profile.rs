//! Profiles: the refractive index of layered air, measured at some heights, and a smooth curve through it.
//!
//! *Theory.* The curve is the natural cubic spline: a cubic between each two points, with equal slopes and second derivatives
//! where two cubics meet, and second derivatives of 0 at both ends. Outside it is constant. With dₖ the width of the piece k and
//! sₖ its mean slope, the halved second derivatives b solve dₖ₋₁ bₖ₋₁ + 2(dₖ₋₁ + dₖ) bₖ + dₖ bₖ₊₁ = 3(sₖ − sₖ₋₁): a row with three
//! terms for each inner point, solved by elimination from the top and substitution from the bottom.
//!
//! *Practice.* The CSV parser is part of this file: the header `height,n`, then a line for each point; spaces and empty lines are ignored.

use crate::document::{Diagnostic, SceneError, read_text};
use std::path::Path;

/// The refractive index n as a function of height.
#[derive(Debug, Clone, PartialEq)]
pub struct Profile {
    /// The points, two or more, sorted by height.
    pub points: Vec<ProfilePoint>,
}

/// A point, and the cubic from there to the next: n + t (slope + t (bend + t twist)), with t the height above the point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ProfilePoint {
    /// The height above the medium's origin, in scene units.
    pub height: f64,
    /// The refractive index n.
    pub n: f64,
    /// The slope dn/dy.
    pub slope: f64,
    /// Half of d²n/dy².
    pub bend: f64,
    /// A sixth of d³n/dy³.
    pub twist: f64,
}

/// The reason why points do not define a profile.
#[derive(Debug, Clone, PartialEq)]
pub struct ProfileError {
    /// The index of the point, if the error is in one.
    pub point: Option<usize>,
    /// The problem.
    pub problem: String,
    /// The remedy.
    pub help: String,
}

/// The header of a file.
const COLUMNS: &str = "height,n";
/// The number of errors after which a file is not read further.
const ENOUGH: usize = 10;

impl Profile {
    /// Computes the spline through points `[height, n]`, with positive n.
    ///
    /// # Errors
    ///
    /// Returns the first flaw: fewer than two points, heights that do not ascend or are too close, or a curve that falls to 0 or below.
    pub fn through(points: &[[f64; 2]]) -> Result<Self, ProfileError> {
        if points.len() < 2 {
            let problem = format!("a profile requires at least two points, found {}", points.len());
            return Err(ProfileError {
                point: None,
                problem,
                help: "give each point as a height and its n".to_owned(),
            });
        }
        if let Some(k) = points.windows(2).position(|pair| pair[1][0] <= pair[0][0]) {
            let problem = format!("the height {} is not above the previous height, {}", points[k + 1][0], points[k][0]);
            return Err(ProfileError {
                point: Some(k + 1),
                problem,
                help: "sort the points by ascending height".to_owned(),
            });
        }
        let profile = Self { points: spline(points) };
        let is_finite = |p: &ProfilePoint| [p.slope, p.bend, p.twist].iter().all(|x| (*x as f32).is_finite());
        if !profile.points.iter().all(is_finite) {
            let width = |k: &usize| points[k + 1][0] - points[*k][0];
            let k = (0..points.len() - 1).min_by(|a, b| width(a).total_cmp(&width(b))).unwrap_or(0);
            let [before, height] = [points[k][0], points[k + 1][0]];
            let problem =
                format!("the height {height:e} is too close to the previous height, {before:e}, for a finite slope");
            return Err(ProfileError { point: Some(k + 1), problem, help: "remove one of the two points".to_owned() });
        }
        let (height, n) = profile.lowest();
        if n <= 0.0 {
            let problem = format!("the curve through the points falls to n = {n:.4} at height {height:.4}");
            let help = "add points near this minimum, because n must stay above 0".to_owned();
            return Err(ProfileError { point: None, problem, help });
        }
        Ok(profile)
    }

    /// Returns n at a height.
    #[must_use]
    pub fn index(&self, y: f64) -> f64 {
        let above = self.points.partition_point(|point| point.height <= y);
        match above {
            0 => self.points[0].n,
            above if above == self.points.len() => self.points[above - 1].n,
            above => self.points[above - 1].at(y - self.points[above - 1].height),
        }
    }

    /// Returns the minimum of n with its height: a point, or a position where a cubic's slope is 0.
    fn lowest(&self) -> (f64, f64) {
        let turns = self.points.windows(2).flat_map(|pair| {
            let (point, width) = (pair[0], pair[1].height - pair[0].height);
            let inside = point.turns().into_iter().filter(move |t| *t > 0.0 && *t < width);
            inside.map(move |t| (point.height + t, point.at(t)))
        });
        let points = self.points.iter().map(|point| (point.height, point.n));
        let lower = |a: (f64, f64), b: (f64, f64)| if b.1 < a.1 { b } else { a };
        points.chain(turns).fold((0.0, f64::INFINITY), lower)
    }

    /// Reads a CSV file.
    ///
    /// # Errors
    ///
    /// Returns [`SceneError::Read`] if the file cannot be read, and otherwise the errors of [`parse`](Self::parse).
    pub fn load(path: &Path) -> Result<Self, SceneError> {
        Self::parse(&read_text(path)?, path)
    }

    /// Reads the text of a CSV file; `path` names it in errors.
    ///
    /// # Errors
    ///
    /// Returns [`SceneError::Diagnostics`] if the header or a row is invalid, or the points do not define a profile (see
    /// [`through`](Self::through)).
    pub fn parse(text: &str, path: &Path) -> Result<Self, SceneError> {
        let mistake =
            |part: &str, problem: String, help: &str| Diagnostic::of(path, text, part, problem, help.to_owned());
        let lines = text.lines().map(str::trim);
        let mut lines = lines.filter(|line| !line.is_empty());
        let header = lines.next().unwrap_or(&text[..0]);
        if !header.split(',').map(str::trim).eq(COLUMNS.split(',')) {
            let problem = format!("expected the columns {COLUMNS}, found `{header}`");
            return Err(SceneError::Diagnostics(vec![mistake(header, problem, "name the columns in the first line")]));
        }
        let (mut mistakes, mut points, mut places) = (Vec::new(), Vec::new(), Vec::new());
        for line in lines {
            match point(line) {
                Ok(point) => {
                    points.push(point);
                    places.push(line.split(',').next().unwrap_or(line).trim_end());
                }
                Err((part, problem)) => mistakes.push(mistake(part, problem, "for example 120.5,1.00027")),
            }
            if mistakes.len() == ENOUGH {
                break;
            }
        }
        if !mistakes.is_empty() {
            return Err(SceneError::Diagnostics(mistakes));
        }
        Self::through(&points).map_err(|flaw| {
            let part = flaw.point.map_or(&text[..0], |k| places[k]);
            SceneError::Diagnostics(vec![mistake(part, flaw.problem, &flaw.help)])
        })
    }
}

impl ProfilePoint {
    fn at(&self, t: f64) -> f64 {
        self.n + t * (self.slope + t * (self.bend + t * self.twist))
    }

    /// Returns the positions where the cubic's slope is 0; missing roots are not finite.
    fn turns(&self) -> [f64; 2] {
        // slope + 2 bend t + 3 twist t² = 0; neither root is computed from a difference of close numbers.
        let root = (self.bend * self.bend - 3.0 * self.twist * self.slope).sqrt();
        let q = -(self.bend + root.copysign(self.bend));
        [q / (3.0 * self.twist), self.slope / q]
    }
}

fn spline(points: &[[f64; 2]]) -> Vec<ProfilePoint> {
    let last = points.len() - 1;
    let width = |k: usize| points[k + 1][0] - points[k][0];
    let mean = |k: usize| (points[k + 1][1] - points[k][1]) / width(k);
    // bₖ = value − factor · bₖ₊₁, from the top down; b is 0 at both ends.
    let mut eliminated = vec![(0.0, 0.0)];
    for k in 1..last {
        let (value, factor) = eliminated[k - 1];
        let pivot = 2.0 * (width(k - 1) + width(k)) - width(k - 1) * factor;
        let right = 3.0 * (mean(k) - mean(k - 1)) - width(k - 1) * value;
        eliminated.push((right / pivot, width(k) / pivot));
    }
    let mut bends = vec![0.0; points.len()];
    for k in (0..last).rev() {
        let (value, factor) = eliminated[k];
        bends[k] = value - factor * bends[k + 1];
    }
    let piece = |k: usize| {
        let [height, n] = points[k];
        if k == last {
            return ProfilePoint { height, n, slope: 0.0, bend: 0.0, twist: 0.0 };
        }
        let slope = mean(k) - width(k) * (2.0 * bends[k] + bends[k + 1]) / 3.0;
        ProfilePoint { height, n, slope, bend: bends[k], twist: (bends[k + 1] - bends[k]) / (3.0 * width(k)) }
    };
    (0..=last).map(piece).collect()
}

/// Parses the numbers of a line; an error contains the invalid part of it.
fn point(line: &str) -> Result<[f64; 2], (&str, String)> {
    let fields: Vec<&str> = line.split(',').map(str::trim).collect();
    let [height, n] = fields[..] else {
        return Err((line, format!("expected 2 numbers, found {}", fields.len())));
    };
    let number = |field| match str::parse::<f64>(field) {
        Ok(number) if number.abs() <= 1e30 => Ok(number),
        _ => Err((if field.is_empty() { line } else { field }, format!("expected a number, found `{field}`"))),
    };
    let (height, value) = (number(height)?, number(n)?);
    if value <= 0.0 {
        return Err((n, format!("n must be above 0, found {n}")));
    }
    Ok([height, value])
}
