//! `--crop`, `--memory` and `merge`: an image made of parts is identical to the whole.

use bentray::output::picture;
use bentray::program::Layer;
use bentray::render::Plane;

use super::{BALL, Folder};

const HOLE: &str = "--set law.kind=schwarzschild --set rays.method=rk4 --set law.mass=0.2 \
                    --set objects.0.center=[1.5,0,0] --set camera.stereo={separation=0.1} --size 40x30 --samples 3";

/// Overlapping parts of odd sizes, each with another schedule and another tile
/// size, merge to the file of a single render: every layer is byte-identical.
#[test]
fn parts_by_any_schedule_make_the_whole_to_the_byte() {
    let folder = Folder::with(BALL);
    let parts = [
        ("0,0,13x17", "--schedule paper"),
        ("13,0,27x9", "--schedule segment --memory 560000"),
        ("11,7,29x11", "--segments-per-pass 3 --no-early-termination --memory 210000"),
        ("0,17,40x13", "--memory 48KiB"),
    ];
    folder.run(&format!("render scene.toml -o whole.exr -o whole.png {HOLE}")).succeeds();
    for (i, (crop, more)) in parts.iter().enumerate() {
        folder.run(&format!("render scene.toml -o part{i}.exr --crop {crop} {more} {HOLE}")).succeeds();
    }
    folder.run("merge part2.exr part0.exr part3.exr part1.exr -o made.exr -o made.png").succeeds();
    assert!(folder.read("made.exr") == folder.read("whole.exr"));
    assert!(folder.read("made.png") == folder.read("whole.png"));
    // A PNG shows the part inside the window.
    folder.run(&format!("render scene.toml -o part.png --crop 11,7,29x11 {HOLE}")).succeeds();
    let [whole, part] = ["whole.png", "part.png"].map(|name| image::open(folder.path(name)).unwrap().into_rgb8());
    assert_eq!(part.dimensions(), (29, 11));
    assert!(part.enumerate_pixels().all(|(x, y, pixel)| pixel == whole.get_pixel(11 + x, 7 + y)));
    // The whole image is also a valid part, and a missing part is reported.
    folder.run("merge whole.exr part1.exr -o made.exr").succeeds();
    assert!(folder.read("made.exr") == folder.read("whole.exr"));
    folder
        .run("merge part0.exr part1.exr part3.exr -o made.exr")
        .fails(1, &["made.exr: the parts leave a gap at column 13, row 9: render it with --crop 13,9,27x8"]);
    assert!(folder.read("made.exr") == folder.read("whole.exr"));
}

#[test]
fn parts_of_other_pictures_are_refused() {
    let folder = Folder::with(BALL);
    folder.run("render scene.toml -o left.exr --crop 0,0,9x12").succeeds();
    folder.write("whole.exr", "an old whole");
    for (more, text) in [
        (
            "--size 16x13",
            "right.exr: this is a part of an image of 16x13 pixels, but left.exr is a part of an image of 16x12",
        ),
        ("--layers depth", "right.exr: its layers differ from those of left.exr"),
        ("--set rays.method=rk4", "right.exr: its `method` is `rk4, scaled_step"),
        (
            "--set sky.color=[1,0,0]",
            "right.exr: its `sky.color` is `[1, 0, 0]`, but that of left.exr is `[0.2, 0.3, 0.4]`",
        ),
        ("--set camera.fov=31", "right.exr: its `camera.fov` is `31`, but that of left.exr is nothing"),
        ("--samples 2", "right.exr: its `samples` is `2`, but that of left.exr is `1`"),
        ("--precision f64", "right.exr: its `rays` is `{ method = "),
        ("--set output.exposure=1", "right.exr: its `shown` is `exposure 1 tonemap none bits 8`"),
        ("--crop 10,0,6x12", "whole.exr: the parts leave a gap at column 9, row 0: render it with --crop 9,0,1x12"),
    ] {
        let crop = if more.starts_with("--crop") { "" } else { "--crop 8,0,8x12" };
        folder.run(&format!("render scene.toml -o right.exr {crop} {more}")).succeeds();
        folder.run("merge left.exr right.exr -o whole.exr").fails(1, &[text]);
    }
    folder.run("merge left.exr nothing.exr -o whole.exr").fails(1, &["nothing.exr: cannot read the file"]);
    folder.run("merge left.exr scene.toml -o whole.exr").fails(1, &["scene.toml: this is not a complete EXR"]);
    folder.run("merge left.exr -o whole.jpg").fails(1, &["whole.jpg: the name must end in .png"]);
    assert_eq!(folder.text("whole.exr"), "an old whole");
}

#[test]
fn parts_and_budgets_that_cannot_be_are_refused() {
    let folder = Folder::with(BALL);
    for (arguments, code, text) in [
        ("--crop 0,0,17x12", 1, "the window 0,0,17x12 is not inside the image of 16x12 pixels"),
        ("--crop 4294967295,0,2x2", 1, "is not inside the image"),
        ("--crop 0,0", 2, "such as 0,540,1920x270, found `0,0`"),
        ("--crop -1,0,2x2", 2, "expected a window as LEFT,TOP,WIDTHxHEIGHT"),
        ("--crop 1,1,0x2", 2, "found `1,1,0x2`"),
        ("--memory 1KiB", 1, "1024 bytes of device memory are too few: this scene needs at least "),
        ("--memory much", 2, "expected an amount of memory such as 512MiB"),
        ("--memory 99999999999GiB", 2, "expected an amount of memory"),
    ] {
        let ran = folder.run(&format!("render scene.toml -o a.png {arguments}"));
        assert_eq!(ran.code, Some(code), "{}", ran.err);
        ran.says(&[text]);
    }
    assert_eq!(folder.names(), ["scene.toml"]);
}

/// Equal parts of an image and of a video, rendered separately in any order and number of jobs, give the result of a single render.
#[test]
fn equal_parts_make_the_whole_to_the_byte() {
    let folder = Folder::with(BALL);
    let scene = format!("{HOLE} --set rays.method=auto --set camera.fov=20");
    folder.run(&format!("render scene.toml -o whole.exr -o whole.png {scene}")).succeeds();
    for part in 1..=5 {
        let ran = folder.run(&format!("render scene.toml -o made.png -o made.exr --part {part}/5 {scene}")).succeeds();
        ran.says(&["reproduce with: bentray render scene.toml"]);
    }
    let names: Vec<String> = (1..=5).map(|part| format!("made.part-{part}-of-5.exr")).collect();
    let parts = names.join(" ");
    folder.run(&format!("merge {parts} -o made.exr -o made.png")).succeeds();
    assert!(folder.read("made.exr") == folder.read("whole.exr") && folder.read("made.png") == folder.read("whole.png"));
    // Bands are of equal work, not of equal height: paths near the black hole take more steps.
    let far = "--set law.kind=schwarzschild --set law.mass=0.1 --set rays.method=dormand-prince --set rays.tolerance=1e-6 \
               --set objects.0.center=[0,0,-9] --set objects.0.radius=0.1 --size 40x60";
    let work = |part: u32| {
        folder.run(&format!("render scene.toml -o cut.exr --part {part}/3 {far}")).succeeds();
        let (settings, band) = picture(&folder.path(&format!("cut.part-{part}-of-3.exr"))).unwrap();
        let Some(Plane::Id(steps)) = band.layer(Layer::Steps) else { panic!("no steps") };
        (settings.window.size[1], steps.iter().map(|steps| f64::from(steps + 8)).sum::<f64>())
    };
    let [(outer, first), (inner, middle), _] = [1, 2, 3].map(work);
    assert!(inner < outer && (first / middle - 1.0).abs() < 0.2, "{outer} {first} {inner} {middle}");
    // A finished part is rendered again only if it belongs to something else.
    let again = |more: &str| folder.run(&format!("render scene.toml -o made.exr --part 2/5 {scene} {more}")).succeeds();
    assert!(!again("").err.contains(" rays, "));
    again("--set sky.color=[1,1,1]").says(&["made.part-2-of-5.exr is rendered again: its `sky.color` is", " rays, "]);
    for (arguments, text) in [
        ("--part 1/31", "--part: there are more parts than the 30 rows of each image"),
        ("--part auto", "--part auto requires one of the variables SLURM_ARRAY_TASK_ID (Slurm)"),
    ] {
        folder.run(&format!("render scene.toml -o a.exr {scene} {arguments}")).fails(1, &[text]);
    }
    folder.run("render scene.toml -o a.exr --part 1/3 --crop 0,0,2x2").fails(2, &["cannot be used with"]);
    let mut command = folder.command(&format!("render scene.toml -o queue.exr --part auto {scene}"));
    let queue = [("ID", "3"), ("MIN", "1"), ("MAX", "5")];
    command.envs(queue.map(|(name, value)| (format!("SLURM_ARRAY_TASK_{name}"), value)));
    assert!(command.output().unwrap().status.success());
    assert!(folder.read("queue.part-3-of-5.exr") == folder.read("made.part-3-of-5.exr"));
}
