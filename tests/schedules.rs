//! All schedules, with masks and without, give the same picture to the last bit.
//!
//! The binary is run, a process for each picture: what is compared is what users get.

use std::path::Path;
use std::process::Command;

use crate::support::shipped_scenes;

const VARIANTS: [&[&str]; 7] = [
    &["--schedule", "fused"],
    &["--schedule", "fused", "--segments-per-pass", "3"],
    &["--schedule", "fused", "--no-masks"],
    &["--schedule", "segment"],
    &["--schedule", "segment", "--no-masks"],
    &["--schedule", "paper"],
    &["--schedule", "paper", "--no-masks"],
];

fn rendered(scene: &Path, variant: &[&str], more: &[&str], folder: &Path) -> Vec<u8> {
    let picture = folder.join("picture.exr");
    let mut command = Command::new(env!("CARGO_BIN_EXE_bentray"));
    let cheap = ["--size", "80x60", "--samples", "1", "--set", "rays.max_segments=120", "--device", "llvmpipe"];
    command.arg("render").args(cheap).args(more).args(variant).arg(scene).arg("-o").arg(&picture);
    command.env("NODEVICE_SELECT", "1");
    let output = command.output().unwrap();
    assert!(output.status.success(), "{variant:?}: {}", String::from_utf8_lossy(&output.stderr));
    std::fs::read(picture).unwrap()
}

fn assert_all_the_same(scene: &Path, more: &[&str]) {
    let folder = tempfile::tempdir().unwrap();
    let first = rendered(scene, VARIANTS[0], more, folder.path());
    for variant in &VARIANTS[1..] {
        let other = rendered(scene, variant, more, folder.path());
        assert!(first == other, "{} {more:?}: {variant:?} differs", scene.display());
    }
}

#[test]
fn shipped_scenes_do_not_depend_on_the_schedule() {
    for scene in shipped_scenes() {
        // Which method is fastest is a matter of time: each picture is to be of the same one.
        let straight = scene.to_string_lossy().contains("straight");
        let method: &[&str] = if straight { &[] } else { &["--set", "rays.method=rk4"] };
        assert_all_the_same(&scene, method);
    }
}

/// Chords of several steps, where `paper` rotates three slots; controllers that remember; ṫ carried along.
#[test]
fn methods_do_not_depend_on_the_schedule() {
    let hole = shipped_scenes().into_iter().find(|path| path.ends_with("fig4e_schwarzschild.toml")).unwrap();
    let methods: [&[&str]; 4] = [
        &["--set", "rays.segment=chord", "--set", "rays.steps_per_segment=5"],
        &["--set", "rays.method=rk4-doubling", "--set", "rays.length=90"],
        &[
            "--set",
            "rays.method=euler-doubling",
            "--set",
            "rays.doubling=paper",
            "--set",
            "rays.tolerance=1e-3",
            "--set",
            "rays.segment=chord",
        ],
        &["--set", "law.form=geodesic", "--set", "rays.method=euler", "--set", "rays.step=0.5"],
    ];
    for method in methods {
        assert_all_the_same(&hole, method);
    }
}
