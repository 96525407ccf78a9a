//! Invalid options: usage errors exit with 2, values that are wrong for the scene with 1.

use super::{BALL, Folder};

#[test]
fn usage_errors_exit_with_2() {
    let folder = Folder::with(BALL);
    let cases: [(&str, &[&str]); 15] = [
        ("frobnicate", &["'frobnicate'"]),
        ("render", &["<SCENE>", "--output <FILE>"]),
        ("render scene.toml", &["--output <FILE>"]),
        ("render -o a.png", &["<SCENE>"]),
        ("render scene.toml -o a.png --frob", &["'--frob'"]),
        (
            "render scene.toml -o a.png --size 10",
            &["expected a size such as 800x600, with sides from 1 to 65536 pixels, found `10`"],
        ),
        ("render scene.toml -o a.png --size 10x", &["found `10x`"]),
        ("render scene.toml -o a.png --size=-1x4", &["found `-1x4`"]),
        ("render scene.toml -o a.png --samples many", &["'many'", "--samples"]),
        ("render scene.toml -o a.png --schedule quick", &["'quick'", "paper, segment, fused"]),
        ("render scene.toml -o a.png --layers depth,colour", &["'colour'", "position"]),
        ("render scene.toml -o a.png --segments-per-pass 0", &["'0'", "1..=1024"]),
        ("trace scene.toml -o a.csv", &["--rays <FILE>"]),
        ("check", &["<SCENES>"]),
        ("new", &["<FILE>"]),
    ];
    for (arguments, texts) in cases {
        folder.run(arguments).fails(2, texts).says(&["--help"]);
    }
    // Without arguments the program prints its usage to stderr.
    let bare = folder.run("");
    assert_eq!((bare.code, bare.out.as_str()), (Some(2), ""));
    bare.says(&["Usage: bentray <COMMAND>", "render", "check", "trace", "devices", "wgsl", "new"]);
    assert_eq!(folder.names(), ["scene.toml"]);
}

/// A flag without effect is rejected.
#[test]
fn segments_a_pass_are_for_passes_of_several() {
    let folder = Folder::with(BALL);
    for schedule in ["paper", "segment"] {
        let flags = format!("--schedule {schedule} --segments-per-pass 3");
        let texts = ["--segments-per-pass requires --schedule fused", schedule];
        folder.run(&format!("render scene.toml -o a.png {flags}")).fails(1, &texts);
    }
    folder.run("render scene.toml -o a.png --schedule fused --segments-per-pass 3").succeeds();
}

#[test]
fn a_chart_is_of_methods_that_there_are() {
    let folder = Folder::with(BALL);
    for places in ["scene.toml", "--stability --scenes ."] {
        std::fs::write(folder.path("scene.csv"), "x,y,z,vx,vy,vz\n0,0,5,0,0,-1\n").unwrap();
        let ran = folder.run(&format!("compare {places} -o chart --methods rk4,exat"));
        ran.fails(1, &["--methods: no scene supports `exat`; use `exact`; methods: "]);
    }
    assert!(!folder.path("chart").exists());
}

#[test]
fn frames_are_of_an_animation() {
    let texts = ["--frames requires a scene with [animation]", "bentray help films"];
    Folder::with(BALL).run("render scene.toml -o a_{frame}.png --frames all").fails(1, &texts);
}

#[test]
fn no_layers_and_one_of_them_are_refused() {
    let folder = Folder::with(BALL);
    folder
        .run("render scene.toml -o a.exr --layers none,depth")
        .fails(1, &["--layers: `none` cannot be combined with other layers"]);
    folder.run("render scene.toml -o a.exr --layers none").succeeds();
}

#[test]
fn changes_that_are_no_key_and_value_exit_with_2() {
    let folder = Folder::with(BALL);
    let cases: [(&str, &str); 4] = [
        ("foo", "`foo`: expected KEY=VALUE, such as rays.step=0.05"),
        ("a..b=1", "`a..b=1`: the key must be names joined by dots"),
        ("=3", "`=3`: the key must be names joined by dots"),
        ("rays.max_parameter=[1", "`rays.max_parameter=[1`: the value is not valid TOML: "),
    ];
    for (change, text) in cases {
        folder.run(&format!("check scene.toml --set {change}")).fails(2, &[text]);
    }
}

#[test]
fn changes_that_do_not_suit_the_scene_exit_with_1() {
    let folder = Folder::with(BALL);
    folder.write("a.png", "an old picture");
    let cases: [(&str, &[&str]); 7] = [
        (
            "--set rays.max_segment=3",
            &[
                "--set rays.max_segment=3:1:1: unknown key `max_segment`",
                "use `max_segments`",
                "\n    rays.max_segment=3\n    ^^^^^^^^^^^^^^^^\n",
            ],
        ),
        ("--set imag.size=3", &["--set imag.size=3:1:1: unknown key `imag`", "use `image`"]),
        ("--set rays.bounding_sphere.radius=nan", &["--set rays.bounding_sphere.radius=nan:1:29: not a finite number"]),
        (
            "--set rays.bounding_sphere=abc",
            &[":1:22: expected a table, found the string \"abc\"", "bounding_sphere = { radius = 50 }"],
        ),
        (
            "--set rays.bounding_sphere=7.5",
            &[":1:22: expected a table, found a number", "for example bounding_sphere = { radius = 7.5 }"],
        ),
        ("--set objects.3.radius=1", &[":1:1: `objects` has 1 entry, counted from 0, and no `3`"]),
        ("--set image.samples=0", &["--set image.samples=0:1:15: expected a whole number from 1 to 1048576, found 0"]),
    ];
    for (arguments, texts) in cases {
        folder.run(&format!("render scene.toml -o a.png {arguments}")).fails(1, texts).says(&["1 error"]);
    }
    assert_eq!(folder.text("a.png"), "an old picture");
    assert_eq!(folder.names(), ["a.png", "scene.toml"]);
}

#[test]
fn a_device_that_is_not_there_is_answered_with_those_that_are() {
    let folder = Folder::with(BALL);
    folder.write("a.png", "an old picture");
    folder.write("rays.csv", "x,y,z,vx,vy,vz\n0,0,5,0,0,-1\n");
    let devices = folder.run("devices").succeeds().out;
    let texts = ["no device named `nosuch`; available: ", devices.split_whitespace().next().unwrap()];
    folder.run("render scene.toml -o a.png --device nosuch").fails(1, &texts);
    folder.run("trace scene.toml --rays rays.csv -o a.png --device nosuch").fails(1, &texts);
    assert_eq!(folder.text("a.png"), "an old picture");
    assert_eq!(folder.names(), ["a.png", "rays.csv", "scene.toml"]);
}
