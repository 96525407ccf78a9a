//! The skies of two sides: their parts, each under names of its own.

use super::generated::unit;
use super::unit::Unit;
use super::{ProgramError, part};

/// `near_sky_radiance` and `beyond_sky_radiance`, of these two parts.
pub(super) fn two_skies(near: &str, beyond: &str) -> Result<[Unit; 2], ProgramError> {
    let text = |name: &str| part(name).map(|part| part.text).ok_or_else(|| ProgramError::NoPart(name.to_owned()));
    let near = text(near)?.replace("sky_", "near_sky_").replace("SkyFace", "NearSkyFace");
    let renamed = [
        ("sky_", "beyond_sky_"),
        ("SkyFace", "BeyondSkyFace"),
        ("struct Sky {", "struct BeyondSky {"),
        ("var<uniform> sky: Sky;", "var<uniform> beyond_sky: BeyondSky;"),
        ("sky.", "beyond_sky."),
    ];
    let beyond = renamed.iter().fold(text(beyond)?.to_owned(), |text, (from, to)| text.replace(from, to));
    Ok([unit("generated/near_sky.wgsl", near), unit("generated/beyond_sky.wgsl", beyond)])
}
