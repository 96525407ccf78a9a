//! Tests of mesh shells: the inside depends on the surface, not on its winding in the file.

use std::path::Path;

use glam::{DMat3, DVec3, Vec3};
use proptest::prelude::*;

use super::{mistakes_of, parse};
use crate::scene::{Mesh, Object, Scene};

/// A box between two corners, optionally wound inward.
#[derive(Debug, Clone, Copy)]
struct Shell {
    lo: DVec3,
    hi: DVec3,
    inward: bool,
}

fn shell(lo: [f64; 3], hi: [f64; 3], inward: bool) -> Shell {
    Shell { lo: lo.into(), hi: hi.into(), inward }
}

/// Returns a cube around the origin.
fn cube(half: f64, inward: bool) -> Shell {
    shell([-half; 3], [half; 3], inward)
}

impl Shell {
    fn holds(&self, x: DVec3) -> bool {
        x.cmpgt(self.lo).all() && x.cmplt(self.hi).all()
    }

    /// Returns its vertices and its triangles with their winding.
    fn parts(&self) -> (Vec<DVec3>, Vec<[usize; 3]>) {
        let corner =
            |i: usize| DVec3::from_array([0, 1, 2].map(|k| if i >> k & 1 == 1 { self.hi[k] } else { self.lo[k] }));
        let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
        let triangles = faces.iter().flat_map(|[a, b, c, d]| [[*a, *b, *c], [*a, *c, *d]]);
        let wound = |[a, b, c]: [usize; 3]| if self.inward { [a, c, b] } else { [a, b, c] };
        ((0..8).map(corner).collect(), triangles.map(wound).collect())
    }
}

/// Returns an OBJ file of shells, transformed by a matrix.
fn obj(shells: &[Shell], map: DMat3) -> String {
    let (mut text, mut before) = (String::new(), 1);
    for shell in shells {
        let (vertices, triangles) = shell.parts();
        text.extend(vertices.iter().map(|x| map * *x).map(|x| format!("v {} {} {}\n", x.x, x.y, x.z)));
        text.extend(triangles.iter().map(|t| format!("f {} {} {}\n", t[0] + before, t[1] + before, t[2] + before)));
        before += vertices.len();
    }
    text
}

fn mesh(text: &str) -> Mesh {
    Mesh::parse(text, Path::new("a.obj")).unwrap_or_else(|e| panic!("{e}"))
}

/// Returns points that fill the cube |x|, |y|, |z| ≤ 4 evenly, none of them on a surface.
fn points() -> impl Iterator<Item = DVec3> {
    let step = DVec3::new(0.819_172_513_396, 0.671_043_606_703, 0.549_700_477_901);
    (1..600).map(move |i| 8.0 * (f64::from(i) * step).fract() - 4.0)
}

/// Returns the number of meshes that replace one for rays, after a check that each winds around no point more than once and that together
/// they contain the expected points.
fn layers(mesh: &Mesh, map: DMat3, expected: impl Fn(DVec3) -> bool) -> usize {
    assert_eq!(mesh.opening(), None);
    let solids: Vec<&Mesh> = match mesh.solids() {
        [] => vec![mesh],
        solids => solids.iter().map(|solid| &**solid).collect(),
    };
    for x in points() {
        let windings: Vec<f64> = solids.iter().map(|solid| solid.winding(map * x - mesh.origin)).collect();
        let near = |winding: &f64, whole: f64| (winding - whole).abs() < 1e-5;
        assert!(windings.iter().all(|winding| near(winding, 0.0) || near(winding, 1.0)), "{x}: {windings:?}");
        assert_eq!(windings.iter().any(|winding| near(winding, 1.0)), expected(x), "{x}: {windings:?}");
    }
    solids.len()
}

/// Returns the number of layers for the shells as given, and after a rotation that leaves no face parallel to an axis.
fn layers_of(shells: &[Shell], expected: impl Fn(DVec3) -> bool) -> usize {
    let turn = DMat3::from_rotation_z(0.3) * DMat3::from_rotation_x(0.7);
    let counts = [DMat3::IDENTITY, turn].map(|map| layers(&mesh(&obj(shells, map)), map, &expected));
    assert_eq!(counts[0], counts[1], "{shells:?}");
    counts[0]
}

const BOTH: [bool; 2] = [false, true];

#[test]
fn every_shell_apart_is_turned_outward() {
    for (first, second) in BOTH.into_iter().flat_map(|first| BOTH.map(|second| (first, second))) {
        let apart =
            [shell([-3.0, -1.0, -1.0], [-1.0, 1.0, 1.0], first), shell([1.0, -1.0, -1.0], [3.0, 1.0, 1.0], second)];
        assert_eq!(layers_of(&apart, |x| apart.iter().any(|shell| shell.holds(x))), 1);
    }
}

/// Checks that a shell in a shell is a cavity, and a shell in a cavity a solid, like CGAL's `orient_to_bound_a_volume`.
#[test]
fn nested_shells_alternate() {
    for inward in 0..8 {
        let shells = [3.5, 2.0, 1.0].map(|half| cube(half, inward >> (half as u32) & 1 == 1));
        assert_eq!(layers_of(&shells, |x| shells.iter().filter(|shell| shell.holds(x)).count() % 2 == 1), 1);
    }
}

#[test]
fn what_is_wound_right_stays_as_it_is() {
    for shells in [vec![cube(2.0, false)], vec![cube(3.0, false), cube(2.0, true), cube(1.0, false)]] {
        let mesh = mesh(&obj(&shells, DMat3::IDENTITY));
        assert!(mesh.opening().is_none() && mesh.solids().is_empty());
    }
}

/// Checks that overlapping or touching shells form a union, which a ray intersects as several objects.
#[test]
fn overlapping_shells_are_solids_of_their_own() {
    let crossing =
        [shell([-3.0, -1.0, -1.0], [0.7, 1.0, 1.0], false), shell([-0.5, -0.8, -1.2], [2.0, 1.3, 1.5], false)];
    // Four faces of each shell are coplanar with faces of the other.
    let flush = [shell([-1.0, -0.7, -0.7], [0.4, 0.7, 0.7], false), shell([-0.4, -0.7, -0.7], [1.0, 0.7, 0.7], false)];
    let touching =
        [shell([-2.0, -1.0, -1.0], [0.0, 1.0, 1.0], false), shell([0.0, -0.5, -0.5], [2.0, 0.6, 0.6], false)];
    for [a, b] in [crossing, flush, touching] {
        for (first, second) in BOTH.into_iter().flat_map(|first| BOTH.map(|second| (first, second))) {
            let shells = [Shell { inward: first, ..a }, Shell { inward: second, ..b }];
            assert_eq!(layers_of(&shells, |x| a.holds(x) || b.holds(x)), 2, "{shells:?}");
        }
    }
    // In a row only neighbors overlap, so that two layers suffice.
    let row: Vec<Shell> =
        (0..7).map(f64::from).map(|i| shell([i - 4.0, -1.0, -1.0], [i - 2.7, 1.0, 1.1], false)).collect();
    assert_eq!(layers_of(&row, |x| row.iter().any(|shell| shell.holds(x))), 2);
}

/// Checks that a solid through the wall of a cavity is an additional solid if its winding equals that of the outer shell around it.
#[test]
fn a_solid_in_the_wall_of_a_cavity_is_no_cavity() {
    let [outer, cavity] = [cube(3.5, false), cube(2.0, true)];
    let bead = shell([1.5, -0.5, -0.5], [2.5, 0.5, 0.5], false);
    for flip in BOTH {
        let shells = [outer, cavity, bead].map(|shell| Shell { inward: shell.inward != flip, ..shell });
        assert_eq!(layers_of(&shells, |x| outer.holds(x) && !cavity.holds(x) || bead.holds(x)), 2);
    }
}

/// Checks that two boxes may share a face, and that duplicate faces count once.
#[test]
fn faces_that_cancel_or_repeat_do_not_count() {
    let [a, b] = [shell([-2.0, -1.0, -1.0], [0.0, 1.0, 1.0], false), shell([0.0, -1.0, -1.0], [2.0, 1.0, 1.0], false)];
    let both = |x| a.holds(x) || b.holds(x);
    // Both are cut along one diagonal, so that the shared face cancels.
    let text = obj(&[a, b], DMat3::IDENTITY);
    assert_eq!(layers(&mesh(&text), DMat3::IDENTITY, both), 1);
    let once = obj(&[a], DMat3::IDENTITY);
    let doubled =
        format!("{once}{}", once.lines().filter(|line| line.starts_with("f 1 ")).collect::<Vec<_>>().join("\n"));
    assert_eq!(layers(&mesh(&doubled), DMat3::IDENTITY, |x| a.holds(x)), 1);
    let sheet = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\nf 1 4 3 2\n";
    assert_eq!(mesh(sheet).opening(), Some("the mesh encloses no volume"));
}

#[test]
fn triangles_that_are_wound_against_their_neighbors_are_turned() {
    let own = cube(2.0, false);
    let text = obj(&[own], DMat3::IDENTITY).replace("f 1 2 6", "f 2 1 6").replace("f 5 6 8", "f 6 5 8");
    assert!(text.contains("f 2 1 6") && text.contains("f 6 5 8"));
    assert_eq!(layers(&mesh(&text), DMat3::IDENTITY, |x| own.holds(x)), 1);
}

/// Checks that given normals stay if they point outward, and turn with the faces if they do not.
#[test]
fn normals_are_on_the_outside_of_turned_faces() {
    for side in [1, -1] {
        let [p, m] = [side, -side];
        let text = format!(
            "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvn {m} 0 0\nvn 0 {m} 0\nvn 0 0 {m}\nvn {p} {p} {p}\n\
             f 1//1 4//1 3//1\nf 1//2 2//2 4//2\nf 1//3 3//3 2//3\nf 2//4 3//4 4//4\n"
        );
        let outward = mesh(&text);
        let inward = mesh(
            &text
                .replace("f 1//1 4//1 3//1", "f 1//1 3//1 4//1")
                .replace("f 1//2 2//2 4//2", "f 1//2 4//2 2//2")
                .replace("f 1//3 3//3 2//3", "f 1//3 2//3 3//3")
                .replace("f 2//4 3//4 4//4", "f 2//4 4//4 3//4"),
        );
        assert!(outward.solids().is_empty());
        let [turned] = inward.solids() else { panic!("{:?}", inward.solids()) };
        for [a, b, c] in &turned.triangles {
            let [p, q, r] = [a, b, c].map(|i| turned.vertices[*i as usize]);
            let across = (q.position - p.position).cross(r.position - p.position);
            assert!(across.dot(p.position - Vec3::splat(0.2)) > 0.0);
            assert!([p, q, r].iter().all(|vertex| vertex.normal.dot(across) > 0.0), "{side}");
        }
    }
}

#[test]
fn a_mesh_without_an_inside_is_refused() {
    let of = |text: &str| mesh(text).opening().map(str::to_owned).unwrap_or_default();
    let open = obj(&[cube(1.0, false)], DMat3::IDENTITY).replace("f 1 3 4\n", "");
    assert_eq!(of(&open), "the mesh is not closed: the edge at [0.0000, 0.0000, -1.0000] belongs to only one triangle");
    // A Möbius strip of five triangles, closed at its edge by a fan: the projective plane, which intersects itself.
    let strip = "f 1 2 3\nf 2 3 4\nf 3 4 5\nf 4 5 1\nf 5 1 2\n";
    let fan = "f 1 3 6\nf 3 5 6\nf 5 2 6\nf 2 4 6\nf 4 1 6\n";
    let corners = "v 1 0 0\nv 0 1 0.3\nv -1 0 0\nv 0 -1 0.5\nv 0.5 0.5 1\nv 0 0 3\n";
    assert!(
        of(&format!("{corners}{strip}{fan}")).starts_with("the mesh has only one side: at ["),
        "{}",
        of(&format!("{corners}{strip}{fan}"))
    );
    let cavities = [cube(3.5, false), shell([-2.0; 3], [1.0; 3], true), shell([-1.0; 3], [2.5; 3], true)];
    assert_eq!(
        of(&obj(&cavities, DMat3::IDENTITY)),
        "two cavities of the mesh overlap, one of them at [-2.0000, -2.0000, -2.0000]"
    );
}

/// Returns a scene of one transparent mesh, and a sphere behind it.
fn scene(folder: &Path, file: &str) -> Scene {
    let text = format!(
        "[rays]\nbounding_sphere = {{ radius = 20 }}\n[[objects]]\nshape = \"mesh\"\nfile = \"{file}\"\ninterior = 1.5\n\
         [[objects]]\nshape = \"sphere\"\ncenter = [0, 0, 9]\nmaterial = \"red\"\n[materials.red]\n"
    );
    Scene::parse(&text, &folder.join("scene.toml"), &[]).unwrap_or_else(|e| panic!("{e}"))
}

/// Checks for every format that a cube with inward winding is solid, and that users are informed.
#[test]
fn files_of_every_format_are_turned() {
    let folder = tempfile::tempdir().expect("a folder");
    let (vertices, triangles) = cube(1.0, true).parts();
    let list = |text: &mut String, before: &str| {
        text.extend(vertices.iter().map(|x| format!("{} {} {}\n", x.x, x.y, x.z)));
        text.extend(triangles.iter().map(|[a, b, c]| format!("{before}{a} {b} {c}\n")));
    };
    let mut ply = "ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\nproperty float z\n\
        element face 12\nproperty list uchar int vertex_indices\nend_header\n"
        .to_owned();
    list(&mut ply, "3 ");
    let corner = |i: usize| format!("vertex {} {} {}\n", vertices[i].x, vertices[i].y, vertices[i].z);
    let facet =
        |t: &[usize; 3]| format!("facet normal 0 0 0\nouter loop\n{}endloop\nendfacet\n", t.map(corner).concat());
    let stl = format!("solid a\n{}endsolid a\n", triangles.iter().map(facet).collect::<String>());
    let positions = vertices.iter().flat_map(|x| x.as_vec3().to_array()).flat_map(f32::to_le_bytes);
    let buffer: Vec<u8> = positions.chain(triangles.iter().flatten().map(|i| *i as u8)).collect();
    std::fs::write(folder.path().join("a.bin"), &buffer).expect("written");
    let gltf = r#"{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"scale":[1,SCALE,1]}],
        "meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],
        "accessors":[{"bufferView":0,"componentType":5126,"count":8,"type":"VEC3","min":[-1,-1,-1],"max":[1,1,1]},
        {"bufferView":1,"componentType":5121,"count":36,"type":"SCALAR"}],
        "bufferViews":[{"buffer":0,"byteLength":96},{"buffer":0,"byteOffset":96,"byteLength":36}],
        "buffers":[{"uri":"a.bin","byteLength":132}]}"#;
    let files = [
        ("a.obj", obj(&[cube(1.0, true)], DMat3::IDENTITY)),
        ("a.ply", ply),
        ("a.stl", stl),
        ("a.gltf", gltf.replace("SCALE", "1")),
        ("mirrored.gltf", gltf.replace("SCALE", "-1")),
    ];
    for (name, text) in files {
        std::fs::write(folder.path().join(name), text).expect("written");
        let scene = scene(folder.path(), name);
        let [cube, _] = &scene.objects[..] else { panic!("{name}: {} objects", scene.objects.len()) };
        let winding = |object: &Object, x| object.shape.mesh().map_or(0.0, |mesh| mesh.winding(x));
        assert!((winding(cube, DVec3::splat(0.3)) - 1.0).abs() < 1e-9 && cube.contains(DVec3::ZERO), "{name}");
        let remark = "objects[0]: 12 of its 12 triangles have inward winding and are reversed";
        assert_eq!(scene.mesh_remarks(), [remark], "{name}");
    }
}

/// Checks that the additional objects of an overlapping mesh come last, so that the indices of other objects do not change.
#[test]
fn solids_of_one_mesh_come_behind_other_objects() {
    let folder = tempfile::tempdir().expect("a folder");
    let shells = [shell([-1.0; 3], [0.4; 3], true), shell([-0.4; 3], [1.0; 3], false)];
    std::fs::write(folder.path().join("a.obj"), obj(&shells, DMat3::IDENTITY)).expect("written");
    let scene = scene(folder.path(), "a.obj");
    let is_mesh: Vec<bool> = scene.objects.iter().map(|object| object.shape.mesh().is_some()).collect();
    assert_eq!(is_mesh, [true, false, true]);
    let remark =
        "12 of its 24 triangles have inward winding and are reversed; its parts overlap and are treated as 2 objects";
    assert_eq!(scene.mesh_remarks(), [format!("objects[0]: {remark}")]);
}

#[test]
fn an_open_interior_is_a_mistake() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("open.obj");
    std::fs::write(&path, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").expect("written");
    let text = format!(
        "[rays]\nbounding_sphere = {{ radius = 9 }}\n[[objects]]\nshape = \"mesh\"\nfile = '{}'\ninterior = 1.5\n",
        path.display()
    );
    let mistakes = mistakes_of(parse(&text));
    let problem = "the mesh is not closed: the edge at [0.5000, 0.0000, 0.0000] belongs to only one triangle";
    assert_eq!(mistakes[0].problem, problem);
    assert_eq!(mistakes[0].help, "set `material`, or use another shape, such as a closed mesh");
}

/// Returns boxes that are disjoint or nested, by repeated bisection of a cube.
fn family() -> impl Strategy<Value = Vec<Shell>> {
    let cut = (0..3_usize, 0.3..0.7_f64, any::<bool>(), any::<bool>(), 0..3_u8);
    prop::collection::vec(cut, 1..12).prop_map(|cuts| {
        let mut open = vec![cube(3.9, false)];
        let mut all = Vec::new();
        for (axis, at, keeps, inward, shrinks) in cuts {
            let Some(place) = open.pop() else { break };
            let (mut low, mut high) = (place, place);
            let middle = place.lo[axis] + at * (place.hi[axis] - place.lo[axis]);
            (low.hi[axis], high.lo[axis]) = (middle, middle);
            let inner =
                |place: Shell| Shell { lo: place.lo.lerp(place.hi, 0.1), hi: place.hi.lerp(place.lo, 0.1), inward };
            if keeps || shrinks == 0 {
                all.push(inner(place));
                open.push(inner(inner(place)));
            } else {
                open.extend([low, high]);
            }
        }
        all
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, ..ProptestConfig::default() })]
    #[test]
    fn shells_that_do_not_meet_alternate_however_they_are_wound(shells in family()) {
        prop_assume!(!shells.is_empty());
        let inside = |x| shells.iter().filter(|shell| shell.holds(x)).count() % 2 == 1;
        prop_assert_eq!(layers_of(&shells, inside), 1);
    }
}
