//! `bentray farm kubernetes`: writes an indexed job, and a second job that combines the parts.
//!
//! *Practice.* Manifests are JSON, which kubectl accepts like YAML. All pods work in one volume, which holds the scene and the
//! images.

use clap::Args;
use serde_json::{Value, json};

use super::job::{Job, Written, finish_words, render_words};
use crate::cli::words::quoted;
use crate::error::Error;

/// The mount path of the volume in a pod.
const FOLDER: &str = "/work";
/// The number of retries of a part.
const AGAIN: u32 = 3;

/// Write the manifests of an indexed Kubernetes job with one pod per part, and of a job that combines the parts
#[derive(Debug, Args)]
pub(super) struct Kubernetes {
    /// Container image with `bentray` in its PATH
    #[arg(long, value_name = "IMAGE")]
    image: String,
    /// Claim of a volume that all pods share; it holds the scene, under the path given here, and receives the images
    #[arg(long, value_name = "CLAIM")]
    volume: String,
    /// Maximum number of pods at a time
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

/// Returns a name that Kubernetes accepts: lower-case letters, digits and hyphens.
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
