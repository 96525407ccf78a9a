//! `map` and `render --from`: the bytes of a new image, and the keys that need other rays.

use super::{BALL, Folder};

#[test]
fn images_from_maps_have_the_bytes_of_new_ones() {
    let folder = Folder::with(BALL);
    folder.run("map scene.toml -o lens.exr --samples 2").succeeds();
    for look in ["", "--set sky.color=[0.9,0,0.1] --set materials.red.color=[0,1,0] --set output.exposure=1"] {
        folder.run(&format!("render scene.toml -o new.png --samples 2 {look}")).succeeds();
        folder.run(&format!("render scene.toml -o from.png -o from.exr --from lens.exr --samples 2 {look}")).succeeds();
        assert!(folder.read("from.png") == folder.read("new.png"), "{look}");
    }
}

#[test]
fn changes_that_need_other_rays_are_refused() {
    let folder = Folder::with(BALL);
    folder.run("map scene.toml -o lens.exr").succeeds();
    for (change, problem) in [
        (
            "--set camera.position=[0,0,6]",
            "`camera.position` is `[0, 0, 6]`, but the rays were traced with `[0, 0, 5]`",
        ),
        (
            "--set materials.red.kind=mirror",
            "`materials.red.kind` is `\"mirror\"`, but the rays were traced with `\"emissive\"`",
        ),
        ("--samples 4", "`image.samples` is `4`, but the rays were traced with `1`"),
        ("--layers depth -o b.exr", "`depth` describes a whole path, and --from has only its end"),
        ("--size 8x6", "`image.size` is `[8, 6]`"),
    ] {
        folder.run(&format!("render scene.toml -o a.png --from lens.exr {change}")).fails(1, &[problem]);
    }
    folder.run("render scene.toml -o image.exr").succeeds();
    folder.run("render scene.toml -o a.png --from image.exr").fails(1, &["`bentray map` writes"]);
    folder.run("map scene.toml -o lens.png").fails(1, &["a lens map is an .exr"]);
    folder
        .run("map scene.toml -o lens.exr --set rays.lighting=path-tracing")
        .fails(1, &["a lens map cannot be combined with lighting"]);
}

/// Stars are between the rays of a map: its other light is shown without them.
#[test]
fn maps_of_scenes_with_stars_show_the_rest() {
    let folder = Folder::with(&BALL.replace("[sky]", "[sky]\nstars = \"stars.csv\""));
    folder.write("stars.csv", "ra,dec,mag\n0,0,-4\n");
    folder.run("map scene.toml -o lens.exr").succeeds();
    folder.run("render scene.toml -o a.png --from lens.exr").fails(1, &["cannot show `sky.stars`", "--set sky.stars="]);
    folder.run("render scene.toml -o from.png --from lens.exr --set sky.stars=").succeeds();
    folder.run("render scene.toml -o new.png --set sky.stars=").succeeds();
    assert!(folder.read("from.png") == folder.read("new.png"));
}
