//! No output overwrites an input or another output, even if their paths differ.

use super::{BALL, Folder};

const MESH: &str = "[[objects]]\nshape = \"mesh\"\nfile = \"mesh.obj\"\nmaterial = \"red\"\n";

/// A command, and a part of its error message.
type Case = (&'static str, &'static str);

/// Checks that each command is rejected before a device is opened, and that the folder is unchanged.
#[track_caller]
fn refused(folder: &Folder, cases: &[Case]) {
    let before: Vec<_> = folder.names().into_iter().map(|name| (folder.read(&name), name)).collect();
    for (arguments, text) in cases {
        folder.run(arguments).fails(1, &[text]);
    }
    let after: Vec<_> = folder.names().into_iter().map(|name| (folder.read(&name), name)).collect();
    assert!(before == after, "{:?}", folder.names());
}

#[test]
fn the_files_of_a_scene_are_not_written_over() {
    let folder = Folder::with(&(BALL.to_owned() + MESH).replace("color = [0.2, 0.3, 0.4]", "image = \"sky.png\""));
    folder.write("mesh.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    folder.write("rays.csv", "x,y,z,vx,vy,vz\n0,0,5,0,0,-1\n");
    folder.write("scene.png", BALL);
    image::RgbImage::new(4, 2).save(folder.path("sky.png")).unwrap();
    refused(
        &folder,
        &[
            ("render scene.png -o scene.png", "scene.png is the scene file and would be overwritten"),
            ("render scene.toml -o sky.png", "sky.png is a file that the scene reads"),
            ("render scene.toml -o ./sky.png", "./sky.png is a file that the scene reads"),
            ("render scene.toml -o a.png --preview sky.png", "sky.png is a file that the scene reads"),
            ("trace scene.toml --rays rays.csv -o rays.csv", "rays.csv is the file of rays"),
            ("trace scene.toml --rays rays.csv --plot mesh.obj", "mesh.obj"),
            ("trace scene.toml --rays rays.csv -o scene.toml", "scene.toml is the scene file"),
        ],
    );
}

#[test]
fn a_file_holds_one_thing() {
    let folder = Folder::with(BALL);
    folder.write("rays.csv", "x,y,z,vx,vy,vz\n0,0,5,0,0,-1\n");
    refused(
        &folder,
        &[
            ("render scene.toml -o a.png -o ./a.png", "./a.png is used for two outputs (also as a.png)"),
            ("render scene.toml -o a.png -o a.png", "a.png is used for two outputs: name another file"),
            ("trace scene.toml --rays rays.csv -o a.csv --plot ./a.csv", "used for two outputs"),
            ("render scene.toml -o a.png/", "a.png/: this is a folder"),
        ],
    );
}

#[test]
fn parts_are_not_written_over_by_their_whole() {
    let folder = Folder::with(BALL);
    folder.run("render scene.toml -o top.exr --crop 0,0,16x6").succeeds();
    folder.run("render scene.toml -o low.exr --crop 0,6,16x6").succeeds();
    refused(
        &folder,
        &[("merge top.exr low.exr -o ./low.exr", "./low.exr is one of the parts and would be overwritten")],
    );
}
