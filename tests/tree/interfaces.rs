//! Single surfaces between two media.

use crate::support::lens::{columns, number, vector};
use crate::support::tree::Interface;
use glam::DVec3;

#[test]
fn light_is_reflected_and_refracted_as_the_table_says() {
    for row in columns(include_str!("../tables/refraction.tsv")) {
        let [n1, n2, k_r, k_t] = [row[1], row[2], row[5], row[6]].map(|text| number(text).unwrap());
        let [normal, d, reflected] = [row[3], row[4], row[7]].map(|text| vector(text).unwrap());
        let close = |a: DVec3, b: DVec3| assert!(a.distance(b) < 1e-14, "{}: {a}, {b} expected", row[0]);
        // A normal may point to either side.
        for normal in [normal, -normal] {
            match (Interface::new(n1, n2, d, normal), vector(row[8])) {
                (Interface::Total { reflected: found }, None) => {
                    close(found, reflected);
                    assert!(k_r.total_cmp(&1.0).is_eq() && k_t.total_cmp(&0.0).is_eq());
                }
                (Interface::Split { reflected: found, transmitted, reflectance }, Some(expected)) => {
                    close(found, reflected);
                    close(transmitted, expected);
                    assert!((reflectance - k_r).abs() < 1e-14, "{}: {reflectance}", row[0]);
                    assert!((1.0 - reflectance - k_t).abs() < 1e-14, "{}: {reflectance}", row[0]);
                }
                (other, _) => panic!("{}: {other:?}", row[0]),
            }
        }
    }
}

/// Returns many pairs of media, normals and directions.
fn cases() -> impl Iterator<Item = (f64, f64, DVec3, DVec3)> {
    let pairs = [(1.0, 1.5), (1.5, 1.0), (1.33, 2.42), (2.42, 1.33), (1.0, 1.001), (1.001, 1.0), (3.0, 0.2)];
    let normals = [DVec3::Y, DVec3::new(1.0, -2.0, 0.5).normalize(), DVec3::new(-3.0, 0.1, 4.0).normalize()];
    pairs.into_iter().flat_map(move |(n1, n2)| {
        normals.into_iter().flat_map(move |normal| {
            let (a, b) = normal.any_orthonormal_pair();
            (0..200).map(move |i| {
                let (angle, turn) = (f64::from(i) * std::f64::consts::FRAC_PI_2 / 200.0, f64::from(i) * 0.7);
                let along = turn.cos() * a + turn.sin() * b;
                (n1, n2, normal, angle.sin() * along - angle.cos() * normal)
            })
        })
    })
}

/// Light that is not reflected is transmitted, by the Fresnel amplitudes for transmission and the width of the refracted beam.
#[test]
fn no_energy_is_lost_at_a_surface() {
    for (n1, n2, normal, d) in cases() {
        let Interface::Split { transmitted, reflectance, .. } = Interface::new(n1, n2, d, normal) else { continue };
        let (cos1, cos2) = (-d.dot(normal), -transmitted.dot(normal));
        let s = 2.0 * n1 * cos1 / (n1 * cos1 + n2 * cos2);
        let p = 2.0 * n1 * cos1 / (n2 * cos1 + n1 * cos2);
        let transmittance = n2 * cos2 / (n1 * cos1) * f64::midpoint(s * s, p * p);
        assert!(
            (reflectance + transmittance - 1.0).abs() < 1e-13,
            "{n1} to {n2} at {d}: {reflectance} {transmittance}"
        );
    }
}

/// Reversed light takes the same paths, with the same weights.
#[test]
fn refraction_can_be_reversed() {
    let mut tried = 0;
    for (n1, n2, normal, d) in cases() {
        let Interface::Split { reflected, transmitted, reflectance } = Interface::new(n1, n2, d, normal) else {
            continue;
        };
        let Interface::Split { transmitted: back, reflectance: again, .. } =
            Interface::new(n2, n1, -transmitted, normal)
        else {
            panic!("{n1} to {n2} at {d}: no way back");
        };
        // Near grazing incidence the path back has lost half of its digits: a cosine is the root of the remainder of 1.
        let allowed = 1e-15 / d.dot(normal).abs().min(transmitted.dot(normal).abs());
        assert!(back.distance(-d) < 4.0 * allowed, "{n1} to {n2} at {d}: {back}");
        assert!((reflectance - again).abs() < 40.0 * allowed, "{n1} to {n2} at {d}: {reflectance} {again}");
        assert!(
            (reflected.dot(normal) + d.dot(normal)).abs() < 1e-15 && (reflected - d).cross(normal).length() < 1e-15
        );
        tried += 1;
    }
    assert!(tried > 2000, "{tried}");
}

/// Total reflection from the denser side begins at sin θ = n₂/n₁; equal media have no surface.
#[test]
fn total_reflection_begins_at_the_critical_angle() {
    let critical = (1.0_f64 / 1.5).asin();
    for (angle, total) in [(critical - 1e-9, false), (critical + 1e-9, true)] {
        let d = DVec3::new(angle.sin(), -angle.cos(), 0.0);
        assert_eq!(matches!(Interface::new(1.5, 1.0, d, DVec3::Y), Interface::Total { .. }), total);
        assert!(matches!(Interface::new(1.5, 1.5 + 1e-6, d, DVec3::Y), Interface::Matched));
        assert!(!matches!(Interface::new(1.5, 1.5 + 2e-6, d, DVec3::Y), Interface::Matched));
    }
}
