//! `--crop`, `--memory` and `assemble`: a picture in parts is the picture.

use super::{BALL, Folder};

const HOLE: &str = "--set law.kind=schwarzschild --set rays.method=rk4 --set law.mass=0.2 \
                    --set objects.0.center=[1.5,0,0] --set camera.stereo={separation=0.1} --size 40x30 --samples 3";

/// Parts of odd sizes that overlap, each under another schedule and in tiles of another size, make the file that one render
/// writes: every layer, to the byte.
#[test]
fn parts_by_any_schedule_make_the_whole_to_the_byte() {
    let folder = Folder::with(BALL);
    let parts = [
        ("0,0,13x17", "--schedule paper"),
        ("13,0,27x9", "--schedule segment --memory 560000"),
        ("11,7,29x11", "--segments-per-pass 3 --no-masks --memory 210000"),
        ("0,17,40x13", "--memory 48KiB"),
    ];
    folder.run(&format!("render scene.toml -o whole.exr -o whole.png {HOLE}")).succeeds();
    for (i, (crop, more)) in parts.iter().enumerate() {
        folder.run(&format!("render scene.toml -o part{i}.exr --crop {crop} {more} {HOLE}")).succeeds();
    }
    folder.run("assemble part2.exr part0.exr part3.exr part1.exr -o made.exr").succeeds();
    assert!(folder.read("made.exr") == folder.read("whole.exr"));
    // A PNG is what is seen through the window.
    folder.run(&format!("render scene.toml -o part.png --crop 11,7,29x11 {HOLE}")).succeeds();
    let [whole, part] = ["whole.png", "part.png"].map(|name| image::open(folder.path(name)).unwrap().into_rgb8());
    assert_eq!(part.dimensions(), (29, 11));
    assert!(part.enumerate_pixels().all(|(x, y, pixel)| pixel == whole.get_pixel(11 + x, 7 + y)));
    // The whole is a part of itself, and what is missing is named.
    folder.run("assemble whole.exr part1.exr -o made.exr").succeeds();
    assert!(folder.read("made.exr") == folder.read("whole.exr"));
    folder
        .run("assemble part0.exr part1.exr part3.exr -o made.exr")
        .fails(1, &["made.exr: the parts leave a gap at column 13, row 9: render it with --crop 13,9,27x8"]);
    assert!(folder.read("made.exr") == folder.read("whole.exr"));
}

#[test]
fn parts_of_other_pictures_are_refused() {
    let folder = Folder::with(BALL);
    folder.run("render scene.toml -o left.exr --crop 0,0,9x12").succeeds();
    folder.write("whole.exr", "an old whole");
    for (more, text) in [
        ("--size 16x13", "right.exr: this is a part of a picture of 16x13 pixels, and left.exr of one of 16x12"),
        ("--layers depth", "right.exr: it has other layers than left.exr"),
        ("--set rays.method=rk4", "right.exr: its `method` is `rk4, scaled_step"),
        (
            "--set sky.color=[1,0,0]",
            "right.exr: its `sky.color` is `[1, 0, 0]`, and that of left.exr `[0.2, 0.3, 0.4]`",
        ),
        ("--set camera.fov=31", "right.exr: its `camera.fov` is `31`, and that of left.exr nothing"),
        ("--samples 2", "right.exr: its `samples` is `2`, and that of left.exr `1`"),
        ("--precision f64", "right.exr: its `rays` is `{ method = "),
        ("--set output.exposure=1", "right.exr: its `shown` is `exposure 1 tonemap none bits 8`"),
        ("--crop 10,0,6x12", "whole.exr: the parts leave a gap at column 9, row 0: render it with --crop 9,0,1x12"),
    ] {
        let crop = if more.starts_with("--crop") { "" } else { "--crop 8,0,8x12" };
        folder.run(&format!("render scene.toml -o right.exr {crop} {more}")).succeeds();
        folder.run("assemble left.exr right.exr -o whole.exr").fails(1, &[text]);
    }
    folder.run("assemble left.exr nothing.exr -o whole.exr").fails(1, &["nothing.exr: cannot read the file"]);
    folder.run("assemble left.exr scene.toml -o whole.exr").fails(1, &["scene.toml: this is not a whole EXR"]);
    folder.run("assemble left.exr -o whole.png").fails(1, &["whole.png: a whole is an EXR"]);
    assert_eq!(folder.text("whole.exr"), "an old whole");
}

#[test]
fn parts_and_budgets_that_cannot_be_are_refused() {
    let folder = Folder::with(BALL);
    for (arguments, code, text) in [
        ("--crop 0,0,17x12", 1, "0,0,17x12 is not inside the picture of 16 by 12 pixels"),
        ("--crop 4294967295,0,2x2", 1, "is not inside the picture"),
        ("--crop 0,0", 2, "`0,0` is not a part such as 0,540,1920x270"),
        ("--crop -1,0,2x2", 2, "`-1,0,2x2` is not a part"),
        ("--crop 1,1,0x2", 2, "`1,1,0x2` is not a part"),
        ("--memory 1KiB", 1, "1024 bytes of device memory are too few: this scene needs at least "),
        ("--memory much", 2, "`much` is not an amount of memory such as 512MiB"),
        ("--memory 99999999999GiB", 2, "is not an amount of memory"),
    ] {
        let ran = folder.run(&format!("render scene.toml -o a.png {arguments}"));
        assert_eq!(ran.code, Some(code), "{}", ran.err);
        ran.says(&[text]);
    }
    assert_eq!(folder.names(), ["scene.toml"]);
}
