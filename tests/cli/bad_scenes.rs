//! Tests invalid scenes: the message has the location, the offending text and a remedy, the exit code is 1, and the old image
//! remains.

use super::{BALL, Folder};

/// A scene with one error, and texts that its message must contain.
type Case = (&'static str, &'static [&'static str]);

/// Syntax and names.
const WRITTEN: &[Case] = &[
    ("[image]\nsize = [8, 8\n[rays]\n", &["scene.toml:", "not valid TOML: "]),
    ("[image]\nsize = = 3\n", &["scene.toml:2:8: not valid TOML: ", "\n    size = = 3\n"]),
    (
        "[image]\nsize = [8, 8]\n\n[image]\nsamples = 2\n",
        &[
            "scene.toml:4:2: not valid TOML: duplicate key",
            "this name is already defined above",
            "double brackets: [[objects]]",
        ],
    ),
    (
        "[image]\nsise = [8, 8]\n[rays]\nbounding_sphere = { radius = 10 }\n",
        &[
            "scene.toml:2:1: unknown key `sise`",
            "\n    sise = [8, 8]\n    ^^^^\n",
            "use `size`; valid keys: size, samples",
        ],
    ),
    (
        "[rays]\nbounding_sphere = { radius = 10 }\n[[objects]]\nshape = \"sphere\"\nmaterial = \"rad\"\n\
         [materials.red]\ndiffuse = [1, 0, 0]\n",
        &[
            "scene.toml:5:12: unknown material `rad`",
            "\n    material = \"rad\"\n               ^^^^^\n",
            "use `red`; materials: red",
        ],
    ),
    (
        "[rays]\nbounding_sphere = { radius = 10 }\nmethod = \"rk5\"\n",
        &[
            "scene.toml:3:10: unknown value `rk5`",
            "use `dormand-prince`; choices: auto, exact, planar, separated, euler",
        ],
    ),
    ("[image]\nsize = [8, 8]\n", &["scene.toml:1:1: missing table [rays]", "help: "]),
];

/// Values.
const VALUES: &[Case] = &[
    (
        "[rays]\nbounding_sphere = { radius = \"ten\" }\n",
        &["scene.toml:2:30: expected a number, found the string \"ten\"", "^^^^^"],
    ),
    (
        "[rays]\nbounding_sphere = { radius = 10 }\n[camera]\nposition = [0, 0, 5]\nfov = \"45deg\"\n",
        &[
            "scene.toml:5:7: expected a number, found the string \"45deg\"",
            "`fov` with kind = \"pinhole\": vertical opening angle",
            "degrees",
        ],
    ),
    (
        "[rays]\nbounding_sphere = { radius = 10 }\n[[objects]]\nshape = \"sphere\"\nmaterial = [1, 0, 0]\n",
        &["scene.toml:5:12: expected a string, found an array of length 3", "help: `material`: surface material"],
    ),
    (
        "[rays]\nbounding_sphere = { radius = 10 }\n[law]\nkind = \"kerr\"\n",
        &["scene.toml:4:8: unknown value `kerr`", "use `kerr-newman`"],
    ),
    ("[rays]\nbounding_sphere = { radius = nan }\n", &["scene.toml:2:30: not a finite number", "use a finite number"]),
    (
        "[rays]\nbounding_sphere = { radius = 10, center = [0, -inf, 0] }\n",
        &["scene.toml:2:47: not a finite number", "use a finite number"],
    ),
    (
        "[rays]\nbounding_sphere = { radius = 10 }\n[image]\nsize = [0, 12]\n",
        &["scene.toml:4:9: expected a whole number from 1 to 65536, found 0"],
    ),
    ("[rays]\nbounding_sphere = { radius = -10 }\n", &["scene.toml:2:30: expected a length above 0, found -10"]),
    (
        "[rays]\nbounding_sphere = { radius = 10 }\n[materials.m]\n[[objects]]\nshape = \"sphere\"\nradius = -1.5\n\
         material = \"m\"\n",
        &["scene.toml:6:10: expected a length above 0, found -1.5"],
    ),
    (
        "[rays]\nbounding_sphere = { radius = 10 }\n[materials.m]\n[[objects]]\nshape = \"sphere\"\ncenter = [9, 0, 0]\n\
         radius = 1.5\nmaterial = \"m\"\n",
        &[
            "scene.toml:5:9: the object extends 0.5 beyond the bounding sphere, where no rays are traced",
            "use a radius of at least 10.5 in rays.bounding_sphere",
        ],
    ),
    (
        "[rays]\nbounding_sphere = { radius = 10 }\n[law]\nkind = \"schwarzschild\"\nmass = 0.75\n[camera]\n\
         position = [0, 1.25, 0]\nup = [1, 0, 0]\n",
        &[
            "scene.toml:7:12: the camera is inside the horizon: r = 1.2500 ≤ 2M = 1.5",
            "move it away from the black hole",
        ],
    ),
];

fn hold(cases: &[Case]) {
    let folder = Folder::new();
    folder.write("out.png", "an old picture");
    for (scene, texts) in cases {
        folder.write("scene.toml", scene);
        let ran = folder.run("render scene.toml -o out.png").fails(1, texts).says(&["1 error"]);
        // The message is identical for every command that reads the scene.
        let others = [folder.run("check scene.toml"), folder.run("wgsl scene.toml")];
        for other in others {
            assert_eq!(other.fails(1, &[]).err, ran.err);
        }
    }
    assert_eq!(folder.names(), ["out.png", "scene.toml"]);
    assert_eq!(folder.text("out.png"), "an old picture");
}

#[test]
fn wrong_words_are_named_with_their_place() {
    hold(WRITTEN);
}

#[test]
fn wrong_values_are_named_with_their_place() {
    hold(VALUES);
}

#[test]
fn all_mistakes_are_found_in_one_run() {
    let folder = Folder::new();
    let scene =
        BALL.replace("16, 12", "16, 0").replace("[0.2, 0.3, 0.4]", "[0.2, inf, 0.4]").replace("\"red\"", "\"read\"");
    folder.write("scene.toml", &scene);
    folder.write("mesh.obj", "v 0 0 0\nv 1 0 0\nv 0 1 nan\nf 1 2 4\n");
    let more = "[[objects]]\nshape = \"mesh\"\nfile = \"mesh.obj\"\nmaterial = \"red\"\ncolour = 1\n";
    folder.write("scene.toml", scene + more);
    let places = [
        "scene.toml:3:13: ",
        "scene.toml:9:15: ",
        "scene.toml:15:12: ",
        "scene.toml:20:1: ",
        "mesh.obj:3:7: ",
        "mesh.obj:4:7: ",
        "--set image.samples=0:1:15: ",
    ];
    let ran = folder.run("render scene.toml -o a.png --set image.samples=0").fails(1, &places).says(&["7 errors"]);
    let at = |place: &str| ran.err.find(place).unwrap();
    assert!(places[..4].windows(2).all(|pair| at(pair[0]) < at(pair[1])), "{}", ran.err);
    assert_eq!(folder.names(), ["mesh.obj", "scene.toml"]);
}

#[test]
fn a_scene_file_that_is_missing_or_no_text_is_named() {
    let folder = Folder::new();
    for command in ["render nope.toml -o a.png", "check nope.toml", "wgsl nope.toml"] {
        folder.run(command).fails(1, &["cannot read `nope.toml`: "]);
    }
    folder.write("scene.toml", b"[image]\n# \xff\xfe\n");
    folder.run("check scene.toml").fails(1, &["scene.toml:2:3: this byte is not valid UTF-8"]);
    assert_eq!(folder.names(), ["scene.toml"]);
}

#[test]
fn a_scene_without_camera_is_traced_but_not_rendered() {
    let folder = Folder::with("[rays]\nbounding_sphere = { radius = 10 }\n");
    folder.write("out.png", "an old picture");
    let ran = folder.run("render scene.toml -o out.png");
    assert_eq!((ran.code, ran.out.as_str()), (Some(1), ""));
    ran.says(&["error: scene.toml: the scene has no [camera]: add one, such as\n    [camera]\n    position = "]);
    assert_eq!(folder.text("out.png"), "an old picture");
    folder.run("check scene.toml").succeeds();
    assert_eq!(folder.names(), ["out.png", "scene.toml"]);
}
