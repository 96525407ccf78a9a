//! Tests videos: their frames equal the still images in every format, and an interrupted video continues.

use std::fs::File;
use std::io::BufReader;
use std::process::Command;

use image::codecs::gif::GifDecoder;
use image::codecs::png::PngDecoder;
use image::{AnimationDecoder, Frame, RgbaImage};

use super::{BALL, Folder};

const FILM: &str = "[animation]\nframes = 5\nrate = 30\n[[animation.tracks]]\nkey = \"sky.color\"\n\
    values = [[0, 0, 0], [1, 1, 1]]\n";

fn film() -> Folder {
    Folder::with(&format!("{BALL}{FILM}"))
}

fn still(folder: &Folder, name: &str) -> RgbaImage {
    image::open(folder.path(name)).unwrap().into_rgba8()
}

fn difference(a: &RgbaImage, b: &RgbaImage) -> f64 {
    assert_eq!(a.dimensions(), b.dimensions());
    let sum: f64 = a.iter().zip(b.iter()).map(|(a, b)| f64::from(a.abs_diff(*b))).sum();
    sum / a.len() as f64
}

#[test]
fn films_without_ffmpeg_hold_the_frames() {
    let folder = film();
    let ran = folder.run("render scene.toml -o film.png -o film.gif --frames all").succeeds();
    ran.says(&["film.png: 5 frames, 30 per second", "film.gif: 5 frames, 30 per second"]);
    assert_eq!(folder.names(), ["film.gif", "film.png", "scene.toml"]);
    let open = |name: &str| BufReader::new(File::open(folder.path(name)).unwrap());
    let frames = PngDecoder::new(open("film.png")).unwrap().apng().unwrap().into_frames();
    let apng: Vec<Frame> = frames.collect_frames().unwrap();
    let gif: Vec<Frame> = GifDecoder::new(open("film.gif")).unwrap().into_frames().collect_frames().unwrap();
    assert_eq!((apng.len(), gif.len()), (5, 5));
    folder.run("render scene.toml -o {frame}.png -o again.gif --frames all").succeeds();
    for k in 0..5 {
        let still = still(&folder, &format!("{k}.png"));
        assert_eq!(apng[k].buffer(), &still, "{k}");
        assert!(difference(gif[k].buffer(), &still) < 2.0, "{k}");
    }
    // Hundredths of a second: 3, 4, 3 and so on.
    let shown: u32 = gif.iter().map(|frame| frame.delay().numer_denom_ms().0).sum();
    assert_eq!(shown, 170);
    // The video is identical if frames are requested as well, and if a separate command makes it.
    folder.run("video 0.png 1.png 2.png 3.png 4.png -o more.gif --rate 30").succeeds();
    assert!(folder.read("film.gif") == folder.read("again.gif") && folder.read("film.gif") == folder.read("more.gif"));
}

#[test]
fn a_film_that_was_stopped_goes_on() {
    let folder = film();
    folder.run("render scene.toml -o whole.png --frames all").succeeds();
    folder.run("render scene.toml -o film.frames/{frame:5}.png --frames 0").fails(1, &["film.frames does not exist"]);
    std::fs::create_dir(folder.path("film.frames")).unwrap();
    folder.run("render scene.toml -o film.frames/{frame:5}.png --frames 0..2").succeeds();
    let ran = folder.run("render scene.toml -o film.png --frames all").succeeds();
    let rendered: Vec<&str> = ran.err.lines().filter(|line| line.starts_with("frame ")).collect();
    assert_eq!(rendered.len(), 2, "{rendered:?}");
    assert!(folder.read("film.png") == folder.read("whole.png"));
    assert_eq!(folder.names(), ["film.png", "scene.toml", "whole.png"]);
    // The video is also identical if it is rendered in parts.
    for part in 1..=3 {
        folder.run(&format!("render scene.toml -o film.png --frames all --part {part}/3")).succeeds();
    }
    folder.write("film.png", "");
    folder.run("farm finish scene.toml -o film.png --frames all --parts 3").succeeds();
    assert!(folder.read("film.png") == folder.read("whole.png"));
}

#[test]
fn videos_are_refused_without_ffmpeg() {
    let folder = film();
    let mut without = folder.command("render scene.toml -o film.mp4 --frames all");
    let said = without.env("PATH", "").output().unwrap();
    let said = String::from_utf8(said.stderr).unwrap();
    assert!(said.contains("film.mp4: .mp4 and .webm require ffmpeg, which is not in the PATH; install it"), "{said}");
    assert_eq!(folder.names(), ["scene.toml"]);
}

#[test]
#[ignore = "needs ffmpeg"]
fn videos_hold_the_frames_with_ffmpeg() {
    let folder = film();
    for name in ["film.mp4", "film.webm"] {
        // Odd sides are also allowed.
        folder.run(&format!("render scene.toml -o {name} -o {{frame}}.png --frames all --size 131x83")).succeeds();
        let before = folder.read(name);
        let mut decoder = Command::new("ffmpeg");
        decoder.args(["-loglevel", "error", "-i", name, "-vf", "scale=in_color_matrix=bt709", "seen_%d.png"]);
        assert!(decoder.current_dir(folder.path(".")).status().unwrap().success());
        for k in 0..5 {
            let seen = image::open(folder.path(&format!("seen_{}.png", k + 1))).unwrap().crop_imm(0, 0, 131, 83);
            let off = difference(&seen.into_rgba8(), &still(&folder, &format!("{k}.png")));
            assert!(off < 4.0, "{name} {k}: {off}");
        }
        folder.run(&format!("render scene.toml -o {name} -o {{frame}}.png --frames all --size 131x83")).succeeds();
        assert!(folder.read(name) == before);
    }
}

#[test]
fn what_is_no_film_is_refused() {
    let folder = film();
    folder.run("render scene.toml -o a.png").succeeds();
    folder.run("render scene.toml -o b.png --size 8x8").succeeds();
    for (arguments, code, text) in [
        (
            "video a.png b.png -o c.gif",
            1,
            "b.png: cannot be a frame of a video: it has 8x8 pixels, but a.png has 16x12",
        ),
        ("video a.png scene.toml -o c.gif", 1, "scene.toml: cannot be a frame of a video"),
        ("video a.png none.png -o c.gif", 1, "none.png: cannot be a frame of a video"),
        ("video a.png -o a.png", 1, "a.png is one of the frames and would be overwritten"),
        ("video a.png -o c.avi", 1, "c.avi: the name of a video must end in .mp4, .webm, .gif, .png or .apng"),
        ("video a.png -o c.gif --rate 0", 2, "expected a number of frames per second from 0.1 to 1000, found `0`"),
        ("render scene.toml -o c.exr --frames all", 1, "c.exr: --frames writes one file per frame"),
        ("render scene.toml -o c.gif", 1, "c.gif: a video consists of frames; add --frames all"),
        ("render scene.toml -o c.gif --frames all --set animation.rate=0", 1, "frames per second, from 0.1 to 1000"),
    ] {
        let ran = folder.run(arguments);
        assert_eq!(ran.code, Some(code), "{arguments}: {}", ran.err);
        ran.says(&[text]);
        assert_eq!(folder.names(), ["a.png", "b.png", "scene.toml"], "{arguments}");
    }
}

/// An error in a later frame is reported with its number before the first frame is rendered.
#[test]
fn frames_are_looked_at_before_any_is_rendered() {
    let fall = "[animation]\nframes = 12\n[[animation.tracks]]\nkey = \"camera.fov\"\n\
                values = [40, 370]\n";
    let folder = Folder::with(&format!("{BALL}{fall}"));
    folder.run("render scene.toml -o a_{frame}.png --frames all").fails(1, &["frame 5: scene.toml:", "found 190"]);
    let checked = folder.run("check scene.toml --json");
    assert!(checked.code == Some(1) && checked.out.contains("\"line\":20"), "{}", checked.out);
    assert_eq!(folder.names(), ["scene.toml"]);
}

/// The command that reproduces a video does not name its deleted frames.
#[test]
fn a_film_is_repeated_without_its_frames() {
    let folder = Folder::with(&format!("{BALL}{FILM}[law]\nkind = \"schwarzschild\"\n"));
    let ran = folder.run("render scene.toml -o film.gif --frames 0..1").succeeds();
    ran.says(&["reproduce with: bentray render scene.toml -o film.gif --frames 0..1\n"]);
}

#[test]
fn what_no_film_can_be_is_refused_before_its_frames() {
    let folder = film();
    let ran = folder.run("render scene.toml -o film.gif --frames all --size 65536x1");
    ran.fails(1, &["film.gif", "a side of 65536 pixels exceeds the limit of 65535 for .gif"]);
    folder.run("render scene.toml -o film.mp4").fails(1, &["film.mp4: a video consists of frames; add --frames all"]);
    assert_eq!(folder.names(), ["scene.toml"]);
}
