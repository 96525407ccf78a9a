//! Tests `bentray light`, and the warnings about lights without effect.

use super::Folder;

const HOLE: &str = "[law]\nkind = \"schwarzschild\"\n[rays]\nbounding_sphere = { radius = 60 }\ntolerance = 1e-6\n\
    [materials.m]\ndiffuse = [1, 1, 1]\n[[objects]]\nshape = \"sphere\"\ncenter = [-3, 3.5, 1]\nradius = 0.2\nmaterial = \"m\"\n\
    [[lights]]\nkind = \"point\"\nposition = [12, 0, 0]\nshadows = \"curved-rays\"\n";

/// Near a black hole a light has an image on either side; behind a repulsive inverse-square center a point can have no image.
#[test]
fn paths_from_lights_are_listed() {
    let folder = Folder::with(HOLE);
    folder.write("places.csv", "x,y,z\n-6,7,2\n-6,-7,2\n");
    let ran =
        folder.run("light scene.toml --at places.csv -o -").succeeds().says(&["4 paths from 1 light to 2 points"]);
    let lines: Vec<&str> = ran.out.lines().collect();
    assert_eq!(lines[0], "place,light,status,leaves_x,leaves_y,leaves_z,arrives_x,arrives_y,arrives_z,spread");
    assert_eq!(lines.len(), 5, "{}", ran.out);
    assert!(lines[1].starts_with("0,0,") && lines[3].starts_with("1,0,"), "{}", ran.out);
    let numbers = |line: &str| line.split(',').skip(3).map(|word| word.parse::<f64>().unwrap()).collect::<Vec<_>>();
    for line in &lines[1..] {
        let numbers = numbers(line);
        let length = |at: usize| numbers[at..at + 3].iter().map(|x| x * x).sum::<f64>().sqrt();
        assert!((length(0) - 1.0).abs() < 1e-5 && (length(3) - 1.0).abs() < 1e-5 && numbers[6] > 0.0, "{line}");
    }
    let repelling = "[law]\nkind = \"sources\"\nsources = [{ position = [0, 0, 0], strength = -3 }]\n";
    folder.write("scene.toml", HOLE.replace("[law]\nkind = \"schwarzschild\"\n", repelling));
    folder.write("places.csv", "x,y,z\n-6,0.1,0\n");
    let ran = folder.run("light scene.toml --at places.csv -o -").succeeds();
    assert_eq!(ran.out.lines().nth(1), Some("0,0,none,,,,,,,"));
}

#[test]
fn what_cannot_be_lit_is_said() {
    let folder = Folder::with(&HOLE.replace("[12, 0, 0]", "[0, 1, 0]"));
    let checked = folder.run("check scene.toml").succeeds();
    assert!(checked.out.contains("lights[0] is inside a capture region and has no effect"), "{}", checked.out);
    folder.write("places.csv", "x,y,z\n1,2,3\n");
    folder.write("rays.csv", "x,y,z,vx\n1,2,3,4\n");
    folder
        .run("light scene.toml --at rays.csv -o -")
        .fails(1, &["rays.csv: line 1", "`vx` is not a valid column for points"]);
    folder.write("scene.toml", HOLE.replace("\"curved-rays\"", "\"straight-rays\""));
    folder.run("light scene.toml --at places.csv -o -").fails(1, &["requires a light with shadows = \"curved-rays\""]);
}

/// The memory of a photon grid is printed, and one that does not fit is rejected with both numbers.
#[test]
fn grids_say_what_they_take() {
    let scene = "[image]\nsize = [16, 12]\n[camera]\nposition = [0, 1, 6]\n[rays]\nbounding_sphere = { radius = 9 }\n\
        [materials.m]\ndiffuse = [1, 1, 1]\n[[objects]]\nshape = \"box\"\nmaterial = \"m\"\nsize = [4, 0.2, 4]\n\
        [[lights]]\nkind = \"point\"\nposition = [0, 2, 0]\nfalloff = \"inverse-square\"\nshadows = \"photon-grid\"\nvoxels = 24\n";
    let folder = Folder::with(scene);
    let checked = folder.run("check scene.toml").succeeds();
    assert!(checked.out.contains("photon grid of 24×5×24 voxels, 65536 paths"), "{}", checked.out);
    folder.run("render scene.toml -o out.png").succeeds().says(&["lights[0]: 24×5×24 voxels", "MiB"]);
    let ran = folder.run("render scene.toml -o no.png --memory 64KiB");
    assert_eq!(ran.code, Some(1), "{}", ran.err);
    ran.says(&["error: the photon grids have 2880 voxels and need", "but 65536 are allowed"]);
    assert!(!folder.names().contains(&"no.png".to_owned()));
    folder.write("places.csv", "x,y,z\n0.3,0.3,0.2\n0,8,0\n");
    let ran = folder.run("light scene.toml --at places.csv -o -").succeeds();
    let line = ran.out.lines().nth(1).unwrap();
    let spread: f64 = line.rsplit(',').next().unwrap().parse().unwrap();
    // The square of the distance, and a position far from all lit surfaces.
    assert!(line.starts_with("0,0,lit,,,,") && (spread / 3.02 - 1.0).abs() < 0.1, "{line}");
    assert_eq!(ran.out.lines().nth(2), Some("1,0,outside,,,,,,,"));
}
