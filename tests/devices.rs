//! Limits of devices that these tests do not run on.

use std::path::Path;

use bentray::gpu::{Geometry, Gpu, METAL_READ_WRITE_TEXTURES};
use bentray::program::{Choice, DeviceProfile, Program};
use bentray::render::{RenderSettings, Renderer};
use bentray::scene::Scene;

use crate::support::pictured;

/// The passes of the scenes that are here which bind more read-write textures than Metal takes: the table may only become shorter.
const KNOWN: &str = include_str!("tables/read_write_textures.tsv");

/// Those of a program, as rows of the table.
fn over(name: &str, program: &Program) -> Vec<String> {
    let counts = program.passes.iter().map(|(pass, _, reflection)| (pass.entry(), reflection.read_write_textures()));
    let over = counts.filter(|(_, count)| *count > METAL_READ_WRITE_TEXTURES);
    over.map(|(pass, count)| format!("{name}\t{pass}\t{count}")).collect()
}

#[test]
fn no_more_passes_exceed_metals_read_write_textures() {
    let found: Vec<String> = pictured().iter().flat_map(|(name, program)| over(name, program)).collect();
    let known: Vec<&str> = KNOWN.lines().filter(|line| !line.starts_with('#')).collect();
    let more: Vec<&String> = found.iter().filter(|row| !known.contains(&row.as_str())).collect();
    assert!(more.is_empty(), "these do not run on Metal, or need more or less than they did: {more:#?}");
    let gone: Vec<&&str> = known.iter().filter(|row| !found.iter().any(|own| own == *row)).collect();
    assert!(gone.is_empty(), "these need no more than Metal takes: leave them out of the table: {gone:#?}");
}

#[test]
fn the_readme_says_how_many_scenes_that_is() {
    let readme = include_str!("../README.md");
    let names = KNOWN.lines().filter_map(|line| line.split_once(".toml\t").map(|(name, _)| name));
    let count = names.collect::<std::collections::BTreeSet<_>>().len();
    assert!(readme.contains(&format!("refuses {count} of the scenes here")), "{count}");
}

/// What the message for such a scene advises is enough.
#[test]
fn random_branches_need_few_read_write_textures() {
    let mut names: Vec<&str> =
        KNOWN.lines().filter_map(|line| line.split_once(".toml").map(|(name, _)| name)).collect();
    names.dedup();
    for name in names {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("{name}.toml"));
        let scene = Scene::load(&path, &["rays.branches=\"random\"".parse().unwrap()]).unwrap();
        let geometry = Geometry::new(&scene);
        let program = Program::new(&scene, &geometry.analysis, &Choice::default(), geometry.extent()).unwrap();
        assert_eq!(over(name, &program), Vec::<String>::new());
    }
}

/// A profile says how programs are written for a device, and changes no bit of what they compute: both kinds of programs on the device that
/// is here.
#[test]
fn pictures_do_not_depend_on_the_profile() {
    let mut gpu = Gpu::open(None).unwrap();
    let other = if gpu.profile.is_processor { DeviceProfile::GPU } else { DeviceProfile::cpu(32) };
    for name in
        ["black_hole", "laws/lattice", "groller/twelve", "thesis/luneburg", "thesis/filter", "spacetimes/wormhole"]
    {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("scenes/{name}.toml"));
        let mut keys = vec!["image.size=[40, 30]".parse().unwrap(), "image.samples=2".parse().unwrap()];
        let text = std::fs::read_to_string(&path).unwrap();
        keys.extend((!text.contains("method =")).then(|| "rays.method=\"rk4\"".parse().unwrap()));
        let scene = Scene::load(&path, &keys).unwrap();
        let own = gpu.profile;
        let [here, there] = [own, other].map(|profile| {
            gpu.profile = profile;
            Renderer::new(&gpu, &scene, RenderSettings::default()).unwrap().picture().unwrap()
        });
        gpu.profile = own;
        assert!(here.band == there.band, "{name}");
        assert_eq!(
            (here.totals.steps, &here.totals.by_status),
            (there.totals.steps, &there.totals.by_status),
            "{name}"
        );
    }
}
