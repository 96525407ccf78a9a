//! The reference of every table and key of the scene format.
//!
//! The syntax is `TABLE { key if WHEN: VALUE = DEFAULT, MEANING; }`; WHEN states the condition under which a key is read, if there is one.

use crate::document::{KeyReference, key_rows};

/// The keys that do not depend on the kinds of a scene.
#[expect(clippy::too_many_lines, reason = "a table")]
pub(super) fn fixed() -> Vec<KeyReference> {
    key_rows! {
        "" {
            units: "table" = "none", "the scale of the scene, which allows numbers with units, such as \"8 kpc\" and \"30 deg\"";
            image: "table" = "{}", "size and sampling of the image";
            camera: "table" = "none", "ray origins and directions; optional for `trace`";
            law: "table" = "{}", "how light travels";
            rays: "table" = "required", "how rays are integrated";
            sky: r#"table | "transparent""# = "{}", "the background for rays that escape; \"transparent\" writes an alpha channel";
            output: "table" = "{}", "how radiance becomes a PNG";
            materials: "table of tables" = "{}", "named materials";
            objects: "array of tables" = "[]", "surfaces that rays can hit";
            volumes: "array of tables" = "[]", "matter that emits and absorbs light along its path";
            radiation: "table" = "none", "light at given frequencies instead of colors, which volumes emit and absorb";
            lights: "array of tables" = "[]",
                "point and directional lights for phong materials; path tracing uses emitting objects and the sky instead";
            path_tracing if r#"lighting = "path-tracing""#: "table" = "{}", "indirect illumination";
            ambient: "table" = "none", "ambient occlusion; without it, ambient light reaches every point";
            animation: "table" = "none", "keys that change between frames, for `render --frames`";
        }
        "units" {
            mass if "no length": "string" = "none", "mass of 1 in scene units, such as \"4.3e6 Msun\": the unit of length is then GM/c², and the unit of time is GM/c³";
            length if "no mass": "string" = "none", "unit of length, such as \"1 km\"; the unit of time is the time in which light travels this length";
            distance: "string" = "none", "distance from which the scene is seen, such as \"8.2 kpc\": lengths and `camera.fov` may then be angles on the sky, such as \"60 uas\"";
        }
        "image" {
            size: "[width, height], 1 to 65536" = "[800, 600]", "image size, in pixels";
            samples: "whole number, 1 to 1048576" = "1", "samples per pixel; with `adaptive`, the maximum per pixel: a power of two, at least 16, by default 64";
            sampler: "multi-jittered | sobol" = "multi-jittered; sobol for adaptive and path-traced images",
                "sample pattern: stratified for exactly `samples` samples, or a sequence whose first 2, 4, 8, … samples are well distributed; `adaptive` requires sobol";
            adaptive: "number between 0 and 1" = "none",
                "threshold of adaptive sampling: a pixel whose corner rays agree takes no more; any other takes 16, 32, … samples until the standard error of its mean, in display values, is below this";
            footprints: "true | false" = "false",
                "filter textures and checkers over the pixel footprint, at one extra ray per pixel: distant floors and skies do not flicker in videos and need fewer samples";
        }
        "camera" {
            position if "no worldline": "[x, y, z]" = "required", "camera position, or the center of the image plane; scene units";
            look_at: "[x, y, z]" = "[0, 0, 0]", "point at the center of the image, in scene units; differs from position";
            up: "[x, y, z]" = "[0, 1, 0]", "direction that points up in the image; not parallel to the viewing direction";
            observer if "no worldline": "coordinate | static | eulerian | zamo | prograde-orbit | retrograde-orbit | infalling | boosted" = "coordinate",
                "frame of the camera: coordinate directions, or an observer: any for black-hole laws; any except `infalling` for metric; static or boosted for wormhole; static, boosted or eulerian for straight";
            velocity if r#"observer = "boosted""#: "[x, y, z], below 1 long" = "required",
                "velocity of the observer relative to the eulerian observer, as a fraction of the speed of light";
            time if "no worldline": "number" = "0", "coordinate time t of the image, counted from law.time; also positions moving objects";
            proper_time if "observer or worldline": "number, 0 or above" = "none",
                "proper time of the observer when the image is taken: without a worldline, the observer falls freely from `position`, starting with the motion set by `observer`";
            worldline if "no position": "array of [t, x, y, z], t ascending" = "none",
                "events on the path of the observer, joined by a smooth curve; proper_time selects position, time and velocity";
            redshift: "true | false" = "false",
                "apply Doppler and gravitational redshift: color shifts, and radiance scales with the fourth power of the frequency ratio g; needs an `observer`";
            color_shift if "redshift": "kept | black-body" = "kept",
                "redshift of colors without a known temperature, including the sky: unchanged, or shifted as the color of a black body";
            stereo: "{ separation, layout, convergence }" = "none",
                "two views in one image, for eyes to the left and right of the position";
        }
        "camera.stereo" {
            separation: "number above 0" = "required", "distance between the eyes, in scene units";
            layout: "side-by-side | top-bottom" = "side-by-side", "arrangement of the views: the left eye at the left, or at the top";
            convergence: "number above 0" = "none",
                "distance of zero parallax, in scene units; without it, the viewing directions are parallel";
        }
        "law" {
            absorption: "[red, green, blue] or { .. }" = "none",
                "absorption and emission of space per unit length: see absorption";
        }
        "law.sources" {
            position: "[x, y, z]" = "required", "position of the source, in scene units";
            strength: "number other than 0" = "required", "above 0 attracts, below 0 repels";
            falloff: r#""inverse-square", { cubic = R }, { yukawa = mu }"# = "inverse-square",
                "how the force decreases with distance";
            capture_radius: "number, 0 or above" = "0",
                "radius within which inward rays are captured, in scene units; 0 disables capture";
        }
        "medium" {
            absorption if "an object's interior": "[red, green, blue] or { .. }" = "none",
                "absorption and emission of the interior per unit length: see absorption";
            reflect_exponent if "an object's interior": "number above 0" = "none: smooth",
                "exponent e of a rough surface: reflected directions follow a cosᵉ lobe around the mirror direction";
            transmit_exponent if "an object's interior": "number above 0" = "none: smooth",
                "exponent e of the cosᵉ lobe around the refracted direction; directions on the wrong side of the surface are lost";
            roughness if "an object's interior": "number above 0, at most 1" = "none: smooth",
                "width a of the microfacet slopes, with the Trowbridge–Reitz (GGX) distribution";
        }
        "rays" {
            accuracy if r#"method = "auto""#: r#"number above 0, or pixels such as "0.1px""# = "0.1px",
                "maximum direction error of 99 % of the rays: in radians, or in pixels at the center of the image";
            bounding_sphere: "{ center, radius }" = "required", "sphere that encloses all objects; rays that leave it escape";
            segment: "arc | chord" = "arc",
                "curve that is tested against objects: the arc of each step, or one chord over several steps";
            arc_tolerance if r#"segment = "arc""#: "number above 0" = "1e-4 × bounding_sphere.radius",
                "maximum distance between an arc and its chords, in scene units";
            steps_per_segment if r#"segment = "chord""#: "whole number, 1 to 1000" = "10", "steps per chord";
            max_segments: "whole number, 1 to 1000000" = "1000", "segments after which a ray stops; with method = \"auto\", four times as many";
            max_parameter: "number above 0" = "none", "value of the ray parameter τ at which rays end";
            sky_at_infinity if "schwarzschild, reissner-nordstrom, kerr-newman, or one inverse-square source": "true | false" = "false",
                "continue rays that leave the bounding sphere to infinity, in closed form; rays given from outside start at infinity";
            precision: "f16 | f32 | f64 | auto" = "f32",
                "precision of the arithmetic: f64 needs device support; f16 stores 16-bit state between passes, as Weiskopf et al. (2004) did; auto, with method = \"auto\", uses f64 if f32 misses the accuracy";
            closed_forms: "true | false" = "true with auto, exact and planar, else false",
                "use closed-form paths in media that have them, with any method";
            max_splits: "whole number, 0 to 20, or stochastic" = "4",
                "maximum splits along a path into a reflected and a refracted ray; stochastic follows one of the two at random per sample";
            lighting: "direct | path-tracing" = "direct",
                "light sources: direct light from [[lights]], or path tracing from all emitters, along rays of the law";
            wavelength if "sellmeier": "number above 0" = "587.56", "wavelength in nm for traces and for images without path tracing; may be infrared or ultraviolet if the glass formula is valid there";
            acceleration: "auto | bvh | grid | none" = "auto",
                "acceleration structure: bounding volume hierarchy, uniform grid, or none; auto is the fastest in our measurements";
        }
        "ambient" {
            rays: "straight | law" = "straight", "rays that test for occlusion: straight lines, or paths of the law";
            distance: "number above 0" = "none", "maximum distance of occluders, in scene units";
            floor: "number from 0 to 1" = "0", "fraction of ambient light that remains under full occlusion";
            transparent if r#"rays = "straight""#: "ignored | tinted | opaque" = "opaque", "light that passes through interiors: all of it, the fraction left by transmission and absorption, or none";
        }
        "path_tracing" {
            max_depth: "whole number, 0 to 1000000" = "none", "maximum number of bounces; light from longer paths is missing";
            rr_depth: "whole number, 1 to 1000000" = "4",
                "bounces before Russian roulette starts";
            light_sampling: "true | false" = "true", "next-event estimation: one extra ray per bounce towards emitters and bright parts of the environment map; less noise, the same expected image";
            guiding: "true | false" = "true", "path guiding: light is traced from the emitters first, so that extra rays also follow its paths via mirrors, glass or the law";
            seed: "whole number, 0 to 4294967295" = "0", "seed of the random numbers; another seed gives different noise";
        }
        "rays.bounding_sphere" {
            center: "[x, y, z]" = "[0, 0, 0]", "scene units";
            radius: "number above 0" = "required", "scene units";
        }
        "sky" {
            color if "no image and no faces": "[red, green, blue]" = "[0, 0, 0]", "uniform color, linear RGB";
            image if "no color and no faces": "file" = "none", "equirectangular environment map: PNG, JPEG, EXR or HDR";
            faces if "no color and no image": "six files" = "none",
                "cube map: the faces +x, -x, +y, -y, +z, -z, seen from inside";
            intensity if "image or faces": "number, 0 or above" = "1", "factor on the radiance of the environment map";
            stars: "file or { file, .. }" = "none", "stars that are points, from a catalog: see sky.stars";
            rotate: "[x, y, z]" = "[0, 0, 0]",
                "rotation of images and stars about the x, then y, then z axis, in degrees; without it, declination 90 is at +y, right ascension 0 at -z";
            other_side if r#"law.kind = "wormhole""#: "table" = "the same sky", "background for rays that escape on the other side";
        }
        "sky.stars" {
            file: "file" = "required", "catalog in CSV, with the columns ra (or ra_h), dec, mag, and b_v or temperature";
            intensity: "number, 0 or above" = "1", "factor on the light of the stars; 1 gives cd/m²";
            limit: "number" = "none", "magnitude of the faintest stars";
            size: "number above 0, at most 1" = "2e-4", "diameter of a star, in degrees, which limits its brightness on critical curves";
        }
        "output" {
            exposure: "number, -64 to 64" = "0", "exposure, in stops; PNG only";
            tonemap: "none | filmic" = "none", "tone curve; PNG only";
            bit_depth: "8, 16" = "8", "bits per channel; PNG only";
            glare: "number, 0 to 1" = "0", "fraction of the light that the glare of a lens spreads (bloom); PNG only";
            clamp if r#"lighting = "path-tracing""#: "number above 0" = "none",
                "maximum radiance of one sample, in its brightest channel: less noise, but darker; bentray prints the loss";
        }
        "materials.NAME.diffuse" {
            color if "no checker and no image": "[red, green, blue]" = "[1, 1, 1] with vertex_colors", "uniform color, linear RGB";
            checker if "no color and no image": "[color, color]" = "none", "the two colors of a checkerboard";
            image if "no color and no checker": "file" = "none", "PNG, JPEG, EXR or HDR";
            vertex_colors: "true | false" = "false", "multiply the color, checker or image by the vertex colors of the mesh";
            repeat if "checker or image": "[u, v], above 0" = "[8, 8] for checker, [1, 1] for image",
                "number of cells or images along u and v";
        }
        "objects" {
            material if "no interior": "name" = "required", "surface material: a name from [materials]";
            interior if "no material": "number, name or { kind, .. }" = "none", "medium inside the object: see medium";
            priority if "interior": "whole number, 0 to 1000" = "0", "precedence where interiors overlap: the higher value wins";
            orbit if "no velocity": "prograde, retrograde or a number" = "none",
                "circular orbit around the axis of the law, as a free particle or at an angular velocity in radians per unit of time; starts at its position at t = 0 and is shown retarded by the light travel time";
            velocity if "no orbit": "[x, y, z]" = "none", "constant velocity, in scene units per unit of time; shown retarded by the light travel time";
            scale: "number or [x, y, z], above 0" = "1", "scaling about the origin, applied first";
            rotate: "[x, y, z]" = "[0, 0, 0]", "rotation about the x, then y, then z axis through the origin, in degrees";
            translate: "[x, y, z]" = "[0, 0, 0]", "translation, in scene units, applied last";
        }
        "lights" {
            kind: "point | directional" = "required", "light from a point, or from a distant source";
            color: "[red, green, blue]" = "[1, 1, 1]", "radiance of a white surface that faces the light, linear RGB";
            shadows: "none | straight-rays | photon-grid | curved-rays" = "none",
                "shadow method: no shadows; straight shadow rays, whatever the law; paths of the law, traced from the light into voxels; or paths of the law, found by the shooting method for each point";
            falloff if r#"kind = "point""#: "none | inverse-square" = "none",
                "constant, or inverse square with `color` at distance 1; photon-grid and curved-rays use the divergence of the ray bundle instead of the distance";
            transparent if r#"shadows = "straight-rays""#: "ignored | tinted | opaque" = "ignored",
                "light that passes straight through interiors: all of it, the fraction left by transmission and absorption, or none";
            voxels if r#"shadows = "photon-grid""#: "whole number, 8 to 512" = "64", "voxels along the longest side of the lit region";
            refine if r#"shadows = "photon-grid""#: "whole number, 1 to 8" = "4",
                "subdivisions per axis of voxels with strongly varying light: caustics, shadow edges, surfaces; 1 for none";
            paths if r#"shadows = "photon-grid""#: "whole number, 1024 to 67108864" = "2 voxels³, at least 65536",
                "rays traced from the light, plus four times as many for subdivided voxels; more rays mean less noise";
            min_distance if r#"shadows = "curved-rays""#: "number above 0" = "0.001 × bounding_sphere.radius",
                "minimum effective distance, in scene units; limits the brightness of caustics";
            position if r#"kind = "point""#: "[x, y, z]" = "required", "scene units";
            direction if r#"kind = "directional""#: "[x, y, z]" = "required", "direction in which the light travels";
        }
        "animation" {
            frames: "whole number, 1 to 1000000" = "required", "number of frames, counted from 0";
            rate: "number, 0.1 to 1000" = "24", "frames per second of a video";
            shutter: "number, 0 to 1" = "0",
                "motion blur: fraction of the frame interval during which the shutter is open, starting at the time of the frame";
            shutter_samples: "power of two, 2 to 1024" = "64",
                "maximum number of shutter times per frame; the samples of a pixel are divided among them";
            tracks: "array of tables" = "[]", "keys that change; without --frames, they have the values of the rest of the file";
        }
        "animation.tracks" {
            key: "key" = "required", "key to animate, as in --set: camera.position, objects.0.center";
            values: "array of numbers, or of arrays of numbers" = "required",
                "values at the keyframes; constant before the first and after the last";
            keyframes: "array of numbers, ascending" = "evenly from the first frame to the last", "frame number of each value";
            interpolation: "linear | smooth" = "linear",
                "interpolation between values: linear, or a cubic with zero slope at both ends of the track";
        }
    }
}
