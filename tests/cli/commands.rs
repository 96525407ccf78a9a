//! `check`, `wgsl`, `devices` and `new`, and the help of all commands.

use std::path::Path;

use bentray::scene::REFERENCE;

use super::{BALL, Folder};
use crate::support::shipped_scenes;

#[test]
fn check_counts_the_bytes_of_every_shipped_scene() {
    let folder = Folder::new();
    let scenes = shipped_scenes();
    let names: Vec<_> = scenes.iter().map(|path| path.display().to_string()).collect();
    let ran = folder.run(&format!("check {}", names.join(" "))).succeeds();
    assert_eq!(ran.err, "");
    let bytes: Vec<u32> = ran
        .out
        .lines()
        .filter_map(|line| line.split_once(" bytes per pixel: "))
        .map(|(total, items)| {
            let total: u32 = total.trim().parse().unwrap();
            let items = items.split(", ").map(|item| item.rsplit_once(' ').unwrap().1);
            assert_eq!(items.map(|n| n.parse::<u32>().unwrap()).sum::<u32>(), total);
            total
        })
        .collect();
    assert_eq!(bytes.len(), scenes.len());
    // Stars have a grid of rays, and the light of the cells between them.
    let most = |path: &Path| if std::fs::read_to_string(path).unwrap().contains("stars.csv") { 100 + 244 } else { 100 };
    assert!(scenes.len() >= 7 && bytes.iter().zip(&scenes).all(|(n, path)| *n <= most(path)), "{bytes:?}");
    for name in names {
        assert!(ran.out.contains(&format!("{name}: ")), "{name}");
    }
}

#[test]
fn check_goes_through_all_scenes_before_it_fails() {
    let folder = Folder::with(BALL);
    folder.write("typo.toml", BALL.replace("sky", "skye"));
    folder.write("zero.toml", BALL.replace("16", "0"));
    let ran = folder.run("check typo.toml scene.toml nope.toml zero.toml");
    assert_eq!(ran.code, Some(1));
    assert!(ran.out.starts_with("scene.toml: 16×12, "), "{}", ran.out);
    assert!(ran.out.contains("\n  pass whole "), "{}", ran.out);
    let ran = ran.says(&["typo.toml:8:2: unknown key `skye`", "cannot read `nope.toml`", "zero.toml:3:9: "]);
    assert_eq!(ran.err.matches("error: ").count(), 3);

    // Every schedule and every change is checked as it would be rendered.
    let passes = |more: &str| {
        let ran = folder.run(&format!("check scene.toml {more}")).succeeds();
        ran.out.lines().filter(|line| line.starts_with("  pass ")).count()
    };
    assert!(passes("--schedule paper --set rays.method=rk4") > passes(""));
    // A black hole that spins too fast for a horizon is allowed and reported.
    for (spin, said) in [("0.9", false), ("1.1", true)] {
        let ran = folder.run(&format!("check scene.toml --set law={{kind=\"kerr-newman\",spin={spin}}}")).succeeds();
        assert_eq!(ran.out.contains("no horizon"), said, "{}", ran.out);
    }
    // A line element that is not a space everywhere is also allowed and reported.
    for (element, said) in [("-dt^2 + dx^2 + dy^2 + dz^2", false), ("-dt^2 + (8 - r)*dx^2 + dy^2 + dz^2", true)] {
        let law = format!("law={{kind=\"metric\",line_element=\"{}\",scale=\"3\"}}", element.replace(' ', ""));
        let ran = folder.run(&format!("check scene.toml --set {law}")).succeeds();
        assert_eq!(ran.out.contains("not have the signature −+++"), said, "{}", ran.out);
    }
    let ran = folder.run("check scene.toml --size 800x600 --samples 9").succeeds();
    assert!(ran.out.starts_with("scene.toml: 800×600, samples 9"), "{}", ran.out);
}

#[test]
fn a_scene_in_a_commands_place_is_to_be_rendered() {
    let ran = Folder::new().run("scene.toml");
    assert_eq!((ran.code, ran.out.as_str()), (Some(2), ""));
    ran.says(&["unrecognized subcommand 'scene.toml'", "to render a scene: bentray render scene.toml -o picture.png"]);
    let helped = Folder::new().run("--help").succeeds();
    assert!(helped.out.contains("Usage: bentray") && helped.err.is_empty());
}

#[test]
fn check_prints_every_key() {
    let ran = Folder::new().run("check --reference").succeeds();
    assert_eq!(ran.err, "");
    for key in REFERENCE.iter() {
        assert!(ran.out.contains(&format!("\n| `{}` | ", key.key)), "{}", key.key);
        assert!(ran.out.contains(&format!("[{}]", key.table)) || key.table.is_empty(), "{}", key.table);
    }
}

/// A schedule is data: the dispatches of a sample can be listed before anything runs.
#[test]
fn check_lists_the_dispatches_of_a_sample() {
    let folder = Folder::with(BALL);
    let listed = |schedule: &str| {
        let said = folder.run(&format!("check scene.toml --commands --schedule {schedule}")).succeeds().out;
        let lines = said.lines().skip_while(|line| !line.ends_with(" commands per sample, in order:")).map(str::trim);
        let lines: Vec<String> =
            lines.take_while(|line| !line.contains("bytes per pixel")).map(str::to_owned).collect();
        assert_eq!(lines[0].split(' ').next().unwrap(), (lines.len() - 1).to_string(), "{said}");
        lines[1..].to_vec()
    };
    let whole = listed("whole");
    assert!(whole.len() == 1 && whole[0].starts_with("whole "), "{whole:?}");
    let fused = listed("fused");
    let passes: Vec<&str> = fused.iter().map(|line| line.split(' ').next().unwrap()).collect();
    assert!(passes[0] == "setup" && passes[1] == "advance" && passes.last() == Some(&"shade"), "{passes:?}");
    // The state alternates between two copies.
    assert!(fused[1].contains("state 0 -> 1") && fused[2].contains("state 1 -> 0"), "{fused:?}");
}

#[test]
fn wgsl_prints_each_pass_with_the_files_over_the_pieces() {
    let folder = Folder::with(BALL);
    let ran = folder.run("wgsl scene.toml --for-device gpu").succeeds();
    assert_eq!(ran.err, "");
    let passes: Vec<&str> = ran.out.split("// ==== pass ").skip(1).collect();
    let checked = folder.run("check scene.toml --parts").succeeds().out;
    let listed: Vec<&str> = checked.lines().filter(|line| line.starts_with("  pass ")).collect();
    assert_eq!(passes.len(), listed.len());
    for (pass, listed) in passes.iter().zip(listed) {
        let name = pass.split_whitespace().next().unwrap();
        assert!(listed.starts_with(&format!("  pass {name} ")), "{listed}");
        assert!(pass.contains(&format!("fn {name}(")), "{name} is its entry point");
        let files: Vec<&str> = pass.lines().filter_map(|line| line.strip_prefix("// ---- ")).collect();
        let (_, parts) = listed.split_once(" modules: ").unwrap();
        assert_eq!(files.join(" "), parts);
        assert!(listed.contains(&format!("{:>2} modules: ", files.len())), "{listed}");
        // Without the line with the name of the pass, the output is a valid program.
        let source = pass.split_once('\n').unwrap().1;
        naga::front::wgsl::parse_str(source).unwrap_or_else(|e| panic!("{}", e.emit_to_string(source)));
    }
    let one = folder.run("wgsl scene.toml --schedule fused --pass shade").succeeds();
    assert_eq!(one.out.matches("// ==== pass ").count(), 1);
    assert!(one.out.starts_with("// ==== pass shade\n"));
}

#[test]
fn devices_are_listed_with_what_they_can_do() {
    let ran = Folder::new().run("devices").succeeds();
    for text in ["driver", "largest texture", "storage textures", "timestamps", "f64"] {
        assert!(ran.out.contains(text), "no `{text}` in {}", ran.out);
    }
    // Any part of the name selects the device, in upper or lower case.
    let name = ran.out.split_whitespace().next().unwrap();
    let folder = Folder::with(BALL);
    let ran = folder.run(&format!("render scene.toml -o a.png --device {}", name.to_uppercase())).succeeds();
    ran.says(&[&format!("device: {name}")]);
}

#[test]
fn a_new_scene_is_right_and_replaces_nothing() {
    let folder = Folder::new();
    let ran = folder.run("new mine.toml").succeeds();
    assert!(ran.out.contains("mine.toml") && ran.out.contains("bentray render"), "{}", ran.out);
    folder.run("check mine.toml").succeeds();
    folder.run("render mine.toml -o a.png --size 16x12 --samples 1 --strict").succeeds();
    folder.write("mine.toml", "my own words");
    folder
        .run("new mine.toml")
        .fails(1, &["mine.toml: the file exists already; name another file, or remove it first"]);
    assert_eq!(folder.text("mine.toml"), "my own words");
    assert_eq!(folder.names(), ["a.png", "mine.toml"]);
}

#[cfg(unix)]
#[test]
fn a_reader_that_goes_away_is_no_fault() {
    use std::process::Stdio;
    let folder = Folder::with(BALL);
    for arguments in ["check scene.toml", "check --reference", "wgsl scene.toml", "devices", "help scenes", "help"] {
        let mut command = folder.command(arguments);
        let mut child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        // This is the behavior of `| head`.
        drop(child.stdout.take());
        let ended = child.wait_with_output().unwrap();
        let message = String::from_utf8(ended.stderr).unwrap();
        assert!(!message.contains("panicked"), "{arguments}: {message}");
        assert!(matches!(ended.status.code(), Some(0 | 1)), "{arguments}: {}", ended.status);
    }
}

#[test]
fn help_names_every_option() {
    let folder = Folder::new();
    let scene = "--set <KEY=VALUE>; --size <WxH>; --samples <N>";
    let device =
        "--device <NAME>; --schedule <SCHEDULE>; --no-early-termination; --no-compaction; --segments-per-pass <K>";
    let cases = [
        ("", "render; check; trace; devices; wgsl; new; --version"),
        ("render", &format!("<SCENE>; -o, --output <FILE>; --layers <LAYER>; --strict; {scene}; {device}")),
        ("check", &format!("[SCENES]...; --reference; --schedule <SCHEDULE>; {scene}")),
        (
            "trace",
            &format!("<SCENE>; --rays <FILE>; -o, --output <FILE>; --path; --plot <FILE>; --set <KEY=VALUE>; {device}"),
        ),
        ("devices", "Usage: bentray devices"),
        ("wgsl", "<SCENE>; --pass <PASS>; --schedule <SCHEDULE>; --set <KEY=VALUE>"),
        ("new", "<FILE>"),
    ];
    for (command, options) in cases {
        let help = folder.run(&format!("{command} --help")).succeeds().out;
        for option in options.split("; ") {
            assert!(help.contains(option), "no `{option}` in the help of {command}:\n{help}");
        }
    }
    let version = folder.run("--version").succeeds().out;
    assert_eq!(version.trim(), concat!("bentray ", env!("CARGO_PKG_VERSION")));
}

/// Everything that a new user is referred to works at once.
#[test]
fn templates_are_written_and_render() {
    let folder = Folder::new();
    for name in ["black-hole", "kerr", "lens", "force", "flow", "paths"] {
        let wrote = folder.run(&format!("new {name}.toml --template {name}")).succeeds();
        assert!(wrote.out.contains(&format!("bentray render {name}.toml -o picture.png")), "{}", wrote.out);
        let ran = folder.run(&format!("render {name}.toml -o {name}.png --size 24x16 --samples 2 --strict")).succeeds();
        assert!(!ran.err.contains("warning"), "{name}: {}", ran.err);
    }
    assert_eq!(folder.text("black-hole.toml"), {
        folder.run("new usual.toml").succeeds();
        folder.text("usual.toml")
    });
    folder
        .run("new other.toml --template hole")
        .fails(2, &["[possible values: black-hole, kerr, lens, force, flow, paths]"]);
}

#[test]
fn shells_man_and_doctors_are_served() {
    let folder = Folder::new();
    for (shell, text) in [("bash", "_bentray()"), ("zsh", "#compdef bentray"), ("fish", "complete -c bentray")] {
        assert!(folder.run(&format!("completions {shell}")).succeeds().out.contains(text), "{shell}");
    }
    let page = folder.run("man").succeeds().out;
    assert!(page.contains(".TH bentray 1"));
    // `make release` reads the list of pages there.
    let others = page.lines().filter_map(|line| line.strip_prefix("bentray\\-")?.strip_suffix("(1)"));
    let others: Vec<&str> = others.collect();
    assert!(others.len() > 10 && others.contains(&"render"), "{others:?}");
    for name in others {
        assert!(folder.run(&format!("man {name}")).succeeds().out.contains(&format!(".TH bentray-{name} 1")), "{name}");
    }
    let page = folder.run("man render").succeeds().out;
    assert!(page.contains(".TH bentray-render 1") && page.contains("\\-\\-frames"), "{page}");
    folder.run("man nothing").fails(1, &["unknown command `nothing`: run `bentray help` for a list"]);
    let said = folder.run("doctor").succeeds().out;
    for line in ["device       ", "64 bits      ", "video        ", "cache        none: every render", "farm         "]
    {
        assert!(said.contains(line), "no `{line}` in:\n{said}");
    }
    let mut without = folder.command("doctor");
    let said = without.env("PATH", "").env("BENTRAY_CACHE", "kept").output().unwrap();
    let said = String::from_utf8(said.stdout).unwrap();
    assert!(said.contains("video        no ffmpeg: ") && said.contains("cache        kept\n"), "{said}");
    let mut without = folder.command("doctor");
    let said = without.env("VK_DRIVER_FILES", "none.json").env("VK_ICD_FILENAMES", "none.json").output().unwrap();
    assert_eq!(said.status.code(), Some(1));
    let said = String::from_utf8(said.stdout).unwrap();
    assert!(said.contains("device       none: no Vulkan, Metal or DX12 device found; to render on the CPU"), "{said}");
}
