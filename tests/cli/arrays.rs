//! Tests `.npz`, `.npy`, `.fits` and `.h5`, the files of arrays: they are written once, merged, and read by other programs.

use std::path::Path;
use std::process::Command;

use super::{BALL, Folder};

/// The Python of `make test`, with the packages that `arrays.py` imports.
const PYTHON: &str = "target/python/bin/python";

const FILM: &str = "[animation]\nframes = 2\n[[animation.tracks]]\nkey = \"sky.color\"\n\
                    values = [[0, 0, 0], [1, 1, 1]]\n";

#[test]
fn merged_arrays_have_the_bytes_of_one_render() {
    let folder = Folder::with(BALL);
    folder.run("render scene.toml -o one.npz -o one.fits -o one.h5 -o one.npy").succeeds();
    for part in ["1/2", "2/2"] {
        folder.run(&format!("render scene.toml -o a.npz --part {part}")).succeeds();
    }
    folder.run("merge a.part-1-of-2.exr a.part-2-of-2.exr -o a.npz -o a.fits -o a.h5 -o a.npy").succeeds();
    for format in ["npz", "fits", "h5", "npy"] {
        assert!(folder.read(&format!("a.{format}")) == folder.read(&format!("one.{format}")), "{format}");
    }
    // The method is in the file.
    for name in ["one.npz", "one.fits", "one.h5"] {
        folder.run(&format!("render scene.toml -o b.png --method-from {name}")).succeeds();
    }
}

#[test]
fn finished_frames_of_arrays_are_kept() {
    let folder = Folder::with(&format!("{BALL}{FILM}"));
    let film = "render scene.toml -o {frame}.npz -o {frame}.fits -o {frame}.h5 --frames 0..1";
    folder.run(film).succeeds();
    let before = ["0.npz", "1.fits", "1.h5"].map(|name| folder.read(name));
    let again = folder.run(film).succeeds();
    assert!(!again.err.contains("rendered again"), "{}", again.err);
    assert!(["0.npz", "1.fits", "1.h5"].map(|name| folder.read(name)) == before);
    folder
        .run(&format!("{film} --layers depth"))
        .succeeds()
        .says(&["0.npz is rendered again: its `layers` is `depth,segments,position,"]);
    folder.write("0.fits", b"SIMPLE  =");
    folder.write("1.h5", b"\x89HDF");
    let again = folder.run(&format!("{film} --layers depth")).succeeds();
    again.says(&["0.fits is rendered again: it is not an image", "1.h5 is rendered again: it is not an image"]);
}

#[test]
fn an_npy_stores_color_alone() {
    let folder = Folder::with(BALL);
    folder
        .run("render scene.toml -o a.npy --layers depth")
        .fails(1, &["--layers requires an output that stores layers"]);
    let transparent = "render scene.toml -o a.npy --set sky=\"transparent\"";
    folder.run(transparent).fails(1, &["a.npy: an .npy stores one array, the color; write an .npz for alpha"]);
    assert_eq!(folder.names(), ["scene.toml"]);
}

/// Runs a script of this folder on the files in `folder`.
fn python(folder: &Folder, script: &str) {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut python = Command::new(root.join(PYTHON));
    let ran = python.arg(root.join("tests/cli").join(script)).current_dir(folder.path(".")).output().unwrap();
    assert!(ran.status.success(), "{script}: {}", String::from_utf8_lossy(&ran.stderr));
}

#[test]
#[ignore = "needs NumPy, astropy and h5py"]
fn arrays_have_the_bits_of_the_exr_with_numpy() {
    for scene in [
        "-o a.npy --size 17x9",
        "--size 17x9 --set sky=\"transparent\"",
        "-o a.npy --size 40x33 --samples 64 --set image.adaptive=0.05",
        "-o a.npy --size 8x5 --samples 2 --set rays.lighting=path-tracing",
    ] {
        let folder = Folder::with(BALL);
        folder.run(&format!("render scene.toml -o a.exr -o a.npz -o a.fits -o a.h5 {scene}")).succeeds();
        python(&folder, "arrays.py");
    }
}

/// The black hole in the center of the Galaxy; the area of its shadow gives the diameter.
const GALACTIC_CENTER: &str = r#"
[units]
mass = "4.3e6 Msun"
distance = "8.2 kpc"
[image]
size = [320, 240]
samples = 16
[camera]
position = [0, 0, 200000]
fov = "75 uas"
[law]
kind = "schwarzschild"
[rays]
bounding_sphere = { radius = "5 au" }
method = "planar"
scaled_step = 0.05
precision = "f64"
[sky]
color = [1, 1, 1]
"#;

#[test]
#[ignore = "needs NumPy, astropy and h5py"]
fn a_shadow_has_its_width_in_world_coordinates_with_numpy() {
    let folder = Folder::with(GALACTIC_CENTER);
    folder.run("render scene.toml -o b.fits --crop 150,100,40x30").succeeds();
    folder.run("render scene.toml -o a.fits").succeeds();
    python(&folder, "coordinates.py");
}

#[test]
#[ignore = "needs NumPy, astropy and h5py"]
fn tables_have_the_columns_of_the_csv_with_numpy() {
    let folder = Folder::with(BALL);
    for options in ["", "--path"] {
        for format in ["csv", "npz"] {
            let mut command = folder.command(&format!("trace scene.toml {options} -o a.{format}"));
            assert!(
                command.args(["--fan", "from=[0,0,5] toward=[0,0,0] spread=30 count=9"]).status().unwrap().success()
            );
        }
        python(&folder, "columns.py");
    }
}
