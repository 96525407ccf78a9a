//! Stores the values of a scene on the device: a buffer or texture for every binding that is the same for all tiles.

use std::borrow::Cow;
use std::collections::{BTreeMap, HashMap, HashSet};
use std::hash::Hasher;
use std::sync::Arc;

use siphasher::sip128::{Hasher128, SipHasher24};
use wgpu::util::{BufferInitDescriptor, DeviceExt};
use wgpu::{Buffer, BufferUsages, Texture};

use super::records::pack;
use super::source::Uploads;
use super::star_buckets::{StarLists, StarSkies};
use super::textures::upload_picture;
use super::uniforms::schedule_values;
use super::{Geometry, Gpu, GpuError, LightGridData};
use crate::program::{Binding, BindingKind, BlockMember, Layout, Program, Role, SceneValue};
use crate::scene::{Picture, Scene};

/// Storage buffers by the hash of their contents, for similar scenes that are on the device at the same time.
pub type Stored = HashMap<u128, Buffer>;

/// The buffers and textures of a scene.
#[derive(Debug)]
pub struct SceneBuffers {
    /// Uniform and storage buffers, by their roles.
    buffers: BTreeMap<Role, Buffer>,
    /// Textures, by their index in the scene.
    pictures: BTreeMap<usize, (Picture, Texture)>,
    /// The stars in the buffers.
    stars: StarSkies,
}

/// The lists of stars, which a film keeps.
const STARS: [&str; 2] = ["star_list", "star_buckets"];

impl SceneBuffers {
    /// Uploads the values of `scene` that `program` binds, with the `fields` of its lights' grids. `segments` is K, the number of segments
    /// of one fused pass. Textures that `before` has already uploaded are reused, and so are buffers with equal contents in `stored`, if
    /// given.
    pub(crate) fn new(
        gpu: &Gpu,
        scene: &Scene,
        geometry: &Geometry,
        program: &Program,
        fields: &[LightGridData],
        segments: u32,
        (before, mut stored): (Option<&Self>, Option<&mut Stored>),
    ) -> Result<Self, GpuError> {
        let same_stars = before.filter(|before| program.features.has_stars && before.stars.is_of(scene));
        let (star_skies, stars) = match same_stars {
            Some(before) => (before.stars.clone(), StarLists::default()),
            None if program.features.has_stars => StarSkies::sorted(scene),
            None => Default::default(),
        };
        let kinds = Vec::new();
        let mut source = Uploads { scene, geometry, program, fields, segments, star_skies, stars, kinds };
        source.kinds = [source.of_kinds(), source.uniforms()].concat();
        let stars = source.star_skies.clone();
        let mut made = Self { buffers: BTreeMap::new(), pictures: BTreeMap::new(), stars };
        let stage = gpu.progress.measured("uploading the scene", program.bindings().count() as f64);
        for binding in program.bindings() {
            match &binding.role {
                role if STARS.contains(&&*binding.name) && same_stars.is_some_and(|own| own.buffer(role).is_some()) => {
                    made.buffers.extend(same_stars.and_then(|own| own.buffers.get_key_value(role)).map(cloned));
                }
                Role::Uniforms(_) | Role::Scene(_) if !made.buffers.contains_key(&binding.role) => {
                    let bytes = source.bytes(binding)?;
                    // A uniform may be rewritten later, so it is never shared.
                    let stored = stored.as_deref_mut().filter(|_| matches!(binding.kind, BindingKind::Storage { .. }));
                    let buffer = match stored {
                        Some(stored) => upload_once(gpu, binding, &bytes, stored)?,
                        None => upload(gpu, binding, &bytes)?,
                    };
                    made.buffers.insert(binding.role.clone(), buffer);
                }
                Role::Picture(k) if !made.pictures.contains_key(k) => {
                    let picture = scene.pictures.get(*k).ok_or_else(|| no_value(&binding.name))?;
                    let there = before.and_then(|before| before.texture_of(picture));
                    let texture = there.map_or_else(|| upload_picture(gpu, picture, scene.has_footprints()), Ok)?;
                    made.pictures.insert(*k, (picture.clone(), texture));
                }
                _ => {}
            }
            stage.advance(1.0);
        }
        Ok(made)
    }

    /// Returns the buffer for a binding, if it belongs to the scene.
    #[must_use]
    pub fn buffer(&self, role: &Role) -> Option<&Buffer> {
        self.buffers.get(role)
    }

    /// Returns the scene's texture with index `k`.
    #[must_use]
    pub fn picture(&self, k: usize) -> Option<&Texture> {
        self.pictures.get(&k).map(|(_, texture)| texture)
    }

    fn texture_of(&self, picture: &Picture) -> Option<Texture> {
        let mut there = self.pictures.values();
        there.find(|(there, _)| Arc::ptr_eq(&there.pixels, &picture.pixels)).map(|(_, texture)| texture.clone())
    }

    /// Returns the size of all scenes on the device together, in bytes; shared resources count once.
    // wgpu's handles are hashed by the identity of the resource, which never changes.
    #[allow(clippy::mutable_key_type)]
    pub fn bytes<'s>(all: impl Iterator<Item = &'s Self> + Clone) -> u64 {
        let texture = |texture: &Texture| {
            u64::from(texture.width())
                * u64::from(texture.height())
                * u64::from(texture.format().block_copy_size(None).unwrap_or(0))
        };
        let buffers: HashSet<&Buffer> = all.clone().flat_map(|scene| scene.buffers.values()).collect();
        let textures: HashSet<&Texture> = all.flat_map(|scene| scene.pictures.values()).map(|(_, own)| own).collect();
        buffers.into_iter().map(Buffer::size).sum::<u64>() + textures.into_iter().map(texture).sum::<u64>()
    }
}

fn cloned<K: Clone, V: Clone>((key, value): (&K, &V)) -> (K, V) {
    (key.clone(), value.clone())
}

fn no_value(binding: &str) -> GpuError {
    GpuError::Layout { binding: binding.to_owned(), problem: "the scene provides no value".to_owned() }
}

/// Uploads like [`upload`], unless a buffer with the same contents exists.
fn upload_once(gpu: &Gpu, binding: &Binding, bytes: &[u8], stored: &mut Stored) -> Result<Buffer, GpuError> {
    let mut hasher = SipHasher24::new();
    hasher.write(bytes);
    let content = hasher.finish128().as_u128();
    if let Some(there) = stored.get(&content) {
        return Ok(there.clone());
    }
    let buffer = upload(gpu, binding, bytes)?;
    stored.insert(content, buffer.clone());
    Ok(buffer)
}

fn upload(gpu: &Gpu, binding: &Binding, bytes: &[u8]) -> Result<Buffer, GpuError> {
    let (usage, limit, allowed) = match binding.kind {
        BindingKind::Uniform(_) | BindingKind::Block { .. } => {
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

impl Uploads<'_> {
    /// Returns the bytes of one of the scene's buffers.
    fn bytes(&self, binding: &Binding) -> Result<Cow<'_, [u8]>, GpuError> {
        if let Some(list) = self.star_list(&binding.name) {
            return Ok(Cow::Borrowed(list));
        }
        match (&binding.kind, &binding.role) {
            (BindingKind::Block { members, span }, _) => {
                let mut bytes = vec![0; *span as usize];
                for BlockMember { name, value, offset, layout } in members {
                    let part = self.values(value, layout)?.ok_or_else(|| no_value(name))?;
                    bytes[*offset as usize..*offset as usize + part.len()].copy_from_slice(&part);
                }
                Ok(Cow::Owned(bytes))
            }
            (BindingKind::Uniform(layout) | BindingKind::Storage { layout, .. }, Role::Scene(value)) => {
                self.values(value, layout)?.map(Cow::Owned).ok_or_else(|| no_value(&binding.name))
            }
            _ => Err(no_value(&binding.name)),
        }
    }

    fn values(&self, SceneValue { name, region }: &SceneValue, layout: &Layout) -> Result<Option<Vec<u8>>, GpuError> {
        match name.as_str() {
            "schedule" => pack(name, layout, [schedule_values(self.scene.rays.max_segments, self.segments)]).map(Some),
            "media" => pack(name, layout, self.media(*region)).map(Some),
            "profile" => pack(name, layout, self.profiles(*region)).map(Some),
            "index_samples" => Ok(Some(bytemuck::cast_slice(&self.index_samples(*region)).to_vec())),
            "volume_samples" => {
                let grids = self.scene.volumes.iter().flat_map(|volume| &volume.grids);
                Ok(Some(
                    bytemuck::cast_slice(&grids.flat_map(|grid| grid.samples.iter().copied()).collect::<Vec<f32>>())
                        .to_vec(),
                ))
            }
            "regions" => pack(name, layout, self.regions()).map(Some),
            own => match self.kinds.iter().find(|binding| binding.name == own) {
                Some(binding) => pack(name, layout, &binding.rows).map(Some),
                None => self.list(own, layout),
            },
        }
    }
}
