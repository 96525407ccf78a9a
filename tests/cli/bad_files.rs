//! Meshes, images and tables of rays that are missing, empty or broken.

use std::io::Cursor;

use image::{DynamicImage, ImageFormat, Rgb, Rgb32FImage};

use super::{BALL, Folder};

const MESH: &str = "[[objects]]\nshape = \"mesh\"\nfile = \"mesh.obj\"\nmaterial = \"red\"\n";

#[test]
fn broken_meshes_are_named_with_the_place_in_their_own_file() {
    let folder = Folder::with(&(BALL.to_owned() + MESH));
    let render = || folder.run("render scene.toml -o a.png");
    render().fails(
        1,
        &[
            "scene.toml:18:8: cannot read `mesh.obj`: ",
            "\n    file = \"mesh.obj\"\n           ^^^^^^^^^^\n",
            "file names are relative to the folder of the scene file",
            "1 error",
        ],
    );
    let corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    let cases: [(&str, &[&str]); 8] = [
        ("", &["mesh.obj:1:1: the mesh has no triangles", "such as `f 1 2 3`"]),
        ("# nothing\nv 0 0 0\n", &["mesh.obj:1:1: the mesh has no triangles"]),
        (&format!("{corners}f 1 2 2\n"), &["the mesh has no triangles with an area"]),
        (
            &format!("{corners}f 1 2 9\n"),
            &[
                "mesh.obj:4:7: vertex `9` does not exist",
                "\n    f 1 2 9\n          ^\n",
                "3 are defined above this line",
            ],
        ),
        (&format!("{corners}f 0 1 2\n"), &["mesh.obj:4:3: vertex `0` does not exist"]),
        (&format!("{corners}f 1 2//1 3\n"), &["mesh.obj:4:5: normal `1` does not exist"]),
        (
            "v 0 0 0\nv 1 NaN 0\nv 0 1 0\nf 1 2 3\n",
            &["mesh.obj:2:5: expected a number, found `NaN`", "numbers must be finite"],
        ),
        ("v 0 0\n", &["mesh.obj:1:1: `v` requires 3 numbers, found 2"]),
    ];
    for (mesh, texts) in cases {
        folder.write("mesh.obj", mesh);
        render().fails(1, texts).says(&["1 error"]);
    }
    assert_eq!(folder.names(), ["mesh.obj", "scene.toml"]);
}

/// Returns an image of noise, which no format compresses well.
fn encoded(format: ImageFormat) -> Vec<u8> {
    let noise = |x: u32, y: u32| (x * 7919 + y * 104_729) as f32 % 1.0e3 / 1.0e3;
    let picture = Rgb32FImage::from_fn(32, 16, |x, y| Rgb([noise(x, y), noise(y, x), 0.5]));
    let picture = DynamicImage::from(picture);
    let picture = match format {
        ImageFormat::Png => DynamicImage::from(picture.to_rgb8()),
        _ => picture,
    };
    let mut bytes = Cursor::new(Vec::new());
    picture.write_to(&mut bytes, format).unwrap();
    bytes.into_inner()
}

#[test]
fn broken_skies_and_textures_are_named_where_the_scene_names_them() {
    let sky = "color = [0.2, 0.3, 0.4]";
    let folder = Folder::new();
    folder.write("scene.png", BALL.replace(sky, "image = \"sky.png\""));
    folder.write("scene.exr", BALL.replace(sky, "image = \"sky.exr\""));
    folder
        .run("check scene.png")
        .fails(1, &["scene.png:9:9: cannot read `sky.png`: ", "\n    image = \"sky.png\"\n            ^^^^^^^^^\n"]);
    for (kind, format) in [("png", ImageFormat::Png), ("exr", ImageFormat::OpenExr)] {
        let whole = encoded(format);
        let mut flipped = whole.clone();
        let middle = flipped.len() / 2;
        flipped[middle..middle + 16].iter_mut().for_each(|byte| *byte ^= 0x55);
        let broken = [b"not a picture".to_vec(), Vec::new(), whole[..whole.len() / 2].to_vec(), flipped];
        for (which, bytes) in broken.into_iter().enumerate() {
            folder.write(&format!("sky.{kind}"), bytes);
            let ran = folder.run(&format!("check scene.{kind}"));
            // In an EXR changed numbers in a block can only be detected if the block does not unpack.
            if !(kind == "exr" && which == 3 && ran.code == Some(0)) {
                ran.fails(1, &[&format!("scene.{kind}:9:9: cannot use the image `sky.{kind}`: "), "1 error"]);
            }
        }
        folder.write(&format!("sky.{kind}"), whole);
        folder.run(&format!("check scene.{kind}")).succeeds();
    }
    let not_finite = Rgb32FImage::from_fn(4, 2, |x, y| Rgb([if (x, y) == (3, 1) { f32::NAN } else { 0.5 }, 0.0, 0.0]));
    DynamicImage::from(not_finite).save(folder.path("sky.exr")).unwrap();
    folder.run("check scene.exr").fails(1, &["`sky.exr`: the pixel in column 3, row 1", "is not finite"]);

    let texture = BALL.replace("[1, 0, 0]", "{ image = \"sky.png\" }");
    folder.write("texture.toml", &texture);
    folder.run("check texture.toml").succeeds();
    folder.write("sky.png", "not a picture");
    folder.run("check texture.toml").fails(1, &["texture.toml:12:19: cannot use the image `sky.png`: "]);
}

#[test]
fn files_are_found_beside_the_scene_not_beside_the_user() {
    let folder = Folder::new();
    std::fs::create_dir(folder.path("inner")).unwrap();
    folder.write("inner/scene.toml", BALL.to_owned() + MESH);
    folder.write("mesh.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    folder.run("check inner/scene.toml").fails(1, &["inner/scene.toml:18:8: cannot read `inner/mesh.obj`: "]);
    std::fs::rename(folder.path("mesh.obj"), folder.path("inner/mesh.obj")).unwrap();
    folder.run("check inner/scene.toml").succeeds();
}

#[test]
fn tables_of_rays_are_refused_with_the_line_and_the_column() {
    let folder = Folder::with(BALL);
    folder.write("out.csv", "an old table");
    let trace = || folder.run("trace scene.toml --rays rays.csv -o out.csv");
    trace().fails(1, &["rays.csv: cannot read the file ("]);
    let cases: [(&str, &[&str]); 11] = [
        ("", &["rays.csv: line 1: the file is empty; begin it with x,y,z,vx,vy,vz"]),
        (
            "0,0,5,0,0,-1\n",
            &[
                "rays.csv: line 1: column 1: `0` is not a valid column for rays",
                "the first line must contain x,y,z,vx,vy,vz",
            ],
        ),
        ("x,y,z,vx,vy\n0,0,5,0,0\n", &["rays.csv: line 1: missing column `vz` in `x,y,z,vx,vy`"]),
        ("x,y,z,vx,vy,vz,x\n", &["rays.csv: line 1: column 7: `x` occurs twice"]),
        ("x,y,z,vx,vy,vz\n", &["rays.csv: line 1: no rays after the header"]),
        (
            "x,y,z,vx,vy,vz\n0,0,5,0,0,-1\n0,0,5,0,abc,-1\n",
            &["rays.csv: line 3: column 5 (vy): expected a finite number such as 1.5 or -2e-3, found `abc`"],
        ),
        (
            "x,y,z,vx,vy,vz\n\n0,nan,5,0,0,-1\n",
            &["rays.csv: line 3: column 2 (y): expected a finite number such as 1.5 or -2e-3, found `nan`"],
        ),
        (
            "x,y,z,vx,vy,vz\n0,0,5,inf,0,-1\n",
            &["rays.csv: line 2: column 4 (vx): expected a finite number such as 1.5 or -2e-3, found `inf`"],
        ),
        (
            "x,y,z,vx,vy,vz\n0,0,5,0,0,-1\n0,0,5,0,0,0\n",
            &["rays.csv: line 3: the velocity 0.0,0.0,0.0 has no direction"],
        ),
        ("x,y,z,vx,vy,vz\n0,0,5,0,1e-30,-0\n", &["rays.csv: line 2: the velocity 0.0,", "such as 0,0,-1"]),
        ("x,y,z,vx,vy,vz\n0,0,5,0,0\n", &["rays.csv: line 2: `0,0,5,0,0` has 5 fields; expected 6"]),
    ];
    for (rays, texts) in cases {
        folder.write("rays.csv", rays);
        trace().fails(1, texts);
    }
    assert_eq!(folder.names(), ["out.csv", "rays.csv", "scene.toml"]);
    assert_eq!(folder.text("out.csv"), "an old table");
}

/// Endless input is not read until memory runs out, and a file that is not a scene is reported as such.
#[test]
#[cfg(unix)]
fn what_is_no_scene_and_no_file_is_refused() {
    let folder = Folder::with(&(BALL.to_owned() + MESH));
    std::os::unix::fs::symlink("/dev/zero", folder.path("mesh.obj")).unwrap();
    folder.run("check scene.toml").fails(1, &["cannot read `mesh.obj`: not a regular file, and longer than 1 GiB"]);
    folder.run("check /dev/zero").fails(1, &["cannot read `/dev/zero`: not a regular file"]);
    std::fs::write(folder.path("a.glb"), b"glTF\x02\0\0\0\xff").unwrap();
    folder.run("check a.glb").fails(1, &["this is a glTF file, not text", "`bentray import FILE -o scene.toml`"]);
}

/// Scenes are not written under the name of an image, and the printed command can be typed.
#[test]
fn scenes_that_are_written_have_names_of_scenes() {
    let folder = Folder::with(BALL);
    folder.run("new a.png").fails(1, &["a.png: this command writes a scene, not an image"]);
    let said = folder.run("new my$scene.toml").succeeds();
    assert!(said.out.contains("`bentray render 'my$scene.toml' -o picture.png`"), "{}", said.out);
}
