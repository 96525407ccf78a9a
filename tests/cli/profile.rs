//! `profile`: tables and plots of a disk's light, and its errors.

use super::Folder;

const DISK: &str = "[image]\nsize = [48, 36]\n[camera]\nposition = [0, -30, 6]\nup = [0, 0, 1]\nobserver = \"static\"\n\
    [law]\nkind = \"kerr-newman\"\nspin = 0.5\n[rays]\nbounding_sphere = { radius = 60 }\nmethod = \"separated\"\n\
    [materials.matter]\nkind = \"accretion\"\nopacity = 0.5\n[materials.dark]\n[[objects]]\nshape = \"disk\"\nmaterial = \"matter\"\n\
    normal = [0, 0, 1]\nradius = 14\ninner_radius = 5\n";

#[test]
fn the_three_kinds_are_written_as_tables_and_plots() {
    let folder = Folder::with(DISK);
    let units = "--set materials.matter.temperature=1e7 --set units.mass=\"10Msun\" --set units.distance=\"1kpc\"";
    for (kind, columns) in [
        ("line", "g,flux,order_0,order_1,order_2,order_3"),
        ("light-curve --range 0,20", "t,flux,order_0,order_1,order_2,order_3"),
        (&format!("spectrum {units} --range 1e15,1e19") as &str, "frequency,flux,order_0,order_1,order_2,order_3"),
    ] {
        folder.run(&format!("profile scene.toml --of {kind} --points 12 -o a.csv -o a.npz -o a.svg")).succeeds();
        let text = folder.text("a.csv");
        let rows: Vec<Vec<f64>> =
            text.lines().skip(1).map(|line| line.split(',').map(|word| word.parse().unwrap()).collect()).collect();
        assert_eq!((text.lines().next(), rows.len()), (Some(columns), 12), "{kind}");
        for row in &rows {
            let sum: f64 = row[2..].iter().sum();
            assert!(row[1] > 0.0 && (row[1] - sum).abs() <= 1e-12 * sum, "{kind}: {row:?}");
        }
        assert!(rows.iter().any(|row| row[3] > 0.0), "{kind}");
        assert!(folder.text("a.svg").contains("order 1") && !folder.read("a.npz").is_empty());
    }
    // Twice as far away, a quarter of the flux.
    let flux = |distance: &str| {
        let units = units.replace("1kpc", distance);
        folder
            .run(&format!("profile scene.toml --of spectrum {units} --points 2 -o a.csv --range 1e16,1e17"))
            .succeeds();
        folder.text("a.csv").lines().nth(1).unwrap().split(',').nth(1).unwrap().parse::<f64>().unwrap()
    };
    assert!((flux("1kpc") / flux("2kpc") - 4.0).abs() < 1e-9);
}

/// The spectrum of a scene with `[radiation]` is the flux of its image at each frequency.
#[test]
fn a_spectrum_is_the_flux_of_the_image() {
    let ball = "[image]\nsize = [24, 24]\n[camera]\nposition = [0, 0, 9]\nobserver = \"static\"\n[rays]\nbounding_sphere = { radius = 30 }\n\
        [radiation]\nfrequencies = [2.0, 6.0]\n[[volumes]]\nshape = \"sphere\"\nemission = \"exp(-r^2)/(1 + nu)\"\nabsorption = \"nu^-2\"\n";
    let folder = Folder::with(ball);
    folder.run("profile scene.toml --of spectrum --points 11 --range 2,6 -o a.csv -o a.svg").succeeds();
    let text = folder.text("a.csv");
    let rows: Vec<[f64; 2]> = text
        .lines()
        .skip(1)
        .map(|line| line.split_once(',').map(|(x, y)| [x, y].map(|word| word.parse().unwrap())).unwrap())
        .collect();
    assert_eq!((text.lines().next(), rows.len()), (Some("frequency,flux"), 11));
    let rendered = folder.run("render scene.toml -o a.exr --json").succeeds();
    let image: serde_json::Value = serde_json::from_str(&rendered.out).unwrap();
    for (row, k) in [(rows[0], 0), (rows[10], 1)] {
        let report = &image["radiation"][k];
        let [frequency, flux] = ["frequency", "flux"].map(|key| report[key].as_f64().unwrap());
        assert!((row[0] / frequency - 1.0).abs() < 1e-12 && (row[1] / flux - 1.0).abs() < 1e-5, "{row:?} {report}");
    }
    assert!(folder.text("a.svg").contains("frequency (ν₀)"));
    for (arguments, problem) in [
        ("--object 0", "the whole image: remove --object"),
        ("--range 1GHz,2GHz", "give radiation.frequencies units"),
        ("--set camera.kind=\"fisheye\"", "no plane on which light could be summed"),
    ] {
        let ran = folder.run(&format!("profile scene.toml --of spectrum -o a.csv {arguments}"));
        assert!(ran.code != Some(0) && ran.err.contains(problem), "{arguments}: {}", ran.err);
    }
}

#[test]
fn what_cannot_be_measured_is_an_error() {
    let folder = Folder::with(DISK);
    for (code, arguments, problem) in [
        (2, "--emissivity r^", "column 3: "),
        (2, "--emissivity x^2", "unknown name `x`"),
        (2, "--range 2", "expected two values"),
        (1, "--of light-curve", "a light curve requires a range"),
        (1, "--of spectrum", "set `temperature` of a material"),
        (1, "--of spectrum --emissivity r", "has no emissivity"),
        (1, "--of light-curve --range 0,2h", "requires the scale of the scene: add [units]"),
        (1, "--of light-curve --range 0,1GHz", "`1GHz` is a frequency, but a time is required here"),
        (1, "--range 2,1", "the first value must be below the second"),
        (1, "--object 3", "the scene has 1 object,"),
        (1, "--set camera.observer=\"coordinate\"", "requires camera.observer"),
        (1, "-o scene.toml", "would be overwritten"),
    ] {
        folder.run(&format!("profile scene.toml -o a.csv {arguments}")).fails(code, &[problem]);
        assert!(!folder.path("a.csv").exists(), "{arguments}");
    }
    // These follow from the traced rays.
    for (arguments, problem) in [
        ("--emissivity 4-r", "error: --emissivity: the emissivity is -"),
        ("--set camera.look_at=[0,-60,0]", "no ray of the camera meets a surface"),
    ] {
        let output = folder.run(&format!("profile scene.toml -o a.csv {arguments}")).says(&[problem]);
        assert!(output.code == Some(1) && !folder.path("a.csv").exists(), "{arguments}");
    }
}
