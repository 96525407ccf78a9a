//! The report on the star catalogs of a scene.

use serde_json::{Value, json};

use crate::cli::format::counted;
use crate::gpu::star_bytes;
use crate::scene::{Scene, Stars};

/// The stars of one side of the sky.
pub(super) struct Catalog<'a> {
    /// The key of the stars.
    key: &'static str,
    stars: &'a Stars,
    /// The number of stars that are shown.
    shown: usize,
    /// The magnitudes of the brightest and the faintest star, and of all together.
    magnitudes: Option<[f64; 3]>,
}

impl<'a> Catalog<'a> {
    /// Returns the catalogs of a scene; one that both sides of the sky share counts once.
    pub(super) fn all(scene: &'a Scene) -> Vec<Self> {
        let [near, other] = [scene.stars[0].as_ref(), scene.stars[1].as_ref()];
        let other = other.filter(|other| near.is_none_or(|near| !near.are_those_of(other)));
        let own = |(key, stars): (&'static str, Option<&'a Stars>)| Some(Self::new(key, stars?));
        [("sky.stars", near), ("sky.other_side.stars", other)].into_iter().filter_map(own).collect()
    }

    fn new(key: &'static str, stars: &'a Stars) -> Self {
        let shown: Vec<f64> = stars.shown().map(|star| star.magnitude.into()).collect();
        let brightest = shown.iter().copied().reduce(f64::min);
        let faintest = shown.iter().copied().reduce(f64::max);
        let flux: f64 = shown.iter().map(|magnitude| 10_f64.powf(-0.4 * magnitude)).sum();
        let magnitudes = brightest.zip(faintest).map(|(first, last)| [first, last, -2.5 * flux.log10()]);
        Self { key, stars, shown: shown.len(), magnitudes }
    }

    pub(super) fn words(&self) -> String {
        let Self { key, stars, shown, magnitudes } = self;
        let (name, read) = (&stars.catalog.name, stars.catalog.stars.len());
        let of = if *shown < read { format!(" of {read}") } else { String::new() };
        let magnitudes = magnitudes.map_or(String::new(), |[brightest, faintest, all]| {
            format!(", magnitudes {brightest:.2} to {faintest:.2}, all together {all:.2}")
        });
        let bytes = star_bytes(*shown);
        format!("{key}: {name}, {}{of}{magnitudes}; {bytes} bytes", counted((*shown, "star")))
    }

    pub(super) fn json(&self) -> Value {
        let Self { key, stars, shown, magnitudes } = self;
        // Catalogs have two or three decimals.
        let magnitude = |k: usize| magnitudes.map(|all| (1e3 * all[k]).round() / 1e3);
        json!({
            "key": key,
            "file": stars.catalog.name,
            "read": stars.catalog.stars.len(),
            "shown": shown,
            "brightest": magnitude(0),
            "faintest": magnitude(1),
            "magnitude": magnitude(2),
            "bytes": star_bytes(*shown),
        })
    }
}
