//! Tests standard input and output instead of files, readers that stop early, and the text on standard error.

use std::io::{BufRead, BufReader, Read, Write};
use std::process::Stdio;

use super::{BALL, Folder, Ran};

/// Runs the program with this text as its standard input.
fn fed(folder: &Folder, arguments: &str, input: &str) -> Ran {
    let mut command = folder.command(arguments);
    let mut child = command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    // A program that reads no input may have ended already.
    let _ = child.stdin.take().unwrap().write_all(input.as_bytes());
    let output = child.wait_with_output().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    Ran { code: output.status.code(), out: text(output.stdout), err: text(output.stderr) }
}

#[test]
fn a_scene_from_standard_input_is_that_of_a_file() {
    let scene = BALL.replace("color = [0.2, 0.3, 0.4]", "image = \"sky.png\"");
    let folder = Folder::with(&scene);
    image::RgbImage::from_fn(4, 2, |x, y| image::Rgb([60 * x as u8, 200 * y as u8, 9]))
        .save(folder.path("sky.png"))
        .unwrap();
    folder.run("render scene.toml -o a.png").succeeds();
    fed(&folder, "render - -o b.png", &scene).succeeds().says(&["reproduce with: bentray render - -o b.png"]);
    assert!(folder.read("a.png") == folder.read("b.png"));
    let found = fed(&folder, "check -", &scene).succeeds();
    assert_eq!(found.out.replace("-: ", "scene.toml: "), folder.run("check scene.toml").succeeds().out);
    let wrong = fed(&folder, "check -", &scene.replace("radius = 10", "radius = -1"));
    assert_eq!(wrong.code, Some(1));
    wrong.says(&["standard input:7:30: "]);
    fed(&folder, "render - -o sky.png", &scene).fails(1, &["sky.png is a file that the scene reads"]);
    // A table may also come from standard input, but not both.
    let rays = "x,y,z,vx,vy,vz\n0,0,5,0,0,-1\n";
    folder.write("rays.csv", rays);
    let traced = folder.run("trace scene.toml --rays rays.csv -o -").succeeds().out;
    assert_eq!(fed(&folder, "trace - --rays rays.csv -o -", &scene).succeeds().out, traced);
    assert_eq!(fed(&folder, "trace scene.toml --rays - -o -", rays).succeeds().out, traced);
    fed(&folder, "trace scene.toml --rays - -o -", "x,y\n").fails(1, &["standard input: line 1: "]);
    fed(&folder, "trace - --rays - -o -", &scene)
        .fails(1, &["standard input cannot be both the scene file and the file"]);
}

#[test]
fn a_new_scene_goes_to_standard_output() {
    let folder = Folder::new();
    let new = folder.run("new -").succeeds();
    assert_eq!(new.err, "");
    fed(&folder, "check -", &new.out).succeeds();
    assert!(folder.names().is_empty(), "{:?}", folder.names());
}

#[test]
fn files_that_need_a_name_are_no_stream() {
    let folder = Folder::with(BALL);
    for arguments in [
        "render scene.toml -o -",
        "render scene.toml -o a.png --preview -",
        "render scene.toml -o a.png --continue -",
        "render scene.toml -o a.png --method-from -",
        "trace scene.toml --pixel 0,0 --plot -",
        "merge - -o a.exr",
        "merge a.exr -o -",
        "video - -o a.gif",
        "video a.png -o -",
        "formula snell -o -",
        "import - -o scene.toml",
        "compare scene.toml -o -",
        "farm slurm scene.toml -o a.png --parts 2 --folder -",
    ] {
        folder.run(arguments).fails(2, &["standard input and output are not supported here: name a file"]);
    }
    folder.run("farm slurm - -o a.png --parts 2").fails(1, &["-: standard input and output are not supported here"]);
    assert_eq!(folder.names(), ["scene.toml"]);
    // A file may have this name.
    folder.run("new ./-").succeeds();
    assert_eq!(folder.names(), ["-", "scene.toml"]);
}

#[test]
fn a_reader_that_has_had_enough_is_no_error() {
    let folder = Folder::with(BALL);
    let many = ["trace", "scene.toml", "--bundle", "from=[-5,0,9] toward=[0,0,0] width=2 count=20000"];
    let rest = ["-o", "-", "--plot", "a.svg"];
    let cases: [(&str, &[&str]); 3] =
        [("trace", &[&many[1..], &rest].concat()), ("check", &["--reference"]), ("help", &["scenes"])];
    for (name, arguments) in cases {
        let mut command = folder.command(name);
        let mut child = command.args(arguments).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        let mut line = String::new();
        BufReader::with_capacity(16, child.stdout.take().unwrap()).read_line(&mut line).unwrap();
        let mut err = String::new();
        child.stderr.take().unwrap().read_to_string(&mut err).unwrap();
        assert_eq!(child.wait().unwrap().code(), Some(0), "{name}: {err}");
        assert!(!err.contains("error"), "{name}: {err}");
    }
    // The other requested files are written.
    assert_eq!(folder.names(), ["a.svg", "scene.toml"]);
}

/// Without a desktop Mesa's device selection layer reports a separate error.
#[cfg(target_os = "linux")]
#[test]
fn no_display_is_no_error() {
    let folder = Folder::with(BALL);
    for arguments in ["devices", "render scene.toml -o a.png"] {
        let mut command = folder.command(arguments);
        for name in ["NODEVICE_SELECT", "XDG_RUNTIME_DIR", "WAYLAND_DISPLAY"] {
            command.env_remove(name);
        }
        let output = command.output().unwrap();
        let err = String::from_utf8(output.stderr).unwrap();
        assert!(output.status.success() && !err.contains("error"), "{err}");
        assert_eq!(err.contains("device: "), arguments != "devices", "{err}");
    }
}

/// A link stays, and its target is written, whether it existed or not.
#[cfg(unix)]
#[test]
fn links_are_followed_to_where_no_file_is_yet() {
    use std::os::unix::fs::symlink;
    let folder = Folder::with(BALL);
    std::fs::create_dir(folder.path("real")).unwrap();
    symlink("real/a.png", folder.path("a.png")).unwrap();
    symlink("../a.png", folder.path("real/b.png")).unwrap();
    for name in ["a.png", "real/b.png"] {
        for _ in 0..2 {
            folder.run(&format!("render scene.toml -o {name} --size 8x8")).succeeds();
            assert!(folder.path(name).is_symlink(), "{name}");
            assert!(!folder.path("real/a.png").is_symlink() && folder.read("real/a.png").starts_with(b"\x89PNG"));
        }
        std::fs::remove_file(folder.path("real/a.png")).unwrap();
    }
    folder
        .run("render scene.toml -o a.png -o real/b.png")
        .fails(1, &["real/b.png is used for two outputs (also as a.png)"]);
    symlink("none/c.png", folder.path("c.png")).unwrap();
    folder.run("render scene.toml -o c.png").fails(1, &["c.png: the folder none does not exist"]);
    symlink("d.png", folder.path("d.png")).unwrap();
    folder.run("render scene.toml -o d.png").fails(1, &["d.png: this is a symbolic link to itself"]);
}
