//! Checks 'Model no more than a scene needs': nothing can be removed from the program of a scene.

use std::collections::{BTreeSet, HashSet};
use std::path::Path;

use bentray::gpu::Geometry;
use bentray::program::{
    BindingKind, DeviceProfile, Layer, LinkedProgram, Mode, Parts, Program, ProgramError, ProgramOptions, RaySkipping,
    Schedule, Unit, link, validated,
};
use bentray::scene::{Override, Precision, Rays, Scene, TEMPLATES};

use crate::support::branches::{Branch, fixed_branches};
use crate::support::{pictured, scene, scenes_in, shipped_scenes};

/// Returns the names of everything that a module declares, with their kinds.
fn declared(module: &naga::Module) -> Vec<String> {
    let named = |kind: &str, name: &Option<String>| format!("{kind} {}", name.as_deref().unwrap_or("?"));
    let mut all: Vec<String> = module.functions.iter().map(|(_, f)| named("fn", &f.name)).collect();
    all.extend(module.global_variables.iter().map(|(_, v)| named("var", &v.name)));
    all.extend(module.types.iter().filter(|(_, t)| t.name.is_some()).map(|(_, t)| named("type", &t.name)));
    all.extend(module.constants.iter().map(|(_, c)| named("const", &c.name)));
    all.extend(module.overrides.iter().map(|(_, o)| named("override", &o.name)));
    all.extend(module.entry_points.iter().map(|e| format!("entry {}", e.name)));
    all
}

/// Returns everything that naga would remove from the program as unused, and variables that are written but never read.
pub fn unused(linked: &LinkedProgram) -> Result<Vec<String>, ProgramError> {
    let mut module = validated(linked)?;
    let before = declared(&module);
    let idle = unread(&module).into_iter().chain(unnamed(&module, &linked.source)).collect::<Vec<_>>();
    naga::compact::compact(&mut module, naga::compact::KeepUnused::No);
    let after = declared(&module);
    Ok(before.into_iter().filter(|name| !after.contains(name)).chain(idle).collect())
}

/// Returns constants that only occur in their declarations. naga keeps them all, because it has already substituted their values.
fn unnamed(module: &naga::Module, source: &str) -> Vec<String> {
    let words: Vec<&str> = source.split(|c: char| !c.is_alphanumeric() && c != '_').collect();
    let names = module.constants.iter().filter_map(|(_, constant)| constant.name.as_deref());
    let unnamed = names.filter(|name| !ENTERED.contains(name) && words.iter().filter(|word| *word == name).count() < 2);
    unnamed.map(|name| format!("const {name}")).collect()
}

/// Names that may be unused. Entering a set of regions names the kind and the medium, even if the pass does not read them; if all
/// space is one region, `media[place]` is a copy of the only medium. A pass notes its lane even if this scene has no long loops there.
const ENTERED: [&str; 3] = ["region", "place", "own_lanes"];

/// Returns private variables that nothing reads, including copies of uniforms.
fn unread(module: &naga::Module) -> Vec<String> {
    let functions = module.functions.iter().map(|(_, function)| function);
    let functions: Vec<_> = functions.chain(module.entry_points.iter().map(|entry| &entry.function)).collect();
    let is_read = |global: naga::Handle<naga::GlobalVariable>| {
        functions.iter().any(|function| {
            let points = |mut at: naga::Handle<naga::Expression>| loop {
                match function.expressions[at] {
                    naga::Expression::Access { base, .. } | naga::Expression::AccessIndex { base, .. } => at = base,
                    naga::Expression::GlobalVariable(found) => return found == global,
                    _ => return false,
                }
            };
            let mut loads = function.expressions.iter().filter_map(|(_, expression)| match expression {
                naga::Expression::Load { pointer } => Some(*pointer),
                _ => None,
            });
            loads.any(points)
        })
    };
    let private = module.global_variables.iter().filter(|(_, variable)| variable.space == naga::AddressSpace::Private);
    let is_set_alone = |name: Option<&str>| name.is_some_and(|name| ENTERED.contains(&name));
    let unread = private.filter(|(global, variable)| !is_read(*global) && !is_set_alone(variable.name.as_deref()));
    unread.map(|(_, variable)| format!("unread {}", variable.name.as_deref().unwrap_or("?"))).collect()
}

/// Cameras and samplings that are in no shipped scene.
const PICTURES: [&[&str]; 7] = [
    &["image.sampler=sobol"],
    &["image.adaptive=0.1", "image.samples=64", "output.tonemap=filmic"],
    &["image.adaptive=0.1", "image.samples=64", "camera.kind=fisheye", "camera.corners=transparent"],
    &["camera.kind=fisheye"],
    &["camera.kind=fisheye", "camera.corners=transparent", "camera.stereo={ separation = 1, convergence = 9 }"],
    &["camera.kind=panorama", "camera.fov=[360, 180]", "camera.stereo={ separation = 1, layout = \"top-bottom\" }"],
    &["camera.observer=static", "camera.stereo={ separation = 1, convergence = 9 }", "rays.sky_at_infinity=true"],
];

#[test]
fn nothing_can_be_taken_out_of_any_program() {
    // Purposes differ in the same modules under every schedule.
    let purposes = |schedule| match schedule {
        Schedule::Whole | Schedule::Paper => [Mode::Picture, Mode::Trace, Mode::Pixels].as_slice(),
        _ => &[Mode::Picture],
    };
    let shipped: Vec<_> = ["scenes/groller", "scenes/light", "scenes/paths", "scenes/spacetimes"]
        .into_iter()
        .flat_map(scenes_in)
        .collect();
    let shipped: Vec<_> = shipped_scenes().into_iter().chain(shipped).collect();
    let hole = shipped.iter().find(|path| path.ends_with("schwarzschild_sky.toml")).unwrap();
    // Many scenes share a pass, and so do many programs of one scene.
    let mut seen = HashSet::new();
    let changed = PICTURES.iter().map(|keys| (hole, keys.iter().map(|key| key.parse().unwrap()).collect()));
    for (i, (path, keys)) in shipped.iter().map(|path| (path, Vec::<Override>::new())).chain(changed).enumerate() {
        let scene = Scene::load(path, &keys).unwrap_or_else(|error| panic!("{error}"));
        let geometry = Geometry::new(&scene);
        // The megakernel, and half of the other schedules.
        let taken = |(k, schedule): &(usize, Schedule)| *schedule == Schedule::Whole || (i + k) % 2 == 0;
        for (_, schedule) in Schedule::ALL.into_iter().enumerate().filter(taken) {
            for (masks, layers) in [(RaySkipping::List, Vec::new()), (RaySkipping::Off, Layer::ALL.to_vec())] {
                for &mode in purposes(schedule) {
                    let options =
                        ProgramOptions { schedule, masks, mode, layers: layers.clone(), ..ProgramOptions::default() };
                    let program = Program::new(&scene, &geometry.analysis, &options, geometry.extent()).unwrap();
                    for (pass, linked, reflection) in &program.passes {
                        if !seen.insert(linked.source.clone()) {
                            continue;
                        }
                        // With more than three uniform buffers lavapipe's search for inlinable uniforms fails.
                        let uniform =
                            |kind: &BindingKind| matches!(kind, BindingKind::Uniform(_) | BindingKind::Block { .. });
                        let buffers = reflection.bindings.iter().filter(|binding| uniform(&binding.kind)).count();
                        assert!(buffers <= 3, "{}: pass {} binds {buffers}", path.display(), pass.entry());
                        let unused = unused(linked).unwrap_or_else(|error| panic!("{error}"));
                        assert!(
                            unused.is_empty(),
                            "{}: pass {} has {unused:?} without use",
                            path.display(),
                            pass.entry()
                        );
                    }
                }
            }
        }
    }
}

/// Features that are missing from `scenes/`: absorption by formulas with constant components, and every pattern of a texture.
const FILTERS: [&str; 6] = [
    "coefficient = [\"0.4\", \"r\", \"x^2\"]",
    "transmittance = [\"0.4\", \"1\", \"exp(-r)\"]",
    "texture = \"mix\", frequency = 2, low = [0, 0, 0], high = [1, 1, 1]",
    "texture = \"wrapped\", frequency = 0.8, low = [0.3, 0.05, 0.1], high = [0.9, 1.0, 0.4]",
    "texture = \"rainbow\", frequency = 2",
    "coefficient = \"2\", emission = [1, 1, 1]",
];

/// Validates a pass as a device receives it, with the values of its pipeline constants. All constant expressions are then
/// evaluated again, also those in functions.
fn with_constants(linked: &LinkedProgram) -> Result<(), String> {
    let module = naga::front::wgsl::parse_str(&linked.source).map_err(|error| error.to_string())?;
    let capabilities = naga::valid::Capabilities::default() | naga::valid::Capabilities::FLOAT64;
    let mut validator = naga::valid::Validator::new(naga::valid::ValidationFlags::all(), capabilities);
    let info = validator.validate(&module).map_err(|error| error.to_string())?;
    let constants = naga::back::PipelineConstants::default();
    let made = naga::back::pipeline_constants::process_overrides(&module, &info, None, &constants);
    made.map(|_| ()).map_err(|error| error.to_string())
}

/// In 64 bits every shipped scene is valid WGSL, for all purposes: a bare literal is an f32 unless another operand is not.
#[test]
fn every_scene_is_valid_in_64_bits() {
    let folders = ["", "/bench", "/groller", "/laws", "/light", "/paths", "/spacetimes", "/stability", "/thesis"];
    let double: [Override; 1] = ["rays.precision=\"f64\"".parse().unwrap()];
    let filtered = FILTERS.map(|filter| {
        scene(&format!(
            "[rays]\nbounding_sphere = {{ radius = 9 }}\nprecision = \"f64\"\n[[objects]]\nshape = \"sphere\"\n\
             interior = {{ kind = \"constant\", n = 1.5, absorption = {{ {filter} }} }}\n"
        ))
    });
    let shipped = folders.iter().flat_map(|folder| scenes_in(&format!("scenes{folder}")));
    let shipped = shipped.map(|path| (Scene::load(&path, &double).unwrap(), path.display().to_string()));
    let (mut count, mut asked, mut seen) = (0, 0, HashSet::new());
    let templates = TEMPLATES.iter().map(|template| {
        let mut scene = scene(template.text);
        scene.rays.precision = Precision::Double;
        (scene, template.name.to_owned())
    });
    let filtered = filtered.into_iter().zip(FILTERS.map(str::to_owned));
    for (scene, name) in shipped.chain(templates).chain(filtered) {
        count += 1;
        let geometry = Geometry::new(&scene);
        // This validates all passes.
        let made = |scene: &Scene, options: &ProgramOptions| {
            Program::new(scene, &geometry.analysis, options, geometry.extent())
        };
        let whole = |mode| ProgramOptions { mode, layers: Layer::ALL.to_vec(), ..ProgramOptions::default() };
        let fused = |mode| ProgramOptions { schedule: Schedule::Fused, mode, ..ProgramOptions::default() };
        for options in [whole(Mode::Picture), whole(Mode::Trace), fused(Mode::Picture)] {
            let program = made(&scene, &options).unwrap_or_else(|error| panic!("{name} {options:?}: {error}"));
            for (_, linked, _) in program.passes.iter().filter(|_| options.mode == Mode::Picture) {
                if seen.insert(linked.source.clone()) {
                    with_constants(linked).unwrap_or_else(|error| panic!("{name} {options:?}: {error}"));
                }
            }
        }
        // Purposes that not every scene allows are checked in 64 bits if 32 bits allow them.
        let single = Scene { rays: Rays { precision: Precision::Single, ..scene.rays.clone() }, ..scene.clone() };
        for options in [Mode::Lit, Mode::Light].map(fused) {
            if !scene.lights.is_empty() && made(&single, &options).is_ok() {
                asked += 1;
                made(&scene, &options).unwrap_or_else(|error| panic!("{name} {options:?}: {error}"));
            }
        }
    }
    println!("{count} scenes, {asked} programs of lights");
    assert!(count > 80, "{count} scenes");
}

/// In naga's HLSL the number of workgroups is only correct in an entry point: a function that receives it gets the group's
/// id, so that rows of a list would overlap on DX12. No pass reads it.
#[test]
fn no_pass_asks_for_the_number_of_workgroups() {
    let is_count =
        |binding: Option<&naga::Binding>| matches!(binding, Some(naga::Binding::BuiltIn(naga::BuiltIn::NumWorkGroups)));
    let keys = ["image.adaptive=0.1", "image.samples=64"].map(|key| key.parse().unwrap());
    let path = shipped_scenes().into_iter().find(|path| path.ends_with("fig4e_schwarzschild.toml")).unwrap();
    let scene = Scene::load(&path, &keys).unwrap();
    let geometry = Geometry::new(&scene);
    for schedule in Schedule::ALL {
        let options = ProgramOptions { schedule, ..ProgramOptions::default() };
        let program = Program::new(&scene, &geometry.analysis, &options, geometry.extent()).unwrap();
        for (pass, linked, _) in &program.passes {
            let module = validated(linked).unwrap();
            for argument in module.entry_points.iter().flat_map(|entry| &entry.function.arguments) {
                let naga::TypeInner::Struct { members, .. } = &module.types[argument.ty].inner else {
                    panic!("{} takes no struct", pass.entry());
                };
                assert!(!members.iter().any(|member| is_count(member.binding.as_ref())), "{}", pass.entry());
            }
        }
    }
}

/// Branches that remain: the file, the condition, and the reason.
const ALLOWED: [(&str, &str, &str); 6] = [
    ("generated/images.wgsl", "image", "each of two skies has its own picture"),
    ("generated/kinds.wgsl", "region", "the kind of a region of a list, which has one here"),
    ("generated/shapes.wgsl", "primitive & ~PRIMITIVE_INDEX", "the surface of a region of a list, which has one here"),
    ("generated/matter.wgsl", "v", "each volume of a list may have its own shape"),
    (
        "shaders/motion/spiral.wgsl",
        "media.continued == 1u",
        "each medium of a list has its own, and the list has one here",
    ),
    (
        "shaders/surface/region_set.wgsl",
        "start.primitive != NOTHING",
        "each region of a list has its own, and the list has one here",
    ),
];

/// Values that a scene fixes determine the choice of modules: no program branches on a uniform or constant for them.
#[test]
fn programs_do_not_branch_on_what_the_scene_fixes() {
    let mut found = BTreeSet::new();
    let mut note = |program: &Program| {
        found.extend(program.passes.iter().flat_map(|(_, linked, _)| fixed_branches(linked)));
    };
    for (k, (path, program)) in pictured().iter().enumerate() {
        note(program);
        let scene = Scene::load(&Path::new(env!("CARGO_MANIFEST_DIR")).join(path), &[]).unwrap();
        let geometry = Geometry::new(&scene);
        let others = [
            (Schedule::Fused, Mode::Picture),
            (Schedule::Segment, Mode::Trace),
            (Schedule::Paper, Mode::Pixels),
            (Schedule::Fused, Mode::Bare),
            (Schedule::Fused, Mode::Light),
            (Schedule::Fused, Mode::Caustics),
        ];
        // In addition to each scene's images, half of the programs for other purposes.
        for (schedule, mode) in others.into_iter().skip(k % 2).step_by(2) {
            let options = ProgramOptions { schedule, mode, device: DeviceProfile::cpu(8), ..ProgramOptions::default() };
            note(&Program::new(&scene, &geometry.analysis, &options, geometry.extent()).unwrap());
        }
    }
    let known = |branch: &Branch| {
        ALLOWED.iter().any(|(file, condition, _)| (branch.file == *file) && branch.condition == *condition)
    };
    let unknown: Vec<_> = found.iter().filter(|branch| !known(branch)).collect();
    assert!(unknown.is_empty(), "{unknown:#?}");
    for (file, condition, _) in ALLOWED {
        assert!(found.iter().any(|branch| branch.file == file && branch.condition == condition), "{file}: {condition}");
    }
}

/// Returns a program of one function, with uniforms of every shape and uses of them all.
fn planted(function: &str) -> LinkedProgram {
    let text = format!(
        "override WIDE: u32 = 1u;\nconst LEAPS: bool = false;\nconst ONE: u32 = 1u;\nconst TWO: u32 = 2u;\n\
         struct Law {{ @size(16) kind: u32, @size(16) a: f32 }}\nstruct Frame {{ first: u32 }}\nstruct Dispatch {{ first: u32 }}\n\
         @group(0) @binding(1) var<uniform> frame: Frame;\n@group(0) @binding(2) var<uniform> dispatch: Dispatch;\n\
         @group(0) @binding(3) var<uniform> law: Law;\n@group(0) @binding(4) var<uniform> one: array<Law, ONE>;\n\
         @group(0) @binding(5) var<uniform> pair: array<Law, TWO>;\n\
         @group(0) @binding(6) var<uniform> list: array<Law, TWO>;\n\
         @group(0) @binding(0) var<storage, read_write> out: array<f32>;\n\
         var<private> region: u32;\n\
         fn wanted() -> bool {{ return false; }}\nfn of_kind() -> u32 {{ return law.kind; }}\n\
         fn chosen(kind: u32, x: f32) -> f32 {{ switch kind {{ case 1u: {{ return x; }} default: {{ return -x; }} }} }}\n\
         fn followed(x: f32) -> f32 {{\n{function}    return x;\n}}\n\
         @compute @workgroup_size(1) fn entry(@builtin(global_invocation_id) id: vec3u) {{\n\
         region = id.x % 2u;\n\
         out[id.x] = followed(out[id.x]) + list[region].a + pair[0].a + pair[1].a + one[0].a + law.a;\n}}\n"
    );
    let unit = Unit::user("planted.wgsl", text);
    // Copies of uniforms leave more to find.
    let device = DeviceProfile { loop_budget: None, ..DeviceProfile::cpu(8) };
    link(&Parts { shared: vec![unit], device, ..Parts::default() }, "entry").unwrap()
}

#[test]
fn planted_branches_are_found() {
    for (form, function, condition) in [
        ("a copied variable", "if law.kind == 1u { return -x; }", "law.kind == 1u"),
        ("a switch", "switch law.kind { case 1u: { return -x; } default: {} }", "law.kind"),
        ("an array of one", "if one[0].a > 0.0 { return -x; }", "one.a > 0.0"),
        ("a place copied by itself", "if pair[1].kind == 1u { return -x; }", "pair.kind == 1u"),
        ("the block", "if list[1].kind == 1u { return -x; }", "uniforms_entry.list[1].kind == 1u"),
        ("a constant", "if LEAPS { return -x; }", "LEAPS"),
        ("an override", "if WIDE > 2u { return -x; }", "WIDE > 2u"),
        ("a local value", "let kind = law.kind + 1u; if kind == 2u { return -x; }", "kind == 2u"),
        ("a local variable", "var kind = law.kind; if kind == 2u { return -x; }", "kind == 2u"),
        ("one side", "if law.kind == 1u && x > 0.0 { return -x; }", "law.kind == 1u"),
        ("the other side", "if x > 0.0 || law.kind == 1u { return -x; }", "law.kind == 1u"),
        ("a parameter", "if x > 0.0 { return chosen(law.kind, x); }", "kind"),
        ("a function's result", "if of_kind() == 1u { return -x; }", "of_kind() == 1u"),
        ("a loop's end", "loop { if law.kind == 1u { break; } if x > 0.0 { break; } }", "law.kind == 1u"),
        (
            "a loop's last end",
            "loop { if x > 0.0 { break; } continuing { break if law.kind == 1u; } }",
            "law.kind == 1u",
        ),
    ] {
        let found = fixed_branches(&planted(function));
        let want = Branch { file: "planted.wgsl".to_owned(), condition: condition.to_owned() };
        assert!(found.contains(&want) && found.len() == 1, "{form}: {found:?}");
    }
}

#[test]
fn other_branches_are_not() {
    for (form, function) in [
        ("a ray's own", "if x > law.a { return -x; }"),
        ("a tile's", "if frame.first == 1u { return -x; }"),
        ("a dispatch's", "if dispatch.first == 1u && frame.first == 0u { return -x; }"),
        ("a count", "var sum = x; for (var i = 0u; i < law.kind; i++) { sum += x; } return sum;"),
        ("an answer", "if wanted() { return -x; }"),
        ("a ray's element", "if list[region].kind == 1u { return -x; }"),
        ("a ray's parameter", "return chosen(region, x) + chosen(law.kind, x);"),
        ("what changes", "var is = LEAPS; if x > 0.0 { is = true; } if is { return -x; }"),
        ("what a condition changes", "var is: bool; if x > 0.0 { is = true; } if is { return -x; }"),
    ] {
        let found = fixed_branches(&planted(function));
        assert!(found.is_empty(), "{form}: {found:?}");
    }
}

/// Unused declarations and reads are found if the linker leaves them in.
#[test]
fn the_check_finds_what_is_unused() {
    let clean = planted("");
    assert_eq!(unused(&clean).unwrap(), Vec::<String>::new());
    let with = |from: &str, to: &str| {
        let mut linked = clean.clone();
        linked.source = linked.source.replace(from, to);
        assert_ne!(linked.source, clean.source, "{from}");
        unused(&linked).unwrap()
    };
    let followed = "fn followed(";
    for (planted, found) in [
        ("fn idle() -> f32 { return 1.0; }", "fn idle"),
        ("var<workgroup> idle: f32;", "var idle"),
        ("@group(0) @binding(77) var<uniform> idle: vec4f;", "var idle"),
        ("struct Idle { a: f32 }", "type Idle"),
        ("const IDLE: f32 = 1.0;", "const IDLE"),
        ("override IDLE: f32 = 1.0;", "override IDLE"),
    ] {
        assert_eq!(with(followed, &format!("{planted}\n{followed}")), [found], "{planted}");
    }
    // A copy that is written, and never read.
    assert_eq!(with("+ law.a", ""), ["unread law"]);
}
