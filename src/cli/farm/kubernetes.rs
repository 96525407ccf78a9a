//! `bentray farm kubernetes`: an indexed job, and one to run behind it that puts the parts together.
//!
//! *Practice.* Manifests are JSON, which kubectl takes as it takes YAML. All pods work in one volume, where the scene is and the pictures
//! go.

use clap::Args;
use serde_json::{Value, json};

use super::job::{Job, Written, finish_words, render_words};
use crate::cli::words::quoted;
use crate::error::Error;

/// Where the volume is in a pod.
const FOLDER: &str = "/work";
/// Times that a part is tried again.
const AGAIN: u32 = 3;

/// Write the manifests of an indexed Kubernetes job, one pod a part, and of one that puts the parts together
#[derive(Debug, Args)]
pub(super) struct Kubernetes {
    /// The container image, with `bentray` in its path
    #[arg(long, value_name = "IMAGE")]
    image: String,
    /// The claim of a volume that all pods share: the scene is in it, under the path that is given here, and pictures go there
    #[arg(long, value_name = "CLAIM")]
    volume: String,
    /// Pods at once
    #[arg(long, value_name = "N", default_value = "8")]
    at_once: u32,
    #[command(flatten)]
    job: Job,
}

pub(super) fn run(arguments: &Kubernetes) -> Result<(), Error> {
    let job = &arguments.job;
    let parts = job.parts();
    job.load()?;
    let render = render_words("bentray", &format!("auto/{parts}"));
    let array = json!({
        "completionMode": "Indexed",
        "completions": parts,
        "parallelism": arguments.at_once.min(parts),
        "backoffLimitPerIndex": AGAIN,
        "maxFailedIndexes": parts,
    });
    let part = arguments.manifest(&name(&job.name(), ""), array, &render);
    let once = json!({ "backoffLimit": AGAIN });
    let last = arguments.manifest(&name(&job.name(), "-finish"), once, &finish_words("bentray", parts));
    let files = [job.write("parts.json", &part)?, job.write("finish.json", &last)?];
    let [apply, apply_last] = [0, 1].map(|i| format!("kubectl apply -f {}", quoted(&[files[i].display().to_string()])));
    let wait = format!("kubectl wait --for=condition=complete --timeout=-1s job/{}", name(&job.name(), ""));
    job.format().say(&Written::new(parts, files.to_vec(), vec![apply, wait, apply_last]))
}

/// A name that Kubernetes takes: small letters, digits and hyphens.
fn name(scene: &str, suffix: &str) -> String {
    let plain = |c: char| if c.is_ascii_alphanumeric() { c.to_ascii_lowercase() } else { '-' };
    let name: String = scene.chars().map(plain).take(40).collect();
    format!("bentray-{}{suffix}", name.trim_matches('-'))
}

impl Kubernetes {
    fn manifest(&self, name: &str, mut spec: Value, command: &[String]) -> String {
        spec["template"] = json!({ "spec": {
            "restartPolicy": "Never",
            "containers": [{
                "name": "bentray",
                "image": self.image,
                "command": command,
                "workingDir": FOLDER,
                "volumeMounts": [{ "name": "work", "mountPath": FOLDER }],
            }],
            "volumes": [{ "name": "work", "persistentVolumeClaim": { "claimName": self.volume } }],
        }});
        let job = json!({ "apiVersion": "batch/v1", "kind": "Job", "metadata": { "name": name }, "spec": spec });
        format!("{job:#}\n")
    }
}

#[cfg(test)]
mod tests {
    use super::name;

    #[test]
    fn names_are_such_as_kubernetes_takes() {
        assert_eq!(name("Black Hole_2", "-finish"), "bentray-black-hole-2-finish");
        assert_eq!(name("é", ""), "bentray-");
    }
}
