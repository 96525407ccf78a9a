//! Tests with a real Slurm installation: two nodes on this machine, one of which fails during the work.

use std::fs::{self, Permissions};
use std::os::unix::fs::PermissionsExt;
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use super::{BALL, Folder};

const FILM: &str = "[law]\nkind = \"schwarzschild\"\nmass = 0.2\n[animation]\nframes = 12\n\
    [[animation.tracks]]\nkey = \"camera.position\"\nvalues = [[0, 0, 5], [1, 0, 5]]\n";
/// The limit of waiting, even on a busy machine.
const PATIENCE: Duration = Duration::from_secs(240);

/// The daemons of Slurm, which end with this value.
struct Slurm {
    folder: Folder,
    munge: Child,
    controller: Option<Child>,
    nodes: Vec<Child>,
}

impl Slurm {
    /// Starts two idle nodes.
    fn start() -> Self {
        let folder = Folder::new();
        fs::set_permissions(folder.path("."), Permissions::from_mode(0o755)).unwrap();
        let path = |name: &str| folder.path(name).display().to_string();
        folder.write("key", [7_u8; 128]);
        fs::set_permissions(folder.path("key"), Permissions::from_mode(0o600)).unwrap();
        let munge = Command::new("/usr/sbin/munged")
            .args(["--foreground", "--force"])
            .args(["key-file=key", "socket=socket", "pid-file=munge.pid", "log-file=munge.log", "seed-file=seed"].map(
                |option| {
                    let (name, file) = option.split_once('=').unwrap();
                    format!("--{name}={}", path(file))
                },
            ))
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        let host = String::from_utf8(Command::new("hostname").arg("-s").output().unwrap().stdout).unwrap();
        let host = host.trim();
        // The ports depend on the process, so that two runs do not collide.
        let port = 20_000 + std::process::id() % 10_000 * 3;
        let own = path("");
        let own = own.trim_end_matches('/');
        folder.write(
            "slurm.conf",
            format!(
                "ClusterName=bentray\nSlurmctldHost={host}(127.0.0.1)\nSlurmctldPort={port}\nSlurmUser=root\nSlurmdUser=root\n\
                 AuthType=auth/munge\nAuthInfo=socket={own}/socket\nStateSaveLocation={own}/state\n\
                 SlurmdSpoolDir={own}/spool.%n\nSlurmctldPidFile={own}/controller.pid\nSlurmdPidFile={own}/%n.pid\n\
                 SlurmctldLogFile={own}/controller.log\nSlurmdLogFile={own}/%n.log\nProctrackType=proctrack/pgid\n\
                 TaskPlugin=task/none\nSelectType=select/cons_tres\nSelectTypeParameters=CR_CPU\n\
                 SchedulerParameters=bf_interval=1,sched_min_interval=100000\nReturnToService=2\nSlurmdTimeout=5\nMpiDefault=none\n\
                 SlurmdParameters=config_overrides\nNodeName=n[1-2] NodeHostname={host} NodeAddr=127.0.0.1 \
                 Port=[{}-{}] CPUs=4 RealMemory=2000\nPartitionName=all Nodes=ALL Default=YES State=UP\n",
                port + 1,
                port + 2
            ),
        );
        fs::create_dir(folder.path("state")).unwrap();
        let mut slurm = Self { folder, munge, controller: None, nodes: Vec::new() };
        slurm.wait("munge", |slurm| slurm.folder.path("socket").exists());
        slurm.controller = Some(slurm.daemon("/usr/sbin/slurmctld", &[]));
        slurm.nodes = ["n1", "n2"].map(|node| slurm.daemon("/usr/sbin/slurmd", &["-N", node])).into();
        slurm.wait("nodes", |slurm| slurm.say("sinfo", &["-h", "-o", "%t %D"]).trim() == "idle 2");
        slurm
    }

    fn daemon(&self, program: &str, more: &[&str]) -> Child {
        let configuration = self.folder.path("slurm.conf");
        let mut command = Command::new(program);
        command.arg("-D").arg("-f").arg(configuration).args(more).stdout(Stdio::null()).stderr(Stdio::null());
        command.env("BENTRAY_CACHE", "").spawn().unwrap()
    }

    /// Returns the output of one of Slurm's commands.
    fn say(&self, program: &str, arguments: &[&str]) -> String {
        let output = Command::new(program).args(arguments).env("SLURM_CONF", self.folder.path("slurm.conf")).output();
        String::from_utf8(output.unwrap().stdout).unwrap()
    }

    fn wait(&self, what: &str, mut is_so: impl FnMut(&Self) -> bool) {
        let begun = Instant::now();
        while !is_so(self) {
            assert!(begun.elapsed() < PATIENCE, "no {what}\n{}", self.say("squeue", &[]));
            sleep(Duration::from_millis(100));
        }
    }

    /// Submits a job and waits until its queue is empty; if `loses` is set, a node fails meanwhile.
    fn run(&mut self, folder: &Folder, job: &str, loses: bool) {
        let mut command = folder.command(&format!("farm slurm {job} --submit"));
        let output = command.env("SLURM_CONF", self.folder.path("slurm.conf")).output().unwrap();
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let (begun, mut is_lost) = (Instant::now(), false);
        while !self.say("squeue", &["-h"]).is_empty() {
            let done = folder.names().iter().filter(|name| name.contains(".part-")).count();
            if loses && !is_lost && done >= 10 && !self.say("squeue", &["-h", "-w", "n2"]).is_empty() {
                self.lose(1);
                is_lost = true;
            }
            // Slurm delays a lost part by two minutes.
            for waiting in self.say("squeue", &["-h", "-t", "PENDING", "-o", "%A %r"]).lines() {
                if let Some((job, "BeginTime")) = waiting.split_once(' ') {
                    self.say("scontrol", &["update", &format!("JobId={job}"), "StartTime=now"]);
                }
            }
            assert!(begun.elapsed() < PATIENCE, "{}", self.say("squeue", &[]));
            sleep(Duration::from_millis(100));
        }
        assert_eq!(is_lost, loses);
        let log = folder.text("scene.farm/finish.log");
        assert!(log.contains("all present and consistent"), "{log}");
    }

    /// Ends a node like a power failure, together with all of its processes.
    fn lose(&mut self, node: usize) {
        let name = format!("n{}", node + 1);
        let jobs = self.say("squeue", &["-h", "-w", &name, "-o", "%A"]);
        self.nodes[node].kill().unwrap();
        for entry in fs::read_dir("/proc").unwrap().filter_map(Result::ok) {
            let read = |file: &str| fs::read(entry.path().join(file)).unwrap_or_default();
            let command = String::from_utf8_lossy(&read("cmdline")).replace('\0', " ");
            let steps = jobs.lines().any(|job| command.starts_with(&format!("slurmstepd: [{job}.")));
            let environment = String::from_utf8_lossy(&read("environ")).replace('\0', "\n");
            let ours =
                environment.lines().any(|line| line.starts_with("SLURM_CONF=") || line.starts_with("SLURM_JOB_ID="));
            let own = ours && environment.lines().any(|line| *line == format!("SLURMD_NODENAME={name}"));
            if steps || own {
                let id = entry.file_name().into_string().unwrap();
                Command::new("kill").args(["-9", &id]).stderr(Stdio::null()).status().unwrap();
            }
        }
        self.say("scontrol", &["update", &format!("NodeName={name}"), "State=DOWN", "Reason=lost"]);
    }
}

impl Drop for Slurm {
    fn drop(&mut self) {
        for child in self.nodes.iter_mut().chain(&mut self.controller).chain([&mut self.munge]) {
            // A process that has already ended needs no action.
            let _ = child.kill();
            let _ = child.wait();
        }
    }
}

/// Checks a video of 12 frames, and an image of 64 parts during which a node is lost: all parts are completed, and the
/// result is byte-identical to that of one machine.
#[test]
#[ignore = "needs Slurm, and root for its daemons"]
fn a_farm_that_loses_a_node_makes_what_one_machine_makes_with_slurm() {
    let mut slurm = Slurm::start();
    let film = Folder::with(&format!("{BALL}{FILM}"));
    slurm.run(&film, "scene.toml -o film_{frame:2}.png --frames all --parts 12", false);
    film.run("render scene.toml -o one_{frame:2}.png --frames all").succeeds();
    for frame in 0..12 {
        assert!(film.read(&format!("film_{frame:02}.png")) == film.read(&format!("one_{frame:02}.png")), "{frame}");
    }
    let picture = Folder::with(&format!("{BALL}{FILM}"));
    let scene = "--size 64x128 --samples 16";
    slurm.run(&picture, &format!("scene.toml -o a.exr -o a.png {scene} --parts 64"), true);
    picture.run(&format!("render scene.toml -o one.exr -o one.png {scene}")).succeeds();
    for format in ["exr", "png"] {
        assert!(picture.read(&format!("a.{format}")) == picture.read(&format!("one.{format}")), "{format}");
    }
}
