//! The choice of a scene's integration method, if the scene leaves it open: from a stored decision, or by a search.

use super::decisions::{Decision, DecisionFile, Rays};
use super::frames::Film;
use crate::error::Error;
use crate::gpu::{Gpu, halved_pictures};
use crate::measure::{Preparation, calibrate, calibrate_paths, compared_layers};
use crate::render::{LightTracer, RenderSettings, Renderer, StartPart, StartUp};
use crate::scene::Scene;

/// A scene with its method.
pub(super) struct Settled<'a> {
    pub scene: Scene,
    /// The settings, which reuse the layers and passes that are compiled already.
    pub settings: RenderSettings,
    /// The renderer of this program, if a search has compiled it.
    pub renderer: Option<Renderer<'a>>,
    /// The tracer of paths between lights and points, if a search has compiled it.
    pub light_tracer: Option<LightTracer<'a>>,
}

/// Returns the scene with a method, found by calibration if the scene leaves it open. `scene` is the scene of `film`, or one of its
/// frames; `launch` receives the time of compiling and searching.
pub(super) fn settle<'a>(
    gpu: &'a Gpu,
    (film, frame): (&Film, Option<u32>),
    scene: Scene,
    mut settings: RenderSettings,
    rays: Rays,
    launch: &mut StartUp,
) -> Result<Settled<'a>, Error> {
    let halved = halved_pictures(&scene, gpu.limits.max_texture_dimension_2d);
    for remark in scene.mesh_remarks().into_iter().chain(halved) {
        tell!("note: {remark}");
    }
    if scene.rays.auto.is_none() {
        return Ok(Settled { scene, settings, renderer: None, light_tracer: None });
    }
    let place = DecisionFile::of(gpu, film, frame, &settings, rays);
    let kept = place.as_ref().and_then(DecisionFile::find);
    let known = kept.and_then(|kept| Some((film.load_as(frame, &kept.followed).ok()?, kept)));
    if let Some((scene, kept)) = known {
        tell_choice(&kept.said, kept.warning.as_deref());
        if kept.compared_layers {
            settings.options.layers = compared_layers(&scene, &settings.options.layers);
        }
        return Ok(Settled { scene, settings, renderer: None, light_tracer: None });
    }
    let (calibration, renderer, light_tracer) = match rays {
        Rays::Given(rays) => (calibrate(gpu, &scene, &settings, Some(rays))?, None, None),
        Rays::Camera(count) => match Preparation::new(gpu, &scene, &settings)? {
            Some(prepared) => {
                launch.count(StartPart::Program);
                let (calibration, renderer) = prepared.choose(count)?;
                (calibration, renderer, None)
            }
            None => (None, None, None),
        },
        Rays::Between(pairs) => {
            let (calibration, tracer) = calibrate_paths(gpu, &scene, &settings, pairs)?.unzip();
            (calibration, None, tracer)
        }
    };
    let Some(calibration) = calibration else { return Ok(Settled { scene, settings, renderer, light_tracer }) };
    let said = calibration.to_string();
    let warning = calibration.warning();
    tell_choice(&said, warning.as_deref());
    let scene = calibration.applied(&scene);
    if let Some(place) = place {
        let compared_layers = calibration.layers != settings.options.layers;
        place.keep(&Decision { said, warning, followed: scene.rays.followed(), compared_layers });
    }
    settings.options.layers = calibration.layers;
    Ok(Settled { scene, settings, renderer, light_tracer })
}

fn tell_choice(said: &str, warning: Option<&str>) {
    tell!("{said}");
    if let Some(warning) = warning {
        tell!("warning: {warning}");
    }
}
