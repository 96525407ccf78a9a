//! Commands that measure: verification, calibration, charts, drift.

use super::pictures::decoded;
use super::{BALL, Folder};

const HOLE: &str = "--set law.kind=schwarzschild --set law.mass=0.2 --set objects.0.center=[1.5,0,0]";

/// The errors are printed, and stored as text in the image.
#[test]
fn a_picture_carries_its_measured_error() {
    let folder = Folder::with(BALL);
    let ran = folder
        .run(&format!("render scene.toml -o a.png -o a.exr --size 48x36 {HOLE} --set rays.method=rk4 --verify 50"))
        .succeeds();
    for text in [
        "verified 50",
        "rays against a reference solution (f64",
        "angle (rad)",
        "position",
        "τ",
        "with a wrong end",
        "unresolved",
    ] {
        assert!(ran.out.contains(text), "{text} in {}", ran.out);
    }
    let (png, exr) = (folder.read("a.png"), folder.read("a.exr"));
    for file in [&png, &exr] {
        let held = |text: &str| file.windows(text.len()).any(|window| window == text.as_bytes());
        for text in ["verify: angle error (rad)", "verify: wrong ends", "verify: unresolved", "rk4, scaled_step 0.1"] {
            assert!(held(text), "{text}");
        }
    }
}

/// The chosen method is printed; a scene that specifies a method is not measured.
#[test]
fn a_calibration_says_what_it_chose() {
    let folder = Folder::with(BALL);
    let ran = folder.run(&format!("render scene.toml -o a.png {HOLE} --set rays.accuracy=1e-3")).succeeds();
    let line = ran.err.lines().find(|line| line.starts_with("method auto: ")).unwrap_or_else(|| panic!("{}", ran.err));
    assert!(line.contains("99 % of the rays within") && line.contains("evaluations per ray"), "{line}");
    // If it is specified, this method gives a bit-identical image.
    let (chosen, _) = line.strip_prefix("method auto: ").and_then(|line| line.split_once("), ")).unwrap();
    let (_, segments) = line.split_once("max_segments ").unwrap();
    let (method, settings) = chosen.split_once(" (").unwrap();
    let settings: Vec<_> = settings.split(", ").map(|s| format!("--set rays.{}", s.replace(' ', "="))).collect();
    let segments = segments.split(';').next().unwrap();
    let named = format!("--set rays.method={method} {} --set rays.max_segments={segments}", settings.join(" "));
    let ran = folder.run(&format!("render scene.toml -o b.png {HOLE} {named}")).succeeds();
    assert!(decoded(&folder, "a.png") == decoded(&folder, "b.png"), "{named}");
    assert!(!ran.err.contains("method auto: "), "{}", ran.err);
    folder
        .run("render scene.toml -o a.png --set rays.accuracy=thin --set law.kind=schwarzschild")
        .fails(1, &["expected an angle in radians, or in pixels such as \"0.1px\""]);
}

/// An image stores all settings of its rays, so that another render follows rays identically for any scene.
#[test]
fn the_method_from_a_picture_is_repeated() {
    let folder = Folder::with(BALL);
    for (method, sought) in [
        (String::new(), true),
        ("--set rays.method=rk4 --set rays.curvature_step=2".to_owned(), false),
        ("--set rays.method=euler-doubling --set rays.doubling=paper --set rays.grow_below=1e-4 --set rays.tolerance=1e-3"
            .to_owned(), false),
    ] {
        let ran = folder.run(&format!("render scene.toml -o a.png -o a.exr {HOLE} {method}")).succeeds();
        assert_eq!(ran.err.contains("method auto: "), sought, "{}", ran.err);
        for of in ["a.png", "a.exr"] {
            let other = "--set rays.method=leapfrog --set rays.step=0.5 --set rays.max_segments=7";
            folder.write("other.toml", BALL.replace("[rays]", "[rays]\nmethod = \"leapfrog\"\nstep = 0.5\nmax_segments = 7"));
            let wrong = folder.run(&format!("render scene.toml -o b.exr {HOLE} {other}")).succeeds();
            assert!(folder.read("a.exr") != folder.read("b.exr"), "{}", wrong.err);
            let ran = folder.run(&format!("render other.toml -o b.exr {HOLE} --method-from {of}")).succeeds();
            assert!(!ran.err.contains("method auto: "), "{}", ran.err);
            assert!(folder.read("a.exr") == folder.read("b.exr"), "{method} of {of}");
        }
    }
    // A setting that does not fit another scene is reported in its original form.
    folder.run(&format!("render scene.toml -o a.png {HOLE} --set rays.method=planar")).succeeds();
    folder.run("render scene.toml -o b.exr --method-from a.png").fails(
        1,
        &["--method-from a.png:1:13: planar requires a law with a single center", "rays.method=\"planar\"\n"],
    );
    folder.write("no.png", "no picture");
    folder.run("render scene.toml -o b.exr --method-from no.png").fails(1, &["no.png: this is not a complete PNG"]);
    folder.run("render scene.toml -o b.exr --method-from none.exr").fails(1, &["none.exr: cannot read the file"]);
    folder.run("render scene.toml -o b.exr --method-from scene.toml").fails(1, &["scene.toml: the name must end in"]);
}

/// The result of a search is stored for the next render and never changes it, even if it is missing, broken, or from another scene.
#[test]
fn a_decision_is_kept_and_changes_nothing() {
    let folder = Folder::with(BALL);
    let run = |arguments: &str, cache: &str| {
        let output = folder.command(arguments).env("BENTRAY_CACHE", cache).output().unwrap();
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let err = String::from_utf8(output.stderr).unwrap();
        err.lines().find(|line| line.starts_with("method auto: ")).unwrap_or_else(|| panic!("{err}")).to_owned()
    };
    let kept = || {
        let names = folder.names();
        names.iter().filter(|name| *name == "kept").count()
            * std::fs::read_dir(folder.path("kept")).map_or(0, Iterator::count)
    };
    let render = |to: &str| format!("render scene.toml -o {to} {HOLE} --set rays.accuracy=1e-3");
    let without = run(&render("a.exr"), "");
    assert_eq!(kept(), 0);
    let first = run(&render("b.exr"), "kept");
    assert_eq!(kept(), 1);
    let again = run(&render("c.exr"), "kept");
    assert_eq!(([&first, &again], kept()), ([&without; 2], 1));
    for name in ["b.exr", "c.exr"] {
        assert!(folder.read(name) == folder.read("a.exr"), "{name}");
    }
    // A different accuracy and a changed scene file are separate decisions.
    run(&format!("{} --set rays.accuracy=1e-4", render("d.exr")), "kept");
    folder.write("scene.toml", format!("{BALL}\n[output]\nexposure = 1\n"));
    run(&render("d.exr"), "kept");
    assert_eq!(kept(), 3);
    // A broken entry is measured again.
    for entry in std::fs::read_dir(folder.path("kept")).unwrap() {
        std::fs::write(entry.unwrap().path(), "said = 3").unwrap();
    }
    folder.write("scene.toml", BALL);
    assert_eq!(run(&render("e.exr"), "kept"), without);
    assert!(folder.read("e.exr") == folder.read("a.exr"));
}

/// Close to the photon ring 32 bits do not resolve a hundredth of a pixel. The message reports this and the result with
/// 64 bits, which are used if the precision is not specified.
#[test]
fn where_32_bits_do_not_suffice_64_are_named_or_taken() {
    let folder = Folder::with(
        "[image]\nsize = [48, 27]\n[camera]\nposition = [0, 0, 100]\nlook_at = [0.0525, 0, 99]\nfov = 0.02\n\
         [law]\nkind = \"schwarzschild\"\n[rays]\nbounding_sphere = { radius = 200 }\n",
    );
    let line = |arguments: &str| {
        let ran = folder.run(arguments).succeeds();
        let warns = ran.err.contains("warning: no method keeps 99 % of the rays within ")
            && ran.err.contains("; --precision f64 is accurate enough\n");
        assert_eq!(warns, !arguments.contains("--precision"), "{}", ran.err);
        ran.err
            .lines()
            .find(|line| line.starts_with("method auto: "))
            .unwrap_or_else(|| panic!("{}", ran.err))
            .to_owned()
    };
    let single = line("render scene.toml -o a.exr");
    assert!(
        single.contains("no method reaches") && single.contains("--precision auto would use 64 bits and planar"),
        "{single}"
    );
    let double = line("render scene.toml -o b.exr --precision auto");
    assert!(double.contains(", precision f64") && !double.contains("no method reaches"), "{double}");
    assert!(folder.read("a.exr") != folder.read("b.exr"));
    line("render scene.toml -o d.exr --precision f64");
    folder.run("render scene.toml -o c.exr --method-from b.exr").succeeds();
    assert!(folder.read("b.exr") == folder.read("c.exr"));
    folder
        .run("check scene.toml --precision auto --set rays.method=rk4")
        .fails(1, &["precision = \"auto\" is chosen together with the method", "or use f32 or f64"]);
}

#[test]
fn a_chart_is_tables_plots_and_a_page() {
    let folder = Folder::with(BALL);
    let ran = folder
        .run(&format!("compare scene.toml -o report --rays 1000 --compared 40 --repeats 1 --methods planar,rk4 {HOLE}"))
        .succeeds();
    assert!(ran.out.contains("fastest") && ran.out.contains("smallest error"), "{}", ran.out);
    let csv = folder.text("report/scene.csv");
    assert!(csv.starts_with("method,setting,ns_per_ray,") && csv.contains("\nrk4,") && csv.contains("\nplanar,"));
    assert!(!csv.contains("euler"), "only the requested methods");
    let page = folder.text("report/index.html");
    for text in ["scene_time.svg", "scene_evaluations.svg", "scene_drift_energy.svg", "The fastest method"] {
        assert!(page.contains(text), "{text}");
    }
    for name in [
        "scene_time.svg",
        "scene_time.png",
        "scene_evaluations.svg",
        "scene_evaluations.png",
        "scene_drift_angular_momentum.png",
    ] {
        assert!(!folder.read(&format!("report/{name}")).is_empty());
    }
    folder.run("compare all -o report").fails(1, &["no scenes in scenes", "--scenes"]);
}

/// With `[radiation]`, a chart's errors are those of the light, and they converge with its tolerance.
#[test]
fn a_chart_of_radiation_has_errors_of_light() {
    let folder = Folder::with(
        "[image]\nsize = [32, 32]\n[camera]\nposition = [0, 0, 20]\nfov = 30\nobserver = \"static\"\n[law]\nkind = \"schwarzschild\"\n\
         [rays]\nbounding_sphere = { radius = 60 }\n[radiation]\nfrequencies = [1.0]\n[[volumes]]\nshape = \"sphere\"\nradius = 12\n\
         density = \"exp(-((r - 7)/0.6)^2)\"\nemission = \"n\"\nabsorption = \"3*n\"\n",
    );
    let ran = folder
        .run("compare scene.toml -o report --rays 1000 --compared 60 --repeats 1 --slowest 4 --methods planar")
        .succeeds();
    assert!(ran.out.contains("relative error of the light, 95 %") && ran.out.contains("of their light"), "{}", ran.out);
    let text = folder.text("report/scene_transfer.csv");
    let rows: Vec<Vec<f64>> =
        text.lines().skip(1).map(|line| line.split(',').map(|word| word.parse().unwrap()).collect()).collect();
    let [loose, tight] = [&rows[0], &rows[4]];
    // The chart uses the fastest setting of the sweep. On a busy machine its steps may be so short that light has no error at any tolerance.
    let converges = tight[3] < 0.1 * loose[3] || loose[3] < 1e-6;
    assert!(rows.len() == 7 && converges && tight[3] < 1e-4 && tight[6] < 1e-5, "{text}");
    assert!(folder.text("report/index.html").contains("scene_transfer.svg"));
}

#[test]
fn places_where_methods_fail_are_a_table() {
    let folder = Folder::with(BALL);
    let place = "[law]\nkind = \"sources\"\n[[law.sources]]\nposition = [0, 0, 0]\nstrength = 1\n[rays]\nbounding_sphere = { radius = 20 }\n";
    std::fs::create_dir(folder.path("places")).unwrap();
    folder.write("places/centre.toml", place);
    folder.write("places/centre.csv", "x,y,z,vx,vy,vz\n-10,0,0,1,0,0\n-10,5,0,1,0,0\n");
    let ran = folder.run("compare --stability --scenes places -o report --methods rk4,euler").succeeds();
    assert!(ran.out.contains("centre") && ran.out.contains("given up") && ran.out.contains("silent"), "{}", ran.out);
    let table = folder.text("report/stability.csv");
    assert!(table.contains("centre,rk4,1,1,0,0,0,0,"));
    // The page explains every column under its name.
    let page = folder.text("report/stability.html").to_lowercase();
    for column in table.lines().next().unwrap().split(',').skip(2) {
        let explains = [". ", ">"].map(|before| page.contains(&format!("{before}{column}: ")));
        assert!(explains.contains(&true), "`{column}` in {page}");
    }
    folder.write("places/more.toml", place);
    folder.run("compare --stability --scenes places -o report").fails(1, &["more.csv"]);
}

#[test]
fn drift_is_measured_when_asked() {
    let folder = Folder::with(BALL);
    folder.write("rays.csv", "x,y,z,vx,vy,vz\n-5,3,0,1,0,0\n-5,1,4,1,0,0\n");
    let trace = "trace scene.toml --rays rays.csv -o ends.csv --drift";
    let hole = "--set law.kind=schwarzschild --set law.mass=0.2 --set rays.method=rk4";
    let ran = folder.run(&format!("{trace} {hole}")).succeeds();
    assert!(ran.err.contains("relative drift") && ran.err.contains("angular momentum"), "{}", ran.err);
    let ran = folder
        .run(&format!(
            "{trace} --set law.kind=lorenz --set law.order=2 --set rays.max_parameter=1 --set rays.method=rk4"
        ))
        .succeeds();
    assert!(ran.err.contains("no drift to report"), "{}", ran.err);
    folder.run(&format!("{trace} {hole} --set rays.sky_at_infinity=true")).fails(1, &["--drift", "sky_at_infinity"]);
}

/// Tracing in 64 bits gives digits that 32 bits do not have.
#[test]
fn precision_is_chosen_on_the_command_line() {
    let folder = Folder::with(BALL);
    folder.write("rays.csv", "x,y,z,vx,vy,vz\n-5,3,0,1,0,0\n");
    let tau = |more: &str| {
        let hole = "--set law.kind=schwarzschild --set law.mass=0.2 --set rays.method=dormand-prince";
        folder.run(&format!("trace scene.toml --rays rays.csv -o ends.csv {hole} {more}")).succeeds();
        folder.text("ends.csv").lines().nth(1).unwrap().split(',').nth(8).unwrap().to_owned()
    };
    let (single, double) = (tau(""), tau("--precision f64"));
    assert!(single.len() <= 10 && double.len() >= 14, "{single} {double}");
    let [single, double] = [single, double].map(|text| text.parse::<f64>().unwrap());
    assert!((single - double).abs() < 1e-4 * double);
}

#[test]
fn scenes_that_are_too_fine_for_32_bits_are_warned_of() {
    let far = BALL.replace("position = [0, 0, 5]", "position = [1e6, 0, 5]\nlook_at = [1e6, 0, 0]");
    let far = far.replace("radius = 10", "radius = 10, center = [1e6, 0, 0]");
    let folder = Folder::with(&far.replace("shape = \"sphere\"", "shape = \"sphere\"\ncenter = [1e6, 0, 0]"));
    let warning = "warning: objects[0]: at 1e6 from the origin, 32-bit positions are 1e-1 apart";
    folder.run("render scene.toml -o a.png").succeeds().says(&[warning, "use --precision f64"]);
    assert!(folder.run("check scene.toml").succeeds().out.contains(warning));
    assert!(!folder.run("render scene.toml -o a.png --precision f64").succeeds().err.contains("warning"));
}
