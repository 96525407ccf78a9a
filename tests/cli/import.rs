//! `import`: a glTF file becomes a scene that can be rendered.

use std::io::Cursor;

use bentray::scene::{Picture, Scene};
use image::{ImageFormat, Rgb, RgbImage};

use super::Folder;

/// Returns a file with a sign of 2 × 2 units, which shows an image of four colors and needs no light, and with a gray wall
/// at its right, 1 unit behind it and lit by a light of 4π candela in front. The camera is 5 units in front of the sign.
fn file() -> Vec<u8> {
    let mut png = Cursor::new(Vec::new());
    let colors = [[255, 0, 0], [0, 255, 0], [0, 0, 255], [255, 255, 255]];
    RgbImage::from_fn(2, 2, |x, y| Rgb(colors[(x + 2 * y) as usize])).write_to(&mut png, ImageFormat::Png).unwrap();
    let corners: [[f32; 3]; 4] = [[-1.0, 1.0, 0.0], [-1.0, -1.0, 0.0], [1.0, 1.0, 0.0], [1.0, -1.0, 0.0]];
    let uvs: [[f32; 2]; 4] = [[0.0, 0.0], [0.0, 1.0], [1.0, 0.0], [1.0, 1.0]];
    let numbers = corners.iter().flatten().chain(uvs.iter().flatten());
    let mut bytes: Vec<u8> = numbers.flat_map(|x| x.to_le_bytes()).collect();
    bytes.extend(png.into_inner());
    while !bytes.len().is_multiple_of(4) {
        bytes.push(0);
    }
    let (length, picture) = (bytes.len(), bytes.len() - 80);
    let mut json = format!(
        r#"{{ "asset": {{ "version": "2.0" }}, "extensionsUsed": ["KHR_lights_punctual", "KHR_materials_unlit"],
        "buffers": [{{ "byteLength": {length} }}],
        "bufferViews": [{{ "buffer": 0, "byteLength": 48 }}, {{ "buffer": 0, "byteOffset": 48, "byteLength": 32 }},
            {{ "buffer": 0, "byteOffset": 80, "byteLength": {picture} }}],
        "accessors": [{{ "bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 4 }},
            {{ "bufferView": 1, "componentType": 5126, "type": "VEC2", "count": 4 }}],
        "images": [{{ "name": "sign", "mimeType": "image/png", "bufferView": 2 }}], "textures": [{{ "source": 0 }}],
        "materials": [
            {{ "name": "sign", "pbrMetallicRoughness": {{ "baseColorTexture": {{ "index": 0 }} }},
                "extensions": {{ "KHR_materials_unlit": {{}} }} }},
            {{ "name": "wall", "doubleSided": true, "pbrMetallicRoughness": {{ "baseColorFactor": [0.5, 0.5, 0.5, 1],
                "metallicFactor": 0, "roughnessFactor": 1 }} }}],
        "meshes": [{{ "primitives": [{{ "attributes": {{ "POSITION": 0, "TEXCOORD_0": 1 }}, "mode": 5, "material": 0 }}] }},
            {{ "primitives": [{{ "attributes": {{ "POSITION": 0 }}, "mode": 5, "material": 1 }}] }}],
        "cameras": [{{ "type": "perspective", "perspective": {{ "yfov": 0.7610127542247298, "aspectRatio": 2, "znear": 0.1 }} }}],
        "extensions": {{ "KHR_lights_punctual": {{ "lights": [{{ "type": "point", "intensity": 12.566370614359172 }}] }} }},
        "nodes": [{{ "name": "sign", "mesh": 0 }}, {{ "name": "wall", "mesh": 1, "translation": [2.4, 0, -1] }},
            {{ "camera": 0, "translation": [0, 0, 5] }},
            {{ "translation": [2.4, 0, 1], "extensions": {{ "KHR_lights_punctual": {{ "light": 0 }} }} }}] }}"#
    );
    while !json.len().is_multiple_of(4) {
        json.push(' ');
    }
    let word = |number: usize| (number as u32).to_le_bytes();
    let whole = 28 + json.len() + length;
    [b"glTF", &word(2)[..], &word(whole), &word(json.len()), b"JSON", json.as_bytes(), &word(length), b"BIN\0", &bytes]
        .concat()
}

#[test]
fn a_file_becomes_a_scene_that_shows_it() {
    let folder = Folder::new();
    folder.write("room.glb", file());
    let ran = folder.run("import room.glb -o new.toml").succeeds();
    assert!(ran.out.contains("wrote new.toml; render it with"), "{}", ran.out);
    assert_eq!(ran.err, "", "everything is imported");
    assert_eq!(folder.names(), ["new-sign.png", "new.toml", "room.glb"]);
    folder.run("check new.toml").succeeds();
    folder.run("render new.toml -o new.png --size 80x40 --samples 1 --strict").succeeds();
    let picture = Picture::load(&folder.path("new.png")).unwrap();
    // The tangent of half the angle is 0.4: at a distance of 5 units, 2 units are half of the height, and a pixel is a tenth of a unit.
    let at = |x: f64, y: f64, z: f64| {
        let per_unit = 50.0 / (5.0 - z);
        let (column, row) = ((40.0 + x * per_unit) as usize, (20.0 - y * per_unit) as usize);
        picture.pixels[row * 80 + column]
    };
    for (x, y, expected) in [
        (-0.5, 0.5, [1.0, 0.0, 0.0]),
        (0.5, 0.5, [0.0, 1.0, 0.0]),
        (-0.5, -0.5, [0.0, 0.0, 1.0]),
        (0.5, -0.5, [1.0; 3]),
    ] {
        // Between texels, half a pixel is 0.05 texels.
        for (found, expected) in at(x, y, 0.0).into_iter().zip(expected) {
            assert!((found - expected).abs() < 0.11, "{x} {y}: {found} {expected}");
        }
    }
    // An intensity of 4 at a distance of 2 is 1, times the gray 0.5, plus a tenth of that. Half a pixel away there is a factor cos⁴.
    let wall = at(2.4, 0.0, -1.0);
    assert!(wall.iter().all(|value| (value - 0.55).abs() < 0.01), "{wall:?}");
    let scene = Scene::load(&folder.path("new.toml"), &[]).unwrap();
    assert_eq!(scene.image.size, [1200, 600]);
}

#[test]
fn nothing_is_replaced_and_a_wrong_file_leaves_nothing() {
    let folder = Folder::new();
    folder.write("room.glb", file());
    folder.write("new-sign.png", "mine");
    folder
        .run("import room.glb -o new.toml")
        .fails(1, &["new-sign.png: the file exists already; name another scene, or remove it first"]);
    assert_eq!((folder.text("new-sign.png"), folder.names().len()), ("mine".to_owned(), 2));
    folder.write("new.toml", "mine");
    folder.run("import room.glb -o new.toml").fails(1, &["new.toml: the file exists already"]);
    folder.write("cut.glb", &file()[..500]);
    folder
        .run("import cut.glb -o cut.toml")
        .fails(1, &["cannot use the mesh `cut.glb`: at byte 8: the header declares "]);
    folder.run("import none.glb -o cut.toml").fails(1, &["cannot read `none.glb`"]);
    folder.write("empty.gltf", r#"{ "asset": { "version": "2.0" } }"#);
    folder.run("import empty.gltf -o cut.toml").fails(1, &["the scene of the file has no triangles"]);
    assert!(!folder.names().contains(&"cut.toml".to_owned()));
}

#[test]
fn what_is_no_gltf_is_said_in_words() {
    let folder = Folder::new();
    for bytes in [&b"\x89PNG\r\n\x1a\n and more"[..], b"[1, 2]", b""] {
        std::fs::write(folder.path("a.gltf"), bytes).unwrap();
        let said = "cannot use the mesh `a.gltf`: not a glTF file: it begins neither with `glTF` nor with `{`";
        folder.run("import a.gltf -o a.toml").fails(1, &[said]);
    }
}
