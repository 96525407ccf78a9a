//! Tests surfaces by a custom law: a reflecting law acts as a mirror, a law that continues rays straight ahead has no
//! effect, and the light is the sum of the weights.

use bentray::render::{RenderSettings, Renderer};
use glam::DVec3;

use crate::support::{gpu, scene};

/// Returns a scene with a ball and a pane of the material, in front of a sky, a floor and another ball.
fn room(material: &str, rays: &str, law: &str) -> String {
    format!(
        "[image]\nsize = [64, 48]\n[camera]\nposition = [0, 2, 9]\nfov = 45\n[law]\n{law}\n[rays]\nbounding_sphere = {{ radius = 40 }}\n{rays}\n\
         [sky]\ncolor = [0.4, 0.55, 0.8]\n[materials.floor]\ndiffuse = {{ checker = [[0.9, 0.9, 0.8], [0.2, 0.3, 0.4]], repeat = [9, 9] }}\n\
         [materials.odd]\n{material}\n[[objects]]\nshape = \"plane\"\ncenter = [0, -2, 0]\nsize = [30, 30]\nmaterial = \"floor\"\n\
         [[objects]]\nshape = \"sphere\"\ncenter = [-0.6, -0.4, -3]\nmaterial = \"floor\"\n\
         [[objects]]\nshape = \"sphere\"\ncenter = [1.2, 0, 0]\nradius = 1.3\nmaterial = \"odd\"\n\
         [[objects]]\nshape = \"plane\"\ncenter = [-2, 0, 0]\nnormal = [0.4, 0, 1]\nsize = [2, 2]\nmaterial = \"odd\"\n\
         [[lights]]\nkind = \"point\"\nposition = [6, 10, 8]\n"
    )
}

fn picture(text: &str) -> Vec<DVec3> {
    let scene = scene(text);
    let [red, green, blue] =
        Renderer::new(&gpu(), &scene, RenderSettings::default()).unwrap().render().unwrap().band.color;
    (0..red.len()).map(|i| DVec3::new(red[i].into(), green[i].into(), blue[i].into())).collect()
}

/// Returns the fraction of the pixels that agree.
fn alike(a: &[DVec3], b: &[DVec3]) -> f64 {
    let same = a.iter().zip(b).filter(|(a, b)| (**a - **b).abs().max_element() < 1e-3).count();
    same as f64 / a.len() as f64
}

const LAWS: [&str; 2] = [
    "kind = \"straight\"",
    "kind = \"sources\"\nsources = [{ position = [0, 4, 0], strength = 0.3, capture_radius = 0.05 }]",
];
const MIRROR: &str = "[\"dx + 2*c*nx\", \"dy + 2*c*ny\", \"dz + 2*c*nz\", \"1\"]";
const ON: &str = "[\"2*dx\", \"2*dy\", \"2*dz\", \"1\"]";

#[test]
fn a_fan_of_one_ray_is_a_mirror_or_nothing() {
    for law in LAWS {
        let odd = |ray: &str| picture(&room(&format!("kind = \"ray-splitter\"\nrays = [{ray}]"), "", law));
        let mirror = picture(&room("kind = \"mirror\"", "", law));
        let part = alike(&odd(MIRROR), &mirror);
        assert!(part > 0.995, "{law}: {part}");
        let text = room("kind = \"mirror\"", "", law);
        let empty = text.replace("radius = 1.3\nmaterial = \"odd\"", "radius = 1e-3\nmaterial = \"floor\"");
        let empty =
            picture(&empty.replace("size = [2, 2]\nmaterial = \"odd\"", "size = [1e-3, 1e-3]\nmaterial = \"floor\""));
        let part = alike(&odd(ON), &empty);
        assert!(part > 0.99, "{law}: {part}");
        assert!(alike(&mirror, &empty) < 0.95);
    }
}

/// Under a uniform sky, weights that add up to 1 hide the surface; smaller sums darken it. Ray splitting and random choices agree.
#[test]
fn weights_are_what_a_surface_gives_back() {
    let three = |a: f64, b: f64, c: f64| {
        let ray = |x: &str, w: f64| format!("[\"dx + {x}*nx\", \"dy + {x}*ny\", \"dz + {x}*nz\", \"{w}\"]");
        format!("kind = \"ray-splitter\"\nrays = [{}, {}, {}]", ray("2*c", a), ray("3*c", b), ray("4*c", c))
    };
    let furnace = |material: &str, rays: &str| {
        let text = room(material, rays, LAWS[0]);
        let is_lone = |part: &&str| part.contains("[image]") || part.contains("radius = 1.3");
        picture(&text.split("[[objects]]").filter(is_lone).collect::<Vec<_>>().join("[[objects]]"))
    };
    let sky = DVec3::new(0.4, 0.55, 0.8);
    for (weights, sum) in [([0.5, 0.3, 0.2], 1.0), ([0.25, 0.15, 0.1], 0.5)] {
        let [a, b, c] = weights;
        for rays in ["max_splits = 12", "max_splits = \"stochastic\""] {
            for color in furnace(&three(a, b, c), rays) {
                let share = color / sky;
                let whole = (share - DVec3::ONE).abs().max_element() < 1e-4;
                assert!(whole || (share - DVec3::splat(sum)).abs().max_element() < 1e-4, "{rays}: {color}");
            }
        }
    }
}
