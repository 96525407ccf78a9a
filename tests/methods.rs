//! Checks 'Model no more than a scene needs' for every method, control and precision that the law of each shipped scene allows.

use std::collections::BTreeSet;
use std::path::Path;

use bentray::model::Law;
use bentray::model::law::{FlowOrder, HoleForm, InMedium, Lorenz, Rossler, RoundHole, Straight};
use bentray::program::{Analysis, Features, Layer, Mode, ProgramOptions, RaySkipping, Schedule, link_all, plan};
use bentray::scene::{Precision, Rays, Scene};

use crate::exactness::unused;
use crate::support::shipped_scenes;

/// The laws that a method supports.
#[derive(Clone, Copy, PartialEq)]
enum For {
    All,
    SecondOrder,
    Medium,
    Straight,
}

/// Settings of `[rays]`, the laws that they support, and all the modules of steps, controls and memories that they need.
const SETTINGS: &[(&str, For, &str)] = &[
    ("method=euler", For::All, "method/step/euler method/control/planned method/control/scaled method/memory_step"),
    ("method=rk4", For::All, "method/step/rk4 method/control/planned method/control/scaled method/memory_step"),
    ("method=rk4 step=0.1", For::All, "method/step/rk4 method/control/planned method/control/fixed method/memory_step"),
    (
        "method=rk4 curvature_step=2",
        For::All,
        "method/step/rk4 method/control/planned method/control/curvature method/memory_step",
    ),
    (
        "method=leapfrog",
        For::SecondOrder,
        "method/step/leapfrog method/control/planned method/control/scaled method/memory_step",
    ),
    (
        "method=leapfrog step=0.1",
        For::SecondOrder,
        "method/step/leapfrog method/control/planned method/control/fixed method/memory_step",
    ),
    (
        "method=rkn4",
        For::SecondOrder,
        "method/step/rkn4 method/control/planned method/control/scaled method/memory_step",
    ),
    (
        "method=rkn4 curvature_step=2",
        For::SecondOrder,
        "method/step/rkn4 method/control/planned method/control/curvature method/memory_step",
    ),
    ("method=euler-doubling", For::All, "method/step/euler method/control/doubling method/memory_step"),
    ("method=rk4-doubling", For::All, "method/step/rk4 method/control/doubling method/memory_step"),
    ("method=euler-doubling doubling=paper", For::All, "method/step/euler method/control/doubling method/memory_step"),
    ("method=bogacki-shampine", For::All, "method/step/bogacki_shampine method/control/embedded method/memory_pair"),
    ("method=dormand-prince", For::All, "method/step/dormand_prince method/control/embedded method/memory_pair"),
    (
        "method=dormand-prince segment=chord",
        For::All,
        "method/step/dormand_prince method/control/embedded method/memory_pair",
    ),
    ("method=snell", For::Medium, "method/step/snell method/control/planned method/control/scaled method/memory_step"),
    (
        "method=snell step=0.1",
        For::Medium,
        "method/step/snell method/control/planned method/control/fixed method/memory_step",
    ),
    ("method=exact", For::Straight, "method/memory_step"),
];

/// A precision, and its modules for numbers and state.
type State = (Precision, &'static str);

/// Returns the order of a flow.
fn flow_order(law: &dyn Law) -> Option<FlowOrder> {
    let lorenz = law.downcast().map(|Lorenz { order, .. }| *order);
    lorenz.or_else(|| law.downcast().map(|Rossler { order, .. }| *order))
}

/// Returns the form of a black hole's law.
fn form(law: &dyn Law) -> Option<HoleForm> {
    law.downcast().map(|RoundHole { form, .. }| *form)
}

fn allows(law: &dyn Law, wanted: For) -> bool {
    match wanted {
        For::All => true,
        For::Medium => law.downcast::<InMedium>().is_some(),
        For::Straight => law.downcast::<Straight>().is_some(),
        For::SecondOrder => flow_order(law) != Some(FlowOrder::Velocity) && form(law) != Some(HoleForm::Geodesic),
    }
}

/// Loads the scene with a setting and without its objects, whose files are large.
fn bare(path: &Path, setting: &str) -> Option<Scene> {
    let keys = setting.split_whitespace().map(str::to_owned).chain(["objects=[]", "lights=[]"].map(str::to_owned));
    let overrides: Vec<_> = keys.map(|key| key.parse().unwrap()).collect();
    Scene::load(path, &overrides).ok()
}

/// Returns the other form of the scene's law, if any.
fn other_form(law: &dyn Law) -> Option<&'static str> {
    form(law).map(|_| "law.form=geodesic").or(flow_order(law).map(|_| "law.order=2"))
}

/// Returns choices to cycle through, so that each way to cut a program meets each row of the table: seven, which is not a multiple of the
/// number of precisions.
fn choices() -> Vec<ProgramOptions> {
    let mut all = vec![ProgramOptions { masks: RaySkipping::Off, ..ProgramOptions::default() }];
    for schedule in [Schedule::Fused, Schedule::Paper, Schedule::Segment] {
        for (mode, layers) in [(Mode::Picture, Layer::ALL.to_vec()), (Mode::Trace, Vec::new())] {
            all.push(ProgramOptions {
                schedule,
                masks: if mode == Mode::Picture { RaySkipping::List } else { RaySkipping::Off },
                mode,
                layers,
                ..ProgramOptions::default()
            });
        }
    }
    all
}

/// Checks every pass of the scene's program: nothing in it is unused, and its modules for steps, controls, memories,
/// numbers and states are together exactly the needed ones.
fn check(scene: &Scene, options: &ProgramOptions, needed: &str, at: &str) {
    let analysis = Analysis::of(scene);
    let features = Features::of(scene, options, &analysis);
    let planned = plan(scene, &analysis, &features).unwrap();
    let mut parts = BTreeSet::new();
    let entries: Vec<&str> = features.passes().iter().map(|pass| pass.entry()).collect();
    for linked in link_all(&planned, &entries).unwrap_or_else(|error| panic!("{at}: {error}")) {
        let unused = unused(&linked).unwrap_or_else(|error| panic!("{at}: {error}"));
        assert!(unused.is_empty(), "{at}: pass {} has {unused:?} without use", linked.entry);
        parts.extend(linked.parts().into_iter().map(|part| part.trim_end_matches(".wgsl").to_owned()));
    }
    let contracts =
        ["method/step/", "method/control/", "method/memory_", "real/f", "state/ray", "state/te", "state/buffer"];
    parts.retain(|part| contracts.iter().any(|contract| part.starts_with(contract)));
    // A path in one pass stores no state.
    let is_kept = |part: &&str| features.schedule != Schedule::Whole || !part.starts_with("state/");
    let needed: BTreeSet<String> = needed.split_whitespace().filter(is_kept).map(str::to_owned).collect();
    assert_eq!(parts, needed, "{at}");
}

/// Checks every setting with one form of the law: allowed settings in these precisions, and rejected ones. Returns the number of both.
fn check_settings(path: &Path, full: &Scene, form: &str, precisions: &[State]) -> [usize; 2] {
    let law = bare(path, form).unwrap().law;
    let mut choices = choices().into_iter().cycle();
    let [mut allowed, mut refused] = [0, 0];
    for (setting, wanted, steps) in SETTINGS {
        let bare = bare(path, &format!("rays.{} {form}", setting.replace(' ', " rays.")));
        assert_eq!(bare.is_some(), allows(&*law, *wanted), "{}: {form} {setting}", path.display());
        let Some(bare) = bare else {
            refused += 1;
            continue;
        };
        for (precision, state) in precisions {
            let rays = Rays { precision: *precision, ..bare.rays.clone() };
            let scene = Scene { law: bare.law.clone(), rays, ..full.clone() };
            let options = choices.next().unwrap();
            let at = format!("{}: {form} {setting} in {precision:?} under {options:?}", path.display());
            check(&scene, &options, &format!("{steps} {state}"), &at);
            allowed += 1;
        }
    }
    [allowed, refused]
}

fn check_scenes(precisions: &[State]) {
    let (mut counts, mut seen) = ([0, 0], BTreeSet::new());
    for path in shipped_scenes() {
        let full = Scene::load(&path, &[]).unwrap();
        // The other form of a law is checked only once.
        let other = other_form(&*full.law).filter(|form| seen.insert(*form));
        for form in [""].into_iter().chain(other) {
            let of_form = check_settings(&path, &full, form, precisions);
            counts = [0, 1].map(|k| counts[k] + of_form[k]);
        }
    }
    println!("{} programs, {} settings refused", counts[0], counts[1]);
    assert!(counts[0] > 100 && counts[1] > 20);
}

#[test]
fn in_16_and_32_bits_methods_have_their_own_parts_only() {
    check_scenes(&[
        (Precision::Half, "real/f32 state/ray state/texture"),
        (Precision::Single, "real/f32 state/ray state/texture"),
    ]);
}

#[test]
fn in_64_bits_methods_have_their_own_parts_only() {
    check_scenes(&[(Precision::Double, "real/f64 state/ray state/buffer")]);
}
