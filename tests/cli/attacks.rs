//! Small files that demand much, and scenes with hidden errors: each is rejected, limited or reported.

use std::fmt::Write;
use std::time::{Duration, Instant};

use exr::prelude::read_first_rgba_layer_from_file;

use super::{BALL, Folder, Ran};

/// Longer than any of them may take on a busy machine, and shorter than they took before.
const LONG: Duration = Duration::from_secs(40);

#[track_caller]
fn soon(run: impl FnOnce() -> Ran) -> Ran {
    let begun = Instant::now();
    let ran = run();
    assert!(begun.elapsed() < LONG, "{:?}", begun.elapsed());
    ran
}

/// Returns the header of a PNG of this size with the correct checksum, and nothing else.
fn forged(width: u32, height: u32) -> Vec<u8> {
    let mut chunk = b"IHDR".to_vec();
    chunk.extend(width.to_be_bytes());
    chunk.extend(height.to_be_bytes());
    chunk.extend([8, 2, 0, 0, 0]);
    let crc = chunk.iter().fold(u32::MAX, |crc, byte| {
        (0..8).fold(crc ^ u32::from(*byte), |crc, _| (crc >> 1) ^ (0xedb8_8320 * (crc & 1)))
    });
    let mut bytes = b"\x89PNG\r\n\x1a\n\0\0\0\x0d".to_vec();
    bytes.extend(chunk);
    bytes.extend((!crc).to_be_bytes());
    bytes.extend(b"\0\0\0\0IDAT\x35\xaf\x06\x1e");
    bytes
}

#[test]
fn pictures_with_forged_sizes_are_refused_by_their_headers() {
    let folder = Folder::with(&BALL.replace("color = [0.2, 0.3, 0.4]", "image = \"sky.png\""));
    folder.write("sky.png", forged(40_000, 40_000));
    let check = || soon(|| folder.run("check scene.toml"));
    check().fails(1, &["the header declares 40000×40000 pixels, which do not fit into the 45 bytes of the file"]);
    let mut large = forged(40_000, 40_000);
    large.resize(1 << 20, 0);
    folder.write("sky.png", large);
    check().fails(
        1,
        &["the image has 40000×40000 = 1600000000 pixels, and at most 268435456 are supported: reduce its size"],
    );
    folder.write("sky.png", forged(0, 4));
    check().fails(1, &["cannot use the image `sky.png`"]);
}

#[test]
fn many_mistakes_are_counted_and_some_are_shown() {
    let mut scene = BALL.to_owned();
    for i in 0..30_000 {
        writeln!(scene, "[k{i}]").unwrap();
    }
    let folder = Folder::with(&scene);
    let ran = soon(|| folder.run("check scene.toml"));
    let ran = ran.fails(1, &["unknown key `k0`", "at least 1000 errors, of which 100 are shown"]);
    assert!(ran.err.len() < 100_000, "{}", ran.err.len());
    // Endless nesting is shown near the error.
    folder.write("scene.toml", format!("a = {}", "[".repeat(1_000_000)));
    let ran = soon(|| folder.run("check scene.toml"));
    assert!(ran.err.len() < 2000, "{}", ran.err.len());
    ran.fails(1, &["scene.toml:1:", "not valid TOML: "]);
    // A key that several kinds have is listed once.
    folder.write("scene.toml", "[camera]\nposition = [0, 0, 5]\nfow = 3\n[rays]\nbounding_sphere = { radius = 9 }\n");
    let ran = folder.run("check scene.toml").fails(1, &["unknown key `fow`"]);
    let keys = ran.err.split("valid keys: ").nth(1).unwrap().lines().next().unwrap();
    let all: Vec<&str> = keys.split(", ").collect();
    assert!(all.iter().enumerate().all(|(i, key)| !all[..i].contains(key)), "{keys}");
}

#[test]
fn long_films_are_checked_by_some_of_their_frames() {
    let track = "[animation]\nframes = 1000000\n[[animation.tracks]]\nkey = \"camera.fov\"\nvalues = [50, 60]\n";
    let folder = Folder::with(&(BALL.to_owned() + track));
    soon(|| folder.run("check scene.toml")).succeeds();
    // An error in the last track is found.
    let track = track.replace("60", "200");
    folder.write("scene.toml", BALL.to_owned() + &track);
    let ran = soon(|| folder.run("check scene.toml"))
        .says(&["scene.toml:20:11: expected an angle between 0 and 180 degrees"]);
    assert_eq!(ran.code, Some(1));
}

#[test]
fn spheres_in_one_place_are_sorted_at_once() {
    let mut scene = BALL.to_owned();
    for _ in 0..100_000 {
        scene += "[[objects]]\nshape = \"sphere\"\nmaterial = \"red\"\n";
    }
    let folder = Folder::with(&scene);
    soon(|| folder.run("check scene.toml")).succeeds();
    let ran = soon(|| folder.run("render scene.toml -o a.png --size 8x8"));
    ran.succeeds();
}

#[test]
fn bytes_that_are_no_text_are_named_with_their_line() {
    let folder = Folder::with(BALL);
    folder.write("rays.csv", b"x,y,z,vx,vy,vz\n0,0,5,0,0,-1\n0,\xff,5,0,0,-1\n");
    let ran = folder.run("trace scene.toml --rays rays.csv -o a.csv");
    ran.fails(1, &["rays.csv: line 3: this byte is not valid UTF-8; save the file as UTF-8"]);
}

/// Returns all numbers of an EXR's color, and whether a PNG is entirely black.
fn seen(folder: &Folder) -> (Vec<f32>, bool) {
    let image = read_first_rgba_layer_from_file(
        folder.path("a.exr"),
        |size, _| vec![[f32::NAN; 4]; size.area()],
        |pixels, at, (r, g, b, a): (f32, f32, f32, f32)| pixels[at.x() + 16 * at.y()] = [r, g, b, a],
    );
    let pixels = image.unwrap().layer_data.channel_data.pixels;
    let png = image::open(folder.path("a.png")).unwrap().to_rgb8();
    (pixels.concat(), png.pixels().all(|pixel| pixel.0 == [0; 3]))
}

#[test]
fn rays_from_the_middle_of_an_infinite_index_are_black() {
    let scene = "[image]\nsize = [16, 12]\n[camera]\nposition = [0, 0, 0]\nlook_at = [0, 0, -1]\n[rays]\n\
        bounding_sphere = { radius = 10 }\n[sky]\ncolor = [0.2, 0.3, 0.4]\n";
    let law = |index: &str| format!("{scene}[law]\nkind = \"medium\"\nindex = {index}\n");
    let ball = format!("{scene}[[objects]]\nshape = \"sphere\"\nradius = 2\ninterior = 1.5\n");
    for (scene, black) in [
        (law("{ kind = \"eaton\", radius = 2 }"), true),
        (law("{ kind = \"inverse-r\", k = 4 }"), true),
        (ball.replace("1.5", "{ kind = \"eaton\" }"), true),
        (ball, false),
    ] {
        let folder = Folder::with(&scene);
        folder.run("render scene.toml -o a.exr -o a.png").succeeds();
        let (numbers, is_black) = seen(&folder);
        assert!(numbers.iter().all(|value| value.is_finite()), "{scene}: {numbers:?}");
        assert_eq!(is_black, black, "{scene}");
    }
}

#[test]
fn nothing_is_said_of_no_rays() {
    let scene = "[image]\nsize = [16, 16]\n[camera]\nposition = [0, 0, 15]\n[law]\nkind = \"sources\"\n[[law.sources]]\n\
        position = [0, 0, 0]\nstrength = 20\n[rays]\nbounding_sphere = { radius = 50 }\n[sky]\ncolor = [0.1, 0.2, 0.3]\n";
    let folder = Folder::with(scene);
    // No ray of this scene can escape, whichever method follows it.
    for method in ["euler", "rk4", "dormand-prince"] {
        let ran = folder.run(&format!("render scene.toml -o a.exr --verify 20 --method {method}"));
        assert!(!ran.err.contains("within 0.0e0"), "{}", ran.err);
        assert!(!ran.out.contains("max 0.00e0"), "{}", ran.out);
    }
    let ran = folder.run("render scene.toml -o a.exr --strict --set rays.method=rk4 --set rays.control.step=1e-9 --set rays.max_segments=2");
    assert_eq!(ran.code, Some(1), "{}", ran.err);
}

/// The memory of files is limited like the memory of the device, and reported before they are read.
#[test]
fn files_take_no_more_memory_than_they_may() {
    let folder = Folder::with(&BALL.replace("color = [0.2, 0.3, 0.4]", "image = \"sky.png\""));
    image::RgbImage::from_fn(512, 256, |x, y| image::Rgb([x as u8, y as u8, 9])).save(folder.path("sky.png")).unwrap();
    let render = |memory: &str| folder.run(&format!("render scene.toml -o a.png --memory {memory}"));
    render("64MiB").succeeds();
    let refused = ["sky.png` : it needs 1.5 MiB of memory, and 1.0 MiB of 1.0 MiB are left".replace("` :", "`:")];
    let ran = render("1MiB");
    assert_eq!(ran.code, Some(1));
    ran.says(&[&refused[0], "help: reduce its size, or raise the limit with --memory"]);
    // The size of a mesh is first estimated from the length of its file.
    let mesh = "[[objects]]\nshape = \"mesh\"\nfile = \"large.obj\"\nmaterial = \"red\"\n";
    folder.write("scene.toml", format!("{BALL}{mesh}"));
    folder.write("large.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n".to_owned() + &"# and so on\n".repeat(200_000));
    render("1MiB").says(&["large.obj`: it needs 2.3 MiB of memory"]);
    // Files that are read again for every frame replace the previous ones.
    let header = "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 64 64 64\nencoding: raw\n\n";
    folder.write("grid.nrrd", [header.as_bytes(), &vec![100; 64 * 64 * 64]].concat());
    let law = "[law]\nkind = \"medium\"\nindex = { kind = \"grid\", file = \"grid.nrrd\", min = [-3, -3, -3], max = [3, 3, 3], \
               scale = 0.01, offset = 0.1 }\n[animation]\nframes = 12\n[[animation.tracks]]\nkey = \"law.index.scale\"\n\
               values = [0.01, 0.012]\n";
    folder.write("scene.toml", format!("{BALL}{law}").replace("[rays]", "[rays]\nmethod = \"rk4\""));
    folder.run("render scene.toml -o {frame}.png --frames all --memory 8MiB").succeeds();
}
