//! A frame with an open shutter shows its whole exposure time.

use exr::prelude::read_first_rgba_layer_from_file;

use super::{BALL, Folder};

/// Returns the colors of a frame, row by row.
fn colors(folder: &Folder, name: &str, width: usize) -> Vec<[f32; 3]> {
    let image = read_first_rgba_layer_from_file(
        folder.path(name),
        |size, _| vec![[f32::NAN; 3]; size.area()],
        move |pixels, at, (r, g, b, _): (f32, f32, f32, f32)| pixels[at.x() + width * at.y()] = [r, g, b],
    );
    image.unwrap().layer_data.channel_data.pixels
}

fn film(samples: u32, animation: &str, track: &str) -> String {
    let ball = BALL.replace("size = [16, 12]", &format!("size = [16, 12]\nsamples = {samples}"));
    format!("{ball}[animation]\nframes = 4\n{animation}\n[[animation.tracks]]\n{track}\n")
}

const AWAY: &str = "key = \"objects.0.center\"\nvalues = [[0, 0, 0], [3, 0, 0]]";

#[test]
fn what_stays_where_it_is_is_sharp_to_the_bit() {
    let folder = Folder::with(&film(16, "shutter = 1", "key = \"objects.0.center\"\nvalues = [[0, 0, 0], [0, 0, 0]]"));
    folder.run("render scene.toml -o {frame}.exr --frames 0").succeeds();
    folder.run("render scene.toml -o sharp_{frame}.exr --frames 0 --set animation.shutter=0").succeeds();
    assert!(colors(&folder, "0.exr", 16) == colors(&folder, "sharp_0.exr", 16));
    // Moving objects are blurred.
    folder.write("scene.toml", film(16, "shutter = 1", AWAY));
    folder.run("render scene.toml -o {frame}.exr --frames 0").succeeds();
    assert!(colors(&folder, "0.exr", 16) != colors(&folder, "sharp_0.exr", 16));
}

/// A straight edge passes 16 pixels at a constant speed: each pixel shows the fraction of the time that it is covered.
#[test]
fn an_edge_that_passes_leaves_a_ramp() {
    let folder = Folder::with(
        "[image]\nsize = [32, 4]\nsamples = 256\n[camera]\nposition = [0, 0, 16]\nfov = 14.250032697803595\n[rays]\n\
         bounding_sphere = { radius = 90 }\n[materials.white]\nkind = \"emissive\"\ncolor = [1, 1, 1]\n[[objects]]\n\
         shape = \"plane\"\nmaterial = \"white\"\nrotate = [90, 0, 0]\nsize = [40, 40]\n[animation]\nframes = 3\nshutter = 0.5\n\
         [[animation.tracks]]\nkey = \"objects.0.center\"\nvalues = [[-28, 0, 0], [4, 0, 0]]\nkeyframes = [1, 2]\n",
    );
    // 4 pixels in tan(fov/2)·16·2 = 4 units: a pixel is one. The right edge goes from −8 to 8.
    folder.run("render scene.toml -o {frame}.exr --frames 1").succeeds();
    let pixels = colors(&folder, "1.exr", 32);
    let mut errors = 0.0;
    for (i, [seen, ..]) in pixels.iter().enumerate() {
        let middle = (i % 32) as f64 - 15.5;
        let expected = (0.5 - middle / 16.0).clamp(0.0, 1.0);
        let error = f64::from(*seen) - expected;
        // The edge is inside the pixel in 16 of the samples, and half of these show it: 4 standard deviations.
        assert!(error.abs() < 4.0 * 2.0 / 256.0, "pixel {i}: {seen}, not {expected}");
        errors += error;
    }
    assert!((errors / pixels.len() as f64).abs() < 2e-3, "{errors}");
}

#[test]
fn what_the_shutter_does_not_go_with_is_said() {
    let folder = Folder::with(&film(16, "shutter = 0.5", AWAY));
    for (set, message) in [
        ("animation.shutter=1.5", "expected a fraction of the frame interval, from 0 to 1, found 1.5"),
        ("animation.shutter_samples=12", "expected a power of two, 2 to 1024"),
        ("image.adaptive=0.05", "adaptive sampling cannot be combined with an open shutter"),
    ] {
        folder.run(&format!("render scene.toml -o {{frame}}.png --frames 0 --set {set}")).fails(1, &[message]);
    }
    let ran = folder.run("render scene.toml -o {frame}.png --frames 0 --samples 1").succeeds();
    ran.says(&["warning: the shutter is open, but one sample per pixel shows no motion blur"]);
    // A moment that is invalid between valid frames: the camera meets the horizon.
    let hole = "[law]\nkind = \"schwarzschild\"\n";
    let track = "key = \"camera.position\"\nvalues = [[0, 0, 5], [0, 0, 1]]\nkeyframes = [3, 3.5]";
    folder.write("scene.toml", film(16, "shutter = 0.5", track) + hole);
    for command in ["check scene.toml", "render scene.toml -o {frame}.png --frames all"] {
        folder.run(command).fails(1, &["frame 3.5: "]);
    }
    assert_eq!(folder.names(), ["0.png", "scene.toml"]);
}

/// Finished frames are identified by their motion during the exposure, and by nothing more.
#[test]
fn finished_frames_are_known_by_their_motion() {
    let folder = Folder::with(&film(4, "shutter = 0.5", AWAY));
    let rendered = |more: &str| {
        let ran = folder.run(&format!("render scene.toml -o {{frame}}.exr --frames 0 {more}")).succeeds();
        ran.err.contains("frame 0: ready after ")
    };
    assert!(rendered("") && !rendered(""));
    assert!(!rendered("--set animation.frames=3 --set animation.rate=30"));
    assert!(rendered("--set animation.shutter=0.25"));
    assert!(rendered("--set animation.shutter=0.25 --set animation.tracks.0.values=[[0,0,0],[2,0,0]]"));
}
