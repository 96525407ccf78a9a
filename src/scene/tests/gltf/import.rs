//! Tests of the glTF import: converted and skipped features, and the validity of the resulting scene.

mod colors;

use image::{ImageFormat, RgbImage};
use serde_json::{Value, json};

use super::{Made, SQUARE};
use crate::assets::Gltf;
use crate::model::camera::{Pinhole, Plane};
use crate::model::material::{Emissive, Glossy, Mirror, Phong};
use crate::scene::import::{Imported, import};
use crate::scene::{Density, LightSource, Pattern, Scene, Shadows, Substance};
use glam::DVec3;

/// A file in a separate folder, and the result of its import.
struct Case {
    folder: tempfile::TempDir,
    imported: Imported,
}

impl Case {
    fn of(made: &Made, rest: &Value) -> Self {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("a file.glb");
        std::fs::write(&path, made.glb(rest)).expect("written");
        let file = Gltf::open(made.glb(rest), &path).unwrap_or_else(|error| panic!("{error}"));
        let imported = import(&file, &folder.path().join("scene.toml")).unwrap_or_else(|error| panic!("{error}"));
        Self { folder, imported }
    }

    /// Returns the scene after its images are written.
    fn scene(&self) -> Scene {
        for (name, bytes) in &self.imported.pictures {
            std::fs::write(self.folder.path().join(name), bytes).expect("written");
        }
        let path = self.folder.path().join("scene.toml");
        std::fs::write(&path, &self.imported.text).expect("written");
        Scene::load(&path, &[]).unwrap_or_else(|error| panic!("{}\n{error}", self.imported.text))
    }
}

/// Returns the data of a square, and one node for each of these materials.
fn squares(materials: &[Value]) -> (Made, Value) {
    let mut made = Made::default();
    let positions = made.floats(&SQUARE);
    let uvs = made.floats(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]]);
    let meshes = (0..materials.len()).map(|i| {
        let attributes = json!({ "POSITION": positions, "TEXCOORD_0": uvs });
        json!({ "primitives": [{ "attributes": attributes, "mode": 5, "material": i }] })
    });
    let nodes = (0..materials.len()).map(|i| json!({ "mesh": i, "name": format!("n{i}"), "translation": [0, 0, i] }));
    let rest = json!({
        "nodes": nodes.collect::<Vec<_>>(),
        "meshes": meshes.collect::<Vec<_>>(),
        "materials": materials,
    });
    (made, rest)
}

fn pbr(metal: f64, rough: f64) -> Value {
    json!({ "pbrMetallicRoughness": { "baseColorFactor": [0.5, 0.25, 0.125, 1], "metallicFactor": metal, "roughnessFactor": rough } })
}

#[test]
fn materials_are_as_near_as_ours_come() {
    let glow = json!({
        "pbrMetallicRoughness": { "baseColorFactor": [0, 0, 0, 1] },
        "emissiveFactor": [1, 0.5, 0],
        "extensions": { "KHR_materials_emissive_strength": { "emissiveStrength": 4 } },
    });
    let unlit = json!({ "extensions": { "KHR_materials_unlit": {} } });
    let materials = [
        pbr(0.0, 1.0),
        pbr(0.0, 0.5),
        pbr(1.0, 0.0),
        pbr(1.0, 0.1),
        pbr(1.0, 0.5),
        glow,
        unlit,
        json!({ "name": "a \"b\"\n" }),
    ];
    let (made, rest) = squares(&materials);
    let case = Case::of(&made, &rest);
    let scene = case.scene();
    assert_eq!(scene.objects.len(), 8);
    let base = DVec3::new(0.5, 0.25, 0.125);
    let of = |i: usize| {
        let Substance::Opaque(material) = scene.objects[i].substance else { panic!("object {i} is clear") };
        &scene.materials[material]
    };
    assert_eq!(of(0).surface.downcast::<Phong>().expect("phong").specular, DVec3::ZERO);
    assert_eq!(of(0).color, Pattern::Constant(base));
    // The exponent 2/r⁴ − 2 at r = 1/2 is 30, and 0.04 (30 + 8)/8 is 0.19.
    let phong = of(1).surface.downcast::<Phong>().expect("phong");
    assert!((phong.shininess - 30.0).abs() < 1e-4 && (phong.specular.x - 0.19).abs() < 1e-6, "{phong:?}");
    assert!(of(2).surface.downcast::<Mirror>().is_some() && of(2).color == Pattern::Constant(base));
    // The exponent is a quarter of 2/r⁴ − 2 at r = 1/10.
    assert!((of(3).surface.downcast::<Glossy>().expect("glossy").exponent - 4999.5).abs() < 1e-2);
    assert_eq!(of(4).surface.downcast::<Phong>().expect("phong").specular, 0.5 * base);
    assert!(
        of(5).surface.downcast::<Emissive>().is_some() && of(5).color == Pattern::Constant(DVec3::new(4.0, 2.0, 0.0))
    );
    assert!(of(6).surface.downcast::<Emissive>().is_some() && of(6).color == Pattern::Constant(DVec3::ONE));
    assert_eq!(of(7).name, "a \"b\"\n");
    let told = case.imported.left_out.join("\n");
    assert_eq!(told.matches("rough metals").count(), 1, "each kind is reported once: {told}");
    assert!(told.contains("added: a camera") && !told.contains("added: a light"), "an emitter shines: {told}");
}

#[test]
fn pictures_within_get_files_of_their_own() {
    let texture = json!({ "pbrMetallicRoughness": { "baseColorTexture": { "index": 0 }, "metallicFactor": 0 } });
    let spotted = json!({ "pbrMetallicRoughness": { "baseColorTexture": { "index": 1 }, "metallicRoughnessTexture": { "index": 0 } } });
    let (mut made, mut rest) = squares(&[texture, spotted]);
    let mut png = std::io::Cursor::new(Vec::new());
    // The green channel is roughness, 51/255, and the blue channel is metalness, 0.
    RgbImage::from_pixel(2, 2, image::Rgb([255, 51, 0])).write_to(&mut png, ImageFormat::Png).expect("a PNG");
    let view = made.view(png.into_inner());
    let other = made.view(*b"RIFF....WEBP");
    rest["images"] = json!([{ "bufferView": view, "name": "my tiles/1" }, { "bufferView": other }]);
    rest["textures"] = json!([{ "source": 0 }, { "source": 1 }]);
    let case = Case::of(&made, &rest);
    assert_eq!(case.imported.pictures.len(), 1);
    assert_eq!(case.imported.pictures[0].0, "scene-my_tiles_1.png");
    let scene = case.scene();
    assert!(matches!(scene.materials[0].color, Pattern::Picture { .. }));
    // Magenta is clearly wrong; its highlight reflects the rest.
    assert_eq!(scene.materials[1].color, Pattern::Constant(DVec3::new(0.96, 0.0, 0.96)));
    let told = case.imported.left_out.join("\n");
    for said in [
        "images in the format WebP, which bentray does not support; convert them to PNG or JPEG and export again (of \
         `image 1`)",
        "which become magenta",
        "which are replaced by their means",
        "added: a light",
    ] {
        assert!(told.contains(said), "{told}");
    }
    // A roughness of 0.2 without metalness.
    let phong = scene.materials[1].surface.downcast::<Phong>().expect("phong");
    assert!(phong.shininess > 1000.0, "{phong:?}");
}

/// Checks textures with an extension's image or with none.
#[test]
fn textures_without_an_image_of_their_own_are_told() {
    let of = |index: usize| json!({ "pbrMetallicRoughness": { "baseColorTexture": { "index": index }, "metallicFactor": 0 } });
    let rough = json!({ "pbrMetallicRoughness": { "metallicRoughnessTexture": { "index": 0 } } });
    let (mut made, mut rest) = squares(&[of(0), of(1), of(2), of(9), rough]);
    let webp = made.view(*b"RIFF\x04\0\0\0WEBP");
    let mut png = std::io::Cursor::new(Vec::new());
    RgbImage::from_pixel(2, 2, image::Rgb([9, 9, 9])).write_to(&mut png, ImageFormat::Png).expect("a PNG");
    let view = made.view(png.into_inner());
    rest["images"] = json!([{ "bufferView": webp, "name": "tiles", "mimeType": "image/webp" }, { "bufferView": view }]);
    let by = |source: usize| json!({ "extensions": { "EXT_texture_webp": { "source": source } } });
    rest["textures"] = json!([by(0), by(1), {}]);
    rest["extensionsUsed"] = json!(["EXT_texture_webp"]);
    let case = Case::of(&made, &rest);
    let told = case.imported.left_out.join("\n");
    assert!(!told.contains("4294967295"), "{told}");
    for said in
        ["images in the format WebP", "(of `tiles`)", "textures without an image (of `material 2`, `material 3`)"]
    {
        assert!(told.contains(said), "{told}");
    }
    let scene = case.scene();
    let magenta = Pattern::Constant(DVec3::new(1.0, 0.0, 1.0));
    let is_missing = [0, 1, 2, 3].map(|i| scene.materials[i].color == magenta);
    assert_eq!(is_missing, [true, false, true, true]);
}

#[test]
fn cameras_and_lights_are_where_their_nodes_are() {
    let (made, mut rest) = squares(&[pbr(0.0, 1.0)]);
    let half = std::f64::consts::FRAC_1_SQRT_2;
    let light = |index: usize| json!({ "KHR_lights_punctual": { "light": index } });
    for node in [
        // Rotated by a right angle around y, the camera looks along −x.
        json!({ "camera": 0, "translation": [9, 1, 2], "rotation": [0, half, 0, half] }),
        json!({ "camera": 1, "translation": [0, 0, 9] }),
        json!({ "extensions": light(0), "translation": [1, 2, 3] }),
        // Rotated by a right angle around x, the light shines upwards.
        json!({ "extensions": light(1), "rotation": [half, 0, 0, half] }),
        json!({ "extensions": light(2), "translation": [3, 2, 1] }),
    ] {
        rest["nodes"].as_array_mut().expect("nodes").push(node);
    }
    rest["cameras"] = json!([
        { "type": "perspective", "perspective": { "yfov": 1, "aspectRatio": 2, "znear": 0.1 } },
        { "type": "orthographic", "orthographic": { "xmag": 3, "ymag": 2, "znear": 0, "zfar": 9 } },
    ]);
    let pi = std::f64::consts::PI;
    rest["extensions"] = json!({ "KHR_lights_punctual": { "lights": [
        { "type": "point", "intensity": 3.0 * pi, "color": [1, 0.5, 0] },
        { "type": "directional", "intensity": pi },
        { "type": "spot", "intensity": pi, "spot": {} },
    ] } });
    let case = Case::of(&made, &rest);
    let scene = case.scene();
    let camera = scene.camera.as_ref().expect("a camera");
    assert_eq!((camera.position, scene.image.size), (DVec3::new(9.0, 1.0, 2.0), [1200, 600]));
    assert!(camera.forward.abs_diff_eq(DVec3::NEG_X, 1e-6) && camera.up.abs_diff_eq(DVec3::Y, 1e-6), "{camera:?}");
    assert!((camera.projection.downcast::<Pinhole>().expect("a pinhole").fov - 1.0_f64.to_degrees()).abs() < 1e-4);
    assert_eq!(scene.lights.len(), 3);
    assert_eq!(scene.lights[0].source, LightSource::Point(DVec3::new(1.0, 2.0, 3.0)));
    assert!(scene.lights[0].color.abs_diff_eq(DVec3::new(3.0, 1.5, 0.0), 1e-6) && scene.lights[0].falls);
    let LightSource::Directional(direction) = scene.lights[1].source else { panic!("{:?}", scene.lights[1]) };
    assert!(direction.abs_diff_eq(DVec3::Y, 1e-6) && scene.lights[1].shadows == Shadows::Straight);
    let told = case.imported.left_out.join("\n");
    for said in ["cameras other than the first", "the cones of spot lights, which become point lights (of `node 5`)"] {
        assert!(told.contains(said), "{told}");
    }
    // The other camera can be selected.
    let other = case.imported.text.replace("[camera]\nfov", "[none]\nfov").replace("# [camera]", "[camera]");
    let lines = other.lines().skip_while(|line| *line != "[camera]").take(6).map(|line| line.trim_start_matches("# "));
    let text = format!("{}\n[rays]\nbounding_sphere = {{ radius = 20 }}\n", lines.collect::<Vec<_>>().join("\n"));
    let plane = super::super::good(&text);
    let plane =
        plane.camera.as_ref().and_then(|camera| camera.projection.downcast::<Plane>().map(|plane| plane.height));
    assert!((plane.expect("a plane") - 4.0).abs() < 1e-6);
}

#[test]
fn closed_glass_is_filled_and_open_glass_is_told() {
    let glass = json!({ "extensions": { "KHR_materials_transmission": { "transmissionFactor": 1 }, "KHR_materials_ior": { "ior": 1.25 } } });
    let mut made = Made::default();
    let positions = made.floats(&[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);
    let closed = made.accessor(5121, "SCALAR", 12, [0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3]);
    let open = made.accessor(5121, "SCALAR", 9, [0, 2, 1, 0, 1, 3, 1, 2, 3]);
    let primitive =
        |indices: usize| json!({ "attributes": { "POSITION": positions }, "indices": indices, "material": 0 });
    let rest = json!({
        "nodes": [{ "mesh": 0 }],
        "meshes": [{ "primitives": [primitive(closed), primitive(open), { "attributes": { "POSITION": positions }, "mode": 0 }] }],
        "materials": [glass],
    });
    let case = Case::of(&made, &rest);
    let scene = case.scene();
    assert_eq!(scene.objects.len(), 2);
    assert!(scene.objects[0].interior().is_some() && scene.objects[1].interior().is_none());
    let told = case.imported.left_out.join("\n");
    assert!(told.contains("not imported: points and lines (of `node 0`)") && told.contains("not closed"), "{told}");
}

/// Checks the Beer–Lambert law: white light acquires the volume's color over its distance.
#[test]
fn volumes_absorb_light() {
    let glass = |volume: &Value| {
        json!({ "extensions": {
            "KHR_materials_transmission": { "transmissionFactor": 1 },
            "KHR_materials_ior": { "ior": 1.25 },
            "KHR_materials_volume": volume,
        } })
    };
    let color = [0.5, 0.125, 1.0];
    let volumes = [
        json!({ "thicknessFactor": 1, "attenuationDistance": 4, "attenuationColor": color }),
        json!({ "thicknessFactor": 1, "attenuationColor": color }),
        json!({ "attenuationDistance": 4, "attenuationColor": color }),
        json!({ "thicknessFactor": 1, "attenuationDistance": 0, "attenuationColor": color }),
        json!({ "thicknessFactor": 1, "attenuationDistance": 0.5, "attenuationColor": [0, 0.25, 0.5] }),
    ];
    let mut made = Made::default();
    let positions = made.floats(&[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);
    let closed = made.accessor(5121, "SCALAR", 12, [0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3]);
    let primitive = |material: usize| json!({ "primitives": [{ "attributes": { "POSITION": positions }, "indices": closed, "material": material }] });
    let all = 0..volumes.len();
    let rest = json!({
        "nodes": all.clone().map(|i| json!({ "mesh": i, "translation": [3 * i, 0, 0] })).collect::<Vec<_>>(),
        "meshes": all.clone().map(primitive).collect::<Vec<_>>(),
        "materials": volumes.iter().map(glass).collect::<Vec<_>>(),
        "extensionsUsed": ["KHR_materials_volume"],
    });
    let case = Case::of(&made, &rest);
    let scene = case.scene();
    let left = |i: usize, distance: f64| {
        let interior = scene.objects[i].interior().expect("an interior");
        assert_eq!(interior.medium.index(DVec3::ZERO), Some(1.25));
        let absorption = interior.absorption.as_deref()?;
        let Density::Even(density) = absorption.density else { panic!("{absorption:?}") };
        Some((-distance * density).exp())
    };
    // The scene has numbers of 32 bits.
    assert!(left(0, 4.0).expect("a filter").abs_diff_eq(color.into(), 1e-6));
    assert!(left(0, 8.0).expect("a filter").abs_diff_eq(DVec3::new(0.25, 1.0 / 64.0, 1.0), 1e-6));
    assert!(left(4, 1.0).expect("a filter").abs_diff_eq(DVec3::new(0.0, 1.0 / 16.0, 0.25), 1e-6));
    assert_eq!([1, 2, 3].map(|i| left(i, 1.0)), [None; 3]);
    let told = case.imported.left_out.join("\n");
    for said in ["absorption of thin-walled materials (`thicknessFactor` is 0)", "a distance that is not above 0"] {
        assert!(told.contains(said), "{told}");
    }
    assert!(!told.contains("extension KHR_materials_volume"), "{told}");
}
