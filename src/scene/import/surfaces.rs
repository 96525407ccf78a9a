//! The import of materials: metallic and rough surfaces as mirrors, lobes, and matte surfaces with a highlight.
//!
//! *Theory.* A roughness r means slopes of width r² (Trowbridge–Reitz), which is close to a Blinn exponent 2/r⁴ − 2 of the half vector;
//! around the mirror direction the exponent is a quarter of it. Dielectrics reflect 0.04 at normal incidence, and a lobe of exponent e with
//! equal energy is (e + 8)/8 times as high. Lights illuminate matte surfaces only, so rough metals are also matte.

use std::path::Path;

use glam::{DVec3, Vec3, Vec4, Vec4Swizzles};

use super::text::{Left, color, key, number, quoted, vector};
use crate::assets::json::extensions::material::Volume;
use crate::assets::json::material::{AlphaMode, Material};
use crate::assets::json::texture::{Info, WrappingMode};
use crate::assets::json::validation::Checked::Valid;
use crate::assets::json::{Index, Texture};
use crate::assets::{Gltf, image_of};

mod paint;
mod pictures;
use paint::{Base, Paint};
use pictures::Pictures;

/// The materials that objects use.
pub(super) struct Surfaces<'a> {
    file: &'a Gltf,
    pictures: Pictures<'a>,
    /// The materials written so far: index in the file, use of vertex colors, and name.
    known: Vec<(Option<usize>, bool, String)>,
    text: String,
    shines: bool,
}

/// The roughness above which a surface looks matte.
const MATTE: f64 = 0.2;
/// The roughness below which a surface is a mirror.
const SMOOTH: f64 = 0.05;
/// The color of surfaces whose image cannot be loaded.
const MISSING: DVec3 = DVec3::new(1.0, 0.0, 1.0);
/// The reflectance of dielectrics at normal incidence.
const DIELECTRIC: f64 = 0.04;

impl<'a> Surfaces<'a> {
    pub fn new(file: &'a Gltf, folder: &'a Path, stem: &str) -> Self {
        let pictures = Pictures::new(file, folder, stem);
        Self { file, pictures, known: Vec::new(), text: String::new(), shines: false }
    }

    /// Returns `true` if one of the materials emits.
    pub fn shines(&self) -> bool {
        self.shines
    }

    /// Returns the tables, and the images to write.
    pub fn finish(self) -> (String, Vec<(String, Vec<u8>)>) {
        (self.text, self.pictures.within)
    }

    /// Returns the key of an object's substance; `has_vertex_colors` is `true` if its mesh has vertex colors.
    pub fn substance(
        &mut self,
        number: Option<usize>,
        has_vertex_colors: bool,
        is_closed: impl Fn() -> bool,
        left: &mut Left,
    ) -> String {
        let material = number.and_then(|number| self.file.root.materials.get(number));
        let extensions = material.and_then(|material| material.extensions.as_ref());
        let transmitted = extensions.and_then(|all| all.transmission.as_ref()).map_or(0.0, |t| t.transmission_factor.0);
        if let Some((material, extensions)) = material.zip(extensions).filter(|_| transmitted > 0.0) {
            let name = material.name.clone().unwrap_or_default();
            if transmitted >= 0.5 && is_closed() {
                left.out("color and roughness of transmissive surfaces, which become clear", &name);
                let index = extensions.ior.as_ref().map_or(1.5, |ior| f64::from(ior.ior.0));
                let index = number_above_one(index);
                let Some(density) = extensions.volume.as_ref().and_then(|volume| absorption(volume, &name, left))
                else {
                    return format!("interior = {index}");
                };
                let density = vector(density);
                return format!(
                    "interior = {{ kind = \"constant\", n = {index}, absorption = {{ coefficient = {density} }} }}"
                );
            }
            left.out("transmission of surfaces that are not closed or that transmit less than half", &name);
        }
        format!("material = {}", quoted(&self.named(number, has_vertex_colors, left)))
    }

    /// Returns the name of a material, and writes the material if it is new.
    fn named(&mut self, index: Option<usize>, has_vertex_colors: bool, left: &mut Left) -> String {
        let is_it = |(known, colored, _): &&(_, _, String)| (*known, *colored) == (index, has_vertex_colors);
        if let Some((.., name)) = self.known.iter().find(is_it) {
            return name.clone();
        }
        let material = index.and_then(|index| self.file.root.materials.get(index)).cloned().unwrap_or_default();
        let own = material.name.clone().filter(|name| !name.is_empty());
        let mut name = own.unwrap_or_else(|| index.map_or("default".to_owned(), |index| format!("material {index}")));
        while self.known.iter().any(|(.., known)| *known == name) {
            name += "'";
        }
        let keys = self.keys(&material, has_vertex_colors, &name, left);
        self.text.extend([format!("[materials.{}]\n{keys}\n", key(&name))]);
        self.known.push((index, has_vertex_colors, name.clone()));
        name
    }

    /// Returns the keys of a material.
    fn keys(&mut self, material: &Material, has_vertex_colors: bool, name: &str, left: &mut Left) -> String {
        let pbr = &material.pbr_metallic_roughness;
        let extensions = material.extensions.as_ref();
        let strength = extensions.and_then(|all| all.emissive_strength.as_ref()).map_or(1.0, |s| s.emissive_strength.0);
        let emission = Vec3::from(material.emissive_factor.0).as_dvec3() * f64::from(strength);
        let base = Vec4::from(pbr.base_color_factor.0).xyz().as_dvec3();
        let picture = pbr.base_color_texture.as_ref().map(|info| self.picture(info, base, name, left));
        let pattern = Paint { base: picture.unwrap_or(Base::Color(base)), has_vertex_colors };
        lost(material, name, left);
        if extensions.is_some_and(|all| all.unlit.is_some()) {
            self.shines = true;
            return format!("kind = \"emissive\"\ncolor = {pattern}\n");
        }
        let is_black = matches!(pattern.base, Base::Color(DVec3::ZERO));
        if emission != DVec3::ZERO && is_black {
            self.shines = true;
            let glow = material.emissive_texture.as_ref().map(|info| self.picture(info, emission, name, left));
            let glow = Paint { base: glow.unwrap_or(Base::Color(emission)), has_vertex_colors: false };
            return format!("kind = \"emissive\"\ncolor = {glow}\n");
        }
        let (metal, rough) = self.metal_and_roughness(material, name, left);
        if metal >= 0.5 && rough < MATTE {
            if emission != DVec3::ZERO {
                left.out("emission of smooth metals", name);
            }
            if rough < SMOOTH {
                return format!("kind = \"mirror\"\ncolor = {pattern}\n");
            }
            return format!("kind = \"glossy\"\ncolor = {pattern}\nexponent = {}\n", number(blinn(rough) / 4.0));
        }
        let mut keys = if metal >= 0.5 {
            left.out("reflections of rough metals, which become matte with a highlight", name);
            matte_metal(&pattern, rough)
        } else {
            matte(&pattern, rough)
        };
        if emission != DVec3::ZERO {
            if material.emissive_texture.is_some() {
                left.out("emission textures on surfaces that are not black", name);
            } else {
                self.shines = true;
                keys.extend([format!("emission = {}\n", color(emission))]);
            }
        }
        keys
    }

    /// Returns the path of an image, or magenta, which is clearly wrong, if it cannot be loaded. `factor` is the color that would multiply
    /// it.
    fn picture(&mut self, info: &Info, factor: DVec3, name: &str, left: &mut Left) -> Base {
        let texture: Option<&Texture> = self.file.root.get(info.index);
        let path = image_number(texture, name, left).and_then(|number| self.pictures.path(number, left));
        let Some(path) = path else {
            left.out("colors of surfaces whose image is unreadable, which become magenta", name);
            return Base::Color(MISSING);
        };
        if !factor.abs_diff_eq(DVec3::ONE, 1e-3) {
            left.out("color factors of textures", name);
        }
        let sampler = texture.and_then(|texture| texture.sampler);
        let sampler = sampler.and_then(|sampler: Index<_>| self.file.root.get(sampler));
        let repeats = |wrap| matches!(wrap, Valid(WrappingMode::Repeat));
        if sampler.is_some_and(|sampler| !repeats(sampler.wrap_s) || !repeats(sampler.wrap_t)) {
            left.out("wrap modes of textures, which repeat instead", name);
        }
        Base::Image(path)
    }

    /// Returns the mean metalness and roughness of a surface.
    fn metal_and_roughness(&mut self, material: &Material, name: &str, left: &mut Left) -> (f64, f64) {
        let pbr = &material.pbr_metallic_roughness;
        let (metal, rough) = (f64::from(pbr.metallic_factor.0), f64::from(pbr.roughness_factor.0));
        let Some(info) = &pbr.metallic_roughness_texture else { return (metal, rough) };
        left.out("metallic-roughness textures, which are replaced by their means", name);
        let texture: Option<&Texture> = self.file.root.get(info.index);
        let mean = image_number(texture, name, left).and_then(|number| self.pictures.mean(number, left));
        mean.map_or((metal, rough), |[_, green, blue]| (metal * blue, rough * green))
    }
}

/// Returns the index of a texture's image.
fn image_number(texture: Option<&Texture>, name: &str, left: &mut Left) -> Option<usize> {
    let number = texture.and_then(image_of);
    if number.is_none() {
        left.out("textures without an image", name);
    }
    number
}

/// Records features of a material that the scene format does not support.
fn lost(material: &Material, name: &str, left: &mut Left) {
    if material.normal_texture.is_some() {
        left.out("normal maps", name);
    }
    if material.occlusion_texture.is_some() {
        left.out("occlusion maps", name);
    }
    if !matches!(material.alpha_mode, Valid(AlphaMode::Opaque)) {
        left.out("transparency of colors", name);
    }
}

/// Returns the Blinn exponent of a roughness.
fn blinn(rough: f64) -> f64 {
    (2.0 / rough.clamp(0.01, 1.0).powi(4) - 2.0).clamp(0.0, 1e6)
}

/// Returns a matte surface with the highlight of its roughness.
fn matte(pattern: &Paint, rough: f64) -> String {
    let exponent = blinn(rough).min(1e4);
    let height = (DIELECTRIC * (exponent + 8.0) / 8.0).min(0.5);
    let Some(color) = pattern.constant().filter(|_| exponent >= BROAD) else {
        return highlight(&format!("diffuse = {pattern}\n"), DVec3::splat(height), exponent);
    };
    // The two parts together reflect at most all light, also after their rounding to 32 bits.
    let below = color.min(DVec3::splat(1.0 - DIELECTRIC));
    let left = (1.0 - 1e-6 - below.max_element()).max(0.0);
    let diffuse = Paint { base: Base::Color(below), has_vertex_colors: false };
    highlight(&format!("diffuse = {diffuse}\n"), DVec3::splat(height.min(left)), exponent)
}

/// Returns a rough metal, which reflects half of the light diffusely and half in its highlight.
fn matte_metal(pattern: &Paint, rough: f64) -> String {
    let base = match &pattern.base {
        Base::Color(color) => Base::Color(0.5 * *color),
        image @ Base::Image(_) => image.clone(),
    };
    // A highlight has a single color.
    let height = pattern.constant().map_or(DVec3::splat(0.3), |color| 0.5 * color);
    highlight(
        &format!("diffuse = {}\n", Paint { base, has_vertex_colors: pattern.has_vertex_colors }),
        height,
        blinn(rough),
    )
}

/// The exponent below which a highlight is indistinguishable from the matte term.
const BROAD: f64 = 2.0;

fn highlight(diffuse: &str, height: DVec3, exponent: f64) -> String {
    if exponent < BROAD || height.max_element() <= 0.0 {
        return diffuse.to_owned();
    }
    format!("{diffuse}specular = {}\nshininess = {}\n", color(height), number(exponent))
}

/// Returns the absorption coefficient σ of a volume per unit length, or `None` if it does not absorb. White light acquires the volume's
/// color c over its distance d: e^(−σ d) = c. Rays pass through the mesh, so that `thickness` only indicates a volume.
fn absorption(volume: &Volume, name: &str, left: &mut Left) -> Option<DVec3> {
    /// The optical depth over the distance for a channel that is fully absorbed.
    const OPAQUE: f64 = 1e6;
    let color = Vec3::from(volume.attenuation_color.0).as_dvec3();
    let distance = f64::from(volume.attenuation_distance.0);
    if color == DVec3::ONE || distance == f64::INFINITY {
        return None;
    }
    if volume.thickness_factor.0 <= 0.0 {
        left.out("absorption of thin-walled materials (`thicknessFactor` is 0)", name);
        return None;
    }
    let is_color = color.cmpge(DVec3::ZERO).all() && color.cmple(DVec3::ONE).all();
    if !(is_color && distance > 0.0) {
        left.out("absorption with a color outside 0 to 1, or a distance that is not above 0", name);
        return None;
    }
    Some(color.to_array().map(|c| (-c.ln()).clamp(0.0, OPAQUE) / distance).into())
}

/// Returns a valid index of refraction as text.
fn number_above_one(index: f64) -> String {
    number(index.clamp(1.0, 10.0))
}
