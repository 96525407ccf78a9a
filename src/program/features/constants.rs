//! Features as WGSL constants, by which the linker selects between variants that differ in a line.

use super::Features;
use crate::model::StereoLayout;
use crate::program::{Layer, Mode, PathEnds, RaySkipping, Schedule, Unit};

/// Pairs each field with its name.
macro_rules! named {
    ($of:expr; $($name:ident)+) => { vec![$((stringify!($name), $of.$name)),+] };
}

impl Features {
    /// Returns the features that modules use, under their names in WGSL.
    #[must_use]
    pub fn constants(&self) -> Vec<(String, bool)> {
        let plain = named!(self;
            splits has_rough_glass has_regions has_sided_mesh has_objects touches sees_glow
            follows_paths in_pieces aims emits_from_boxes clamps draws_wavelength falls grids_fall grids_all_fall
            is_occluded occludes_along_law looks_from_surfaces follows_lines all_cast shuts_out weakens_lines
            is_limited compensates_tau keeps_taken keeps_w keeps_last_hit has_leaps suspends items_in_order has_chords writes_chords_out ends_with_steps rejects keeps_errors captures_by_formula has_structure is_glossy captures is_extreme is_asymptotic is_plane is_about_center keeps_last carries_time by_length turns_with_camera travels has_throat joins_whole
            has_two_skies has_stars has_grid sample_is_grid first_is_grid centers_first defers_sky sees_through has_vertex_colors is_transparent enumerates adapts is_filmic keeps_footprints
            beams shifts_hues knows_shift follows_shift keeps_orders keeps_crossings
        );
        let volumes = named!(self.volumes;
            transfers transfers_orbits has_volumes media_absorb has_jumps emits absorbs is_spectral counts_transfer keeps_depth bounds_matter bounds_media has_edges has_grids shifts_volumes has_horizon volumes_change places_by_law is_parallel
        );
        let derived = [
            ("leaves_surfaces", self.looks_from_surfaces || self.shoots || self.follows_paths),
            ("looks_for_light", self.looks_from_surfaces || self.shoots),
            ("leaves_light", self.mode.leaves_light()),
            ("finds_caustics", self.mode == Mode::Caustics),
            ("is_given", self.mode.is_given()),
            ("chooses_pixels", self.mode == Mode::Pixels),
            ("draws", self.is_picture() || self.mode.leaves_light()),
            ("carries_light", self.follows_paths || self.sees_glow),
            ("sees_path_ends", !self.layers.is_empty() || self.sees_through),
            ("colors_dispersed", self.disperses && self.follows_paths),
            ("filters_images", self.keeps_footprints && self.has_images),
            ("keeps_bundles", self.keeps_bundles()),
            ("reads_bundles", self.keeps_footprints && !self.sample_is_grid),
            ("adds_starlight", self.has_stars && !self.sample_is_grid),
            ("keeps_sky_light", self.has_stars || self.defers_sky),
            ("describes_bundles", self.describes_bundles()),
            ("keeps_magnification", self.layers.contains(&Layer::Magnification)),
            ("keeps_bundle_shape", self.layers.contains(&Layer::Bundle)),
            ("ends_below", self.below_part.is_some()),
            ("skips_ended", self.masks != RaySkipping::Off),
            ("lists_open", self.lists_open()),
            ("lists_branches", self.lists_open() && self.rounds > 1),
            ("asks_tau", self.asks_tau()),
            ("counts_loops", self.device.loop_budget.is_some()),
            ("ends_on_arcs", self.has_objects && !self.has_chords),
            ("ends_on_chords", self.has_objects && self.has_chords),
            ("follows_whole", self.schedule == Schedule::Whole),
            ("has_three_slots", self.slots == 3),
            ("resumes", self.suspends && self.schedule != Schedule::Whole),
            ("keeps_ends", self.ends == PathEnds::Stored),
            ("shades_ends", self.shades_ends()),
            ("keeps_counts", self.keeps_counts()),
            ("keeps_length", self.is_picture() && self.layers.contains(&Layer::Depth)),
            ("side_by_side", self.views == Some(StereoLayout::SideBySide)),
            ("top_bottom", self.views == Some(StereoLayout::TopBottom)),
        ];
        plain.into_iter().chain(volumes).chain(derived).map(|(name, value)| (name.to_uppercase(), value)).collect()
    }

    /// Returns the constants as WGSL.
    pub(in crate::program) fn unit(&self) -> Unit {
        let constants = self.constants();
        let text = constants.iter().map(|(name, value)| format!("const {name}: bool = {value};\n"));
        Unit::generated("generated/features.wgsl", text.collect())
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;
    use std::path::Path;

    use super::*;
    use crate::program::tokens::Tokens;
    use crate::program::{Analysis, ProgramOptions, all_parts};
    use crate::scene::Scene;

    /// Constants that are generated elsewhere: for a kind of region, for obstacles and for the sources of forces.
    const OTHERS: [&str; 6] = ["IS_EMPTY", "IS_WHOLE", "LEAPS", "HAS_AIMS", "HAS_LISTS", "FINDS_NEAR"];

    #[test]
    fn parts_ask_for_every_constant_and_for_no_other() {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes/black_hole.toml");
        let scene = Scene::load(&path, &[]).unwrap();
        let constants = Features::of(&scene, &ProgramOptions::default(), &Analysis::of(&scene)).constants();
        let known: BTreeSet<String> =
            constants.into_iter().map(|(name, _)| name).chain(OTHERS.map(str::to_owned)).collect();
        let mut asked = BTreeSet::new();
        for part in all_parts() {
            let tokens = Tokens::of(part.text);
            for i in (0..tokens.len()).filter(|&i| tokens.word(i) == "if") {
                let at = if tokens.word(i + 1) == "!" { i + 2 } else { i + 1 };
                let name = tokens.word(at);
                let is_constant =
                    tokens.word(at + 1) == "{" && name.chars().all(|c| c.is_ascii_uppercase() || c == '_');
                assert!(!is_constant || known.contains(name), "{} requests {name}", part.file);
                asked.insert(name.to_owned());
            }
        }
        let idle: Vec<&String> = known.iter().filter(|name| !asked.contains(*name)).collect();
        assert!(idle.is_empty(), "no module requests {idle:?}");
    }
}
