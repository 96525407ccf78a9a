//! Tests volumes under laws, precisions and axes that few scenes combine.

use crate::support::scene;
use crate::volumes::lights_of;

/// A ball of unit emission and radius has the light of its chord under a typed flat metric, and in a uniform medium in 64 bits.
#[test]
fn a_ball_is_as_bright_as_its_chord_is_long() {
    for law in [
        "[law]\nkind = \"metric\"\nline_element = \"-dt^2 + dx^2 + dy^2 + dz^2\"\nscale = \"1\"\n[rays]\nmethod = \"dormand-prince\"\n",
        "[law]\nkind = \"medium\"\nindex = { kind = \"constant\", n = 1.3 }\n[rays]\nprecision = \"f64\"\n",
    ] {
        let text = format!(
            "{law}bounding_sphere = {{ radius = 30 }}\n[radiation]\nfrequencies = [1.0]\n[[volumes]]\nshape = \"sphere\"\nemission = \"1 + 1e-9*x\"\n"
        );
        let (lights, totals) = lights_of(&scene(&text), &[[5.0, 0.6, 0.0, -1.0, 0.0, 0.0]]);
        assert!((lights[0][0].intensity - 1.6).abs() < 1e-5, "{law}{lights:?} {totals}");
    }
}

/// The polar angle of formulas counts from the axis of the law, also without spin.
#[test]
fn angles_count_from_the_axis() {
    let of = |method: &str| {
        let text = format!(
            "[law]\nkind = \"kerr-newman\"\naxis = [1, 0, 0]\n[rays]\nbounding_sphere = {{ radius = 100 }}\nmethod = \"{method}\"\n\
             [radiation]\nfrequencies = [1.0]\n[[volumes]]\nshape = \"sphere\"\nradius = 15\n\
             density = \"exp(-(r/10)^2)*(1.5 + cos(theta))\"\nemission = \"n*nu\"\n"
        );
        lights_of(&scene(&text), &[[-5.0, 12.0, 4.0, 2.0, -20.0, 3.0]]).0[0][0].intensity
    };
    let (one, two) = (of("separated"), of("dormand-prince"));
    assert!((one / two - 1.0).abs() < 1e-4, "{one} {two}");
}

/// The optical depth of opaque matter is that of all of it, although nothing behind its first part is seen.
#[test]
fn depths_are_whole() {
    let text = "[rays]\nbounding_sphere = { radius = 30 }\n[radiation]\nfrequencies = [1.0]\n[[volumes]]\n\
                density = \"exp(-((r - 8)/0.05)^2)\"\nemission = \"n\"\nabsorption = 1e3\n";
    let (lights, _) = lights_of(&scene(text), &[[20.0, 3.0, 0.0, -1.0, 0.0, 0.0]]);
    // Of two crossings at an angle whose cosine is √(1 − b²/r²); thickness over radius is 6e-3.
    let expected = 2.0 * 1e3 * 0.05 * std::f64::consts::PI.sqrt() / (1.0 - 9.0_f64 / 64.0).sqrt();
    assert!((lights[0][0].optical_depth / expected - 1.0).abs() < 1e-3, "{lights:?} {expected}");
}

/// A scene warns of matter that cannot be, in its region alone.
#[test]
fn impossible_matter_has_a_position() {
    let warned = |volume: &str| {
        let law = "[law]\nkind = \"kerr-newman\"\nspin = 0.5\n[rays]\nbounding_sphere = { radius = 30 }\n[radiation]\nfrequencies = [1.0]\n";
        scene(&format!("{law}[[volumes]]\n{volume}\nemission = 1\n")).warnings().join("\n")
    };
    for shape in [
        "",
        "shape = \"sphere\"\nradius = 8",
        "shape = \"box\"\nsize = [9, 8, 7]",
        "shape = \"cylinder\"\nradius = 6\nheight = 9",
    ] {
        // The density is negative only beyond the region, or within it too.
        let beyond = warned(&format!("{shape}\ndensity = \"31*31 - r^2\""));
        assert!(beyond.is_empty(), "{shape}: {beyond}");
        let within = warned(&format!("{shape}\ndensity = \"x\""));
        assert!(within.contains("volumes[0]: the density is -") && within.contains(" at [-"), "{shape}: {within}");
    }
    let fast = warned("shape = \"sphere\"\nradius = 8\nflow = { velocity = [0, 2, 0] }");
    assert!(fast.contains("the speed is 2.000 of that of light"), "{fast}");
    let outside = warned("shape = \"cylinder\"\nradius = 6\nheight = 9\ndensity = \"37 - x^2 - z^2\"");
    assert!(outside.is_empty(), "{outside}");
}

/// A typed metric shows the same light of matter down to the horizon as the law that it is, whatever the motion.
#[test]
fn typed_metrics_shine_down_to_the_horizon() {
    // Emission that grows with the frequency, which grows without bound toward the horizon.
    let of = |law: &str, flow: &str| {
        let text = format!(
            "{law}bounding_sphere = {{ radius = 100 }}\nprecision = \"f64\"\n[radiation]\nfrequencies = [1.0]\ntolerance = 1e-6\n\
             [[volumes]]\nshape = \"sphere\"\nradius = 15\nflow = {flow}\ndensity = \"exp(-(r/10)^2)\"\nemission = \"n*nu^3\"\n"
        );
        lights_of(&scene(&text), &[[20.0, 3.0, 4.0, -1.0, -0.05, -0.1]]).0[0][0].intensity
    };
    let typed = "[law]\nkind = \"metric\"\nline_element = \"-A*dt^2 + dr^2/A + r^2*dOmega2\"\nscale = \"r\"\n[law.terms]\nA = \"1 - 2/r\"\n\
                 [rays]\nmethod = \"dormand-prince\"\ntolerance = 1e-10\n";
    let own = "[law]\nkind = \"schwarzschild\"\n[rays]\nmethod = \"planar\"\nscaled_step = 0.05\n";
    let regular = "[law]\nkind = \"metric\"\nline_element = \"-dt^2 + dx^2 + dy^2 + dz^2 + 2/r*(dt + dr)^2\"\nscale = \"r\"\n\
                   capture_condition = \"r < 2.002\"\n[rays]\nmethod = \"dormand-prince\"\ntolerance = 1e-10\n";
    // Eulerian observers fall in coordinates that are regular at the horizon.
    let all = ["\"static\"", "\"zamo\"", "{ angular_momentum = \"r\" }", "\"eulerian\"", "{ velocity = [0.1, 0, 0] }"];
    for (law, flows) in [(typed, &all[..]), (regular, &all[..3])] {
        for flow in flows {
            let (one, two) = (of(law, flow), of(own, flow));
            assert!((one / two - 1.0).abs() < 3e-4, "{flow} {law}: {one} {two}");
        }
    }
}

/// The light of a given ray depends on its direction alone, also where matter moves: in flat space, where any speed is allowed.
#[test]
fn light_has_the_speed_of_light() {
    let text = "[camera]\nposition = [20, 0, 0]\nobserver = \"static\"\ntime = 3\n[rays]\nbounding_sphere = { radius = 300 }\n[radiation]\n\
                frequencies = [1.0]\n[[volumes]]\ndensity = \"exp(-((x - 0.5*t)^2 + y^2 + z^2))\"\nemission = \"n\"\n";
    let rays = [1.0, 0.2, 7.0].map(|speed| [5.0, 5.0, 5.0, -0.8 * speed, -0.48 * speed, -0.36 * speed]);
    let (lights, _) = lights_of(&scene(text), &rays);
    let [one, slow, fast] = [0, 1, 2].map(|ray| lights[ray][0].intensity);
    assert!((slow / one - 1.0).abs() < 1e-5 && (fast / one - 1.0).abs() < 1e-5, "{one} {slow} {fast}");
}

/// Formulas count from the center of a line element, whatever its symmetry.
#[test]
fn formulas_count_from_the_center_of_a_line_element() {
    let of = |more: &str| {
        let text = format!(
            "[law]\nkind = \"metric\"\nline_element = \"-dt^2 + (1 + {more})*dx^2 + dy^2 + dz^2\"\nscale = \"1\"\n\
             [rays]\nmethod = \"dormand-prince\"\nbounding_sphere = {{ radius = 30 }}\n[radiation]\nfrequencies = [1.0]\n\
             [[volumes]]\nshape = \"sphere\"\nradius = 3\ntranslate = [2, 0, 0]\ndensity = \"exp(-r^2)\"\nemission = \"n\"\n"
        );
        lights_of(&scene(&text), &[[5.0, 0.6, 0.0, -1.0, 0.0, 0.0]]).0[0][0].intensity
    };
    let [symmetric, not, changing] = ["0", "1e-12*x", "1e-12*t"].map(of);
    assert!(
        (not / symmetric - 1.0).abs() < 1e-5 && (changing / symmetric - 1.0).abs() < 1e-5,
        "{symmetric} {not} {changing}"
    );
}

/// A captured path adds the light at the horizon once, also if rounding leaves it above the capture sphere at first.
#[test]
fn light_at_the_horizon_counts_once() {
    let of = |precision: &str| {
        let text = format!(
            "[law]\nkind = \"kerr-newman\"\nspin = 0.9\n[rays]\nmethod = \"separated\"\nscaled_step = 0.05\nprecision = \"{precision}\"\n\
             bounding_sphere = {{ radius = 100 }}\n[radiation]\nfrequencies = [1.0]\ntolerance = 1e-5\n[[volumes]]\nshape = \"sphere\"\n\
             radius = 15\nflow = \"zamo\"\ndensity = \"exp(-(r/10)^2)\"\nemission = \"n*nu^3\"\n"
        );
        let rays: Vec<[f64; 6]> = (0..18).map(|k| [20.0, 3.0, 4.0, -1.0, 0.02 * f64::from(k) - 0.2, -0.1]).collect();
        lights_of(&scene(&text), &rays).0
    };
    for (single, double) in of("f32").iter().zip(of("f64")) {
        assert!((single[0].intensity / double[0].intensity - 1.0).abs() < 1e-4, "{single:?} {double:?}");
    }
}

/// The light at the horizon of a hole with spin is found in coordinates that are regular there, however near the path is to the horizon.
#[test]
fn typed_metrics_shine_down_to_a_turning_horizon() {
    let of = |law: &str| {
        let text = format!(
            "{law}precision = \"f64\"\nbounding_sphere = {{ radius = 100 }}\n[radiation]\nfrequencies = [1.0]\ntolerance = 1e-8\n\
             [[volumes]]\nshape = \"sphere\"\nradius = 15\nflow = \"zamo\"\n\
             density = \"exp(-(x^2 + y^2 + z^2)/100)\"\nemission = \"n*nu^3\"\n"
        );
        let rays: Vec<[f64; 6]> = (0..6).map(|k| [20.0, 3.0, 4.0, -1.0, 0.02 * f64::from(k) - 0.2, -0.15]).collect();
        lights_of(&scene(&text), &rays).0
    };
    let own = of("[law]\nkind = \"kerr-newman\"\nspin = 0.9\n[rays]\nmethod = \"separated\"\nscaled_step = 0.02\n");
    let horizon = 1.0 + (1.0_f64 - 0.81).sqrt();
    // The rest of the way counts with its leading power, so that the error falls with the distance from the horizon.
    for (height, bound) in [(2e-3, 1e-4), (2e-5, 2e-6)] {
        let typed = format!(
            "[law]\nkind = \"metric\"\nscale = \"R\"\nparameters = {{ a = 0.9 }}\ncapture_condition = \"R < {}\"\n\
             line_element = \"-dt^2 + dx^2 + dy^2 + dz^2 + f*(dt + (R*x + a*y)/(R^2 + a^2)*dx + (R*y - a*x)/(R^2 + a^2)*dy + z/R*dz)^2\"\n\
             [law.terms]\nb = \"x^2 + y^2 + z^2 - a^2\"\nR = \"sqrt(0.5*(b + sqrt(b^2 + 4*a^2*z^2)))\"\nf = \"2*R^3/(R^4 + a^2*z^2)\"\n\
             [rays]\nmethod = \"dormand-prince\"\ntolerance = 1e-9\n",
            horizon * (1.0 + height)
        );
        for (one, two) in of(&typed).iter().zip(&own) {
            let off = one[0].intensity / two[0].intensity - 1.0;
            assert!(off.abs() < bound, "{height}: {off} {one:?} {two:?}");
        }
    }
}

/// Matter whose absorption grows without bound toward the horizon is opaque there: if light is emitted in proportion, that of every captured
/// ray is the uniform source function, times g³.
#[test]
fn matter_is_opaque_at_the_horizon() {
    for (law, emission, absorption) in
        [("\"schwarzschild\"", "nu^4", "nu"), ("\"kerr-newman\"\nspin = 0.9", "0.02*nu^5", "0.02*nu^2")]
    {
        let text = format!(
            "[law]\nkind = {law}\n[rays]\nbounding_sphere = {{ radius = 100 }}\n[radiation]\nfrequencies = [1.0, 1.5]\n\
             tolerance = 1e-5\n[[volumes]]\nshape = \"sphere\"\nradius = 4\nflow = \"zamo\"\n\
             emission = \"{emission}\"\nabsorption = \"{absorption}\"\n"
        );
        let rays = [[20.0, 3.0, 4.0, -1.0, -0.15, -0.2], [20.0, 0.0, 1.0, -1.0, 0.05, -0.05]];
        let (lights, totals) = lights_of(&scene(&text), &rays);
        for light in &lights {
            for (light, nu) in light.iter().zip([1.0_f64, 1.5]) {
                let off = light.intensity / nu.powi(3) - 1.0;
                assert!(off.abs() < 2e-3, "{law} {emission}: {off} {totals}");
            }
        }
        assert_eq!(totals.undefined, 0, "{law} {emission}: {totals}");
    }
}

/// Of several frequencies, each has the matter of its own: pieces end although a formula falls steeply between them.
#[test]
fn each_frequency_has_bounds_of_its_own() {
    let of = |frequencies: &str| {
        let text = format!(
            "[law]\nkind = \"kerr-newman\"\nspin = 0.9\n[rays]\nbounding_sphere = {{ radius = 100 }}\n[radiation]\n\
             frequencies = {frequencies}\n[[volumes]]\nshape = \"sphere\"\nradius = 30\nflow = \"zamo\"\n\
             density = \"exp(-((r - 6)/2)^2)\"\nemission = \"n*nu^3*exp(-nu)\"\nabsorption = \"n*exp(-2*nu)\"\n"
        );
        let rays: Vec<[f64; 6]> = (0..20).map(|k| [20.0, 3.0, 4.0, -1.0, 0.05 * f64::from(k) - 0.5, -0.2]).collect();
        lights_of(&scene(&text), &rays)
    };
    let (all, totals) = of("[1.0, 2.0, 20.0]");
    assert_eq!((totals.unsettled, totals.undefined), (0, 0), "{totals}");
    for (k, frequency) in ["[1.0]", "[2.0]", "[20.0]"].iter().enumerate() {
        for (one, all) in of(frequency).0.iter().zip(&all) {
            let (one, all) = (one[0].intensity, all[k].intensity);
            assert!((one - all).abs() < 2e-3 * one + 1e-12, "{frequency}: {one} {all}");
        }
    }
}
