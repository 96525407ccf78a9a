//! What commands say of pictures of random paths, and of filters.

use super::Folder;

const ROOM: &str = "[image]\nsize = [12, 12]\nsamples = 16\n[camera]\nposition = [0, 0, 2.5]\n[rays]\nbound = { radius = 9 }\n\
    transport = \"paths\"\n[materials.m]\nkind = \"phong\"\n[materials.lamp]\nkind = \"emissive\"\ncolor = [4, 4, 4]\n\
    [[objects]]\nshape = \"box\"\nmaterial = \"m\"\ncenter = [0, -1, 0]\nsize = [4, 0.2, 4]\n\
    [[objects]]\nshape = \"sphere\"\nmaterial = \"lamp\"\ncenter = [0, 1, 0]\nradius = 0.3\n";

#[test]
fn pictures_say_their_noise() {
    let folder = Folder::with(ROOM);
    let checked = folder.run("check scene.toml").succeeds();
    assert!(checked.out.contains("paths aim at 1 lamps: objects 1 (from 0)"), "{}", checked.out);
    let checked = folder.run("check scene.toml --set paths.aim=false").succeeds();
    assert!(checked.out.contains("paths aim at nothing"), "{}", checked.out);
    folder
        .run("render scene.toml -o out.exr --layers error,normal")
        .succeeds()
        .says(&["noise ", "% of the picture's mean (median pixel "]);
    let bytes = std::fs::read(folder.path("out.exr")).unwrap();
    assert!(bytes.windows(6).any(|name| name == b"error\0"), "no layer of errors");
    folder.run("render scene.toml -o one.png --samples 1").succeeds().says(&["its noise is not known"]);
    let cut = folder.run("render scene.toml -o cut.png --set paths.depth=0").succeeds();
    cut.says(&[" cut "]);
    folder.write("scene.toml", ROOM.replace("transport = \"paths\"\n", ""));
    folder.run("render scene.toml -o out.exr --layers error").fails(1, &["the layer `error` is of pictures"]);
}

#[test]
fn filters_that_are_none_are_warned_of() {
    let filter = "[law]\nkind = \"straight\"\nfilter = { density = \"x - 1\" }\n";
    let folder = Folder::with(&format!("{filter}{}", ROOM.replace("transport = \"paths\"\n", "")));
    let ran = folder.run("render scene.toml -o out.png").succeeds();
    ran.says(&["filters not known on ", "warning: on ", "is below 0 or above 1"]);
    let ramp = "filter = { texture = \"ramp\", frequency = 1, ramp = \"none.png\" }";
    folder.write("scene.toml", format!("{filter}{ROOM}").replace("filter = { density = \"x - 1\" }", ramp));
    folder.run("render scene.toml -o out.png").fails(1, &["none.png"]);
}
