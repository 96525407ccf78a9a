//! Tests `--json`: scripts and people get the same values.

use std::collections::BTreeSet;

use serde_json::Value;

use super::{BALL, Folder, Ran};

const FILM: &str = "[animation]\nframes = 3\nrate = 12\n[[animation.tracks]]\nkey = \"sky.color\"\n\
    values = [[0, 0, 0], [1, 1, 1]]\n";
/// A light whose shadows are in a grid.
const GRID: &str = "[image]\nsize = [16, 12]\n[camera]\nposition = [0, 1, 6]\n[rays]\nbounding_sphere = { radius = 9 }\n\
    [materials.m]\ndiffuse = [1, 1, 1]\n[[objects]]\nshape = \"box\"\nmaterial = \"m\"\nsize = [4, 0.2, 4]\n\
    [[lights]]\nkind = \"point\"\nposition = [0, 2, 0]\nfalloff = \"inverse-square\"\nshadows = \"photon-grid\"\nvoxels = 16\n";
const HOLE: &str = "--set law.kind=schwarzschild --set law.mass=0.2 --set rays.method=rk4";

impl Ran {
    /// Returns the objects on stdout, one per line, and checks that there is nothing else.
    #[track_caller]
    fn objects(&self) -> Vec<Value> {
        let object = |line: &str| serde_json::from_str(line).unwrap_or_else(|error| panic!("{error}: {line}"));
        let objects: Vec<Value> = self.out.lines().map(object).collect();
        assert!(objects.iter().all(Value::is_object), "{}", self.out);
        objects
    }

    /// Returns the only object.
    #[track_caller]
    fn object(&self) -> Value {
        let objects = self.objects();
        assert_eq!(objects.len(), 1, "{}", self.out);
        objects.into_iter().next().unwrap()
    }

    /// Returns the line on stderr that contains this text.
    #[track_caller]
    fn line(&self, text: &str) -> &str {
        self.err.lines().find(|line| line.contains(text)).unwrap_or_else(|| panic!("no `{text}` in {}", self.err))
    }
}

fn sum(of: &Value) -> f64 {
    of.as_object().unwrap().values().map(|value| value.as_f64().unwrap()).sum()
}

#[test]
fn a_render_has_the_numbers_of_its_words() {
    let folder = Folder::with(BALL);
    let ran = folder.run(&format!("render scene.toml -o a.png -o a.exr --samples 4 {HOLE} --json")).succeeds();
    let picture = ran.object();
    assert_eq!((&picture["scene"], &picture["frame"]), (&"scene.toml".into(), &Value::Null));
    assert_eq!((&picture["files"], &picture["rendered"]), (&vec!["a.png", "a.exr"].into(), &true.into()));
    assert_eq!((&picture["size"], &picture["origin"]), (&vec![16, 12].into(), &vec![0, 0].into()));
    assert_eq!((&picture["rays"], &picture["samples"]), (&(16 * 12 * 4).into(), &4.into()));
    assert_eq!((sum(&picture["terminations"]), &picture["unresolved_rays"]), (16.0 * 12.0 * 4.0, &0.into()));
    let words = ran.line(" rays, ");
    assert!(words.starts_with(&format!("768 rays, {} steps, {} segments, ", picture["steps"], picture["segments"])));
    for (end, count) in picture["terminations"].as_object().unwrap() {
        assert_eq!(words.contains(&format!(" {end} {count}")), *count != 0, "{words}");
    }
    assert!(words.contains(&format!(", {:.3} s in total;", picture["seconds"].as_f64().unwrap())), "{words}");
    assert!(words.contains(&format!(", {:.3} s on the device,", sum(&picture["device_seconds"]))), "{words}");
    assert!(ran.line("first pixel").starts_with(&format!("first pixel after {:.3} s", sum(&picture["start_seconds"]))));
    assert_eq!(ran.line("reproduce with: "), format!("reproduce with: {}", picture["command"].as_str().unwrap()));
    assert!(!ran.err.contains("--json"), "{}", ran.err);
    let followed = &picture["integrator"];
    assert_eq!((&followed["method"], &followed["precision"]), (&"rk4".into(), &"f32".into()));
    assert!(followed["scaled_step"].as_f64().unwrap() > 0.0 && followed["max_segments"].is_u64(), "{followed}");
    // The files do not depend on `--json`.
    let with = folder.read("a.exr");
    folder.run(&format!("render scene.toml -o a.png -o a.exr --samples 4 {HOLE}")).succeeds();
    assert!(folder.read("a.exr") == with);
}

#[test]
fn frames_have_a_line_each_and_so_has_their_film() {
    let folder = Folder::with(&format!("{BALL}{FILM}"));
    let render = |frames: &str| {
        folder.run(&format!("render scene.toml -o film.png -o {{frame}}.png --frames {frames} --json")).succeeds()
    };
    let kept = render("0..1").objects();
    assert_eq!(kept.iter().map(|line| &line["frame"]).collect::<Vec<_>>(), [&0.into(), &1.into(), &Value::Null]);
    let lines = render("all").objects();
    let [frames @ .., film] = lines.as_slice() else { panic!("{lines:?}") };
    assert_eq!(
        frames.iter().map(|frame| frame["rendered"].as_bool()).collect::<Vec<_>>(),
        [false, false, true].map(Some)
    );
    for (i, frame) in frames.iter().enumerate() {
        assert_eq!((&frame["frame"], &frame["files"]), (&i.into(), &vec![format!("{i}.png")].into()));
        assert!(frame["rays"].is_null() == (i < 2), "{frame}");
    }
    assert_eq!(*film, serde_json::json!({ "video": "film.png", "frames": 3, "frames_per_second": 12.0 }));
}

#[test]
fn what_could_not_be_followed_is_counted_and_fails_as_ever() {
    let folder = Folder::with(BALL);
    let ran = folder.run(&format!("render scene.toml -o a.png {HOLE} --set rays.max_segments=2 --strict --json"));
    let picture = ran.object();
    assert!(ran.code == Some(1) && picture["unresolved_rays"].as_u64().unwrap() > 0, "{}", ran.out);
    assert_eq!(picture["unresolved_rays"], picture["terminations"]["exhausted"]);
    ran.line("reached rays.max_segments");
    folder.run("render nope.toml -o a.png --json").fails(1, &["cannot read `nope.toml`"]);
    folder.run("render scene.toml -o a.png --device none --json").fails(1, &["none"]);
}

#[test]
fn an_error_that_is_measured_is_in_the_picture_alone() {
    let folder = Folder::with(BALL);
    let line = format!("render scene.toml -o a.png {HOLE} --verify 40");
    let words = folder.run(&line).succeeds().out;
    let found = &folder.run(&format!("{line} --json")).succeeds().object()["verification"];
    assert!(
        words.starts_with(&format!("verified {} rays against a reference solution (f64", found["rays"])),
        "{words}"
    );
    assert!(words.contains(&format!("{} with a wrong end", found["wrong_terminations"])), "{words}");
    let number = |key: &str| found["angle_radians"][key].as_f64().unwrap();
    assert!(number("median") <= number("p99") && number("p99") <= number("max"), "{found}");
    assert!(words.contains(&format!("{:.2e}", number("max"))), "{words}");
}

#[test]
fn scenes_are_checked_a_line_each_with_the_place_of_every_mistake() {
    let folder = Folder::with(&format!("{BALL}{FILM}"));
    folder.write("typo.toml", BALL.replace("sky", "skye").replace("red\"", "rod\""));
    let scenes = "scene.toml typo.toml nope.toml";
    let [words, ran] = ["", "--json"].map(|more| folder.run(&format!("check {scenes} {more}")));
    assert_eq!((ran.code, &ran.err), (Some(1), &words.err));
    let objects = ran.objects();
    let [right, typo, nope] = objects.as_slice() else { panic!("{}", ran.out) };

    assert_eq!((&right["scene"], &right["errors"]), (&"scene.toml".into(), &Value::Array(Vec::new())));
    assert_eq!((&right["frames"], &right["animated"]), (&3.into(), &vec!["sky.color"].into()));
    assert_eq!(sum(&right["bytes_per_pixel_of"]), right["bytes_per_pixel"].as_f64().unwrap());
    assert!(words.out.contains(&format!("  {} bytes per pixel: ", right["bytes_per_pixel"])), "{}", words.out);
    for pass in right["passes"].as_array().unwrap() {
        let number = |key: &str| pass[key].as_u64().unwrap();
        let line = format!("{:>4} lines, {:>2} bindings, ", number("lines"), number("bindings"));
        assert!(words.out.contains(&line), "{line} in {}", words.out);
    }

    let text = folder.text("typo.toml");
    let mistakes = typo["errors"].as_array().unwrap();
    assert_eq!(words.err.matches("\n    help: ").count(), mistakes.len());
    for mistake in mistakes {
        let number = |key: &str| mistake[key].as_u64().unwrap() as usize;
        let (line, column, excerpt) = (number("line"), number("column"), mistake["excerpt"].as_str().unwrap());
        let place = format!("{}:{line}:{column}: ", mistake["file"].as_str().unwrap());
        assert!(words.err.contains(&format!("{place}{}", mistake["problem"].as_str().unwrap())), "{mistake}");
        assert!(text.lines().nth(line - 1).unwrap()[column - 1..].starts_with(excerpt), "{mistake}");
        assert!(words.err.contains(mistake["help"].as_str().unwrap()), "{mistake}");
    }
    assert_eq!(mistakes.iter().map(|mistake| &mistake["excerpt"]).collect::<Vec<_>>(), ["skye", "\"rod\""]);

    let unread = &nope["errors"][0];
    assert_eq!((&unread["file"], &unread["line"]), (&"nope.toml".into(), &Value::Null));
    assert!(unread["problem"].as_str().unwrap().starts_with("cannot read `nope.toml`"), "{unread}");
    let reference = folder.run("check --reference --json").succeeds().object();
    assert_eq!(reference["keys"].as_array().unwrap().len(), bentray::scene::REFERENCE.len());
}

#[test]
fn devices_and_what_is_there_are_listed() {
    let folder = Folder::new();
    let found = folder.run("devices --json").succeeds().object();
    let words = folder.run("devices").succeeds().out;
    for device in found["devices"].as_array().unwrap() {
        let text = |key: &str| device[key].as_str().unwrap();
        assert!(words.contains(&format!("{} ({}, {})\n", text("name"), text("kind"), text("backend"))), "{words}");
        let mebibytes = device["buffer_bytes"].as_u64().unwrap() >> 20;
        assert!(words.contains(&format!(" {mebibytes} MiB\n")), "{words}");
        assert!(words.contains(&format!(" {0} × {0}\n", device["texture_side_pixels"])), "{words}");
    }
    let doctor = |path: &str, cache: &str| {
        let output = folder.command("doctor --json").env("PATH", path).env("BENTRAY_CACHE", cache).output().unwrap();
        assert!(output.status.success());
        serde_json::from_slice::<Value>(&output.stdout).unwrap()
    };
    let bare = doctor("", "");
    assert_eq!((&bare["devices"], &bare["video"]), (&found["devices"], &false.into()));
    assert_eq!((&bare["cache"], &bare["queues"]), (&Value::Null, &Value::Array(Vec::new())));
    let cache = &doctor("", "kept")["cache"];
    assert_eq!((&cache["folder"], &cache["writable"]), (&"kept".into(), &true.into()));
    folder.write("file", "no folder");
    assert_eq!(doctor("", "file/kept")["cache"]["writable"], false);
    let mut none = folder.command("doctor --json");
    let none = none.env("VK_DRIVER_FILES", "none.json").env("VK_ICD_FILENAMES", "none.json").output().unwrap();
    assert_eq!(none.status.code(), Some(1));
    assert_eq!(serde_json::from_slice::<Value>(&none.stdout).unwrap()["devices"], Value::Array(Vec::new()));
}

#[test]
fn a_farm_says_what_to_run_and_which_parts_are_done() {
    let folder = Folder::with(&format!("{BALL}{FILM}"));
    let job = "scene.toml -o {frame}.png --frames all --parts 3 --json";
    let wrote = folder.run(&format!("farm slurm {job}")).succeeds().object();
    let files = ["parts.sh", "finish.sh", "submit.sh"].map(|name| format!("scene.farm/{name}"));
    assert_eq!(
        (&wrote["files"], &wrote["commands"]),
        (&files.to_vec().into(), &vec!["bash scene.farm/submit.sh"].into())
    );
    assert!(!folder.text("scene.farm/parts.sh").contains("--json"), "nothing reads the output of a part");
    folder.run("render scene.toml -o {frame}.png --frames all --part 2/3").succeeds();
    folder.write("scene.farm/part-1.log", "error: no room\npart failed: exit code 1\n");
    folder.write("scene.farm/part-3.log", "device: x\n");
    let status = folder.run(&format!("farm status {job}")).succeeds().object();
    let parts = serde_json::json!([
        { "part": 1, "state": "failed", "error": "error: no room" },
        { "part": 2, "state": "done", "error": null },
        { "part": 3, "state": "running", "error": null },
    ]);
    assert_eq!(status["parts"], parts);
    assert_eq!(status["count"], serde_json::json!({ "done": 1, "failed": 1, "running": 1, "pending": 0 }));
    folder.run("render scene.toml -o {frame}.png --frames all").succeeds();
    let whole = folder.run(&format!("farm finish {job}")).succeeds().object();
    assert_eq!((&whole["images"], &whole["files"]), (&3.into(), &vec!["0.png", "1.png", "2.png"].into()));
}

/// Keys whose members have foreign names: keys of scenes, statuses, buffers, columns.
const NAMES: [&str; 4] = ["integrator", "terminations", "bytes_per_pixel_of", "tables"];

/// Collects all keys of a value, at any depth.
fn keys(value: &Value, found: &mut BTreeSet<String>) {
    match value {
        Value::Array(all) => all.iter().for_each(|value| keys(value, found)),
        Value::Object(all) => {
            for (key, value) in all {
                found.insert(key.clone());
                if !NAMES.contains(&key.as_str()) {
                    keys(value, found);
                }
            }
        }
        _ => {}
    }
}

/// A volume that shines at one frequency.
const GLOW: &str = "image = { size = [4, 4] }\n[camera]\nposition = [0, 0, 9]\n[rays]\nbounding_sphere = { radius = 20 }\n\
                    [radiation]\nfrequencies = [1]\n[[volumes]]\nshape = \"sphere\"\nemission = 1\n";

/// A sky with one star.
const STARS: &str = "image = { size = [4, 4] }\n[camera]\nposition = [0, 0, 9]\n[rays]\nbounding_sphere = { radius = 20 }\n\
                     [sky]\nstars = \"stars.csv\"\n";

/// The manual's page names every key that is printed, and no other key.
#[test]
fn every_key_is_in_the_guide_and_no_other() {
    let folder = Folder::with(&format!("{BALL}{FILM}"));
    folder.write("grid.toml", GRID);
    folder.write("typo.toml", BALL.replace("sky", "skye"));
    folder.write("glow.toml", GLOW);
    folder.write("stars.toml", STARS);
    folder.write("stars.csv", "ra,dec,mag\n0,0,1\n");
    let job = "scene.toml -o {frame}.png --frames all --parts 3";
    let mut printed = BTreeSet::new();
    for line in [
        "devices",
        "check --reference",
        "check scene.toml grid.toml stars.toml typo.toml",
        "check scene.toml --set units.length=1km --set units.distance=1kpc",
        "render grid.toml -o a.png --set image.adaptive=0.05 --samples 16",
        "render scene.toml -o a.png --set rays.lighting=path-tracing --set output.clamp=1 --samples 2",
        "render scene.toml -o a.png --verify 9",
        "render glow.toml -o a.png",
        "render stars.toml -o a.png",
        "render scene.toml -o film.gif --frames 0..1",
        "bench compaction scene.toml --size 16x16 --repeats 1",
        &format!("farm slurm {job}"),
        &format!("farm status {job}"),
    ] {
        folder.run(&format!("{line} --json")).objects().iter().for_each(|object| keys(object, &mut printed));
    }
    let doctor = folder.command("doctor --json").env("BENTRAY_CACHE", "kept").output().unwrap();
    keys(&serde_json::from_slice(&doctor.stdout).unwrap(), &mut printed);
    folder.run("render scene.toml -o {frame}.png --frames all").succeeds();
    keys(&folder.run(&format!("farm finish {job} --json")).succeeds().object(), &mut printed);

    let page = bentray::guide::pages().find(|page| page.name == "json").unwrap().text;
    let prose: String = page.split("```").step_by(2).collect();
    let is_key = |word: &&str| word.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_');
    let said: BTreeSet<String> = prose.split('`').skip(1).step_by(2).filter(is_key).map(str::to_owned).collect();
    // Other names on the page: commands, and another page.
    let others = ["check", "doctor", "kubernetes", "parallel", "performance"].map(str::to_owned).into();
    let said: BTreeSet<String> = said.difference(&others).cloned().collect();
    assert_eq!(printed, said);
}
