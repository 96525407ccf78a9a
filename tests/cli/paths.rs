//! Tests the output of commands about path tracing and absorption.

use super::Folder;

const ROOM: &str = "[image]\nsize = [12, 12]\nsamples = 16\n[camera]\nposition = [0, 0, 2.5]\n[rays]\nbounding_sphere = { radius = 9 }\n\
    lighting = \"path-tracing\"\n[materials.m]\nkind = \"phong\"\n[materials.lamp]\nkind = \"emissive\"\ncolor = [4, 4, 4]\n\
    [[objects]]\nshape = \"box\"\nmaterial = \"m\"\ncenter = [0, -1, 0]\nsize = [4, 0.2, 4]\n\
    [[objects]]\nshape = \"sphere\"\nmaterial = \"lamp\"\ncenter = [0, 1, 0]\nradius = 0.3\n";

#[test]
fn pictures_say_their_noise() {
    let folder = Folder::with(ROOM);
    let checked = folder.run("check scene.toml").succeeds();
    assert!(checked.out.contains("direct-light sampling: 1 emitter (objects[1])"), "{}", checked.out);
    let checked = folder.run("check scene.toml --set path_tracing.light_sampling=false").succeeds();
    assert!(checked.out.contains("direct-light sampling: none"), "{}", checked.out);
    folder
        .run("render scene.toml -o out.exr --layers standard_error,normal")
        .succeeds()
        .says(&["noise ", "% of the image's mean (median pixel "]);
    let bytes = std::fs::read(folder.path("out.exr")).unwrap();
    assert!(bytes.windows(6).any(|name| name == b"error\0"), "no error layer");
    folder.run("render scene.toml -o one.png --samples 1").succeeds().says(&["noise unknown"]);
    let cut = folder.run("render scene.toml -o cut.png --set path_tracing.max_depth=0").succeeds();
    cut.says(&[" cut "]);
    // An emitter of radiance 4 exceeds a clamp of 1, and no sample exceeds 5.
    let clamped = folder.run("render scene.toml -o clamped.png --set output.clamp=1").succeeds();
    clamped.says(&[" samples clamped, removing "]);
    folder
        .run("render scene.toml -o clamped.png --set output.clamp=5")
        .succeeds()
        .says(&["; 0 samples clamped, removing 0.00 %"]);
    folder.write("scene.toml", ROOM.replace("lighting = \"path-tracing\"\n", ""));
    folder
        .run("render scene.toml -o out.exr --layers standard_error")
        .fails(1, &["the layer `standard_error` requires random samples"]);
}

#[test]
fn pictures_go_on_where_they_were() {
    let folder = Folder::with(ROOM);
    folder.run("render scene.toml -o long.exr --samples 11").succeeds();
    let long = std::fs::read(folder.path("long.exr")).unwrap();
    folder.run("render scene.toml -o part.exr --samples 5").succeeds();
    for how in ["", " --schedule fused --memory 1MiB"] {
        let ran =
            folder.run(&format!("render scene.toml -o more.exr --samples 11 --continue part.exr{how}")).succeeds();
        ran.says(&["864 rays"]);
        assert!(std::fs::read(folder.path("more.exr")).unwrap() == long, "{how}");
    }
    // The output file may be the input file, and layers may be omitted.
    folder.run("render scene.toml -o part.exr -o part.png --samples 11 --continue part.exr").succeeds();
    assert!(std::fs::read(folder.path("part.exr")).unwrap() == long);
    let few =
        folder.run("render scene.toml -o few.exr --layers normal,accumulated,luminance_m2 --samples 5").succeeds();
    few.says(&["noise"]);
    let go_on = |rest: &str| folder.run(&format!("render scene.toml -o more.exr {rest}"));
    go_on("--continue few.exr --layers normal").succeeds();
    go_on("--continue few.exr --layers depth").fails(1, &["few.exr: it has no layer `depth`"]);
    go_on("--continue part.exr").succeeds();
    go_on("--samples 11 --continue part.exr").fails(1, &["has 11 samples per pixel already", "--samples 22"]);
    for (other, why) in [
        (
            "--set objects.1.radius=0.2",
            "few.exr: its `objects.1.radius` is `0.3`, not `0.2`; only `samples` and [output] may",
        ),
        (
            "--precision f64",
            "few.exr: its integration method is { method = \"exact\", max_segments = 1000, precision = \"f32\" }",
        ),
    ] {
        let ran = go_on(&format!("{other} --continue few.exr")).says(&[why]);
        assert_eq!(ran.code, Some(1));
    }
    go_on("--crop 0,0,4x4 --continue few.exr").fails(1, &["few.exr: it shows the window 0,0,12x12"]);
    go_on("--set image.sampler=multi-jittered --continue few.exr")
        .fails(1, &["multi-jittered samples require a fixed number"]);
    go_on("--layers standard_error").succeeds();
    go_on("--continue more.exr").fails(1, &["more.exr: it has no layers `accumulated`"]);
    go_on("--samples 1").succeeds();
    go_on("--continue more.exr").fails(1, &["it has one sample per pixel"]);
    folder.write("scene.toml", ROOM.replace("lighting = \"path-tracing\"\n", ""));
    go_on("--layers accumulated").fails(1, &["the layers `accumulated` and `luminance_m2` require"]);
}

#[test]
fn previews_are_pictures_so_far() {
    let folder = Folder::with(ROOM);
    folder.run("render scene.toml -o long.exr --preview so_far.exr --preview-every 0 --samples 9").succeeds();
    folder.run("render scene.toml -o more.exr --samples 9 --continue so_far.exr").succeeds().says(&["144 rays"]);
    assert!(std::fs::read(folder.path("more.exr")).unwrap() == std::fs::read(folder.path("long.exr")).unwrap());
    // The tiles of an image can also be previewed and clamped.
    let tiles = "--set output.clamp=1 --preview b.exr --preview-every 0 --size 64x64 --memory 300KiB --samples 5";
    let looked = folder.run(&format!("render scene.toml -o a.exr {tiles}")).succeeds();
    let at_once = folder.run("render scene.toml -o c.exr --set output.clamp=1 --size 64x64 --samples 5").succeeds();
    assert!(std::fs::read(folder.path("a.exr")).unwrap() == std::fs::read(folder.path("c.exr")).unwrap());
    let clamped = |words: &str| words.split("; ").last().unwrap_or_default().trim().to_owned();
    assert!(clamped(&at_once.err).contains("samples clamped"), "{}", at_once.err);
    assert_eq!(clamped(&looked.err), clamped(&at_once.err));
    folder.run("render scene.toml -o a.png --preview a.png").fails(1, &["used for two outputs"]);
    folder.run("render scene.toml -o a.png --preview no/b.png").fails(1, &["no/b.png"]);
    folder.run("render scene.toml -o a.png --preview-every 3").fails(2, &["--preview"]);
    folder
        .run("render scene.toml -o a.png --preview b.png --preview-every=-3")
        .fails(2, &["expected a number of seconds"]);
    folder
        .run("render scene.toml -o a.png --preview b.png --preview-every 0 --set image.adaptive=0.1")
        .fails(1, &["adaptive"]);
}

#[test]
fn filters_that_are_none_are_warned_of() {
    let filter = "[law]\nkind = \"straight\"\nabsorption = { coefficient = \"x - 1\" }\n";
    let folder = Folder::with(&format!("{filter}{}", ROOM.replace("lighting = \"path-tracing\"\n", "")));
    let ran = folder.run("render scene.toml -o out.png").succeeds();
    ran.says(&[
        "matter not defined on ",
        "warning: ",
        "matter that is negative",
        "each transmittance is between 0 and 1",
    ]);
    let ramp = "absorption = { texture = \"ramp\", frequency = 1, ramp = \"none.png\" }";
    folder.write("scene.toml", format!("{filter}{ROOM}").replace("absorption = { coefficient = \"x - 1\" }", ramp));
    folder.run("render scene.toml -o out.png").fails(1, &["none.png"]);
}
