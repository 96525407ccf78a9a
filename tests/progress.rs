//! Tests the progress that a renderer reports.

use std::cell::RefCell;
use std::time::Duration;

use bentray::gpu::Gpu;
use bentray::program::{ProgramOptions, Schedule};
use bentray::progress::Progress;
use bentray::render::{Band, Preview, RenderError, RenderSettings, Renderer, Watch};
use bentray::scene::Scene;

use crate::support::open;

/// A ball in straight space.
const BALL: &str = r#"
[image]
size = [32, 24]
[camera]
position = [0, 0, 5]
[rays]
bounding_sphere = { radius = 10 }
[materials.white]
kind = "emissive"
color = [1, 1, 1]
[[objects]]
shape = "sphere"
material = "white"
"#;

/// Opens a device that reports the progress of all work.
fn watched() -> (Gpu, Progress) {
    let progress = Progress::watched();
    (open().reporting(progress.clone()), progress)
}

fn ball(keys: &[&str]) -> Scene {
    let overrides: Vec<_> = keys.iter().map(|key| key.parse().unwrap()).collect();
    Scene::parse(BALL, "test.toml".as_ref(), &overrides).unwrap()
}

/// Returns the fraction of the image that is done while it is rendered.
fn rendered(progress: &Progress) -> f64 {
    let state = progress.state().unwrap();
    assert_eq!(state.words, "rendering");
    state.done.unwrap()
}

#[test]
fn tiles_that_end_are_reported_though_a_sample_is_one_submission() {
    let (gpu, progress) = watched();
    for (schedule, keys) in [
        (Schedule::Whole, "image.samples=3"),
        (Schedule::Fused, "image.samples=3"),
        (Schedule::Segment, "image.samples=1"),
        (Schedule::Fused, "image.adaptive=0.1"),
    ] {
        let ball = ball(&[keys]);
        let options = ProgramOptions { schedule, ..ProgramOptions::default() };
        let settings = RenderSettings { options, tile_pixels: 32 * 8, ..RenderSettings::default() };
        let mut renderer = Renderer::new(&gpu, &ball, settings).unwrap();
        let mut rows = 0;
        let mut at_band = |band: Band| {
            let before = f64::from(rows) / 24.0;
            rows += band.rows;
            let (found, expected) = (rendered(&progress), f64::from(rows) / 24.0);
            // In an adaptive tile the amount of work is unknown until it has ended.
            let is_adaptive = keys.contains("adaptive");
            assert!(
                (found - expected).abs() < 1e-9 || is_adaptive && found > before && found <= expected,
                "{keys} {found}"
            );
            Ok(())
        };
        renderer.render_bands(&mut at_band).unwrap();
        assert!(rows == 24 && progress.state().is_none(), "{keys}");
    }
}

#[test]
fn samples_that_end_are_reported() {
    struct Looks<'p>(&'p Progress, RefCell<Vec<(u32, f64)>>);
    impl Preview for Looks<'_> {
        fn every(&self) -> Duration {
            Duration::ZERO
        }
        fn look(&self, _: &Band, samples: u32) -> Result<(), RenderError> {
            self.1.borrow_mut().push((samples, rendered(self.0)));
            Ok(())
        }
    }
    let (gpu, progress) = watched();
    let ball = ball(&["image.samples=5", "rays.lighting=path-tracing"]);
    let looks = Looks(&progress, RefCell::default());
    let mut renderer = Renderer::new(&gpu, &ball, RenderSettings::default()).unwrap();
    renderer.render_watched(&mut |_| Ok(()), &Watch { preview: Some(&looks), ..Watch::default() }).unwrap();
    let looks = looks.1.into_inner();
    assert!(looks.len() > 2, "{looks:?}");
    for (samples, done) in looks {
        assert!((done - f64::from(samples) / 5.0).abs() < 1e-9, "{done} after {samples}");
    }
}
