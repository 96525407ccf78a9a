//! Primaries: the colors of red, green and blue in an image.
//!
//! *Theory.* Four CIE 1931 chromaticities, of red, green, blue and white, determine the matrix from linear RGB to XYZ: its columns have the
//! directions of the primaries, and their sum is white. Colors with one white point are adapted to another by scaling the
//! responses of cones, given by the Bradford matrix (Lam 1985; the version of ICC.1, annex E).
//!
//! *Practice.* The renderer's colors are linear in the primaries of Rec. 709, with D65 as white, like sRGB.

use glam::{DMat3, DVec2, DVec3};

/// The chromaticities, x and y, of a color space's primaries and white.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Primaries {
    pub red: DVec2,
    pub green: DVec2,
    pub blue: DVec2,
    pub white: DVec2,
}

const D65: DVec2 = DVec2::new(0.3127, 0.329);
/// The white point of ICC profiles, as XYZ.
const D50: DVec3 = DVec3::new(0.9642, 1.0, 0.8249);

impl Primaries {
    pub const REC709: Self =
        Self { red: DVec2::new(0.64, 0.33), green: DVec2::new(0.3, 0.6), blue: DVec2::new(0.15, 0.06), white: D65 };
    pub const REC2020: Self = Self {
        red: DVec2::new(0.708, 0.292),
        green: DVec2::new(0.17, 0.797),
        blue: DVec2::new(0.131, 0.046),
        white: D65,
    };
    pub const DISPLAY_P3: Self =
        Self { red: DVec2::new(0.68, 0.32), green: DVec2::new(0.265, 0.69), blue: DVec2::new(0.15, 0.06), white: D65 };
    /// The largest difference of chromaticities that is due to rounding in files.
    const SAME: f64 = 2e-5;

    /// Creates primaries from red, green, blue and white, x before y.
    pub fn of([rx, ry, gx, gy, bx, by, wx, wy]: [f64; 8]) -> Self {
        let [red, green, blue, white] = [[rx, ry], [gx, gy], [bx, by], [wx, wy]].map(DVec2::from);
        Self { red, green, blue, white }
    }

    /// Returns the matrix from linear colors in these primaries to Rec. 709,
    /// the identity for Rec. 709 itself; `None` if they span no color space.
    pub fn to_rec709(self) -> Option<DMat3> {
        let all = |space: Self| [space.red, space.green, space.blue, space.white];
        let same = |(a, b): (DVec2, DVec2)| a.abs_diff_eq(b, Self::SAME);
        if all(self).into_iter().zip(all(Self::REC709)).all(same) {
            return Some(DMat3::IDENTITY);
        }
        let to_xyz = self.to_xyz()?;
        xyz_to_rec709(white_point(self.white)).map(|from_xyz| from_xyz * to_xyz)
    }

    fn to_xyz(self) -> Option<DMat3> {
        let direction = |c: DVec2| DVec3::new(c.x, c.y, 1.0 - c.x - c.y);
        let directions = DMat3::from_cols(direction(self.red), direction(self.green), direction(self.blue));
        let to_xyz = directions * DMat3::from_diagonal(inverse(directions)? * white_point(self.white));
        to_xyz.is_finite().then_some(to_xyz)
    }
}

/// Returns the matrix to Rec. 709 from the XYZ of ICC profiles.
pub(super) fn profile_to_rec709() -> Option<DMat3> {
    xyz_to_rec709(D50)
}

/// Returns the matrix from XYZ to Rec. 709 that maps this white, as XYZ, to `(1, 1, 1)`.
fn xyz_to_rec709(white: DVec3) -> Option<DMat3> {
    let bradford = DMat3::from_cols(
        DVec3::new(0.8951, -0.7502, 0.0389),
        DVec3::new(0.2664, 1.7135, -0.0685),
        DVec3::new(-0.1614, 0.0367, 1.0296),
    );
    let scale = (bradford * white_point(D65)) / (bradford * white);
    let adapted = inverse(bradford)? * DMat3::from_diagonal(scale) * bradford;
    let to_rec709 = inverse(Primaries::REC709.to_xyz()?)? * adapted;
    to_rec709.is_finite().then_some(to_rec709)
}

/// Returns a chromaticity as XYZ with the luminance 1.
fn white_point(c: DVec2) -> DVec3 {
    DVec3::new(c.x, c.y, 1.0 - c.x - c.y) / c.y
}

/// Returns the inverse of a matrix with entries of about 1, unless it is singular within the rounding of files.
fn inverse(matrix: DMat3) -> Option<DMat3> {
    (matrix.determinant().abs() > 1e-6).then(|| matrix.inverse())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn close(ours: DMat3, rows: [[f64; 3]; 3], tolerance: f64) {
        let theirs = DMat3::from_cols_array_2d(&rows).transpose();
        assert!(ours.abs_diff_eq(theirs, tolerance), "{ours} is not {theirs}");
    }

    /// The tolerances are the precision of the published matrices.
    #[test]
    fn matrices_are_the_published_ones() {
        // CSS Color 4, from the chromaticities of IEC 61966-2-1.
        let srgb = [
            [0.412_390_8, 0.357_584_3, 0.180_480_8],
            [0.212_639_0, 0.715_168_7, 0.072_192_3],
            [0.019_330_8, 0.119_194_8, 0.950_532_2],
        ];
        close(Primaries::REC709.to_xyz().expect("a space"), srgb, 1e-7);
        // ITU-R BT.2087-0, table 2, inverted as described there.
        let rec2020 = [[1.6605, -0.5876, -0.0728], [-0.1246, 1.1329, -0.0083], [-0.0182, -0.1006, 1.1187]];
        close(Primaries::REC2020.to_rec709().expect("a space"), rec2020, 1e-4);
        // ACES2065-1 to linear Rec. 709 with Bradford adaptation, as in the ACES configurations of OpenColorIO.
        let aces = Primaries::of([0.7347, 0.2653, 0.0, 1.0, 0.0001, -0.077, 0.321_68, 0.337_67]);
        let to_rec709 =
            [[2.521_69, -1.134_13, -0.387_56], [-0.276_48, 1.372_72, -0.096_24], [-0.015_38, -0.152_98, 1.168_35]];
        close(aces.to_rec709().expect("a space"), to_rec709, 1e-3);
    }

    #[test]
    fn white_stays_white_and_rec709_stays_itself() {
        let radiance = Primaries::of([0.64, 0.33, 0.29, 0.6, 0.15, 0.06, 1.0 / 3.0, 1.0 / 3.0]);
        let xyz = Primaries::of([1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0 / 3.0, 1.0 / 3.0]);
        for space in [radiance, xyz, Primaries::REC2020, Primaries::DISPLAY_P3] {
            let white = space.to_rec709().expect("a space") * DVec3::ONE;
            assert!(white.abs_diff_eq(DVec3::ONE, 1e-12), "{space:?}: {white}");
        }
        assert_eq!(Primaries::REC709.to_rec709(), Some(DMat3::IDENTITY));
        let profile = profile_to_rec709().expect("a space") * D50;
        assert!(profile.abs_diff_eq(DVec3::ONE, 1e-12), "{profile}");
    }

    #[test]
    fn what_spans_no_space_has_no_matrix() {
        let right = Primaries::REC709;
        for wrong in [
            Primaries { blue: right.green, ..right },
            Primaries::of([0.0; 8]),
            Primaries { white: DVec2::new(0.3, 0.0), ..right },
            Primaries { blue: DVec2::new(f64::NAN, 0.06), ..right },
        ] {
            assert_eq!(wrong.to_rec709(), None, "{wrong:?}");
        }
    }
}
