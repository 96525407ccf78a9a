//! Light around black holes with a charge and without spin.

use bentray::model::Law;
use bentray::model::law::{HoleForm, KerrNewman, RoundHole};
use bentray::render::{RenderSettings, Status, trace};
use glam::DVec3;

use crate::kerr_fates::fate;
use crate::shaders::Random;
use crate::support::{gpu, scene};

/// Without spin a Kerr–Newman black hole is a Reissner–Nordström one: paths are
/// identical, also with `planar` and with a cosmological constant.
#[test]
fn charged_holes_are_those_of_kerr_and_newman_without_spin() {
    let gpu = gpu();
    let mut random = Random::new(83);
    for charge in [0.0, 0.6, 1.0] {
        let hole = KerrNewman { mass: 1.0, spin: 0.0, axis: DVec3::Z, charge, center: DVec3::ZERO };
        let (mut rays, mut fates) = (Vec::new(), Vec::new());
        while rays.len() < 2000 {
            let x = random.direction() * random.log(4.0, 20.0);
            let v = (random.direction() - 0.7 * x.normalize()).normalize();
            if let Some(fate) = fate(&hole, x, hole.starting_velocity(x, v)) {
                rays.push([x.x, x.y, x.z, v.x, v.y, v.z]);
                fates.push(fate);
            }
        }
        let ends_by = |law: &str, rays_table: &str| {
            let scene = scene(&format!(
                "[law]\n{law}\n[rays]\nbounding_sphere = {{ radius = 30 }}\nmax_segments = 20000\nprecision = \"f64\"\n{rays_table}"
            ));
            trace(&gpu, &scene, &RenderSettings::default(), &rays).unwrap().0
        };
        let fine = "method = \"dormand-prince\"\ntolerance = 1e-12";
        let spinless = ends_by(&format!("kind = \"kerr-newman\"\ncharge = {charge}"), fine);
        let charged = format!("kind = \"reissner-nordstrom\"\ncharge = {charge}");
        let vast = format!("{charged}\ncosmological_constant = 0.01");
        for (law, method, bound) in
            [(&charged, fine, 1e-8), (&vast, fine, 1e-8), (&charged, "method = \"planar\"\nscaled_step = 0.005", 1e-7)]
        {
            let ends = ends_by(law, method);
            for (i, (end, other)) in ends.iter().zip(&spinless).enumerate() {
                assert_eq!(end.status, fates[i], "Q = {charge}, {method}: {:?}", rays[i]);
                assert_eq!(other.status, fates[i], "Q = {charge}: {:?}", rays[i]);
                if end.status == Status::Escaped {
                    let off = DVec3::from(end.x).distance(DVec3::from(other.x)) / 30.0;
                    // The error of light that winds around the black hole grows by e^π per half turn.
                    let bound = if other.steps > 200 { 1e3 * bound } else { bound };
                    assert!(off < bound, "Q = {charge}, {method}: off by {off:e}, {:?}", rays[i]);
                }
            }
        }
    }
}

/// Photon spheres, horizons and the smallest impact parameters of light that escapes.
#[test]
fn charged_holes_have_their_landmarks() {
    for (charge, sphere, impact, horizon) in [
        (0.3, 2.938_749_456_993_815_7, 5.116_794_745_329_72, 1.953_939_201_416_945_7),
        (0.8, 2.484_885_780_179_610_5, 4.545_986_272_128_442, 1.6),
        (1.0, 2.0, 4.0, 1.0),
    ] {
        let hole = RoundHole {
            mass: 1.0,
            charge,
            cosmological: 0.0,
            center: DVec3::ZERO,
            axis: DVec3::Z,
            form: HoleForm::Charged,
        };
        let found = hole.photon_sphere().unwrap();
        assert!((found - sphere).abs() < 1e-14 && (found / hole.clock(found).sqrt() - impact).abs() < 1e-14);
        assert!((hole.horizon().unwrap() - horizon).abs() < 1e-7, "{:?}", hole.horizon());
    }
    let vast = RoundHole {
        mass: 1.0,
        charge: 0.0,
        cosmological: 0.1,
        center: DVec3::ZERO,
        axis: DVec3::Z,
        form: HoleForm::Charged,
    };
    let horizon = vast.horizon().unwrap();
    assert!(horizon > 2.0 && vast.clock(horizon).abs() < 1e-12 && vast.clock(3.0) > 0.0, "{horizon}");
}
