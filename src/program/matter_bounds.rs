//! The bounds of matter that is given by formulas along a piece of a path, as WGSL.

use std::fmt::Write as _;

use super::formula::body;
use super::interval::Bounds;
use crate::assets::{Id, Variable, VolumeFormulas};
use crate::model::absorption::Density;
use crate::scene::Scene;

/// The variables of emission and absorption other than coordinates, and their ranges.
const OTHERS: [(Variable, &str); 2] = [(VolumeFormulas::DENSITY, "density"), (VolumeFormulas::NU, "frequencies")];

/// The matter of a volume or of a medium, whose formulas depend on position or time.
struct Bounded<'a> {
    /// The end of the names of its functions.
    name: String,
    /// The condition in WGSL that a piece is in the matter.
    condition: String,
    /// The place of its points: volumes come first, and the medium of the current step is the last.
    slot: usize,
    formulas: &'a VolumeFormulas,
    /// The kind of absorption, if this is a medium.
    medium: Option<&'a Density>,
}

impl<'a> Bounded<'a> {
    fn of_volumes(scene: &'a Scene) -> impl Iterator<Item = Self> {
        let all = scene.volumes.iter().enumerate().filter(|(_, volume)| volume.formulas.varies());
        all.map(|(v, volume)| Self {
            name: format!("volume_{v}"),
            condition: format!("(within & {}u) != 0u", 1_u32 << v),
            slot: v,
            formulas: &volume.formulas,
            medium: None,
        })
    }

    fn of_media(scene: &'a Scene) -> impl Iterator<Item = Self> {
        let slot = scene.volumes.len();
        let all = scene.absorptions().filter_map(|own| Some((own, own.formulas()?))).enumerate();
        all.filter(|(_, (_, formulas))| formulas.varies()).map(move |(which, (own, formulas))| Self {
            name: format!("medium_{which}"),
            condition: format!("absorption.kind == {} && absorption.which == {which}u", own.kind().to_uppercase()),
            slot,
            formulas,
            medium: Some(&own.density),
        })
    }

    /// Returns the kinds of light: the colors of media, frequencies, or the colors of coefficients. Of powers of the frequency, only the
    /// factor is compared.
    fn lights(&self, light: &Light) -> usize {
        match self.formulas.exponents() {
            _ if self.medium.is_some() => 3,
            None if light.is_spectral => light.frequencies.len(),
            _ => self.formulas.coefficients.len(),
        }
    }

    /// Generates the record of the values at a point from which the bounds along a piece follow.
    fn recorded(&self) -> String {
        let (name, slot) = (&self.name, self.slot);
        let leaves: Vec<Id> = bounds(self.formulas).leaves.into_keys().collect();
        let (lines, values) = body(self.formulas.graph(), &leaves, &VolumeFormulas::VARIABLES);
        let mut text = format!("\nfn see_{name}(p: MatterPlace) {{\n{lines}");
        for (k, value) in values.iter().enumerate() {
            let _ = writeln!(text, "    see_value({slot}u, {k}u, {value});");
        }
        let _ = writeln!(text, "    see_point({slot}u);\n}}\n");
        text
    }

    /// Generates the functions of the range of the density and of the largest emission and absorption.
    fn ranges(&self) -> String {
        let (name, formulas) = (&self.name, self.formulas);
        let bounds = bounds(formulas);
        let count = bounds.leaves.len();
        let (lines, values) = bounds.body(&[formulas.density]);
        // Functions of constants are not evaluated in 64 bits.
        let is_constant = formulas.graph().number(formulas.density).is_some();
        let range = if is_constant { values.join("") } else { format!("max({}, Real2(0.0))", values.join("")) };
        let mut text = format!(
            "fn density_range_{name}(ranges: array<Real2, {count}>) -> Real2 {{\n{lines}    return {range};\n}}\n\n"
        );
        for (c, channel) in formulas.coefficients.iter().enumerate() {
            let (lines, values) = bounds.body(&[formulas.temperature.unwrap_or(channel.emission), channel.absorption]);
            let [emission, absorption] = &values[..] else { continue };
            let emission = match formulas.temperature {
                Some(_) => format!("interval_product({emission}, {absorption}).y"),
                None => most(formulas, channel.emission, emission),
            };
            let number = formulas.graph().number(channel.absorption);
            let absorption = match (self.medium, number) {
                // A color's coefficient is largest where the color is least.
                (Some(Density::Color(_)), Some(color)) => format!("Real({:?})", -color.max(1e-30).ln()),
                (Some(Density::Color(_)), None) => format!("-real_log(max({absorption}.x, 1e-30))"),
                _ => most(formulas, channel.absorption, absorption),
            };
            let _ = writeln!(
                text,
                "fn most_{c}_{name}(ranges: array<Real2, {count}>, density: Real2, frequencies: Real2) -> Real2 {{\n\
                 {lines}    return Real2({emission}, {absorption});\n}}\n"
            );
        }
        text
    }

    /// Generates the test whether the piece hides some of this matter.
    fn hides(&self, light: &Light) -> String {
        let (name, slot, formulas) = (&self.name, self.slot, self.formulas);
        let count = bounds(formulas).leaves.len();
        let ranges: Vec<_> = (0..count).map(|k| format!("seen_range({slot}u, {k}u)")).collect();
        let mut text = format!(
            "    if {} {{\n        let ranges = array<Real2, {count}>({});\n        let density = density_range_{name}(ranges);\n",
            self.condition,
            ranges.join(", ")
        );
        let has_factors = formulas.exponents().is_some() || self.medium.is_some();
        let most = |c: usize| {
            let nu = light.frequencies[c];
            let frequencies =
                if has_factors { "Real2(1.0)".to_owned() } else { format!("{nu:?} * seen_shifts({slot}u)") };
            format!("most_{}_{name}(ranges, density, {frequencies})", c.min(formulas.coefficients.len() - 1))
        };
        // Light of given frequencies has the mean of a medium's colors.
        let is_mean = self.medium.is_some() && light.is_spectral;
        let lights = if is_mean { 1 } else { self.lights(light) };
        for c in 0..lights {
            let value = if is_mean { format!("({} + {} + {}) / 3.0", most(0), most(1), most(2)) } else { most(c) };
            let _ = writeln!(text, "        let most_{c} = {value};");
            let all = if lights == 1 { 0..light.frequencies.len() } else { c..c + 1 };
            for k in all {
                let _ =
                    writeln!(text, "        hides = hides_light({slot}u, {c}u, {k}u, most_{c}, piece, size) || hides;");
            }
        }
        text + "    }\n"
    }
}

/// The light whose matter is bounded.
pub(super) struct Light {
    /// The frequency of each channel, in units of ν₀.
    pub frequencies: Vec<f64>,
    /// Channels are frequencies instead of colors.
    pub is_spectral: bool,
}

/// Returns the bounds of the density, emission and absorption.
fn bounds(formulas: &VolumeFormulas) -> Bounds<'_> {
    Bounds::new(formulas.graph(), &formulas.light(), &OTHERS)
}

/// Returns the upper end of a range; naga does not evaluate components of constant vectors.
fn most(formulas: &VolumeFormulas, id: Id, range: &str) -> String {
    formulas.graph().number(id).map_or_else(|| format!("{range}.y"), |number| format!("Real({number:?})"))
}

/// Generates the bounds of all matter: the records of points, and the test whether a piece of a path may hide matter.
pub(super) fn matter_bounds(scene: &Scene, bounds_media: bool, light: &Light) -> String {
    let volumes: Vec<_> = Bounded::of_volumes(scene).collect();
    let media: Vec<_> = Bounded::of_media(scene).filter(|_| bounds_media).collect();
    let all = || volumes.iter().chain(&media);
    let slots = scene.volumes.len() + usize::from(bounds_media);
    let functions = all().map(|own| bounds(own.formulas).leaves.len()).max().unwrap_or(0);
    let lights = all().map(|own| own.lights(light)).max().unwrap_or(1);
    let mut text = format!(
        "const MATTER_SLOTS: u32 = {slots}u;\nconst MEDIUM_SLOT: u32 = {}u;\nconst SMOOTH_FUNCTIONS: u32 = {functions}u;\n\
         const LIGHTS_SEEN: u32 = {lights}u;\n",
        scene.volumes.len()
    );
    let mut end =
        "fn see_end(step: Stretch, within: u32, f: Real) {\n    let spot = stretch_spot(step, f);\n".to_owned();
    let mut medium = "fn see_medium(p: MatterPlace) {\n".to_owned();
    let mut hides =
        "fn matter_hides(within: u32, piece: TransferPiece, size: Real) -> bool {\n    var hides = false;\n".to_owned();
    for own in all() {
        text += &own.recorded();
        text += &own.ranges();
        hides += &own.hides(light);
    }
    for Bounded { name, condition, .. } in &volumes {
        let _ = writeln!(
            end,
            "    if {condition} {{\n        see_{name}({});\n    }}",
            name.replace('_', "_place_") + "(spot)"
        );
    }
    for Bounded { name, condition, .. } in &media {
        let _ = writeln!(medium, "    if {condition} {{\n        see_{name}(p);\n    }}");
    }
    if bounds_media {
        end += "    see_medium(placed_by_origin(spot, absorption.center));\n";
    }
    text + &medium + "}\n\n" + &hides + "    return hides;\n}\n\n" + &end + "}\n\n"
}
