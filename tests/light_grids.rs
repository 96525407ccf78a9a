//! Tests photon grids: the light in their voxels, against closed forms and against the shooting method.

use bentray::gpu::LightGridData;
use bentray::program::{ProgramOptions, RaySkipping, Schedule};
use bentray::render::{LightReport, RenderError, RenderSettings, Renderer, light_grids, light_paths};
use glam::DVec3;

use crate::support::{gpu, scene};

const WALLS: &str = "[materials.wall]\nkind = \"phong\"\ndiffuse = [1, 1, 1]\nambient = 0\n\
     [[objects]]\nshape = \"box\"\nmaterial = \"wall\"\nscale = [6, 0.2, 6]\ntranslate = [0, -2, 0]\n\
     [[objects]]\nshape = \"box\"\nmaterial = \"wall\"\nscale = [6, 0.2, 6]\ntranslate = [0, 2.5, 0]\n";

fn grids(text: &str) -> Vec<(LightGridData, LightReport)> {
    light_grids(&gpu(), &scene(text), &RenderSettings::default()).unwrap()
}

fn lamp(rest: &str) -> String {
    format!(
        "[[lights]]\nkind = \"point\"\nposition = [0.3, 0.2, -0.4]\nfalloff = \"inverse-square\"\nshadows = \"photon-grid\"\n{rest}\n"
    )
}

/// Returns positions between the walls, none of them near a wall or the light.
fn places() -> impl Iterator<Item = DVec3> {
    let at = |i: u32, n: u32| f64::from(i * n % 61) / 61.0;
    let all = (1..400).map(move |i| {
        DVec3::new(at(i, 7), at(i, 23), at(i, 41)) * DVec3::new(5.0, 3.4, 5.0) - DVec3::new(2.5, 1.4, 2.5)
    });
    all.filter(|x| x.distance(DVec3::new(0.3, 0.2, -0.4)) > 0.8)
}

/// Straight light: 1/r² from the point light, and constant brightness from the distant light.
#[test]
fn straight_light_falls_off_with_the_square_of_the_distance() {
    let sun = "[[lights]]\nkind = \"directional\"\ndirection = [1, 0, 0.5]\nshadows = \"photon-grid\"\nvoxels = 32\n";
    let text = format!("[rays]\nbounding_sphere = {{ radius = 9 }}\n{WALLS}{}{sun}", lamp("voxels = 48"));
    let found = grids(&text);
    let (mut off, mut turned, mut count) = (0.0_f64, 0.0_f64, 0.0);
    for x in places() {
        let way = x - DVec3::new(0.3, 0.2, -0.4);
        let f = found[0].0.at(x).unwrap().truncate().as_dvec3();
        off += (f.length() * way.length_squared() - 1.0).powi(2);
        turned = turned.max(f.angle_between(way));
        let sun = found[1].0.at(x).unwrap();
        assert!((f64::from(sun.w) - 1.0).abs() < 0.15, "{x}: {sun}");
        assert!(sun.truncate().as_dvec3().angle_between(DVec3::new(1.0, 0.0, 0.5)) < 1e-3, "{x}: {sun}");
        count += 1.0;
    }
    // A voxel is h wide, and the direction of the light turns by h/r inside it.
    let h = found[0].0.volume.h;
    assert!(turned < h / 0.8, "{turned}");
    assert!((off / count).sqrt() < 0.05, "{}", (off / count).sqrt());
    assert!(found.iter().all(|(_, report)| report.totals.unfollowed() == 0 && report.totals.lost == 0));
}

/// For a point light in a glass ball, the light that the ball reflects leaves it later.
#[test]
fn glass_about_a_lamp_keeps_its_light() {
    let ball = "[[objects]]\nshape = \"sphere\"\ncenter = [0.3, 0.2, -0.4]\nradius = 0.5\ninterior = 1.5\n";
    let found =
        grids(&format!("[rays]\nbounding_sphere = {{ radius = 9 }}\n{WALLS}{ball}{}", lamp("voxels = 32\nrefine = 1")));
    let mean = |values: Vec<f64>| values.iter().sum::<f64>() / values.len() as f64;
    let bright = |x: DVec3| f64::from(found[0].0.at(x).unwrap().w) * x.distance_squared(DVec3::new(0.3, 0.2, -0.4));
    let all = mean(places().map(bright).collect());
    assert!((all - 1.0).abs() < 0.02, "{all}");
}

/// Around a center the grid agrees with the shooting method, twice as closely with half the voxel size.
#[test]
fn grids_approach_what_shooting_finds() {
    let law = "[law]\nkind = \"sources\"\n[[law.sources]]\nposition = [1, -0.5, 0.6]\nstrength = 0.4\n";
    let text = |voxels: u32| {
        format!(
            "{law}[rays]\nmethod = \"dormand-prince\"\nbounding_sphere = {{ radius = 9 }}\n{WALLS}{}",
            lamp(&format!("voxels = {voxels}\nrefine = 1"))
        )
    };
    let far = |x: &DVec3| x.distance(DVec3::new(1.0, -0.5, 0.6)) > 1.0;
    let pairs: Vec<[DVec3; 2]> = places().filter(far).map(|x| [x, DVec3::new(0.3, 0.2, -0.4)]).collect();
    let (paths, _) = light_paths(&gpu(), &scene(&text(16)), &RenderSettings::default(), &pairs).unwrap();
    let angle = |voxels: u32| {
        let field = &grids(&text(voxels))[0].0;
        let angles: Vec<f64> = pairs
            .iter()
            .zip(&paths)
            .filter_map(|([x, _], paths)| {
                let clear = paths.iter().filter(|path| path.clear && path.spread > 0.0);
                let f: DVec3 = clear.map(|path| DVec3::from(path.arrives) / path.spread).sum();
                (f.length() > 0.0).then(|| field.at(*x).unwrap().truncate().as_dvec3().angle_between(f))
            })
            .collect();
        angles.iter().sum::<f64>() / angles.len() as f64
    };
    let [coarse, fine] = [16, 32].map(angle);
    assert!(fine < 0.6 * coarse && fine < 0.03, "{coarse} and {fine}");
}

const ROOM: &str = "[image]\nsize = [48, 36]\n[camera]\nposition = [0, 0.3, 6]\nfov = 60\n\
     [[objects]]\nshape = \"sphere\"\nmaterial = \"wall\"\ncenter = [0.2, -1, 0.3]\nradius = 0.5\n";

/// In straight light the shadows of a grid are those of straight lines, except for a voxel at their edges.
#[test]
fn shadows_lie_where_straight_ones_do() {
    let picture = |shadows: &str| {
        let light = lamp("").replace("photon-grid", shadows);
        let room = scene(&format!("{ROOM}[rays]\nbounding_sphere = {{ radius = 9 }}\n{WALLS}{light}"));
        Renderer::new(&gpu(), &room, RenderSettings::default()).unwrap().render().unwrap()
    };
    let [grid, straight, none] = ["photon-grid", "straight-rays", "none"].map(picture);
    let (mut agree, mut all, mut dark) = (0, 0, 0);
    for ((grid, straight), none) in
        grid.band.color[0].iter().zip(&straight.band.color[0]).zip(&none.band.color[0]).filter(|(_, none)| **none > 0.0)
    {
        all += 1;
        dark += u32::from(*straight == 0.0);
        agree += u32::from((*grid > 0.5 * none) == (*straight > 0.0));
    }
    assert!(dark > 30 && 100 * agree >= 98 * all, "{agree} of {all}, of them {dark} in shadow");
}

/// The image does not depend on schedules, masks and tiles.
#[test]
fn pictures_do_not_depend_on_the_schedule() {
    let law = "[law]\nkind = \"sources\"\n[[law.sources]]\nposition = [1, -0.5, 0.6]\nstrength = 0.4\n";
    let room = scene(&format!(
        "{ROOM}{law}[rays]\nmethod = \"dormand-prince\"\nbounding_sphere = {{ radius = 9 }}\n{WALLS}{}",
        lamp("voxels = 16\npaths = 16384")
    ));
    let picture = |schedule, masks, tile_pixels| {
        let options = ProgramOptions { schedule, masks, ..ProgramOptions::default() };
        let settings = RenderSettings { options, tile_pixels, ..RenderSettings::default() };
        Renderer::new(&gpu(), &room, settings).unwrap().render().unwrap().band
    };
    let first = picture(Schedule::Whole, RaySkipping::List, 1 << 20);
    assert!(first.color[0].iter().any(|value| *value > 0.0));
    for (schedule, masks) in [
        (Schedule::Fused, RaySkipping::Off),
        (Schedule::Segment, RaySkipping::List),
        (Schedule::Paper, RaySkipping::Grid),
    ] {
        assert!(picture(schedule, masks, 300) == first, "{schedule:?}");
    }
}

/// A grid that exceeds the memory is rejected with both numbers; if only its parts do, it takes fewer of them and reports that.
#[test]
fn memory_is_kept_to() {
    let room = scene(&format!("{ROOM}[rays]\nbounding_sphere = {{ radius = 9 }}\n{WALLS}{}", lamp("voxels = 48")));
    let with = |memory| light_grids(&gpu(), &room, &RenderSettings { memory, ..RenderSettings::default() });
    let Err(RenderError::LightGrid { needed, allowed, .. }) = with(1 << 20) else { panic!("not refused") };
    assert!(needed > 1 << 20 && allowed == 1 << 20);
    let report = &with(needed + (1 << 21)).unwrap()[0].1;
    assert!(report.refined[0] > 0 && report.refined[0] < report.refined[1], "{report}");
    assert!(report.to_string().contains("limited by memory"), "{report}");
}

/// If nothing that light meets moves, a frame reuses the grid of the previous frame.
#[test]
fn grids_are_kept_while_the_light_stays() {
    let text = format!("{ROOM}[rays]\nbounding_sphere = {{ radius = 9 }}\n{WALLS}{}", lamp("voxels = 16"));
    let first = scene(&text);
    let gpu = gpu();
    let mut renderer = Renderer::new(&gpu, &first, RenderSettings::default()).unwrap();
    let before: Vec<_> = renderer.light_reports().into_iter().cloned().collect();
    for (change, keeps) in [(("[0, 0.3, 6]", "[1, 0.3, 6]"), true), (("[0.3, 0.2, -0.4]", "[0.5, 0.2, -0.4]"), false)] {
        let next = scene(&text.replace(change.0, change.1));
        renderer.set_scene(next.clone()).unwrap();
        let mut fresh = Renderer::new(&gpu, &next, RenderSettings::default()).unwrap();
        assert!(renderer.render().unwrap().band == fresh.render().unwrap().band);
        // The times that they took always differ.
        assert_eq!(renderer.light_reports().into_iter().eq(&before), keeps, "{change:?}");
    }
}
