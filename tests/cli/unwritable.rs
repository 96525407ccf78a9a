//! Outputs that cannot be written are rejected before any work, with a remedy.

use super::{BALL, Folder};

#[test]
fn targets_that_cannot_be_written_are_refused_before_the_work() {
    let folder = Folder::with(BALL);
    folder.write("rays.csv", "x,y,z,vx,vy,vz\n0,0,5,0,0,-1\n");
    std::fs::create_dir(folder.path("folder.png")).unwrap();
    let cases: [(&str, &str); 12] = [
        ("render scene.toml -o nodir/a.png", "nodir/a.png: the folder nodir does not exist; create it"),
        ("render scene.toml -o a.png -o nodir/b.exr", "nodir/b.exr: the folder nodir does not exist"),
        ("render scene.toml -o folder.png", "folder.png: this is a folder, and only a regular file"),
        ("render scene.toml -o scene.toml/a.png", "scene.toml/a.png: "),
        ("render scene.toml -o a.jpg", "a.jpg: the name must end in .png (color, for viewing), in .exr"),
        ("render scene.toml -o a", "a: the name must end in .png"),
        ("render scene.toml -o a.png -o b.gif", "b.gif: a video consists of frames; add --frames all"),
        ("trace scene.toml --rays rays.csv -o nodir/a.csv", "nodir/a.csv: the folder nodir does not exist"),
        ("trace scene.toml --rays rays.csv -o folder.png", "folder.png: this is a folder"),
        ("new nodir/scene.toml", "nodir/scene.toml: the folder nodir does not exist"),
        ("new folder.png", "folder.png: this command writes a scene, not an image"),
        ("new scene.toml", "scene.toml: the file exists already"),
    ];
    for (arguments, text) in cases {
        let ran = folder.run(arguments).fails(1, &[text]);
        assert!(!ran.err.contains("device: "), "a device was opened first: {}", ran.err);
    }
    assert_eq!(folder.names(), ["folder.png", "rays.csv", "scene.toml"]);
}

#[test]
fn a_plot_that_cannot_be_written_leaves_no_table_behind() {
    let folder = Folder::with(BALL);
    folder.write("rays.csv", "x,y,z,vx,vy,vz\n0,0,5,0,0,-1\n");
    let ran = folder.run("trace scene.toml --rays rays.csv -o a.csv --plot nodir/a.svg");
    assert_eq!((ran.code, ran.out.as_str()), (Some(1), ""));
    ran.says(&["error: nodir/a.svg: the folder nodir does not exist; create it"]);
    assert_eq!(folder.names(), ["rays.csv", "scene.toml"]);
}

#[cfg(unix)]
#[test]
fn devices_and_read_only_files_are_not_replaced() {
    use std::os::unix::fs::PermissionsExt;
    let folder = Folder::with(BALL);
    folder.write("a.png", "an old picture");
    let mode = |mode| {
        let permissions = PermissionsExt::from_mode(mode);
        std::fs::set_permissions(folder.path("a.png"), permissions).unwrap();
    };
    mode(0o444);
    folder.run("render scene.toml -o a.png").fails(1, &["a.png: the file is read-only; make it writable"]);
    mode(0o644);
    assert_eq!(folder.text("a.png"), "an old picture");
    std::os::unix::fs::symlink("/dev/null", folder.path("b.png")).unwrap();
    folder.run("render scene.toml -o b.png").fails(1, &["b.png: this is a device or pipe"]);
}
