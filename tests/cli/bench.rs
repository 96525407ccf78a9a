//! `bentray bench`: reports for people and for scripts.

use super::{BALL, Folder};

/// The keys of the 2004 benchmark scene, at a small size.
const SMALL: &str = "--size 16x16 --repeats 1";

#[test]
fn a_report_is_printed_and_written() {
    let folder = Folder::with(BALL);
    let ran = folder.run(&format!("bench schedules {SMALL} -o report")).succeeds();
    for word in ["paper", "segment", "fused", "whole", "early termination (s)", "16×16"] {
        assert!(ran.out.contains(word), "{word}: {}", ran.out);
    }
    let csv = folder.text("report/schedules_schedules.csv");
    assert_eq!(csv.lines().count(), 9, "{csv}");
    let header: Vec<&str> = csv.lines().next().unwrap().split(',').collect();
    assert!(csv.lines().all(|line| line.split(',').count() == header.len()), "{csv}");
    assert!(folder.text("report/index.html").contains("schedules_fused.svg"));
    assert!(folder.text("report/schedules_fused.svg").contains("seconds on the device"));
}

#[test]
fn json_is_for_scripts() {
    let folder = Folder::with(BALL);
    folder.write(
        "hole.toml",
        "[camera]\nposition = [0, 0, 20]\n[law]\nkind = \"schwarzschild\"\n\
         [rays]\nmethod = \"rk4\"\nscaled_step = 0.3\nbounding_sphere = { radius = 30 }\n",
    );
    let ran = folder.run(&format!("bench limit hole.toml scene.toml {SMALL} --json")).succeeds();
    let json: serde_json::Value = serde_json::from_str(&ran.out).unwrap();
    let tables = &json["tables"];
    assert_eq!(tables["ceilings"].as_array().unwrap().len(), 3);
    let [hole, ball] = tables["scenes"].as_array().unwrap().as_slice() else { panic!("{tables}") };
    assert!(hole["faster relative to bare"].as_f64().unwrap() > 0.0 && hole["steps per ray"].as_f64().unwrap() > 10.0);
    // Straight space has no steps.
    assert!(ball["faster relative to bare"].is_null() && ball["method"] == "exact");
    assert_eq!((&json["name"], &json["repeats"], &json["size"]), (&"limit".into(), &1.into(), &vec![16, 16].into()));
}

#[test]
fn sampling_has_an_error_for_every_number_of_samples() {
    let folder = Folder::with(BALL);
    let ran = folder.run("bench sampling scene.toml --size 16x12 --repeats 1 -o report --json").succeeds();
    let json: serde_json::Value = serde_json::from_str(&ran.out).unwrap();
    let tables = &json["tables"];
    let rows = tables["scenes"].as_array().unwrap();
    assert_eq!((rows.len(), tables["judged"].as_array().unwrap().len()), (8, 1));
    let number = |row: usize, key: &str| rows[row][key].as_f64().unwrap();
    assert!(number(0, "RMSE") > 2.0 * number(2, "RMSE") && number(3, "RMSE") < number(2, "RMSE"), "{tables}");
    assert_eq!((number(3, "samples per pixel"), number(2, "relative to uniform 16")), (64.0, 1.0));
    assert!(number(6, "samples per pixel") < 16.0 && number(6, "at the cap (%)") < 50.0, "{tables}");
    assert_eq!(folder.text("report/sampling_scenes.csv").lines().count(), 9);
    assert!(folder.text("report/sampling_error.svg").contains("RMSE"));
}

#[test]
fn aims_and_guide_are_worth_their_time() {
    let folder = Folder::with(BALL);
    let ran = folder.run("bench paths --size 4x4 --repeats 1 --json").succeeds();
    let json: serde_json::Value = serde_json::from_str(&ran.out).unwrap();
    let tables = &json["tables"];
    let rows = tables["emitters"].as_array().unwrap();
    assert_eq!((rows.len(), tables["truths"].as_array().unwrap().len()), (12, 4));
    let error = |row: usize| rows[row]["error"].as_f64().unwrap();
    for lamp in 0..4 {
        let [own, aimed] = [error(3 * lamp), error(3 * lamp + 1)];
        assert!(own > 1.3 * aimed && aimed > 0.0, "{tables}");
    }
}

#[test]
fn the_list_is_held_against_masks() {
    let folder = Folder::with(BALL);
    let ran = folder.run(&format!("bench compaction scene.toml {SMALL} -o report")).succeeds();
    assert!(ran.out.contains("speedup by compaction"), "{}", ran.out);
    assert_eq!(folder.text("report/compaction_compaction.csv").lines().count(), 5);
}

#[test]
fn a_start_is_measured_by_its_parts() {
    let folder = Folder::with(BALL);
    let ran = folder.run("bench start scene.toml --repeats 1 --json").succeeds();
    let json: serde_json::Value = serde_json::from_str(&ran.out).unwrap();
    let rows = json["tables"]["start"].as_array().unwrap();
    let [cold, warm] = rows.as_slice() else { panic!("{json}") };
    for row in [cold, warm] {
        let number = |name: &str| row[name].as_f64().unwrap();
        let parts = ["scene", "device", "program", "method", "first image"].map(number);
        assert!((parts.iter().sum::<f64>() - number("launch to first pixel (s)")).abs() < 0.01, "{row}");
        assert!(number("second image (s)") > 0.0);
    }
    assert_eq!((&cold["cache"], &warm["cache"]), (&"empty".into(), &"filled".into()));
}

#[test]
fn scenes_are_for_some() {
    let folder = Folder::with(BALL);
    folder
        .run("bench paper scene.toml")
        .fails(1, &["scene.toml: scene files can be given only for `limit`, `sampling`, `compaction` and `start`"]);
    folder.run("bench limit missing.toml").fails(1, &["missing.toml"]);
    folder.run("bench paper mesh.obj").fails(1, &["mesh.obj: a mesh can be given only for `groller`"]);
    folder.run("bench groller one.obj two.obj").fails(1, &["two.obj: `groller` takes one mesh"]);
    folder.run("bench groller missing.obj").fails(1, &["missing.obj"]);
}
