//! Calls single shader functions: modules are linked with a generated entry point, which calls them on rows of inputs.
//!
//! *Practice.* A new program costs about 0.3 s on lavapipe, so one probe tries many functions on many inputs. A probe's body
//! reads its input rows as `p0`, `p1`, … (vec4f) and writes each output row by `put(k, row)`; rows that it does not write show.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::fmt::Write as _;

use bentray::gpu::{Gpu, Pipeline, pack};
use bentray::model::shape::SOLIDS;
use bentray::model::{Row, Value};
use bentray::program::{
    Analysis, BindingKind, Features, Layout, LinkedProgram, Parts, ProgramOptions, Reflection, Unit, link, part, plan,
    reflect, solid_codes,
};
use glam::{DVec3, Vec4};
use wgpu::util::{BufferInitDescriptor, DeviceExt};
use wgpu::{Buffer, BufferUsages, MapMode, PollType};

/// A record as (member, value).
pub type Record = Vec<(&'static str, Value)>;

/// Returns the record of a force source or a capture sphere around a point.
pub fn about_a_point(record: Record) -> Record {
    [record, vec![("along", Value::Vec3(DVec3::ZERO)), ("kind", Value::Uint(0))]].concat()
}

/// Returns a frame of one pixel, for the barriers against the compiler.
fn frame() -> Record {
    let one = Value::Uint2([1, 1]);
    vec![
        ("origin", Value::Uint2([0, 0])),
        ("size", one),
        ("image", one),
        ("sample", Value::Uint(0)),
        ("branch", Value::Uint(0)),
        ("listed", Value::Uint(0)),
        ("zero", Value::Uint(0)),
    ]
}

/// The initial value of an output: a NaN that no arithmetic makes.
const UNWRITTEN: u32 = 0x7fc0_dead;

/// Modules and the values of their bindings.
#[derive(Default)]
pub struct Probe {
    units: Vec<Unit>,
    records: BTreeMap<&'static str, Vec<Row>>,
    numbers: BTreeMap<&'static str, Vec<u32>>,
    features: Vec<&'static str>,
}

impl Probe {
    /// Creates a probe of the modules with these names, in 32 bits unless they specify otherwise.
    pub fn new(parts: &[&str]) -> Self {
        let unit = |name: &str| Unit::from(part(name).unwrap_or_else(|| panic!("no module {name}")));
        let mut names: Vec<&str> = Vec::new();
        for part in parts {
            if !names.contains(part) {
                names.push(part);
            }
        }
        names.push("real/hash");
        let usual = [
            ("real/math", "real/math"),
            ("real/f", "real/f32"),
            ("method/memory_", "method/memory_step"),
            ("surface/region_", "surface/region_none"),
            ("segment/last_hit", "segment/last_hit"),
            ("shape/facing", "shape/facing"),
            ("segment/join", "segment/join"),
        ];
        for (folder, usual) in usual {
            if !names.iter().any(|name| name.starts_with(folder)) {
                names.push(usual);
            }
        }
        let mut units: Vec<Unit> = names.iter().map(|name| unit(name)).collect();
        // The common modules of second-order laws and of steps of a planned size.
        let common = [
            ("law/", "fn law_derivative(", "law/accelerated"),
            ("method/control/", "fn accepted_step(", "method/control/planned"),
            ("law/", "fn law_ray_constant(", "law/no_constant"),
            ("law/", "fn law_projected(", "law/projected_as_is"),
            ("law/", "fn law_start(", "law/start_as_given"),
            ("motion/", "fn law_start(", "law/start_as_given"),
            ("method/memory_pair", "fn first_derivative(", "method/first_derivative"),
            ("segment/walk", "fn first_hit(", "segment/hit_still"),
            ("segment/ray", "fn later(", "state/tau"),
        ];
        for (folder, function, common) in common {
            let some = names.iter().any(|name| name.starts_with(folder));
            if some && !units.iter().any(|unit| unit.text.contains(function)) {
                units.push(unit(common));
            }
        }
        let probe = Self { units, ..Self::default() }.bind("frame", [frame()]);
        if !probe.units.iter().any(|unit| unit.text.contains("anchor_offset(")) {
            return probe;
        }
        // Forces originate in points, unless the probe specifies otherwise.
        let mut probe = probe
            .stub("fn anchor_offset(kind: u32, d: Real3, along: Real3) -> Real3 { return offset_center(d, along); }");
        probe.units.push(unit("law/offset"));
        probe
    }

    /// Adds a few lines of WGSL instead of a module that needs more of a device than a probe has.
    pub fn stub(mut self, text: &str) -> Self {
        self.units.push(Unit::user("stub.wgsl", text.to_owned()));
        self
    }

    /// Adds a feature that modules request; all others are absent.
    pub fn with(mut self, feature: &'static str) -> Self {
        self.features.push(feature);
        self
    }

    /// Adds the text generated for a scene, such as `generated/sources.wgsl`.
    pub fn generated(mut self, scene: &str, file: &str) -> Self {
        let scene = super::scene(scene);
        let analysis = Analysis::of(&scene);
        let features = Features::of(&scene, &ProgramOptions::default(), &analysis);
        let parts = plan(&scene, &analysis, &features).unwrap_or_else(|error| panic!("{error}"));
        let made = parts.shared.into_iter().chain(parts.regions.into_iter().flatten()).find(|unit| unit.file == file);
        self.units.push(made.unwrap_or_else(|| panic!("the scene has no {file}")));
        self
    }

    /// Binds records to `name`: one, or all the records of a list.
    pub fn bind<N: Into<Cow<'static, str>>>(
        mut self,
        name: &'static str,
        records: impl IntoIterator<Item = Vec<(N, Value)>>,
    ) -> Self {
        let row = |record: Vec<(N, Value)>| record.into_iter().map(|(name, value)| (name.into(), value)).collect();
        self.records.insert(name, records.into_iter().map(row).collect());
        self
    }

    /// Binds a list whose length is the constant `count` in the program.
    pub fn list<N: Into<Cow<'static, str>>>(
        self,
        name: &'static str,
        count: &str,
        records: impl IntoIterator<Item = Vec<(N, Value)>>,
    ) -> Self {
        let records: Vec<_> = records.into_iter().collect();
        let constant = format!("const {count}: u32 = {}u;", records.len());
        self.stub(&constant).bind(name, records)
    }

    /// Binds plain numbers to `name`.
    pub fn numbers(mut self, name: &'static str, numbers: &[u32]) -> Self {
        self.numbers.insert(name, numbers.to_vec());
        self
    }

    /// Runs `body` once for each of the inputs, I rows each, and returns the O rows that it writes for each.
    pub fn run<const I: usize, const O: usize>(&self, gpu: &Gpu, body: &str, inputs: &[[Vec4; I]]) -> Vec<[Vec4; O]> {
        let mut shared = self.units.clone();
        shared.push(entry(body, I, O, inputs.len()));
        if !shared.iter().any(|unit| unit.text.contains("struct Frame")) {
            shared.push(Unit::from(part("state/arguments").expect("the module that declares the frame")));
        }
        let generated = GENERATED
            .into_iter()
            .filter(|name| !shared.iter().any(|unit| unit.text.contains(&format!("const {name}:"))));
        let generated: Vec<&str> = generated.collect();
        shared.push(features(&self.features, &generated));
        if !shared.iter().any(|unit| unit.file == "generated/shapes.wgsl") {
            shared.push(Unit::generated("codes.wgsl", solid_codes(&SOLIDS)));
        }
        let parts = Parts { shared, ..Parts::default() };
        let linked = link(&parts, "probe").unwrap_or_else(|error| panic!("{error}"));
        let reflection = reflect(&linked).unwrap_or_else(|error| panic!("{error}"));
        let flat: Vec<Vec4> = inputs.iter().flatten().copied().collect();
        let unwritten = vec![UNWRITTEN; 4 * O * inputs.len()];
        let output = buffer(gpu, bytemuck::cast_slice(&unwritten), BufferUsages::STORAGE | BufferUsages::COPY_SRC);
        let buffers: Vec<Buffer> = reflection
            .bindings
            .iter()
            .map(|binding| match binding.name.as_str() {
                "probe_in" => buffer(gpu, bytemuck::cast_slice(&flat), BufferUsages::STORAGE),
                "probe_out" => output.clone(),
                _ => buffer(gpu, &self.bytes(binding), usage(&binding.kind)),
            })
            .collect();
        dispatch(gpu, &linked, &reflection, &buffers, inputs.len());
        let words = read(gpu, &output);
        let lost = words.iter().position(|word| *word == UNWRITTEN);
        assert!(lost.is_none(), "output word {lost:?} was not written (4 words per row, {O} rows per input)");
        let rows: Vec<Vec4> =
            words.chunks(4).map(|w| Vec4::from_array([0, 1, 2, 3].map(|k| f32::from_bits(w[k])))).collect();
        rows.chunks(O).map(|chunk| std::array::from_fn(|k| chunk[k])).collect()
    }

    fn packed(&self, name: &str, layout: &Layout) -> Vec<u8> {
        let records = self.records.get(name).unwrap_or_else(|| panic!("the probe was given no `{name}`"));
        pack(name, layout, records).unwrap_or_else(|error| panic!("{error}"))
    }

    fn bytes(&self, binding: &bentray::program::Binding) -> Vec<u8> {
        let name = binding.name.as_str();
        if let Some(numbers) = self.numbers.get(name) {
            return bytemuck::cast_slice(numbers).to_vec();
        }
        if let BindingKind::Block { members, span } = &binding.kind {
            let mut bytes = vec![0; *span as usize];
            for member in members {
                let part = self.packed(&member.name, &member.layout);
                bytes[member.offset as usize..][..part.len()].copy_from_slice(&part);
            }
            return bytes;
        }
        let (BindingKind::Uniform(layout) | BindingKind::Storage { layout, .. }) = &binding.kind else {
            panic!("`{name}` is a texture: give the probe a stub instead");
        };
        self.packed(name, layout)
    }
}

/// Constants that are generated with a scene's lists and regions.
const GENERATED: [&str; 3] = ["IS_WHOLE", "HAS_LISTS", "FINDS_NEAR"];

/// Declares the constants that modules request, which are true for these features.
fn features(present: &[&str], generated: &[&str]) -> Unit {
    let scene = super::scene("[rays]\nbounding_sphere = { radius = 1 }\n");
    let mut names = Features::of(&scene, &ProgramOptions::default(), &Analysis::of(&scene)).constants();
    names.extend(generated.iter().map(|name| ((*name).to_owned(), false)));
    for feature in present {
        assert!(names.iter().any(|(name, _)| name == feature), "no feature {feature}");
    }
    let text = names.iter().map(|(name, _)| format!("const {name}: bool = {};\n", present.contains(&&**name)));
    Unit::generated("generated/features.wgsl", text.collect())
}

fn entry(body: &str, rows_in: usize, rows_out: usize, count: usize) -> Unit {
    let mut text = format!(
        "struct ProbeRow {{\n    row: vec4f,\n}}\n\n\
         @group(0) @binding(900) var<storage, read> probe_in: array<ProbeRow>;\n\
         @group(0) @binding(901) var<storage, read_write> probe_out: array<ProbeRow>;\n\
         var<private> probe_index: u32;\n\n\
         fn put(k: u32, row: vec4f) {{\n    probe_out[probe_index * {rows_out}u + k] = ProbeRow(row);\n}}\n\n\
         @compute @workgroup_size(64)\nfn probe(@builtin(global_invocation_id) probe_id: vec3u) {{\n    \
         if probe_id.x < {count}u {{\n    probe_index = probe_id.x;\n"
    );
    for k in 0..rows_in {
        let _ = writeln!(text, "    let p{k} = probe_in[probe_index * {rows_in}u + {k}u].row;");
    }
    text += body;
    text += "    }\n}\n";
    Unit::user("probe.wgsl", text)
}

fn usage(kind: &BindingKind) -> BufferUsages {
    if matches!(kind, BindingKind::Uniform(_) | BindingKind::Block { .. }) {
        BufferUsages::UNIFORM
    } else {
        BufferUsages::STORAGE
    }
}

fn buffer(gpu: &Gpu, contents: &[u8], usage: BufferUsages) -> Buffer {
    gpu.device.create_buffer_init(&BufferInitDescriptor { label: Some("probe"), contents, usage })
}

fn dispatch(gpu: &Gpu, linked: &LinkedProgram, reflection: &Reflection, buffers: &[Buffer], count: usize) {
    let pipeline = Pipeline::new(gpu, linked, reflection, gpu.division()).unwrap_or_else(|error| panic!("{error}"));
    let entries: Vec<_> = reflection
        .bindings
        .iter()
        .zip(buffers)
        .map(|(binding, buffer)| wgpu::BindGroupEntry { binding: binding.number, resource: buffer.as_entire_binding() })
        .collect();
    let layout = &pipeline.layout;
    let group =
        gpu.device.create_bind_group(&wgpu::BindGroupDescriptor { label: Some("probe"), layout, entries: &entries });
    let mut encoder = gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
    {
        let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
        pass.set_pipeline(&pipeline.pipeline);
        let sections = reflection.bindings.iter().filter(|binding| binding.role.is_per_dispatch()).map(|_| 0);
        pass.set_bind_group(0, &group, &sections.collect::<Vec<_>>());
        pass.dispatch_workgroups(count.div_ceil(64) as u32, 1, 1);
    }
    gpu.queue.submit([encoder.finish()]);
}

fn read(gpu: &Gpu, from: &Buffer) -> Vec<u32> {
    let staging = gpu.device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("probe"),
        size: from.size(),
        usage: BufferUsages::COPY_DST | BufferUsages::MAP_READ,
        mapped_at_creation: false,
    });
    let mut encoder = gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
    encoder.copy_buffer_to_buffer(from, 0, &staging, 0, from.size());
    gpu.queue.submit([encoder.finish()]);
    let (sender, receiver) = std::sync::mpsc::channel();
    staging.map_async(MapMode::Read, .., move |result| sender.send(result).expect("the reader waits"));
    gpu.device.poll(PollType::wait_indefinitely()).expect("the device answers");
    receiver.recv().expect("the device answers").expect("the result can be read");
    bytemuck::pod_collect_to_vec(&staging.get_mapped_range(..).expect("the result is mapped"))
}
