//! Which method a scene's rays are followed by, where it leaves that open: as was decided before, or by a search.

use super::decisions::{Decision, Place, Rays};
use super::frames::Film;
use crate::error::Error;
use crate::gpu::Gpu;
use crate::measure::{calibrate, calibrate_for, compared_layers};
use crate::render::RenderSettings;
use crate::scene::Scene;

/// The scene with a method, found by calibration where it leaves that open, and the settings that keep what is compiled already.
/// `scene` is that of `film`, or of a frame of it.
pub(super) fn settle(
    gpu: &Gpu,
    (film, frame): (&Film, Option<u32>),
    scene: Scene,
    mut settings: RenderSettings,
    rays: Rays,
) -> Result<(Scene, RenderSettings), Error> {
    if scene.rays.auto.is_none() {
        return Ok((scene, settings));
    }
    let place = Place::of(gpu, film, frame, &settings, rays);
    let kept = place.as_ref().and_then(Place::find);
    let known = kept.and_then(|kept| Some((film.load_as(frame, &kept.followed).ok()?, kept)));
    if let Some((scene, kept)) = known {
        tell_choice(&kept.said, kept.warning.as_deref());
        if kept.compared_layers {
            settings.choice.layers = compared_layers(&settings.choice.layers);
        }
        return Ok((scene, settings));
    }
    let calibration = match rays {
        Rays::Given(rays) => calibrate(gpu, &scene, &settings, Some(rays)),
        Rays::Camera(count) => calibrate_for(gpu, &scene, &settings, count),
    }?;
    let Some(calibration) = calibration else { return Ok((scene, settings)) };
    let warning = calibration.warning();
    tell_choice(&calibration.to_string(), warning.as_deref());
    let scene = calibration.applied(&scene);
    if let Some(place) = place {
        let (said, followed) = (calibration.to_string(), scene.rays.followed());
        let compared_layers = calibration.layers != settings.choice.layers;
        place.keep(Decision { said, warning, followed, compared_layers });
    }
    settings.choice.layers = calibration.layers;
    Ok((scene, settings))
}

fn tell_choice(said: &str, warning: Option<&str>) {
    tell!("{said}");
    if let Some(warning) = warning {
        tell!("warning: {warning}");
    }
}
