//! 'Model no more than a scene needs', made executable: nothing can be taken out of a scene's program.

use bentray::gpu::Geometry;
use bentray::program::{
    BindingKind, Choice, Layer, Linked, Masks, Parts, Program, ProgramError, Purpose, Schedule, Unit, link, validated,
};
use bentray::scene::{Override, Scene};

use crate::support::shipped_scenes;

/// Everything that a module declares, by kind, as names.
fn declared(module: &naga::Module) -> Vec<String> {
    let named = |kind: &str, name: &Option<String>| format!("{kind} {}", name.as_deref().unwrap_or("?"));
    let mut all: Vec<String> = module.functions.iter().map(|(_, f)| named("fn", &f.name)).collect();
    all.extend(module.global_variables.iter().map(|(_, v)| named("var", &v.name)));
    all.extend(module.types.iter().filter(|(_, t)| t.name.is_some()).map(|(_, t)| named("type", &t.name)));
    all.extend(module.constants.iter().map(|(_, c)| named("const", &c.name)));
    all.extend(module.entry_points.iter().map(|e| format!("entry {}", e.name)));
    all
}

/// What naga would remove from the program as unused.
pub fn unused(linked: &Linked) -> Result<Vec<String>, ProgramError> {
    let mut module = validated(linked)?;
    let before = declared(&module);
    naga::compact::compact(&mut module, naga::compact::KeepUnused::No);
    let after = declared(&module);
    Ok(before.into_iter().filter(|name| !after.contains(name)).collect())
}

/// Cameras and samplings that no shipped scene has.
const PICTURES: [&[&str]; 7] = [
    &["image.pattern=progressive"],
    &["image.adaptive=0.1", "image.samples=64", "output.tonemap=filmic"],
    &["image.adaptive=0.1", "image.samples=64", "camera.kind=fisheye", "camera.corners=transparent"],
    &["camera.kind=fisheye"],
    &["camera.kind=fisheye", "camera.corners=transparent", "camera.stereo={ separation = 1, convergence = 9 }"],
    &["camera.kind=panorama", "camera.fov=[360, 180]", "camera.stereo={ separation = 1, layout = \"top-bottom\" }"],
    &["camera.frame=static", "camera.stereo={ separation = 1, convergence = 9 }", "rays.asymptotic=true"],
];

#[test]
fn nothing_can_be_taken_out_of_any_program() {
    let purposes = [Purpose::Picture, Purpose::Trace, Purpose::Pixels];
    let shipped = shipped_scenes();
    let hole = shipped.iter().find(|path| path.ends_with("schwarzschild_sky.toml")).unwrap();
    let changed = PICTURES.iter().map(|keys| (hole, keys.iter().map(|key| key.parse().unwrap()).collect()));
    for (path, keys) in shipped.iter().map(|path| (path, Vec::<Override>::new())).chain(changed) {
        let scene = Scene::load(path, &keys).unwrap_or_else(|error| panic!("{error}"));
        let geometry = Geometry::new(&scene);
        for schedule in [Schedule::Paper, Schedule::Segment, Schedule::Fused] {
            for (masks, layers) in [(Masks::List, Vec::new()), (Masks::Off, Layer::ALL.to_vec())] {
                for purpose in purposes {
                    let choice = Choice { schedule, masks, purpose, layers: layers.clone() };
                    let program = Program::new(&scene, &geometry.analysis, &choice, geometry.extent()).unwrap();
                    for (pass, linked, reflection) in &program.passes {
                        // More than three uniform buffers are more than lavapipe's search for inlinable uniforms bears.
                        let uniform =
                            |kind: &BindingKind| matches!(kind, BindingKind::Uniform(_) | BindingKind::Block { .. });
                        let buffers = reflection.bindings.iter().filter(|binding| uniform(&binding.kind)).count();
                        assert!(buffers <= 3, "{}: pass {} binds {buffers}", path.display(), pass.entry());
                        let unused = unused(linked).unwrap_or_else(|error| panic!("{error}"));
                        assert!(
                            unused.is_empty(),
                            "{}: pass {} has {unused:?} for nothing",
                            path.display(),
                            pass.entry()
                        );
                    }
                }
            }
        }
    }
}

/// No uniform that only repeats what the scene fixes: kinds of law, shape, method, camera and sky are in the choice of parts.
#[test]
fn programs_do_not_branch_on_what_the_scene_fixes() {
    for path in shipped_scenes() {
        let scene = Scene::load(&path, &[]).unwrap();
        let geometry = Geometry::new(&scene);
        let program = Program::new(&scene, &geometry.analysis, &Choice::default(), geometry.extent()).unwrap();
        for (pass, linked, reflection) in &program.passes {
            for binding in &reflection.bindings {
                // What is bound apart (the picture's first sample, a walk's later passes) is not the scene's.
                let BindingKind::Block { members, .. } = &binding.kind else { continue };
                let fields = members.iter().flat_map(|m| m.layout.fields.iter().map(|f| (&m.name, &f.name)));
                for (member, field) in fields {
                    for branch in ["if", "switch"] {
                        let test = format!("{branch} {}.{member}.{field} ", binding.name);
                        let found = linked.source.contains(&test);
                        assert!(!found, "{}: `{test}` in {}", path.display(), pass.entry());
                    }
                }
            }
        }
    }
}

/// A part that is planted for nothing is found.
#[test]
fn the_check_finds_what_is_unused() {
    let text = "struct Kept { a: f32 }\n@group(0) @binding(0) var<storage, read_write> kept: Kept;\n\
                @group(0) @binding(1) var<uniform> idle: Kept;\n\
                @compute @workgroup_size(1) fn entry() { let idle_too = 1.0; kept.a = idle_too; if false { kept.a = idle.a; } }\n\
                fn extra() -> f32 { return 1.0; }\n";
    let unit = Unit { file: "planted.wgsl".into(), text: text.into() };
    let linked = link(&Parts { shared: vec![unit], regions: Vec::new() }, "entry").unwrap();
    assert!(!linked.source.contains("extra"), "the linker leaves out what is not reached");
    assert!(unused(&linked).unwrap().is_empty());
}
