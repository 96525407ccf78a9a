//! Checks limits of devices on which these tests do not run.

use std::path::Path;

use bentray::gpu::{Geometry, Gpu};
use bentray::program::{BindingKind, DeviceProfile, Mode, Program, ProgramOptions, Schedule};
use bentray::render::{RenderSettings, Renderer};
use bentray::scene::Scene;

use crate::support::all_scenes;

/// The limits that WebGPU guarantees for a pass (<https://www.w3.org/TR/webgpu/#limits>): storage buffers, storage
/// textures, other textures and uniform buffers.
const LIMITS: [usize; 4] = [8, 4, 16, 12];
/// Scenes with a pass that needs more storage buffers, and their number, at most 12. A mesh takes three (its tree, and the data for
/// hits and for shading) and one more if it has sides, a photon grid two, lists of pixels four, and pixels and counts one each.
const MORE: [(&str, usize); 4] = [
    ("scenes/paths/prism.toml", 11),
    ("scenes/spacetimes/wormhole.toml", 9),
    ("scenes/thesis/rod.toml", 9),
    ("scenes/thesis/vase.toml", 11),
];

/// Every pass of every scene here, with every schedule, binds no more than every device supports.
#[test]
fn passes_fit_webgpus_default_limits() {
    let mut over = Vec::new();
    for path in all_scenes() {
        let scene = Scene::load(&path, &[]).unwrap();
        let geometry = Geometry::new(&scene);
        let more = MORE.iter().find(|(name, _)| path.ends_with(name));
        let limits = [more.map_or(LIMITS[0], |(_, count)| *count), LIMITS[1], LIMITS[2], LIMITS[3]];
        let mut most = 0;
        for (schedule, mode) in
            Schedule::ALL.map(|schedule| (schedule, Mode::Picture)).into_iter().chain([(Schedule::Fused, Mode::Trace)])
        {
            let options = ProgramOptions { schedule, masks: schedule.masks(), mode, ..ProgramOptions::default() };
            let program = Program::new(&scene, &geometry.analysis, &options, geometry.extent()).unwrap();
            let named = |what: String| format!("{} by {schedule:?}: {what}", path.display());
            for (pass, _, reflection) in &program.passes {
                let buffers = reflection.count(|kind| matches!(kind, BindingKind::Storage { .. }));
                let written = reflection.count(|kind| matches!(kind, BindingKind::StorageTexture(_)));
                let read = reflection.count(|kind| matches!(kind, BindingKind::Texture(_)));
                let uniforms = reflection.bindings.len() - buffers - written - read;
                let counts = [buffers, written, read, uniforms];
                most = most.max(buffers);
                if counts.iter().zip(limits).any(|(count, limit)| *count > limit) {
                    over.push(named(format!("{} binds {counts:?} of {limits:?}", pass.entry())));
                }
            }
        }
        assert!(more.is_none_or(|(_, count)| *count == most), "{}: {most}", path.display());
    }
    assert!(over.is_empty(), "{over:#?}");
}

/// A profile determines the form of programs for a device, but not a bit of their
/// results. The test runs programs of both profiles on the available device.
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
            Renderer::new(&gpu, &scene, RenderSettings::default()).unwrap().render().unwrap()
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
