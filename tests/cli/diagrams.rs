//! Tests `bentray trace --plot`: ray diagrams, and the measurements in them.

use super::tables::{HEADER, Rows, table};
use super::{BALL, Folder};

/// A Luneburg lens that fills the bounding sphere: parallel rays meet where the middle one leaves it.
const LENS: &str = "[law]\nkind = \"medium\"\nindex = { kind = \"luneburg\", radius = 1, c = 2 }\n\
                    [rays]\nmethod = \"rk4\"\nbounding_sphere = { radius = 1 }\n";

/// Returns the number after a text.
fn number_after(text: &str, before: &str) -> f64 {
    let rest = text.split(before).nth(1).unwrap_or_else(|| panic!("no `{before}` in {text}"));
    let number: String = rest.chars().take_while(|c| c.is_ascii_digit() || "+-.e".contains(*c)).collect();
    number.parse().unwrap_or_else(|_| panic!("{number} in {text}"))
}

#[test]
fn fans_and_bundles_are_followed_like_rays_of_a_file() {
    let folder = Folder::with(BALL);
    folder.write("rays.csv", "x,y,z,vx,vy,vz\n0,0,5,0,0,-1\n");
    let more =
        "--bundle from=[5,0,0],toward=[0,0,0],width=4,count=3 --fan from=[0,5,0],toward=[0,0,0],spread=90,count=2";
    folder.run(&format!("trace scene.toml --rays rays.csv -o out.csv {more}")).succeeds();
    let rows = Rows::of(&folder.text("out.csv"), HEADER);
    // The ray of the file, two of the fan, and three of the bundle.
    assert_eq!(rows.column("status"), ["hit", "escaped", "escaped", "escaped", "hit", "escaped"]);
    let [x, y, z, ..] = rows.numbers(4);
    assert!(f64::from(x - 1.0).abs() < 1e-6 && y == 0.0 && z == 0.0);
    assert_eq!(folder.names(), ["out.csv", "rays.csv", "scene.toml"]);
}

#[test]
fn a_diagram_needs_no_table() {
    let folder = Folder::with(BALL);
    let rays = "--bundle from=[-5,0,0],toward=[0,0,0],width=4,count=9";
    let ran = folder.run(&format!("trace scene.toml {rays} --plot a.svg")).succeeds();
    assert_eq!(ran.out, "");
    assert_eq!(folder.names(), ["a.svg", "scene.toml"]);
    let svg = folder.text("a.svg");
    for text in ["x (scene units)", "y (scene units)", ">surface<", ">hit<", ">escaped<"] {
        assert!(svg.contains(&text.replace(['>', '<'], "")), "{text}");
    }
    // The frame shows the ball, and the bounding sphere is outside.
    assert!(!svg.contains("bound"));
    folder
        .run(&format!("trace scene.toml {rays} --plot b.svg --view all --cut y=0.5"))
        .fails(1, &["the bundle from [-5, 0, 0]"]);
    folder.run(&format!("trace scene.toml {rays} --plot b.png --view all --cut y")).succeeds();
    folder.run(&format!("trace scene.toml {rays} --plot c.svg --view all --cut y")).succeeds();
    let svg = folder.text("c.svg");
    assert!(svg.contains("bound") && svg.contains("z (scene units)") && !svg.contains("y (scene units)"));
    assert_eq!(folder.names(), ["a.svg", "b.png", "c.svg", "scene.toml"]);
}

#[test]
fn a_lens_has_its_focus_where_it_should() {
    let folder = Folder::with(LENS);
    let rays = (-4..=4).map(|i| f64::from(i) * 0.2).map(|y| [-(1.0 - y * y).sqrt(), y, 0.0, 1.0, 0.0, 0.0]);
    folder.write("rays.csv", table(&rays.collect::<Vec<_>>()));
    let ran = folder.run("trace scene.toml --rays rays.csv --focus --plot a.svg").succeeds();
    assert!((number_after(&ran.err, "focus of rays.csv: [") - 1.0).abs() < 2e-3, "{}", ran.err);
    assert!(number_after(&ran.err, "spread ") < 2e-3, "{}", ran.err);
    assert!(ran.err.contains("of 9 rays"), "{}", ran.err);
    let svg = folder.text("a.svg");
    assert!(svg.contains("F1") && svg.contains("r = R"));
    let folder = Folder::with(BALL);
    let parallel =
        folder.run("trace scene.toml --bundle from=[-2,2,0],toward=[0,2,0],width=1,count=3 --focus").succeeds();
    parallel.says(&["no focus of the bundle from [-2, 2, 0], because fewer than two rays pass through the scene or \
                     all stay parallel"]);
}

#[test]
fn windings_are_counted() {
    let folder = Folder::with(BALL);
    // Past the ball at a distance of 2, from (−3, 2) to the bounding sphere at (√96, 2): clockwise as seen from the origin.
    let ran = folder.run("trace scene.toml --bundle from=[-3,2,0],toward=[0,2,0],width=1,count=1 --windings [0,0,0]");
    let ran = ran.succeeds();
    let turns = -(2.0_f64.atan2(-3.0) - 2.0_f64.atan2(96.0_f64.sqrt())) / std::f64::consts::TAU;
    let row = ran.err.lines().last().unwrap();
    let found: f64 = row.split_whitespace().nth(1).unwrap().parse().unwrap();
    assert!((found - turns).abs() < 1e-5, "{found} {turns}");
}

#[test]
fn tight_spirals_are_wound_to_their_end() {
    let folder = Folder::with(
        "[rays]\nprecision = \"f64\"\nbounding_sphere = { radius = 4.0000001 }\n\
         [[objects]]\nshape = \"sphere\"\nradius = 4\ninterior = { kind = \"inverse-r\", k = 4 }\n",
    );
    for (psi, bound) in [(0.3_f64, 1e-6), (0.01, 1e-6), (0.001, 1e-4)] {
        let (sin, cos) = psi.sin_cos();
        folder.write("rays.csv", format!("x,y,z,vx,vy,vz\n2,0,0,{sin},{cos},0\n"));
        let ran = folder.run("trace scene.toml --rays rays.csv --cut z --windings [0,0,0]").succeeds();
        let mut words = ran.err.lines().last().unwrap().split_whitespace().skip(1);
        let found: f64 = words.next().unwrap().parse().unwrap();
        assert_eq!(words.next(), Some("escaped"));
        // (θ_R − θ_s)/2π = ln(R/r)/(2π tan ψ) (thesis Eq. 21).
        let turns = 2.0_f64.ln() / psi.tan() / std::f64::consts::TAU;
        assert!((found.abs() / turns - 1.0).abs() < bound, "{psi}: {found} {turns}");
    }
}

#[test]
fn mistakes_in_a_diagram_exit_with_2() {
    let folder = Folder::with(BALL);
    let cases: [(&str, &[&str]); 12] = [
        ("--plot a.svg", &["--rays <FILE>", "--fan <FAN>", "--bundle <BUNDLE>"]),
        ("--fan from=[0,0,5],toward=[0,0,0],spread=9,count=2", &["--output <FILE>", "--plot <FILE>"]),
        ("--plot a.svg --fan from=[0,0,5]", &["missing `toward`; for example `from="]),
        (
            "--plot a.svg --fan from=[0,5],toward=[0,0,0],spread=9,count=2",
            &["expected three numbers such as [1, 0, -2.5], found `[0,5]`"],
        ),
        (
            "--plot a.svg --bundle from=[0,0,5],toward=[0,0,0],spread=9",
            &["unknown key `spread`, expected one of from, toward, width"],
        ),
        ("--plot a.svg --bundle from=[0,0,5],toward=[0,0,0],width=-1,count=2", &["`width`: expected a number > 0"]),
        ("--plot a.svg --cut w", &["expected x, y, z"]),
        ("--plot a.svg --cut z=high", &["expected a number, as in `z=2.5`, found `z=high`"]),
        ("--plot a.svg --cut normal=[0,0,0]", &["`normal` is zero"]),
        ("--plot a.svg --view [0,1,2]", &["four numbers [left, right, bottom, top]"]),
        ("--plot a.svg --view [1,0,0,1]", &["expected left < right"]),
        ("--plot a.svg --windings [0,0]", &["expected three numbers such as [1, 0, -2.5], found `[0,0]`"]),
    ];
    for (arguments, texts) in cases {
        folder.run(&format!("trace scene.toml {arguments}")).fails(2, texts);
    }
    let rays = "--fan from=[0,0,5],toward=[0,0,0],spread=9,count=2";
    folder.run(&format!("trace scene.toml {rays} --plot a.pdf")).fails(1, &["a.pdf", ".svg"]);
    folder.run(&format!("trace scene.toml {rays} --plot no/a.svg")).fails(1, &["the folder no does not exist"]);
    folder.run(&format!("trace scene.toml {rays} --plot a.svg --path")).fails(2, &["--output <FILE>"]);
    assert_eq!(folder.names(), ["scene.toml"]);
}

#[test]
fn formulas_are_drawn_without_a_scene() {
    let folder = Folder::new();
    let charts: [(&str, &[&str]); 7] = [
        ("fresnel --eta 1.4", &["reflected, η = 1.4", "transmitted, η = 1.4", "angle of incidence (degrees)"]),
        ("snell", &["η = 1.33", "angle of refraction (degrees)"]),
        ("beer --c 0.9,0.5 --distance 8", &["c = 0.9", "c = 0.5", "distance d in the medium"]),
        ("noise --octaves 3 --length 5 --seed 2", &["octave 1", "octave 3", "sum", "cells of the first octave"]),
        ("noise --wrap 5", &["from 0 to 1", "wrapped 5 times"]),
        ("spiral", &["I and II: outwards", "III and IV: inwards"]),
        ("spirals --psi 5.73,90", &["5.73° to the circle", "90° to the circle", "medium"]),
    ];
    for (arguments, texts) in charts {
        folder.run(&format!("formula {arguments} -o a.svg")).succeeds();
        let svg = folder.text("a.svg");
        for text in texts {
            assert!(svg.contains(text), "{arguments}: no {text}");
        }
        assert!(!svg.contains("cannot be shown") && !svg.contains("NaN"), "{arguments}");
        folder.run(&format!("formula {arguments} -o a.png")).succeeds();
    }
    for (arguments, text) in [
        ("", "fresnel"),
        ("tangent", "'tangent'"),
        ("fresnel", "--output <FILE>"),
        ("fresnel --eta 0", "expected a number > 0 and at most 1e6, found `0`"),
        ("beer --c 1.5", "expected a number > 0 and at most 1, found `1.5`"),
        ("noise --octaves 9", "1..=8"),
        ("noise --length 0", "expected a number > 0 and at most 1000, found `0`"),
        ("spiral --ratio 1", "expected a number > 1 and at most 1e6, found `1`"),
        ("spirals --psi 0.01", "found `0.01`"),
        ("spirals --psi -90", "found `-90`"),
    ] {
        let ran = folder.run(&format!("formula {arguments}"));
        assert_eq!(ran.code, Some(2), "{arguments}");
        ran.says(&[text]);
    }
    folder.run("formula beer -o a.pdf").fails(1, &["a.pdf", ".svg"]);
    assert_eq!(folder.names(), ["a.png", "a.svg"]);
}
