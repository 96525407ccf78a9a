//! Tests `farm`: the scripts that it writes for queues run as a queue would run them.

use std::process::Command;

use super::{BALL, Folder, Ran};

const FILM: &str = "[law]\nkind = \"schwarzschild\"\nmass = 0.2\n[animation]\nframes = 3\n\
    [[animation.tracks]]\nkey = \"camera.position\"\nvalues = [[0, 0, 5], [1, 0, 5]]\n";

/// Runs a script that `farm` wrote as a queue runs it for one part.
fn script(folder: &Folder, name: &str, variables: &[(&str, &str)]) -> Ran {
    let mut command = Command::new("bash");
    command.arg(name).current_dir(folder.path(".")).env("BENTRAY_CACHE", "");
    let output = command.envs(variables.iter().copied()).output().unwrap();
    Ran {
        code: output.status.code(),
        out: String::from_utf8(output.stdout).unwrap(),
        err: String::from_utf8(output.stderr).unwrap(),
    }
}

/// Checks five parts of a video of three frames, so that some frames are cut in two.
#[test]
fn parts_of_a_film_come_together_to_the_byte() {
    let folder = Folder::with(&format!("{BALL}{FILM}"));
    let job = "scene.toml -o film_{frame}.exr -o film_{frame}.png --frames all --samples 2";
    folder.run(&format!("render {job}")).succeeds();
    let names = ["film_0.exr", "film_0.png", "film_1.exr", "film_1.png", "film_2.exr", "film_2.png"];
    let at_once = names.map(|name| folder.read(name));
    for name in names {
        std::fs::remove_file(folder.path(name)).unwrap();
    }
    let wrote = folder.run(&format!("farm slurm {job} --parts 5 --sbatch=--time=5")).succeeds();
    assert!(wrote.out.contains("submit with `bash scene.farm/submit.sh`"), "{}", wrote.out);
    let parts = folder.text("scene.farm/parts.sh");
    assert!(parts.contains("#SBATCH --array=1-5\n") && parts.contains("#SBATCH --time=5\n"), "{parts}");
    let status = |more: &str| folder.run(&format!("farm status {job} --parts 5 {more}")).succeeds().out;
    assert_eq!(status(""), "0 of 5 parts are done\nnot started: 5 (1-5)\n");
    let run = |part: &str| script(&folder, "scene.farm/parts.sh", &[("SLURM_ARRAY_TASK_ID", part)]);
    for part in ["1", "2", "3", "5"] {
        assert_eq!(run(part).code, Some(0));
    }
    folder.write("scene.farm/part-4.log", run("6").err + "part failed: exit code 1\n");
    let said = status("");
    assert!(said.starts_with("4 of 5 parts are done\nfailed: 1 (4)\npart 4: error: --part auto: Slurm"), "{said}");
    assert!(status("--set sky.color=[0,0,1]").starts_with("0 of 5 parts are done\n"));
    let finish = |more: &str| folder.run(&format!("farm finish {job} --parts 5 {more}"));
    finish("").fails(1, &["1 of 5 parts are missing or belong to another scene: 4; run them again"]);
    assert_eq!(run("4").code, Some(0));
    assert!(run("4").err.lines().all(|line| !line.contains(" rays, ")), "rendered again");
    let finished = script(&folder, "scene.farm/finish.sh", &[]);
    assert_eq!((finished.code, finished.out.as_str()), (Some(0), "3 images, all present and consistent\n"));
    assert!(names.map(|name| folder.read(name)) == at_once);
    assert_eq!(status(""), "5 of 5 parts are done\n");
    // Files of another scene do not count as parts of this one.
    finish("--set sky.color=[0,0,1]").fails(1, &["5 of 5 parts are missing or belong to another scene: 1-5"]);
}

#[test]
fn kubernetes_has_manifests() {
    let folder = Folder::with(BALL);
    let wrote = folder.run("farm kubernetes scene.toml -o a.exr --parts 4 --image x/bentray --volume work --at-once 9");
    assert!(wrote.succeeds().out.contains("kubectl apply -f scene.farm/parts.json"));
    let manifest = |name: &str| serde_json::from_str::<serde_json::Value>(&folder.text(name)).unwrap();
    let parts = manifest("scene.farm/parts.json");
    assert_eq!((&parts["spec"]["completions"], &parts["spec"]["parallelism"]), (&4.into(), &4.into()));
    let command = &parts["spec"]["template"]["spec"]["containers"][0]["command"];
    assert_eq!(*command, serde_json::json!(["bentray", "render", "scene.toml", "-o", "a.exr", "--part", "auto/4"]));
    let last = manifest("scene.farm/finish.json");
    let command = &last["spec"]["template"]["spec"]["containers"][0]["command"];
    let finish = ["bentray", "farm", "finish", "scene.toml", "-o", "a.exr", "--parts", "4"];
    assert_eq!(*command, serde_json::json!(finish));
}

#[test]
#[ignore = "needs GNU parallel"]
fn parts_come_together_with_parallel() {
    let folder = Folder::with(BALL);
    folder.run("farm parallel scene.toml -o a.exr -o b.png --parts 3 --at-once 2").succeeds();
    folder.run("render scene.toml -o a.exr -o b.png").succeeds();
    let at_once = ["a.exr", "b.png"].map(|name| folder.read(name));
    let ran = script(&folder, "scene.farm/run.sh", &[]);
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    assert!(["a.exr", "b.png"].map(|name| folder.read(name)) == at_once);
}

#[test]
fn jobs_that_cannot_be_are_refused_before_anything_is_written() {
    let folder = Folder::with(BALL);
    for (arguments, code, text) in [
        ("slurm scene.toml -o a.exr", 2, "--parts <N>"),
        ("slurm scene.toml -o a.exr --parts 0", 2, "'--parts <N>'"),
        ("slurm scene.toml -o a.exr --parts 13", 1, "there are more parts than the 12 rows of each image"),
        ("slurm none.toml -o a.exr --parts 3", 1, "cannot read `none.toml`"),
        ("slurm scene.toml -o no/a.exr --parts 3", 1, "the folder no does not exist"),
        ("slurm scene.toml -o a.exr --parts 3 --crop 0,0,4x4", 1, "--crop cannot be used with `farm`"),
        ("status scene.toml -o a.exr --parts 3 --part 1/3", 1, "--part cannot be used with `farm`"),
        ("kubernetes scene.toml -o a.exr --parts 3", 2, "--image <IMAGE>"),
        ("slurm scene.toml -o a.exr --parts 3 --submit", 1, "submit.sh: sbatch failed"),
    ] {
        let ran = folder.command(&format!("farm {arguments}")).env("PATH", "/bin").env_remove("SLURM_CONF").output();
        let ran = ran.unwrap();
        assert_eq!(ran.status.code(), Some(code), "{arguments}");
        let said = String::from_utf8(ran.stderr).unwrap();
        assert!(said.contains(text), "no `{text}` in:\n{said}");
        if !arguments.contains("--submit") {
            assert_eq!(folder.names(), ["scene.toml"], "{arguments}");
        }
    }
}
