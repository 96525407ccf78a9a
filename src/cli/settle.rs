//! Which method a scene's rays are followed by, where it leaves that open: as was decided before, or by a search.

use super::decisions::{Decision, Place, Rays};
use super::frames::Film;
use crate::error::Error;
use crate::gpu::{Gpu, halved_pictures};
use crate::measure::{Preparation, calibrate, calibrate_paths, compared_layers};
use crate::render::{LightTracer, RenderSettings, Renderer, StartPart, StartUp};
use crate::scene::Scene;

/// A scene with its method.
pub(super) struct Settled<'a> {
    pub scene: Scene,
    /// They keep what is compiled already.
    pub settings: RenderSettings,
    /// Of the same program, where a search has compiled it.
    pub renderer: Option<Renderer<'a>>,
    /// As well, for the paths between lights and places.
    pub light_tracer: Option<LightTracer<'a>>,
}

/// The scene with a method, found by calibration where it leaves that open. `scene` is that of `film`, or of a frame of it; `launch`
/// is told how long compiling and searching took.
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
    let place = Place::of(gpu, film, frame, &settings, rays);
    let kept = place.as_ref().and_then(Place::find);
    let known = kept.and_then(|kept| Some((film.load_as(frame, &kept.followed).ok()?, kept)));
    if let Some((scene, kept)) = known {
        tell_choice(&kept.said, kept.warning.as_deref());
        if kept.compared_layers {
            settings.choice.layers = compared_layers(&settings.choice.layers);
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
        let compared_layers = calibration.layers != settings.choice.layers;
        place.keep(&Decision { said, warning, followed: scene.rays.followed(), compared_layers });
    }
    settings.choice.layers = calibration.layers;
    Ok(Settled { scene, settings, renderer, light_tracer })
}

fn tell_choice(said: &str, warning: Option<&str>) {
    tell!("{said}");
    if let Some(warning) = warning {
        tell!("warning: {warning}");
    }
}
