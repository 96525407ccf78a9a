//! Tests `--frames`: each frame equals the still image of its values, and all frames use the program compiled for the first.

use super::{BALL, Folder};

const FILM: &str = r#"
[law]
kind = "schwarzschild"
mass = 0.2
[animation]
frames = 5
[[animation.tracks]]
key = "camera.position"
values = [[0, 0, 5], [0.7, 0.3, 4.1]]
[[animation.tracks]]
key = "law.mass"
values = [0.1, 0.3, 0.2]
keyframes = [1, 3, 4]
[[animation.tracks]]
key = "objects.0.center"
values = [[1.5, 0, 0], [1.9, 0.1, -0.3]]
keyframes = [0, 2]
[[animation.tracks]]
key = "materials.red.color"
values = [[1, 0, 0], [0.5, 0.4, 0.3]]
"#;

fn film() -> Folder {
    Folder::with(&format!("{}{FILM}", BALL.replace("[rays]", "[rays]\nmethod = \"rk4\"")))
}

/// Returns `(1 − t)a + tb` as the program reads it.
fn between<const N: usize>(t: f64, a: [f64; N], b: [f64; N]) -> String {
    let mixed: Vec<String> = (0..N).map(|i| ((1.0 - t) * a[i] + t * b[i]).to_string()).collect();
    format!("[{}]", mixed.join(","))
}

#[test]
fn frames_are_the_stills_of_their_values_to_the_byte() {
    let folder = film();
    let ran = folder.run("render scene.toml -o film_{frame:3}.exr -o {frame}.png --frames all").succeeds();
    for k in 0..5 {
        ran.err.lines().find(|line| line.starts_with(&format!("frame {k}: ready after "))).expect("one line per frame");
        let t = f64::from(k);
        let mass = [0.1, 0.1, (0.5 * 0.1) + (0.5 * 0.3), 0.3, 0.2][k as usize];
        let (place, color) = (
            between((0.5 * t).min(1.0), [1.5, 0.0, 0.0], [1.9, 0.1, -0.3]),
            between(t / 4.0, [1.0, 0.0, 0.0], [0.5, 0.4, 0.3]),
        );
        let camera = between(t / 4.0, [0.0, 0.0, 5.0], [0.7, 0.3, 4.1]);
        folder
            .run(&format!(
                "render scene.toml -o still.exr -o still.png --set camera.position={camera} --set law.mass={mass} \
                 --set objects.0.center={place} --set materials.red.color={color}"
            ))
            .succeeds();
        assert!(folder.read("still.exr") == folder.read(&format!("film_{k:03}.exr")), "frame {k}");
        assert!(folder.read("still.png") == folder.read(&format!("{k}.png")), "frame {k}");
    }
    // A range of the video's frames, and a part of a frame.
    let one = folder.read("film_003.exr");
    folder.run("render scene.toml -o film_{frame:3}.exr --frames 3..4").succeeds();
    assert!(folder.read("film_003.exr") == one);
    folder.run("render scene.toml -o top_{frame}.exr --frames 3 --crop 0,0,16x5").succeeds();
    folder.run("render scene.toml -o rest_{frame}.exr --frames 3 --crop 0,5,16x7").succeeds();
    folder.run("merge top_3.exr rest_3.exr -o whole.exr").succeeds();
    assert!(folder.read("whole.exr") == one);
}

/// A video continues after an interruption: frames with identical settings stay, and all others are rendered.
#[test]
fn finished_frames_are_known_by_what_made_them() {
    let folder = film();
    let film = |more: &str| {
        let ran =
            folder.run(&format!("render scene.toml -o {{frame}}.exr -o {{frame}}.png --frames {more}")).succeeds();
        let rendered = ran.err.lines().filter_map(|line| line.strip_prefix("frame ")?.split_once(": ready after "));
        (rendered.map(|(frame, _)| frame.to_owned()).collect::<Vec<_>>(), ran)
    };
    assert_eq!(film("0..2").0, ["0", "1", "2"]);
    let first = folder.read("0.exr");
    std::fs::remove_file(folder.path("1.png")).unwrap();
    let (rendered, ran) = film("all");
    assert_eq!(rendered, ["1", "3", "4"]);
    ran.says(&["2 of 5 existed already, rendered with the same settings"]);
    assert!(film("all").0.is_empty() && folder.read("0.exr") == first);
    // Changes of the scene, method, number of samples, appearance or window.
    for (change, why) in [
        ("--set sky.color=[0,0,1]", "0.exr is rendered again: its `sky.color` is `[0.2, 0.3, 0.4]`, not `[0, 0, 1]`"),
        ("--set rays.method=euler", "0.exr is rendered again: its `method` is `"),
        ("--samples 4", "0.exr is rendered again: its `samples` is `1`, not `4`"),
        ("--set output.bit_depth=16", "0.exr is rendered again: its `shown` is `"),
        ("--crop 0,0,4x4", "0.exr is rendered again: its `part` is `0,0,16x12 of 16x12`, not `0,0,4x4 of 16x12`"),
        ("--layers depth", "0.exr is rendered again: its `layers` is `depth,segments,position,"),
    ] {
        let (rendered, ran) = film(&format!("0 {change}"));
        assert_eq!(rendered, ["0"]);
        ran.says(&[why]);
        film("0");
        assert!(folder.read("0.exr") == first);
    }
    folder.write("0.png", "no picture");
    film("0").1.says(&["0.png is rendered again: it is not an image from this version of bentray"]);
}

/// Frames that were finished before an invalid frame stay, and the message names the responsible key.
#[test]
fn a_frame_of_another_program_names_the_key_before_any_is_rendered() {
    let folder = film();
    // A stretched sphere is an ellipsoid.
    let stretched =
        "[[animation.tracks]]\nkey = \"objects.0.scale\"\nvalues = [[1, 1, 1], [1, 2, 1]]\nkeyframes = [1, 2]\n";
    folder.write("scene.toml", folder.text("scene.toml") + stretched);
    let message = "frame 2 requires a different shader program than frame 0 because of `objects.0.scale`: ";
    let ran = folder.run("render scene.toml -o {frame}.png --frames all");
    assert_eq!(ran.code, Some(1));
    ran.says(&[message]);
    assert_eq!(folder.names(), ["scene.toml"]);
    let checked = folder.run("check scene.toml");
    assert_eq!(checked.code, Some(1));
    checked.says(&[message]);
    folder.run("render scene.toml -o {frame}.png --frames 2..4").succeeds();
    assert_eq!(folder.names(), ["2.png", "3.png", "4.png", "scene.toml"]);
}

#[test]
fn frames_that_cannot_be_are_refused() {
    let folder = film();
    for (arguments, code, text) in [
        (
            "-o a.exr --frames 0..4",
            1,
            "a.exr: --frames writes one file per frame, so the name needs {frame} or {frame:4}",
        ),
        (
            "-o {frame}.png",
            1,
            "{frame}.png: a placeholder for the frame number ({frame}, #### or %04d) requires --frames",
        ),
        (
            "-o {frame:x}.png --frames 1",
            1,
            "{frame:x}.png: `{frame:x}` is not a valid placeholder: use {frame} or {frame:4}",
        ),
        ("-o a_{n}.png --frames 1", 1, "a_{n}.png: `{n}` is not a valid placeholder: use {frame} or {frame:4}"),
        ("-o {frame}.png --frames 3..5", 1, "--frames: there is no frame 5; the frames of the scene are 0..4"),
        ("-o {frame}.png --frames 3..2", 2, "the range `3..2` is descending; use 2..3"),
        ("-o {frame}.png --frames 1 --verify 9", 2, "'--verify <N>'"),
        ("-o {frame}.png --frames 1 --set law.mass=1", 1, "--set law.mass=1:1:10: `law.mass` is animated"),
        ("-o {frame}.png --frames 4 --set animation.tracks.1.values=[1,2,-3]", 1, "expected a mass above 0, found -3"),
    ] {
        let ran = folder.run(&format!("render scene.toml {arguments}"));
        assert_eq!(ran.code, Some(code), "{}", ran.err);
        ran.says(&[text]);
    }
    assert_eq!(folder.names(), ["scene.toml"]);
    let still = Folder::with(BALL);
    still
        .run("render scene.toml -o {frame}.png --frames all")
        .fails(1, &["--frames requires a scene with [animation]"]);
}

/// Frames of a list equal the video's, are divided among parts, and are rendered once; every placeholder receives the number.
#[test]
fn lists_of_frames_are_rendered_whole_in_parts_and_as_a_film() {
    let folder = Folder::with(&format!(
        "{BALL}[animation]\nframes = 9\n[[animation.tracks]]\nkey = \"sky.color\"\nvalues = [[0, 0, 0], [1, 1, 1]]\n"
    ));
    folder
        .run("render scene.toml -o {frame}/a_##.png --frames 1")
        .fails(1, &["1/a_01.png: the folder 1 does not exist"]);
    folder.run("render scene.toml -o x{frame}_{frame:2}.png --frames 8,1-5:2").succeeds();
    let names = ["scene.toml", "x1_01.png", "x3_03.png", "x5_05.png", "x8_08.png"];
    assert_eq!(folder.names(), names);
    let film = "render scene.toml -o x{frame}_{frame:2}.png -o film.gif --frames 1,3,5,8";
    folder.run(film).succeeds().says(&["4 of 4 existed already", "film.gif: 4 frames, 24 per second"]);
    // The jobs of an array with a step render all frames among them.
    for id in [0, 2, 4] {
        let mut command = folder.command("render scene.toml -o a_%03d.png --frames 8,1-5:2 --part auto");
        let array = [("ID", id), ("MIN", 0), ("MAX", 4), ("COUNT", 3), ("STEP", 2)];
        command.envs(array.map(|(name, value)| (format!("SLURM_ARRAY_TASK_{name}"), value.to_string())));
        assert!(command.output().unwrap().status.success(), "job {id}");
    }
    for frame in [1, 3, 5, 8] {
        assert!(
            folder.read(&format!("a_{frame:03}.png")) == folder.read(&format!("x{frame}_{frame:02}.png")),
            "{frame}"
        );
    }
}
