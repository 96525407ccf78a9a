//! A scene's values on the device: a buffer or texture for every binding of its program that is the same for all tiles.

use std::collections::BTreeMap;

use glam::{DVec2, DVec3};
use half::f16;
use wgpu::util::{BufferInitDescriptor, DeviceExt, TextureDataOrder};
use wgpu::{
    Buffer, BufferUsages, Extent3d, Texture, TextureDescriptor, TextureDimension, TextureFormat, TextureUsages,
};

use super::geometry::PlacedShape;
use super::records::Value::{Float, Uint, Uint2, Uint4, Vec2, Vec3, Vec4};
use super::records::{Value, pack};
use super::{Geometry, Gpu, GpuError};
use crate::program::{Binding, BindingKind, Layout, Program, Purpose, constant};
use crate::scene::{
    CameraKind, Control, Falloff, FlowField, Law, Light, MaterialKind, Method, Pattern, Picture, Scene, Segment, Sky,
};

/// The bindings of a scene, by name.
#[derive(Debug)]
pub struct SceneBuffers {
    /// Uniform and storage buffers.
    pub buffers: BTreeMap<String, Buffer>,
    /// Pictures.
    pub textures: BTreeMap<String, Texture>,
}

/// What the values are read from.
struct Source<'a> {
    scene: &'a Scene,
    geometry: &'a Geometry,
    program: &'a Program,
    segments: u32,
}

impl SceneBuffers {
    /// Uploads what `program` binds of `scene`. `segments` is K, the segments of one fused pass.
    pub fn new(
        gpu: &Gpu,
        scene: &Scene,
        geometry: &Geometry,
        program: &Program,
        segments: u32,
    ) -> Result<Self, GpuError> {
        let source = Source { scene, geometry, program, segments };
        let mut made = Self { buffers: BTreeMap::new(), textures: BTreeMap::new() };
        for binding in program.passes.iter().flat_map(|(_, _, reflection)| &reflection.bindings) {
            if made.buffers.contains_key(&binding.name) || made.textures.contains_key(&binding.name) {
                continue;
            }
            if let Some(picture) = image_index(&binding.name).and_then(|k| scene.pictures.get(k)) {
                made.textures.insert(binding.name.clone(), upload_picture(gpu, picture)?);
            } else if let Some(bytes) = source.bytes(binding)? {
                made.buffers.insert(binding.name.clone(), upload(gpu, binding, &bytes)?);
            }
        }
        Ok(made)
    }
}

fn image_index(name: &str) -> Option<usize> {
    name.strip_prefix("image_")?.parse().ok()
}

fn upload(gpu: &Gpu, binding: &Binding, bytes: &[u8]) -> Result<Buffer, GpuError> {
    let (usage, limit, allowed) = match binding.kind {
        BindingKind::Uniform(_) => {
            (BufferUsages::UNIFORM, "max_uniform_buffer_binding_size", gpu.limits.max_uniform_buffer_binding_size)
        }
        _ => (BufferUsages::STORAGE, "max_storage_buffer_binding_size", gpu.limits.max_storage_buffer_binding_size),
    };
    let what = format!("bytes in one buffer (`{}`)", binding.name);
    gpu.check(limit, &what, allowed.min(gpu.limits.max_buffer_size), bytes.len() as u64)?;
    Ok(gpu.device.create_buffer_init(&BufferInitDescriptor {
        label: Some(&binding.name),
        contents: bytes,
        usage: usage | BufferUsages::COPY_DST,
    }))
}

/// In 16 bits where its values fit.
fn upload_picture(gpu: &Gpu, picture: &Picture) -> Result<Texture, GpuError> {
    let [width, height] = picture.size;
    gpu.check(
        "max_texture_dimension_2d",
        &format!("pixels along one side of a picture (`{}`)", picture.name),
        u64::from(gpu.limits.max_texture_dimension_2d),
        u64::from(width.max(height)),
    )?;
    let fits = picture.pixels.iter().flatten().all(|v| *v <= f16::MAX.to_f32());
    let texels = picture.pixels.iter().flat_map(|[r, g, b]| [*r, *g, *b, 1.0]);
    let (format, bytes) = if fits {
        let halves: Vec<f16> = texels.map(f16::from_f32).collect();
        (TextureFormat::Rgba16Float, bytemuck::cast_slice(&halves).to_vec())
    } else {
        let floats: Vec<f32> = texels.collect();
        (TextureFormat::Rgba32Float, bytemuck::cast_slice(&floats).to_vec())
    };
    let descriptor = TextureDescriptor {
        label: Some(&picture.name),
        size: Extent3d { width, height, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: TextureDimension::D2,
        format,
        usage: TextureUsages::TEXTURE_BINDING | TextureUsages::COPY_DST,
        view_formats: &[],
    };
    Ok(gpu.device.create_texture_with_data(&gpu.queue, &descriptor, TextureDataOrder::LayerMajor, &bytes))
}

impl Source<'_> {
    /// The bytes of a binding; none for what belongs to tiles and passes.
    fn bytes(&self, binding: &Binding) -> Result<Option<Vec<u8>>, GpuError> {
        let (BindingKind::Uniform(layout) | BindingKind::Storage { layout, .. }) = &binding.kind else {
            return Ok(None);
        };
        let name = binding.name.as_str();
        let one = |row: &[(&'static str, Value)]| pack(name, layout, [row]).map(Some);
        match name {
            "bound" => {
                let bound = &self.scene.rays.bound;
                one(&[("center", Vec3(bound.center)), ("radius", Float(bound.radius))])
            }
            "schedule" => one(&[
                ("max_segments", Uint(self.scene.rays.max_segments)),
                ("segments", Uint(self.segments)),
                ("segment_work", Uint(self.program.work.segment as u32)),
            ]),
            "camera" => one(&self.camera()),
            "sampling" => {
                let columns = f64::from(self.scene.image.samples).sqrt().ceil() as u32;
                one(&[("grid", Uint2([columns, self.scene.image.samples.div_ceil(columns)]))])
            }
            "law" | "flow" | "medium" => one(&self.law()),
            "control" => one(&self.control()),
            "snell" => match self.scene.rays.method {
                Method::Snell { threshold } => one(&[("threshold", Float(threshold))]),
                _ => Ok(None),
            },
            "limit" => one(&[("length", Float(self.scene.rays.length.unwrap_or(f64::MAX)))]),
            "chord" => match self.scene.rays.segment {
                Segment::Chord { steps } => one(&[("steps", Uint(steps))]),
                Segment::Arc { .. } => Ok(None),
            },
            "arc" => match self.scene.rays.segment {
                Segment::Arc { tolerance } => {
                    let (lo, hi) = self.geometry.bounds();
                    one(&[("tolerance", Float(tolerance)), ("lo", Vec3(lo)), ("hi", Vec3(hi))])
                }
                Segment::Chord { .. } => Ok(None),
            },
            "sky" => one(&self.sky()),
            _ => self.list(name, layout),
        }
    }

    fn camera(&self) -> Vec<(&'static str, Value)> {
        let Some(camera) = &self.scene.camera else { return Vec::new() };
        let [width, height] = self.scene.image.size.map(f64::from);
        let half = match camera.kind {
            CameraKind::Pinhole { fov } => (0.5 * fov).to_radians().tan(),
            CameraKind::Plane { height } => 0.5 * height,
        };
        vec![
            ("position", Vec3(camera.position)),
            ("forward", Vec3(camera.forward)),
            ("right", Vec3(camera.right * half * width / height)),
            ("up", Vec3(camera.up * half)),
        ]
    }

    fn law(&self) -> Vec<(&'static str, Value)> {
        match &self.scene.law {
            Law::Schwarzschild { mass, center, .. } => vec![("center", Vec3(*center)), ("mass", Float(*mass))],
            Law::Flow { field: FlowField::Lorenz { sigma, rho, beta }, .. } => {
                vec![("sigma", Float(*sigma)), ("rho", Float(*rho)), ("beta", Float(*beta))]
            }
            Law::Flow { field: FlowField::Rossler { alpha, beta, gamma }, .. } => {
                vec![("alpha", Float(*alpha)), ("beta", Float(*beta)), ("gamma", Float(*gamma))]
            }
            Law::Medium(n) => vec![
                ("center", Vec3(n.center)),
                ("radius", Float(n.radius)),
                ("amplitude", Float(n.amplitude)),
                ("frequency", Float(n.frequency)),
                ("octaves", Uint(n.octaves)),
                ("seed", Uint(n.seed)),
            ],
            Law::Straight | Law::Sources(_) => Vec::new(),
        }
    }

    fn control(&self) -> Vec<(&'static str, Value)> {
        match self.scene.rays.control {
            Control::Exact => Vec::new(),
            Control::Fixed { step } => vec![("step", Float(step))],
            Control::Scaled { eta } => vec![("eta", Float(eta))],
            Control::Doubling { tolerance, grow_below, eta, .. } => {
                vec![("tolerance", Float(tolerance)), ("grow_below", Float(grow_below)), ("eta", Float(eta))]
            }
        }
    }

    fn sky(&self) -> Vec<(&'static str, Value)> {
        match &self.scene.sky {
            Sky::Color(color) => vec![("color", Vec3(*color))],
            Sky::Equirectangular(image, intensity) => {
                vec![("intensity", Float(*intensity)), ("image", Uint(*image as u32))]
            }
            Sky::Faces(faces, intensity) => {
                let f = faces.map(|face| face as u32);
                vec![
                    ("faces", Uint4([f[0], f[1], f[2], f[3]])),
                    ("more_faces", Uint2([f[4], f[5]])),
                    ("intensity", Float(*intensity)),
                ]
            }
        }
    }

    fn list(&self, name: &str, layout: &Layout) -> Result<Option<Vec<u8>>, GpuError> {
        let g = self.geometry;
        let placed = |kind: &str| {
            let shapes = g.placed.get(kind).map_or(&[][..], Vec::as_slice);
            pack(name, layout, shapes.iter().map(placed_row)).map(Some)
        };
        let spaces = |kind: &str| {
            let shapes = g.placed.get(kind).map_or(&[][..], Vec::as_slice);
            pack(name, layout, shapes.iter().map(space_rows)).map(Some)
        };
        match name {
            "balls" => {
                let shapes = g.placed.get("sphere").map_or(&[][..], Vec::as_slice);
                pack(name, layout, shapes.iter().map(|s| [("center", Vec3(s.center)), ("radius", Float(s.radius))]))
                    .map(Some)
            }
            "ellipsoid_spaces" => spaces("ellipsoid"),
            "box_spaces" => spaces("box"),
            "plane_spaces" => spaces("plane"),
            "spheres" => placed("sphere"),
            "ellipsoids" => placed("ellipsoid"),
            "boxes" => placed("box"),
            "planes" => placed("plane"),
            "nodes" => pack(
                name,
                layout,
                g.nodes.iter().map(|n| {
                    [
                        ("lo", Vec3(n.lo.into())),
                        ("hi", Vec3(n.hi.into())),
                        ("skip", Uint(n.skip)),
                        ("leaf", Uint(n.leaf)),
                    ]
                }),
            )
            .map(Some),
            "triangles" => pack(
                name,
                layout,
                g.triangles.iter().map(|[a, b, c, object]| {
                    [("a", Uint(*a)), ("b", Uint(*b)), ("c", Uint(*c)), ("object", Uint(*object))]
                }),
            )
            .map(Some),
            "vertices" => pack(
                name,
                layout,
                g.vertices.iter().map(|v| {
                    [
                        ("position", Vec3(v.position.into())),
                        ("normal", Vec3(v.normal.into())),
                        ("u", Float(v.uv.x.into())),
                        ("v", Float(v.uv.y.into())),
                    ]
                }),
            )
            .map(Some),
            "object_materials" => {
                let materials: Vec<u32> = self.scene.objects.iter().map(|object| object.material as u32).collect();
                Ok(Some(bytemuck::cast_slice(&materials).to_vec()))
            }
            "materials" => self.materials(layout).map(Some),
            _ => self.lights_and_sources(name, layout),
        }
    }

    fn materials(&self, layout: &Layout) -> Result<Vec<u8>, GpuError> {
        let code = |part: &str, name: &str| constant(part, name) as u32;
        let kinds = [code("material/emissive", "EMISSIVE"), code("material/phong", "PHONG")];
        let patterns =
            [code("pattern/constant", "CONSTANT"), code("pattern/checker", "CHECKER"), code("pattern/image", "IMAGE")];
        let rows = self.scene.materials.iter().map(|material| {
            let (kind, ambient, specular, shininess, emission) = match material.kind {
                MaterialKind::Emissive => (kinds[0], 0.0, DVec3::ZERO, 1.0, DVec3::ZERO),
                MaterialKind::Phong { ambient, specular, shininess, emission } => {
                    (kinds[1], ambient, specular, shininess, emission)
                }
            };
            let (pattern, color, second, repeat, image) = match &material.color {
                Pattern::Constant(color) => (patterns[0], *color, DVec3::ZERO, DVec2::ONE, 0),
                Pattern::Checker { colors, repeat } => (patterns[1], colors[0], colors[1], *repeat, 0),
                Pattern::Picture { picture, repeat } => (patterns[2], DVec3::ONE, DVec3::ZERO, *repeat, *picture),
            };
            [
                ("kind", Uint(kind)),
                ("pattern", Uint(pattern)),
                ("color", Vec3(color)),
                ("second_color", Vec3(second)),
                ("specular", Vec3(specular)),
                ("shininess", Float(shininess)),
                ("emission", Vec3(emission)),
                ("ambient", Float(ambient)),
                ("repeat", Vec2(repeat)),
                ("image", Uint(image as u32)),
            ]
        });
        pack("materials", layout, rows)
    }

    fn lights_and_sources(&self, name: &str, layout: &Layout) -> Result<Option<Vec<u8>>, GpuError> {
        let lights = self.scene.lights.iter();
        let sources = match &self.scene.law {
            Law::Sources(sources) => sources.as_slice(),
            _ => &[],
        };
        let bytes = match name {
            "point_lights" => pack(
                name,
                layout,
                lights.filter_map(|light| match *light {
                    Light::Point { position, color } => Some([("position", Vec3(position)), ("color", Vec3(color))]),
                    Light::Directional { .. } => None,
                }),
            ),
            "directional_lights" => pack(
                name,
                layout,
                lights.filter_map(|light| match *light {
                    Light::Directional { direction, color } => {
                        Some([("direction", Vec3(direction)), ("color", Vec3(color))])
                    }
                    Light::Point { .. } => None,
                }),
            ),
            "inverse_square" => pack(
                name,
                layout,
                sources
                    .iter()
                    .filter(|s| s.falloff == Falloff::InverseSquare)
                    .map(|s| [("position", Vec3(s.position)), ("strength", Float(s.strength))]),
            ),
            "cubic" => pack(
                name,
                layout,
                sources.iter().filter_map(|s| match s.falloff {
                    Falloff::Cubic { radius } => Some([
                        ("position", Vec3(s.position)),
                        ("strength", Float(s.strength)),
                        ("radius", Float(radius)),
                    ]),
                    _ => None,
                }),
            ),
            "yukawa" => pack(
                name,
                layout,
                sources.iter().filter_map(|s| match s.falloff {
                    Falloff::Yukawa { mu } => {
                        Some([("position", Vec3(s.position)), ("strength", Float(s.strength)), ("mu", Float(mu))])
                    }
                    _ => None,
                }),
            ),
            "capture_spheres" => pack(
                name,
                layout,
                self.capture_spheres()
                    .into_iter()
                    .map(|(center, radius)| [("center", Vec3(center)), ("radius", Float(radius))]),
            ),
            _ => return Ok(None),
        };
        bytes.map(Some)
    }

    /// A hole captures at its horizon, or as far out as its photon sphere where nothing lies between that a ray moving inwards
    /// could still hit. Traced rays are followed to the horizon itself.
    fn capture_spheres(&self) -> Vec<(DVec3, f64)> {
        match &self.scene.law {
            Law::Schwarzschild { mass, center, .. } => {
                let clear =
                    self.geometry.clearance(*center) > 3.0 * mass && self.program.choice.purpose == Purpose::Picture;
                vec![(*center, if clear { 3.0 * mass } else { 2.0 * mass })]
            }
            Law::Sources(sources) => {
                sources.iter().filter(|s| s.capture > 0.0).map(|s| (s.position, s.capture)).collect()
            }
            _ => Vec::new(),
        }
    }
}

fn space_rows(shape: &PlacedShape) -> [(&'static str, Value); 3] {
    [("row_x", Vec4(shape.rows[0])), ("row_y", Vec4(shape.rows[1])), ("row_z", Vec4(shape.rows[2]))]
}

fn placed_row(shape: &PlacedShape) -> [(&'static str, Value); 7] {
    [
        ("center", Vec3(shape.center)),
        ("radius", Float(shape.radius)),
        ("row_x", Vec4(shape.rows[0])),
        ("row_y", Vec4(shape.rows[1])),
        ("row_z", Vec4(shape.rows[2])),
        ("material", Uint(shape.material)),
        ("object", Uint(shape.object)),
    ]
}
