//! Every table and key of the format, as the user reads them.
//!
//! `TABLE { key if WHEN: VALUE = DEFAULT, MEANING; }`: WHEN says beside what a key is read, where it is not always.

use super::KeyReference;

macro_rules! keys {
    ($($table:literal {
        $($key:ident $(if $when:literal)?: $value:literal = $default:literal, $meaning:literal;)*
    })*) => {
        &[$($(KeyReference {
            table: $table,
            key: stringify!($key),
            when: concat!($($when)?),
            value: $value,
            default: $default,
            meaning: $meaning,
        },)*)*]
    };
}

/// Every key: a test holds it to what the reading of scenes asks for.
pub const REFERENCE: &[KeyReference] = keys! {
    "" {
        image: "table" = "{}", "size and sampling of the picture";
        camera: "table" = "none", "where rays start; `trace` needs none";
        law: "table" = "{}", "how light travels";
        rays: "table" = "required", "how light is followed";
        sky: "table" = "{}", "what a ray that escapes sees";
        output: "table" = "{}", "how radiance becomes a PNG";
        materials: "table of tables" = "{}", "materials by name";
        objects: "array of tables" = "[]", "things to hit";
        lights: "array of tables" = "[]",
            "lights for phong materials; they shine in straight lines, without shadows or fall-off";
        animation: "table" = "none", "what changes from frame to frame, for `render --frames`";
    }
    "image" {
        size: "[width, height], 1 to 65536" = "[800, 600]", "pixels";
        samples: "whole number, 1 to 4096" = "1", "rays a pixel; with `adaptive` the most that one may take, a power of two from 16 and by default 64";
        pattern: "multi-jittered | progressive" = "multi-jittered",
            "how they are spread: for their number, or so that any first 2, 4, 8, … are spread well; `adaptive` has it progressive";
        adaptive: "number between 0 and 1" = "none",
            "more rays only where the picture needs them: a pixel whose corners end and look alike is done with those, any other takes 16, 32, … until the standard error of its mean, in what a screen shows, is below this";
    }
    "camera" {
        kind: "pinhole | plane | fisheye | panorama" = "pinhole",
            "rays from one point as through a window, parallel rays from a plane, or rays from one point by their angle from the middle, or by longitude and latitude";
        position: "[x, y, z]" = "required", "the point, or the centre of the plane; scene units";
        look_at: "[x, y, z]" = "[0, 0, 0]", "the point in the middle of the picture; differs from position";
        up: "[x, y, z]" = "[0, 1, 0]", "what is up in the picture; not parallel to the view";
        fov if r#"kind = "pinhole""#: "number between 0 and 180" = "50", "vertical opening angle, degrees";
        fov if r#"kind = "fisheye""#: "number above 0, up to 1000000" = "180",
            "opening angle of the disk in the middle of the picture, degrees: above 360 the view goes round again";
        corners if r#"kind = "fisheye""#: "black | transparent" = "black",
            "what is outside the disk; transparent gives PNG and EXR alpha";
        fov if r#"kind = "panorama""#: "[across, upwards], up to [360, 180]" = "[360, 180]",
            "opening angles, degrees; the whole is laid out like an equirectangular sky";
        height if r#"kind = "plane""#: "number above 0" = "required", "height of the plane, scene units";
        frame: "coordinate | static" = "coordinate",
            "whose directions the camera sees: the coordinates', or those of an observer at rest (schwarzschild only)";
        stereo: "{ separation, layout, convergence }" = "none",
            "two views in one picture, of eyes to the left and right of the position";
    }
    "camera.stereo" {
        separation: "number above 0" = "required", "from eye to eye, scene units";
        layout: "side-by-side | top-bottom" = "side-by-side", "the left eye's view is at the left, or at the top";
        convergence: "number above 0" = "none",
            "the distance at which both views show the same, scene units; without it both look the same way";
    }
    "law" {
        kind: "straight | schwarzschild | sources | lorenz | rossler | medium" = "straight",
            "straight lines, a black hole, force centres, an orbit of a flow, or a medium of varying index";
        mass if r#"kind = "schwarzschild""#: "number above 0" = "1",
            "M, scene units (G = c = 1): the horizon is at r = 2M";
        center if r#"kind = "schwarzschild""#: "[x, y, z]" = "[0, 0, 0]", "the hole's place";
        form if r#"kind = "schwarzschild""#: "path | geodesic" = "path",
            "the equation that is integrated: of the path alone, or the full geodesic with its time";
        sources if r#"kind = "sources""#: "array of tables" = "required", "the force centres, at least one";
        sigma if r#"kind = "lorenz""#: "number" = "10", "σ";
        rho if r#"kind = "lorenz""#: "number" = "28", "ρ";
        beta if r#"kind = "lorenz""#: "number" = "8/3", "β";
        alpha if r#"kind = "rossler""#: "number" = "0.375", "α";
        beta if r#"kind = "rossler""#: "number" = "2", "β";
        gamma if r#"kind = "rossler""#: "number" = "4", "γ";
        order if r#"kind = "lorenz" or "rossler""#: "1, 2" = "1",
            "the field is the ray's velocity (1) or its acceleration (2)";
        index if r#"kind = "medium""#: "number, name or { kind, .. }" = "required", "the index of refraction: see medium";
    }
    "law.sources" {
        kind: "center" = "center", "the kind of source";
        position: "[x, y, z]" = "required", "the centre, scene units";
        strength: "number other than 0" = "required", "above 0 attracts, below 0 repels";
        falloff: r#""inverse-square", { cubic = R }, { yukawa = mu }"# = "inverse-square",
            "how the force falls with distance";
        capture: "number, 0 or above" = "0",
            "a ray that comes this near moving inwards is captured, scene units; 0 for never";
    }
    "law.sources.falloff" {
        cubic if "no yukawa": "number above 0" = "none",
            "R: the force is 2r³/R³ − 3r²/R² + 1 inside this radius and nothing outside; scene units";
        yukawa if "no cubic": "number above 0" = "none", "μ: the force is e^(−μr)(1 + μr)/r²; per scene unit";
    }
    "medium" {
        kind: "constant | luneburg | gaussian | inverse-r | maxwell-fisheye | eaton | rod | linear | exponential | sech | profile | noise | textured | explosion | expression | grid" = "required",
            "how n varies: a number stands for { kind = \"constant\", n }, and so do vacuum, air, ice, water, ethyl-alcohol, fused-quartz, acrylic, crown-glass, polyester-resin, flint-glass and diamond";
        n if r#"kind = "constant" or "textured""#: "number above 0" = "required", "the index";
        center if r#"kind = "luneburg", "gaussian", "inverse-r", "maxwell-fisheye", "eaton", "rod", "noise", "textured" or "explosion""#: "[x, y, z]" = "the object's, or [0, 0, 0]",
            "where r is 0, a point of the rod's axis, or of the noise's lattice; scene units";
        radius if r#"kind = "luneburg", "gaussian", "eaton" or "explosion""#: "number above 0" = "the object's, or required", "R, scene units";
        c if r#"kind = "luneburg""#: "number, 2 or above" = "2", "C: n = √(C − r²/R²)";
        a if r#"kind = "gaussian""#: "number above 0" = "required", "n = a e^(−b r²/R²)";
        b if r#"kind = "gaussian""#: "number" = "ln a: n = 1 at R", "see a";
        k if r#"kind = "inverse-r""#: "number above 0" = "the object's radius, or required", "n = k/r";
        ingoing if r#"kind = "inverse-r""#: "black | continue" = "black",
            "rays towards the centre are captured there, or followed as if they went outwards";
        n0 if r#"kind = "maxwell-fisheye""#: "number above 0" = "2", "n = n₀/(1 + r²/a²)";
        a if r#"kind = "maxwell-fisheye""#: "number above 0" = "the object's radius, or required", "scene units";
        n0 if r#"kind = "rod" or "sech""#: "number above 0" = "required", "the index on the axis, or on the plane";
        g if r#"kind = "rod""#: "number above 0" = "required", "n = n₀ √(1 − g²ρ²), ρ the distance from the axis";
        axis if r#"kind = "rod""#: "[x, y, z]" = "the cylinder's, or [0, 0, 1]", "along the rod";
        origin if r#"kind = "linear", "exponential", "sech" or "profile""#: "[x, y, z]" = "the object's center, or [0, 0, 0]", "a point of height 0";
        n0 if r#"kind = "linear""#: "number above 0" = "1", "the index at the origin";
        gradient if r#"kind = "linear""#: "[x, y, z], not all 0" = "required", "n² = n₀² + gradient · (x − origin)";
        up if r#"kind = "exponential", "sech" or "profile""#: "[x, y, z]" = "[0, 1, 0]", "where height grows";
        delta if r#"kind = "exponential""#: "number above -1, other than 0" = "required", "n = 1 + δ e^(−y/H), y the height";
        height if r#"kind = "exponential""#: "number above 0" = "required", "H, scene units";
        g if r#"kind = "sech""#: "number above 0" = "required", "n = n₀ sech(g y), y the height";
        file if r#"kind = "profile" and no points"#: "file" = "none",
            "layered air, measured: CSV with the header height,n and a line for each point, heights over the origin in scene units";
        points if r#"kind = "profile" and no file"#: "[[height, n], ...]" = "none",
            "the points of the profile, by rising height: a smooth curve goes through them (the natural cubic spline), constant outside";
        n0 if r#"kind = "noise""#: "number above 0" = "1", "n₀ of n = n₀ + amplitude · Σ 2⁻ʲ noise(2ʲ · frequency · (x − center))";
        amplitude if r#"kind = "noise" or "textured""#: "number" = "required",
            "of the noise, which reaches 125/64 · (2 − 2^(1 − octaves)) times it: n must stay above 0; textured: where light goes in or out, with straight paths inside";
        amplitude if r#"kind = "explosion""#: "number between -0.5 and 0.5" = "required", "of the noise: n = 1 + amplitude · noise, falling to 1 at R";
        frequency if r#"kind = "noise", "textured" or "explosion""#: "number above 0" = "required", "lattice cells a unit length";
        octaves if r#"kind = "noise", "textured" or "explosion""#: "whole number, 1 to 8" = "1", "terms of the noise";
        seed if r#"kind = "noise", "textured" or "explosion""#: "whole number" = "0", "chooses the noise";
        n if r#"kind = "expression""#: "formula" = "required",
            "the index as a function of x, y, z and r, with numbers, pi, + - * / ^ ( ), sqrt, exp, log, sin, cos, tan, sinh, cosh, tanh, atan, abs, min and max; its gradient is derived; rays fail where it is not above 0";
        center if r#"kind = "expression""#: "[x, y, z]" = "the object's, or [0, 0, 0]", "where x, y, z and r are 0; scene units";
        scale if r#"kind = "expression""#: "number above 0" = "the object's radius, or 1",
            "the length over which n changes, scene units: steps are a fraction of it";
        file if r#"kind = "grid""#: "file" = "required",
            "samples of the index, n = offset + scale · value, between which it is a Catmull-Rom spline: NRRD if it ends in .nrrd, else bare numbers, x fastest";
        min if r#"kind = "grid""#: "[x, y, z]" = "as the NRRD file says, or required",
            "where the first sample is, scene units; with max";
        max if r#"kind = "grid""#: "[x, y, z]" = "as the NRRD file says, or required",
            "where the last sample is; beyond the grid the index is that at its border";
        scale if r#"kind = "grid""#: "number other than 0" = "1", "see file";
        offset if r#"kind = "grid""#: "number" = "0", "see file";
        size if r#"kind = "grid", unless the file is NRRD"#: "[nx, ny, nz], 2 or more" = "required", "samples along x, y and z";
        type if r#"kind = "grid", unless the file is NRRD"#: "u8 | u16 | f32 | f64" = "required", "what a sample is";
        endian if r#"kind = "grid", unless the file is NRRD"#: "little | big" = "little", "which end of a number comes first";
    }
    "rays" {
        method: "auto | exact | planar | euler | leapfrog | rkn4 | rk4 | euler-doubling | rk4-doubling | bogacki-shampine | dormand-prince | snell"
            = "exact for straight lines; rk4 if a step is given, dormand-prince if a tolerance is; else auto",
            "the integrator; auto measures which is fastest at the accuracy, exact is for the straight law, planar for laws with one centre, leapfrog and rkn4 for accelerations that depend on place alone, snell for the medium";
        accuracy if r#"method = "auto""#: r#"number above 0, or pixels such as "0.1px""# = "0.1px",
            "the error in direction that 99 of 100 rays shall stay under: radians, or parts of a pixel at the picture's centre";
        bound: "{ center, radius }" = "required", "the sphere that rays escape from and that holds all objects";
        step if r#"method = "euler", "leapfrog", "rkn4", "rk4" or "snell" (the others choose their steps)"#: "number above 0" = "none",
            "length of a step, in τ; excludes curvature_step";
        curvature_step if r#"method as for step"#: "number above 0" = "none",
            "every step turns the ray through this angle, degrees";
        scaled_step if r#"any method but "exact""#: "number above 0" = "0.1; 0.5 beside step or curvature_step; 0.3 for doubling and embedded methods",
            "η: a step is η times the law's own scale at its place, or no longer than that where something else chooses it; planar: radians round the centre";
        doubling if r#"method = "euler-doubling" or "rk4-doubling""#: "rejecting | paper" = "rejecting",
            "a step over the tolerance is tried again, or only the next is shorter";
        tolerance if r#"a doubling method, "bogacki-shampine" or "dormand-prince""#: "number above 0" = "1e-5",
            "steps shrink above this relative error";
        grow_below if r#"method = "euler-doubling" or "rk4-doubling""#: "number above 0, below tolerance" = "tolerance / 10",
            "steps grow below this relative difference";
        threshold if r#"method = "snell""#: "number above 0" = "0.001",
            "the change of index at which the ray is refracted";
        segment: "arc | chord" = "arc",
            "what is tested against the objects: each step's arc, or one chord over several steps";
        arc_tolerance if r#"segment = "arc""#: "number above 0" = "1e-4 of the bound's radius",
            "how far an arc's chords may depart from it, scene units";
        steps_per_segment if r#"segment = "chord""#: "whole number, 1 to 1000" = "10", "steps a chord";
        max_segments: "whole number, 1 to 1000000" = "1000", "a ray is given up after so many segments";
        length: "number above 0" = "none", "rays end at this τ";
        asymptotic if "schwarzschild, or one inverse-square source": "true | false" = "false",
            "rays that leave the bound are followed to infinity in closed form, and those given from outside come from there";
        precision: "f16 | f32 | f64" = "f32",
            "bits of the numbers: f64 where the device has it, f16 keeps 16 bits between passes as in 2004";
        branches: "whole number, 0 to 20, or random" = "4",
            "where a surface splits light both rays are followed, so many times along a path; or one at random, a sample";
        accelerate: "auto | bvh | grid | none" = "auto",
            "how objects are searched: by a hierarchy of boxes, a uniform grid, or one after the other; auto is what measures best";
    }
    "rays.bound" {
        center: "[x, y, z]" = "[0, 0, 0]", "scene units";
        radius: "number above 0" = "required", "scene units";
    }
    "sky" {
        color if "no image and no faces": "[red, green, blue]" = "[0, 0, 0]", "one colour, linear";
        image if "no color and no faces": "file" = "none", "an equirectangular picture: PNG, EXR or HDR";
        faces if "no color and no image": "six files" = "none",
            "the faces +x, -x, +y, -y, +z, -z of a cube, seen from inside";
        intensity if "image or faces": "number, 0 or above" = "1", "factor on the picture's radiance";
    }
    "output" {
        exposure: "number, -64 to 64" = "0", "stops; PNG only";
        tonemap: "none | filmic" = "none", "the tone curve; PNG only";
        bits: "8, 16" = "8", "bits a channel; PNG only";
    }
    "materials.NAME" {
        kind: "phong | emissive | mirror" = "phong", "lit by the lights, shining itself, or reflecting";
        diffuse if r#"kind = "phong""#: "[red, green, blue], { checker, repeat }, { image, repeat }" = "[0.8, 0.8, 0.8]",
            "the surface's colour, linear";
        ambient if r#"kind = "phong""#: "number from 0 to 1" = "0.1", "fraction of the colour that needs no light";
        specular if r#"kind = "phong""#: "[red, green, blue]" = "[0, 0, 0]", "colour of the highlight";
        shininess if r#"kind = "phong""#: "number above 0" = "32", "the highlight's exponent";
        emission if r#"kind = "phong""#: "[red, green, blue]" = "[0, 0, 0]", "radiance added";
        color if r#"kind = "emissive""#: "[red, green, blue], { checker, repeat }, { image, repeat }" = "required",
            "radiance, linear";
        color if r#"kind = "mirror""#: "[red, green, blue], { checker, repeat }, { image, repeat }" = "[1, 1, 1]",
            "the part of the light that it gives back";
    }
    "materials.NAME.diffuse" {
        checker if "no image": "[color, color]" = "none", "two colours in turn";
        image if "no checker": "file" = "none", "PNG, EXR or HDR";
        repeat if "checker or image": "[u, v], above 0" = "[8, 8] for checker, [1, 1] for image",
            "cells, or pictures, along u and v";
    }
    "materials.NAME.color" {
        checker if "no image": "[color, color]" = "none", "two colours in turn";
        image if "no checker": "file" = "none", "PNG, EXR or HDR";
        repeat if "checker or image": "[u, v], above 0" = "[8, 8] for checker, [1, 1] for image",
            "cells, or pictures, along u and v";
    }
    "objects" {
        shape: "sphere | plane | box | cylinder | disk | mesh" = "required", "what it is";
        material if "no interior": "name" = "required", "what its surface is made of: one of [materials]";
        interior if "no material": "number, name or { kind, .. }" = "none", "the medium that fills it: see medium";
        priority if "interior": "whole number, 0 to 1000" = "0", "where interiors overlap, the higher one is there";
        center if r#"any shape but "mesh""#: "[x, y, z]" = "[0, 0, 0]", "its middle, scene units";
        radius if r#"shape = "sphere", "cylinder" or "disk""#: "number above 0" = "1", "scene units";
        height if r#"shape = "cylinder""#: "number above 0" = "2", "from face to face, scene units";
        axis if r#"shape = "cylinder""#: "[x, y, z]" = "[0, 1, 0]", "from the lower face to the upper";
        normal if r#"shape = "plane" or "disk""#: "[x, y, z]" = "[0, 1, 0]", "where it faces";
        hole if r#"shape = "disk""#: "number, 0 or above, below the radius" = "0", "radius of a round hole, scene units";
        size if r#"shape = "plane""#: "[width, depth], above 0" = "twice the bound's radius", "edges, scene units";
        size if r#"shape = "box""#: "[x, y, z], above 0" = "[1, 1, 1]", "edges, scene units";
        min if r#"shape = "box""#: "[x, y, z]" = "none", "its lowest corner; with max in place of center and size";
        max if r#"shape = "box""#: "[x, y, z]" = "none", "its highest corner";
        file if r#"shape = "mesh""#: "file" = "required", "an OBJ file";
        scale: "number or [x, y, z], above 0" = "1", "done first, about the origin";
        rotate: "[x, y, z]" = "[0, 0, 0]", "degrees about the x, then y, then z axis, about the origin";
        translate: "[x, y, z]" = "[0, 0, 0]", "done last, scene units";
    }
    "lights" {
        kind: "point | directional" = "required", "from a place, or from far away";
        color: "[red, green, blue]" = "[1, 1, 1]", "radiance, linear";
        position if r#"kind = "point""#: "[x, y, z]" = "required", "scene units";
        direction if r#"kind = "directional""#: "[x, y, z]" = "required", "where the light travels to";
    }
    "animation" {
        frames: "whole number, 1 to 1000000" = "required", "how many; they count from 0";
        tracks: "array of tables" = "[]", "the keys that change; without --frames they are as the rest of the file says";
    }
    "animation.tracks" {
        key: "key" = "required", "as --set takes it: camera.position, objects.0.center";
        values: "array of numbers, or of arrays of numbers" = "required",
            "the values at some frames; before the first and after the last it stays";
        at: "array of numbers, ascending" = "evenly from the first frame to the last", "the frame of each value";
        between: "linear | smooth" = "linear",
            "how a value goes to the next: straight, or along a cubic that rests at both ends of the track";
    }
};
