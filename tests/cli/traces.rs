//! `bentray trace`: one row per ray, in order, and each ray ends exactly where it should.

use super::tables::{HEADER, PATH_HEADER, Rows, table};
use super::{BALL, Folder};

/// Returns directions on a spiral over the whole sphere.
fn spiral(count: usize) -> impl Iterator<Item = [f64; 3]> {
    (0..count).map(move |i| {
        let z = 1.0 - (2.0 * i as f64 + 1.0) / count as f64;
        let (sin, cos) = (2.4 * i as f64).sin_cos();
        let r = (1.0 - z * z).sqrt();
        [r * cos, r * sin, z]
    })
}

fn trace(folder: &Folder, more: &str) -> Rows {
    let ran = folder.run(&format!("trace scene.toml --rays rays.csv -o out.csv {more}")).succeeds();
    assert_eq!(ran.out, "");
    Rows::of(&folder.text("out.csv"), HEADER)
}

#[test]
fn rays_end_on_the_bound_at_their_length_and_on_surfaces() {
    let bound = [1.0, 2.0, 3.0];
    let folder = Folder::with(
        "[rays]\nbounding_sphere = { center = [1, 2, 3], radius = 10 }\n[materials.m]\n\
         [[objects]]\nshape = \"sphere\"\ncenter = [7, 2, 3]\nradius = 2\nmaterial = \"m\"\n\
         [[objects]]\nshape = \"sphere\"\ncenter = [1, -4, 3]\nradius = 3\nmaterial = \"m\"\n",
    );
    let rays: Vec<[f64; 6]> = spiral(200).map(|[x, y, z]| [1.5, 2.25, 2.5, x, y, z]).collect();
    folder.write("rays.csv", table(&rays));
    let centers = [([7.0, 2.0, 3.0], 2.0), ([1.0, -4.0, 3.0], 3.0)];
    let bent = "--set law.kind=schwarzschild --set law.mass=0.05 --set law.center=[1,2,6]";
    for (law, straight) in [("", true), ("--set rays.method=rk4", true), (bent, false)] {
        let rows = trace(&folder, law);
        assert_eq!(rows.0.len(), rays.len());
        let (mut hits, mut escapes) = ([0; 2], 0);
        for (i, ray) in rays.iter().enumerate() {
            assert_eq!(rows.0[i][0], i.to_string());
            match (rows.0[i][1].as_str(), rows.0[i][12].as_str()) {
                ("escaped", "") => {
                    let off = rows.distance(i, bound) / 10.0 - 1.0;
                    assert!(off.abs() <= 2e-6, "{law}: ray {i} escapes {off:e} off");
                    escapes += 1;
                }
                ("hit", object) => {
                    let object: usize = object.parse().unwrap();
                    let (center, radius) = centers[object];
                    let off = rows.distance(i, center) - radius;
                    assert!(off.abs() <= 1e-5, "{law}: ray {i} hits {off:e} off");
                    hits[object] += 1;
                }
                other => assert!(!straight && other == ("captured", ""), "{law}: {other:?}"),
            }
            let numbers = rows.numbers(i).map(f64::from);
            let line = |k: usize| ray[k] + numbers[6] * ray[k + 3];
            let off = (0..3).map(|k| (numbers[k] - line(k)).abs());
            assert!(!straight || off.fold(0.0, f64::max) < 1e-5, "{law}: ray {i}");
        }
        assert!(hits.iter().all(|n| *n > 2) && escapes > 100, "{law}");

        let rows = trace(&folder, &format!("{law} --set rays.max_parameter=2.7"));
        assert!(rows.column("status").contains(&"ended"), "{law}");
        for (i, status) in rows.column("status").into_iter().enumerate() {
            let tau = rows.column("tau")[i];
            let short = tau.parse::<f32>().unwrap() < 2.7;
            assert!(if status == "ended" { tau == "2.7" } else { short }, "{law}: {status} at {tau}");
        }
    }
}

#[test]
fn rays_from_outside_the_bound_are_followed_in_and_through_or_escape_at_once() {
    let folder = Folder::with(BALL);
    let rays = [
        [20.0, 0.0, 0.0, -1.0, 0.0, 0.0],
        [20.0, 0.0, 0.0, 1.0, 0.0, 0.0],
        [20.0, 11.0, 0.0, -1.0, 0.0, 0.0],
        [20.0, 5.0, 0.0, -1.0, 0.0, 0.0],
    ];
    folder.write("rays.csv", table(&rays));
    for method in ["exact", "rk4"] {
        let rows = trace(&folder, &format!("--set rays.method={method}"));
        assert_eq!(rows.column("status"), ["hit", "escaped", "escaped", "escaped"], "{method}");
        assert_eq!(rows.column("object"), ["0", "", "", ""]);
        assert_eq!(rows.numbers(0), [1.0, 0.0, 0.0, -1.0, 0.0, 0.0, 19.0]);
        // A ray that starts outside and moves outward has escaped at its start.
        assert_eq!(rows.numbers(1), [20.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0]);
        assert_eq!(rows.column("steps")[1], "0");
        // A ray that misses the bounding sphere ends somewhere outside.
        assert!(rows.distance(2, [0.0; 3]) > 10.0, "{method}");
        // A ray through the bounding sphere ends where it leaves.
        let [x, y, ..] = rows.numbers(3);
        assert!((f64::from(x) + 75.0_f64.sqrt()).abs() < 2e-5, "{method}: {x}");
        assert_eq!(y, 5.0);
    }
}

#[test]
fn no_ray_is_lost_without_a_word() {
    let folder = Folder::with(BALL);
    // A ray that is too fast for numbers of 32 bits, one with too few segments, and a valid one.
    let rays = [[0.0, 0.0, 5.0, 0.0, 0.0, 1e25], [0.0, 0.0, 5.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.5, 0.0, 0.0, -1.0]];
    folder.write("rays.csv", table(&rays));
    let more = "--set rays.method=rk4 --set rays.max_segments=3";
    let ran = folder.run(&format!("trace scene.toml --rays rays.csv -o - {more}")).succeeds();
    let rows = Rows::of(&ran.out, HEADER);
    assert_eq!(rows.column("status")[1..], ["exhausted", "hit"]);
    assert!(["failed", "stalled"].contains(&rows.column("status")[0]));
    assert_eq!(rows.column("steps")[1], "3");
    let totals = ran.err.lines().find(|line| line.contains(" rays, ")).unwrap();
    for status in rows.column("status") {
        assert!(totals.contains(&format!(" {status} 1")), "{totals}");
    }
    for schedule in ["segment", "paper", "fused --no-early-termination --segments-per-pass 2"] {
        let arguments = format!("trace scene.toml --rays rays.csv -o - {more} --schedule {schedule}");
        let other = folder.run(&arguments).succeeds();
        assert_eq!(other.out, ran.out, "{schedule}");
    }
}

#[test]
fn order_columns_and_totals_hold_for_many_rays() {
    let folder = Folder::with(BALL);
    // More rays than a row of the state's textures, and columns in a different order.
    let count = 1030;
    let xs = (0..count).map(|i| f64::from(i) / f64::from(count) * 4.0 - 2.0);
    let lines = xs.map(|x| format!("-1, 0, 0, {x}, 5, 0.25\n"));
    let text = "vz, vy, vx, x, z, y\n".to_owned() + &lines.collect::<String>();
    folder.write("rays.csv", text);
    let ran = folder.run("trace scene.toml --rays rays.csv -o - --set rays.method=rk4").succeeds();
    let rows = Rows::of(&ran.out, HEADER);
    assert_eq!(rows.0.len(), count as usize);
    for i in 0..count as usize {
        let x = i as f64 / f64::from(count) * 4.0 - 2.0;
        assert_eq!(rows.0[i][0], i.to_string());
        assert!((f64::from(rows.numbers(i)[0]) - x).abs() < 1e-6);
        assert_eq!(rows.0[i][1] == "hit", x * x + 0.0625 < 1.0, "x = {x}");
    }
    let steps: u64 = rows.column("steps").iter().map(|n| n.parse::<u64>().unwrap()).sum();
    let hits = rows.column("status").iter().filter(|s| **s == "hit").count();
    let totals = ran.err.lines().last().unwrap();
    let begins = format!("{count} rays, {steps} steps, {steps} segments, ");
    assert!(totals.starts_with(&begins), "not {begins}: {totals}");
    assert!(totals.ends_with(&format!("; hit {hits} escaped {}", count as usize - hits)), "{totals}");
}

#[test]
fn the_shadow_edge_lies_at_the_critical_impact_parameter() {
    let folder = Folder::with("[law]\nkind = \"schwarzschild\"\n[rays]\nbounding_sphere = { radius = 1100 }\n");
    // b = L/E with L = r s and E² = 1 − s² + (1 − 2/r) s², because s is the tangential part of a unit direction.
    let ray = |r: f64, b: f64| {
        let s = b / (r * r + 2.0 * b * b / r).sqrt();
        [0.0, 0.0, r, s, 0.0, -(1.0 - s * s).sqrt()]
    };
    let rays = [ray(50.0, 5.19), ray(50.0, 5.21), ray(1000.0, 5.19), ray(1000.0, 5.21)];
    folder.write("rays.csv", table(&rays));
    for form in ["orbit-equation", "geodesic"] {
        let rows = trace(&folder, &format!("--set law.form={form}"));
        let statuses = rows.column("status");
        assert_eq!(statuses, ["captured", "escaped", "captured", "escaped"], "{form}");
    }
}

#[test]
fn paths_run_from_the_start_to_the_result() {
    let folder = Folder::with(BALL);
    let rays = [[0.0, 0.0, 5.0, 0.0, 0.0, -1.0], [0.0, 0.0, 5.0, 0.0, 0.6, -0.8], [3.0, 0.25, 0.25, 0.0, 0.0, 1.0]];
    folder.write("rays.csv", table(&rays));
    let law = "--set law.kind=schwarzschild --set law.mass=0.1 --set rays.method=rk4";
    let ends = trace(&folder, law);
    let ran =
        folder.run(&format!("trace scene.toml --rays rays.csv -o paths.csv --path --plot paths.svg {law}")).succeeds();
    assert_eq!(ran.out, "");
    let rows = Rows::of(&folder.text("paths.csv"), PATH_HEADER);
    let mut at = 0;
    for (i, ray) in rays.iter().enumerate() {
        let path: Vec<usize> = (at..rows.0.len()).take_while(|r| rows.0[*r][0] == i.to_string()).collect();
        assert!(path.len() > 3, "ray {i} has {} points", path.len());
        for (index, row) in path.iter().enumerate() {
            assert_eq!(rows.0[*row][1], index.to_string());
            assert!(index == 0 || rows.numbers(*row)[6] > rows.numbers(row - 1)[6], "tau grows");
        }
        let start = [0, 1, 2, 3, 4, 5].map(|k| ray[k] as f32);
        assert_eq!(rows.numbers(path[0])[..6], start);
        assert_eq!(rows.numbers(path[0])[6], 0.0);
        assert_eq!(rows.numbers(path[path.len() - 1]), ends.numbers(i), "ray {i}");
        at += path.len();
    }
    assert_eq!(at, rows.0.len());
    let svg = folder.text("paths.svg");
    assert!(svg.starts_with("<svg") && svg.trim_end().ends_with("</svg>"));
    for word in ["hit", "escaped", "<path"] {
        assert!(svg.contains(word), "{word}");
    }
}

/// The rays of a straight pinhole camera go through the centers of their pixels.
#[test]
fn pixels_start_where_the_camera_looks() {
    let folder = Folder::with(
        "[image]\nsize = [40, 20]\nsamples = 9\n[camera]\nposition = [0, 0, 5]\nfov = 90\n[rays]\nbounding_sphere = { radius = 8 }\n",
    );
    folder.run("trace scene.toml --pixel 0,0 --pixel 29,4 -o out.csv --path").succeeds();
    let rows = Rows::of(&folder.text("out.csv"), PATH_HEADER);
    for (ray, [x, y]) in [("0", [0.0, 0.0]), ("1", [29.0, 4.0])] {
        let ray = rows.0.iter().find(|row| row[0] == ray).unwrap();
        let number = |k: usize| ray[k].parse::<f64>().unwrap();
        assert_eq!([2, 3, 4].map(number), [0.0, 0.0, 5.0]);
        // The longer side or the height spans 90 degrees.
        let slope = [number(5) / -number(7), number(6) / -number(7)];
        let wanted = [(x + 0.5 - 20.0) / 10.0, (10.0 - y - 0.5) / 10.0];
        let scale = slope[0] / wanted[0];
        assert!((scale - 1.0).abs() < 1e-6 || (scale - 0.5).abs() < 1e-6, "{slope:?} and {wanted:?}");
        assert!((slope[1] / wanted[1] - scale).abs() < 1e-6, "{slope:?} and {wanted:?}");
    }
    folder.run("trace scene.toml --pixel 40,3 -o -").fails(1, &["pixel 40,3 is outside the image of 40x20 pixels"]);
    let round = "trace scene.toml --pixel 0,0 -o - --set camera.kind=fisheye --set camera.fov=180 --set camera.corners=transparent";
    let ran = folder.run(round);
    assert_eq!(ran.code, Some(1), "{}", ran.err);
    ran.says(&["the camera has no ray through pixel 0,0"]);
    folder.run("trace scene.toml --pixel 4 -o -").fails(2, &["such as 320,240, found `4`"]);
}

/// The attractor of the orbit through a pixel is drawn behind it.
#[test]
fn an_attractor_is_drawn_behind_the_orbits() {
    let folder = Folder::with(
        "[image]\nsize = [40, 30]\n[camera]\nkind = \"orthographic\"\nposition = [0, -12, 25]\nlook_at = [0, 0, 25]\nup = [0, 0, 1]\nheight = 45\n\
         [law]\nkind = \"lorenz\"\n[rays]\nmethod = \"rk4\"\nbounding_sphere = { center = [0, 0, 25], radius = 110 }\nmax_parameter = 1.5\n",
    );
    folder.run("trace scene.toml --pixel 10,10 --plot with.svg --attractor 20 --cut y").succeeds();
    folder.run("trace scene.toml --pixel 10,10 --plot without.svg --cut y").succeeds();
    let [with, without] = ["with.svg", "without.svg"].map(|name| folder.text(name));
    assert!(with.len() > 2 * without.len(), "{} and {}", with.len(), without.len());
    folder.run("trace scene.toml --pixel 10,10 --attractor -o -").fails(2, &["--plot"]);
    let straight = "trace scene.toml --pixel 10,10 --plot no.svg --attractor --set law.kind=straight";
    folder.run(straight).fails(1, &["--attractor requires a flow"]);
}

#[test]
fn nothing_comes_out_of_a_horizon() {
    let folder = Folder::with("[rays]\nbounding_sphere = { radius = 30 }\n");
    // Outward and across, from 0.4 to 0.95 of the radius of the inner horizon.
    for (law, inside) in [
        ("--set law.kind=schwarzschild", 2.0),
        ("--set law.kind=schwarzschild --set law.form=geodesic", 2.0),
        ("--set law.kind=reissner-nordstrom --set law.charge=0.6", 1.8),
        ("--set law.kind=kerr-newman --set law.spin=0.8", 0.4),
    ] {
        let rays: Vec<[f64; 6]> = (0..12)
            .map(|i| {
                let r = inside * (0.4 + 0.05 * f64::from(i));
                let (sin, cos) = (0.1 + 0.25 * f64::from(i)).sin_cos();
                [0.0, r, 0.0, 0.0, sin, cos]
            })
            .collect();
        folder.write("rays.csv", table(&rays));
        let rows = trace(&folder, law);
        for (i, ray) in rays.iter().enumerate() {
            assert_eq!(rows.0[i][1], "captured", "{law}: ray {i}");
            assert_eq!(rows.numbers(i).map(f64::from)[..3], ray.map(|x| f64::from(x as f32))[..3], "{law}: ray {i}");
        }
        let ran = folder.run(&format!("trace scene.toml --rays rays.csv -o path.csv --path {law}")).succeeds();
        assert_eq!(ran.err.lines().filter(|line| line.starts_with("warning")).count(), 0, "{}", ran.err);
        let paths = Rows::of(&folder.text("path.csv"), PATH_HEADER);
        assert_eq!(paths.0.len(), rays.len(), "a path consists of its start");
    }
}

/// Between the horizons, the start of some light shows that it came from below, and it ends on the horizon in its first segment.
#[test]
fn every_path_begins_where_its_ray_does() {
    let folder = Folder::with(
        "[image]\nsize = [12, 12]\n[camera]\nposition = [1.2, 0.4, 0.5]\nlook_at = [2.2, 0.4, 0.5]\nup = [0, 0, 1]\n\
         kind = \"fisheye\"\nfov = 360\nobserver = \"infalling\"\n[law]\nkind = \"kerr-newman\"\nspin = 0.9\n\
         [rays]\nmethod = \"dormand-prince\"\ntolerance = 1e-6\nmax_segments = 4000\nbounding_sphere = { radius = 60 }\n",
    );
    // The pixels inside the circle of a fisheye image.
    let pixels = (0..144_i32).map(|i| [i % 12, i / 12]);
    let pixels: Vec<[i32; 2]> = pixels.filter(|[x, y]| (2 * x - 11).pow(2) + (2 * y - 11).pow(2) < 136).collect();
    let options: Vec<_> = pixels.iter().map(|[x, y]| format!(" --pixel {x},{y}")).collect();
    let options = options.concat();
    folder.run(&format!("trace scene.toml --path -o path.csv{options}")).succeeds();
    let paths = Rows::of(&folder.text("path.csv"), PATH_HEADER);
    let starts: Vec<usize> = (0..paths.0.len()).filter(|row| paths.0[*row][1] == "0").collect();
    assert_eq!(starts.len(), pixels.len());
    let mut short = 0;
    for (i, &row) in starts.iter().enumerate() {
        let start = paths.numbers(row).map(f64::from);
        assert!(paths.distance(row, [1.2, 0.4, 0.5]) < 1e-6 && start[6] == 0.0, "{start:?}");
        if starts.get(i + 1).copied().unwrap_or(paths.0.len()) > row + 2 {
            continue;
        }
        short += 1;
        // The mean velocity on the path differs from the velocity at each end no more than these differ from each other.
        let end = paths.numbers(row + 1).map(f64::from);
        let sum = |of: &dyn Fn(usize) -> f64| (0..3).map(|k| of(k).powi(2)).sum::<f64>().sqrt();
        let off = sum(&|k| end[k] - start[k] - end[6] * 0.5 * (start[k + 3] + end[k + 3]));
        let change = sum(&|k| start[k + 3] - end[k + 3]);
        assert!(off <= 0.5 * end[6] * change + 1e-5, "{start:?} {end:?}");
    }
    assert!(short > 2, "{short}");
}
