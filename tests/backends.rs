//! Translates the shipped programs to the language of every backend: Metal, DirectX and Vulkan. Their compilers are not available here, but
//! naga rejects a program that its language cannot express. The numbers of resources are checked by `devices`.

use std::collections::HashSet;

use bentray::gpu::Geometry;
use bentray::program::{Mode, Program, ProgramOptions, Schedule};
use bentray::scene::{Override, Scene};
use naga::back::{hlsl, msl, pipeline_constants::process_overrides, spv};
use naga::valid::{Capabilities, ValidationFlags, Validator};
use naga::{Module, valid::ModuleInfo};
use rayon::prelude::*;

use crate::support::all_scenes;

/// Metal 2.4 is the version that wgpu uses on macOS 12, and DirectX 12 requires shader model 5.1.
const METAL: (u8, u8) = (2, 4);
const DIRECTX: hlsl::ShaderModel = hlsl::ShaderModel::V5_1;

/// A translation, which may fail.
type Translation = fn(&Module, &ModuleInfo) -> Result<(), String>;

/// Returns the distinct WGSL sources of the scenes' programs in a precision, each with the name of its scene.
fn sources(precision: &str) -> Vec<(String, String)> {
    let precision: Override = format!("rays.precision=\"{precision}\"").parse().unwrap();
    let (mut known, mut all) = (HashSet::new(), Vec::new());
    for path in all_scenes() {
        let scene = Scene::load(&path, std::slice::from_ref(&precision)).unwrap();
        let geometry = Geometry::new(&scene);
        for schedule in [Schedule::Whole, Schedule::Segment] {
            let (masks, mode) = (schedule.masks(), Mode::Picture);
            let options = ProgramOptions { schedule, masks, mode, ..ProgramOptions::default() };
            let program = Program::new(&scene, &geometry.analysis, &options, geometry.extent()).unwrap();
            for (pass, linked, _) in program.passes {
                if known.insert(linked.source.clone()) {
                    all.push((format!("{} ({})", path.display(), pass.entry()), linked.source));
                }
            }
        }
    }
    all
}

/// Translates all programs in a precision, and returns the failures and the number of programs.
fn failures(precision: &str, to: &[Translation]) -> (Vec<String>, usize) {
    let all = sources(precision);
    let failed = |(name, source): &(String, String)| {
        let capabilities = Capabilities::default() | Capabilities::FLOAT64;
        let module = naga::front::wgsl::parse_str(source).map_err(|error| format!("{name}: {error}")).unwrap();
        let info = Validator::new(ValidationFlags::all(), capabilities).validate(&module).unwrap();
        let constants = naga::back::PipelineConstants::default();
        let (module, info) = process_overrides(&module, &info, None, &constants).unwrap();
        to.iter().filter_map(|to| to(&module, &info).err()).map(|error| format!("{name}: {error}")).collect::<Vec<_>>()
    };
    (all.par_iter().flat_map_iter(failed).collect(), all.len())
}

fn metal(module: &Module, info: &ModuleInfo) -> Result<(), String> {
    let options = msl::Options { lang_version: METAL, fake_missing_bindings: true, ..msl::Options::default() };
    let (_, entries) = msl::write_string(module, info, &options, &msl::PipelineOptions::default())
        .map_err(|error| format!("Metal: {error}"))?;
    entries
        .entry_point_names
        .into_iter()
        .try_for_each(|name| name.map(|_| ()).map_err(|error| format!("Metal: {error}")))
}

fn directx(module: &Module, info: &ModuleInfo) -> Result<(), String> {
    let options = hlsl::Options { shader_model: DIRECTX, fake_missing_bindings: true, ..hlsl::Options::default() };
    let (mut text, pipeline) = (String::new(), hlsl::PipelineOptions::default());
    let written = hlsl::Writer::new(&mut text, &options, &pipeline).write(module, info, None);
    let entries = written.map_err(|error| format!("DirectX: {error}"))?.entry_point_names;
    entries.into_iter().try_for_each(|name| name.map(|_| ()).map_err(|error| format!("DirectX: {error}")))
}

fn vulkan(module: &Module, info: &ModuleInfo) -> Result<(), String> {
    let words = spv::write_vec(module, info, &spv::Options::default(), None);
    words.map(|_| ()).map_err(|error| format!("Vulkan: {error}"))
}

#[test]
fn every_backend_expresses_the_programs() {
    let (failed, count) = failures("f32", &[metal, directx, vulkan]);
    println!("{count} programs");
    assert!(failed.is_empty(), "{failed:#?}");
    assert!(count > 200, "{count}");
}

/// Metal has no 64-bit numbers.
#[test]
fn programs_in_64_bits_are_for_directx_and_vulkan() {
    let (failed, count) = failures("f64", &[directx, vulkan]);
    println!("{count} programs");
    assert!(failed.is_empty(), "{failed:#?}");
}
