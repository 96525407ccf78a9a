//! Every table and key of the format, as the user reads them.
//!
//! `TABLE { key if WHEN: VALUE = DEFAULT, MEANING; }`: WHEN says beside what a key is read, where it is not always.

use crate::document::{KeyReference, key_rows};

/// The keys that are read whatever the kinds of a scene are.
#[expect(clippy::too_many_lines, reason = "a table")]
pub(super) fn fixed() -> Vec<KeyReference> {
    key_rows! {
        "" {
            image: "table" = "{}", "size and sampling of the picture";
            camera: "table" = "none", "where rays start; `trace` needs none";
            law: "table" = "{}", "how light travels";
            rays: "table" = "required", "how light is followed";
            sky: r#"table | "transparent""# = "{}", "what a ray that escapes sees: a transparent one gives pictures alpha";
            output: "table" = "{}", "how radiance becomes a PNG";
            materials: "table of tables" = "{}", "materials by name";
            objects: "array of tables" = "[]", "things to hit";
            lights: "array of tables" = "[]",
                "lamps, for phong materials; paths have none of them, but what shines";
            path_tracing if r#"lighting = "path-tracing""#: "table" = "{}", "how light goes from surface to surface";
            ambient: "table" = "none", "how ambient light is shut out: without it it reaches every place";
            animation: "table" = "none", "what changes from frame to frame, for `render --frames`";
        }
        "image" {
            size: "[width, height], 1 to 65536" = "[800, 600]", "pixels";
            samples: "whole number, 1 to 1048576" = "1", "rays a pixel; with `adaptive` the most that one may take, a power of two from 16 and by default 64";
            sampler: "multi-jittered | sobol" = "multi-jittered; sobol for adaptive and path-traced images",
                "how they are spread: for their number, or so that any first 2, 4, 8, … are spread well; `adaptive` has it sobol";
            adaptive: "number between 0 and 1" = "none",
                "more rays only where the picture needs them: a pixel whose corners end and look alike is done with those, any other takes 16, 32, … until the standard error of its mean, in what a screen shows, is below this";
            footprints: "true | false" = "false",
                "average pictures and checkers over what a pixel sees of them, for one more ray a pixel: distant floors and skies do not crawl in films, and few samples do";
        }
        "camera" {
            position if "no worldline": "[x, y, z]" = "required", "the point, or the centre of the plane; scene units";
            look_at: "[x, y, z]" = "[0, 0, 0]", "the point in the middle of the picture; differs from position";
            up: "[x, y, z]" = "[0, 1, 0]", "what is up in the picture; not parallel to the view";
            observer if "no worldline": "coordinate | static | eulerian | zamo | prograde-orbit | retrograde-orbit | infalling | boosted" = "coordinate",
                "whose directions the camera sees: the coordinates', or those of an observer: all under laws of holes, all but `infalling` under metric; static and boosted under wormhole, and eulerian too under straight";
            velocity if r#"observer = "boosted""#: "[x, y, z], below 1 long" = "required",
                "of the observer, in parts of light's speed, past one who is normal";
            time if "no worldline": "number" = "0", "t when the picture is taken: after law.time, and for objects that move";
            proper_time if "observer or worldline": "number, 0 or above" = "none",
                "the picture is taken so much later by the observer's own clock: left to himself he has fallen freely from `position` meanwhile, moving as `observer` says to begin with; or he has come so far along the worldline";
            worldline if "no position": "array of [t, x, y, z], t ascending" = "none",
                "the observer's way through spacetime, smooth between these events: where, when and how fast he is follows from proper_time";
            redshift: "true | false" = "false",
                "whether light is as the observer sees it: brighter and bluer from what comes near or lies higher, by the fourth power of its frequency's ratio; needs an `observer`";
            color_shift if "redshift": "kept | black-body" = "kept",
                "what becomes of colours that no temperature is known of, the sky's too: they stay, or each is taken for that of a black body, which reddens and turns blue";
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
            absorption: "[red, green, blue] or { .. }" = "none",
                "what space leaves of light after a unit length, or adds to it: see absorption";
        }
        "law.sources" {
            position: "[x, y, z]" = "required", "a point of what it is centred on, scene units";
            strength: "number other than 0" = "required", "above 0 attracts, below 0 repels";
            falloff: r#""inverse-square", { cubic = R }, { yukawa = mu }"# = "inverse-square",
                "how the force falls with distance";
            capture_radius: "number, 0 or above" = "0",
                "a ray that comes this near moving inwards is captured, scene units; 0 for never";
        }
        "medium" {
            absorption if "an object's interior": "[red, green, blue] or { .. }" = "none",
                "what it leaves of light after a unit length, or adds to it: see absorption";
            reflect_exponent if "an object's interior": "number above 0" = "none: smooth",
                "a rough surface: what it reflects is spread as cosᵉ of the angle to the mirror's direction";
            transmit_exponent if "an object's interior": "number above 0" = "none: smooth",
                "what goes through is spread so about the refracted direction; what would end on the wrong side is lost";
            roughness if "an object's interior": "number above 0, at most 1" = "none: smooth",
                "a surface of microfacets, the width a of their slopes by the law of Trowbridge and Reitz (GGX)";
        }
        "rays" {
            accuracy if r#"method = "auto""#: r#"number above 0, or pixels such as "0.1px""# = "0.1px",
                "the error in direction that 99 of 100 rays shall stay under: radians, or parts of a pixel at the picture's centre";
            bounding_sphere: "{ center, radius }" = "required", "the sphere that rays escape from and that holds all objects";
            segment: "arc | chord" = "arc",
                "what is tested against the objects: each step's arc, or one chord over several steps";
            arc_tolerance if r#"segment = "arc""#: "number above 0" = "1e-4 of the bound's radius",
                "how far an arc's chords may depart from it, scene units";
            steps_per_segment if r#"segment = "chord""#: "whole number, 1 to 1000" = "10", "steps a chord";
            max_segments: "whole number, 1 to 1000000" = "1000", "a ray is given up after so many segments; with method = \"auto\", after four times as many";
            max_parameter: "number above 0" = "none", "rays end at this τ";
            sky_at_infinity if "schwarzschild, reissner-nordstrom, kerr-newman, or one inverse-square source": "true | false" = "false",
                "rays that leave the bound are followed to infinity in closed form, and those given from outside come from there";
            precision: "f16 | f32 | f64 | auto" = "f32",
                "bits of the numbers: f64 where the device has it, f16 keeps 16 bits between passes as in 2004; beside method = \"auto\", auto takes f64 where f32 does not reach the accuracy";
            closed_forms: "true | false" = "true with auto, exact and planar, else false",
                "media whose paths have a closed form are followed by it, whatever the method";
            max_splits: "whole number, 0 to 20, or stochastic" = "4",
                "where a surface splits light both rays are followed, so many times along a path; or one at random, a sample";
            lighting: "direct | path-tracing" = "direct",
                "what lights surfaces: the scene's lights; or all that shines, by paths from surface to surface under the law";
            wavelength if "sellmeier": "number above 0" = "587.56", "of light, nm, where paths do not draw it: in pictures without paths, and in traces; infrared and ultraviolet too, where the glass's formula holds";
            acceleration: "auto | bvh | grid | none" = "auto",
                "how objects are searched: by a hierarchy of boxes, a uniform grid, or one after the other; auto is what measures best";
        }
        "ambient" {
            rays: "straight | law" = "straight", "along what a place looks for light: straight lines, or paths under the scene's law";
            distance: "number above 0" = "none", "what is farther away shuts nothing out, scene units";
            floor: "number from 0 to 1" = "0", "the part that is left where all is closed";
            transparent if r#"rays = "straight""#: "ignored | tinted | opaque" = "opaque", "what comes through interiors: all light, what they transmit and filter, none";
        }
        "path_tracing" {
            max_depth: "whole number, 0 to 1000000" = "none", "surfaces that send a path on, at most; light beyond is missing";
            rr_depth: "whole number, 1 to 1000000" = "4",
                "after so many surfaces a path is given up at random, the sooner the less it weighs, and what is left weighs more";
            light_sampling: "true | false" = "true", "from each surface one more ray towards lamps and what is bright in the sky's picture: less noise, the same picture";
            guiding: "true | false" = "true", "light is followed from the lamps first, so that these rays also go where mirrors, glass or the law send it";
            seed: "whole number, 0 to 4294967295" = "0", "another for another picture of the same light: other noise";
        }
        "rays.bounding_sphere" {
            center: "[x, y, z]" = "[0, 0, 0]", "scene units";
            radius: "number above 0" = "required", "scene units";
        }
        "sky" {
            color if "no image and no faces": "[red, green, blue]" = "[0, 0, 0]", "one colour, linear";
            image if "no color and no faces": "file" = "none", "an equirectangular picture: PNG, JPEG, EXR or HDR";
            faces if "no color and no image": "six files" = "none",
                "the faces +x, -x, +y, -y, +z, -z of a cube, seen from inside";
            intensity if "image or faces": "number, 0 or above" = "1", "factor on the picture's radiance";
            other_side if r#"law.kind = "wormhole""#: "table" = "the same sky", "what a ray that escapes on the other side sees";
        }
        "output" {
            exposure: "number, -64 to 64" = "0", "stops; PNG only";
            tonemap: "none | filmic" = "none", "the tone curve; PNG only";
            bit_depth: "8, 16" = "8", "bits a channel; PNG only";
            clamp if r#"lighting = "path-tracing""#: "number above 0" = "none",
                "the most radiance that one sample may add, in its brightest channel: less noise, and less light; what is lost is said";
        }
        "materials.NAME.diffuse" {
            color if "no checker and no image": "[red, green, blue]" = "[1, 1, 1] with vertex_colors", "one color, linear";
            checker if "no color and no image": "[color, color]" = "none", "two colours in turn";
            image if "no color and no checker": "file" = "none", "PNG, JPEG, EXR or HDR";
            vertex_colors: "true | false" = "false", "whether the color, checker or image is multiplied by the vertex colors of the mesh";
            repeat if "checker or image": "[u, v], above 0" = "[8, 8] for checker, [1, 1] for image",
                "cells, or pictures, along u and v";
        }
        "objects" {
            material if "no interior": "name" = "required", "what its surface is made of: one of [materials]";
            interior if "no material": "number, name or { kind, .. }" = "none", "the medium that fills it: see medium";
            priority if "interior": "whole number, 0 to 1000" = "0", "where interiors overlap, the higher one is there";
            orbit if "no velocity": "prograde, retrograde or a number" = "none",
                "it goes round the law's axis, on a circular orbit of matter or through so many radians in a unit of time, and is seen where it was when its light left it; at t = 0 it is in its place";
            velocity if "no orbit": "[x, y, z]" = "none", "it moves straight on, scene units in a unit of time, and is seen where it was when its light left it";
            scale: "number or [x, y, z], above 0" = "1", "done first, about the origin";
            rotate: "[x, y, z]" = "[0, 0, 0]", "degrees about the x, then y, then z axis, about the origin";
            translate: "[x, y, z]" = "[0, 0, 0]", "done last, scene units";
        }
        "lights" {
            kind: "point | directional" = "required", "from a place, or from far away";
            color: "[red, green, blue]" = "[1, 1, 1]", "radiance of a white surface that faces it, linear";
            shadows: "none | straight-rays | photon-grid | curved-rays" = "none",
                "what it does not reach: nothing that faces it; what is behind something opaque on a straight line, whatever the law; or what no path under the law leads to from it, by paths from the light that are kept in voxels, or by the search for one from each place";
            falloff if r#"kind = "point""#: "none | inverse-square" = "none",
                "as bright everywhere, or by the square of the distance, `color` at distance 1; with grid and shooting, by the spread of its bundle of paths";
            transparent if r#"shadows = "straight-rays""#: "ignored | tinted | opaque" = "ignored",
                "what comes straight through interiors: all light, what they transmit and filter, none";
            voxels if r#"shadows = "photon-grid""#: "whole number, 8 to 512" = "64", "along the longest side of what is lit";
            refine if r#"shadows = "photon-grid""#: "whole number, 1 to 8" = "4",
                "parts along each axis of voxels in which light changes much: at caustics, at shadows' edges and at surfaces; 1 for none";
            paths if r#"shadows = "photon-grid""#: "whole number, 1024 to 67108864" = "2 voxels³, at least 65536",
                "rays from the light, and four times as many for the parts; more leave less noise";
            min_distance if r#"shadows = "curved-rays""#: "number above 0" = "0.001 times the bound's radius",
                "no place is brighter than one so near to it, scene units: at a caustic";
            position if r#"kind = "point""#: "[x, y, z]" = "required", "scene units";
            direction if r#"kind = "directional""#: "[x, y, z]" = "required", "where the light travels to";
        }
        "animation" {
            frames: "whole number, 1 to 1000000" = "required", "how many; they count from 0";
            rate: "number, 0.1 to 1000" = "24", "how many of them a film shows in a second";
            shutter: "number, 0 to 1" = "0",
                "motion blur: the part of the time between two frames for which the shutter is open, from a frame's own time on";
            shutter_samples: "power of two, 2 to 1024" = "64",
                "how many moments a frame shows while the shutter is open, at most: each is rendered with some of the samples";
            tracks: "array of tables" = "[]", "the keys that change; without --frames they are as the rest of the file says";
        }
        "animation.tracks" {
            key: "key" = "required", "as --set takes it: camera.position, objects.0.center";
            values: "array of numbers, or of arrays of numbers" = "required",
                "the values at some frames; before the first and after the last it stays";
            keyframes: "array of numbers, ascending" = "evenly from the first frame to the last", "the frame of each value";
            interpolation: "linear | smooth" = "linear",
                "how a value goes to the next: straight, or along a cubic that rests at both ends of the track";
        }
    }
}
