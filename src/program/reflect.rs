//! Reflection of a linked program: validation by naga, and the bindings and layouts that the host would otherwise repeat.

use naga::{AddressSpace, ArraySize, ImageClass, Module, ScalarKind, StorageAccess, TypeInner, VectorSize};

use super::ProgramError;
use super::interface::{PICTURE, Role, SceneValue};
use super::link::link;
use super::linked::LinkedProgram;
use super::parts::part;
use super::unit::{Parts, Unit};
use super::validate::validated;

/// A validated program and its interface.
#[derive(Debug, Clone)]
pub struct Reflection {
    /// The entry point.
    pub entry: String,
    /// The bindings in the order of their numbers.
    pub bindings: Vec<Binding>,
    /// Whether the program computes in 64 bits.
    pub doubles: bool,
    /// The names of the constants that the host may override.
    pub overrides: Vec<String>,
}

impl Reflection {
    /// Counts the bindings for which `is` returns `true`.
    #[must_use]
    pub fn count(&self, is: impl Fn(&BindingKind) -> bool) -> usize {
        self.bindings.iter().filter(|binding| is(&binding.kind)).count()
    }
}

/// One resource that a program binds, in group 0.
#[derive(Debug, Clone, PartialEq)]
pub struct Binding {
    /// The variable's name.
    pub name: String,
    /// The number in `@binding`.
    pub number: u32,
    /// The kind of resource.
    pub kind: BindingKind,
    /// The purpose.
    pub role: Role,
}

/// The kinds of resource.
#[derive(Debug, Clone, PartialEq)]
pub enum BindingKind {
    /// A uniform buffer with one struct.
    Uniform(Layout),
    /// The uniform buffer with all uniforms of a scene.
    Block {
        /// The uniforms, each with its layout.
        members: Vec<BlockMember>,
        /// The size of the block in bytes.
        span: u32,
    },
    /// A storage buffer.
    Storage {
        /// The layout of its contents.
        layout: Layout,
        /// Whether the program only reads it.
        read_only: bool,
    },
    /// A texture read with `textureLoad`.
    Texture(naga::ScalarKind),
    /// A storage texture of this format, which is only written.
    StorageTexture(naga::StorageFormat),
}

/// One of a scene's uniforms in the block.
#[derive(Debug, Clone, PartialEq)]
pub struct BlockMember {
    /// Its name in the block.
    pub name: String,
    /// The value of the scene that it holds.
    pub value: SceneValue,
    /// The offset in bytes.
    pub offset: u32,
    /// The layout of its values.
    pub layout: Layout,
}

/// The layout of a buffer: a struct, or an array of structs, vectors or scalars.
#[derive(Debug, Clone, PartialEq)]
pub struct Layout {
    /// The members of the struct; empty for an array of vectors or scalars.
    pub fields: Vec<Field>,
    /// The size of one element in bytes.
    pub span: u32,
    /// The number of elements: one for a struct, `None` if the buffer may hold any number of them.
    pub count: Option<u32>,
}

impl Layout {
    /// Returns the member with this name.
    #[must_use]
    pub fn field(&self, name: &str) -> Option<&Field> {
        self.fields.iter().find(|field| field.name == name)
    }
}

/// A member of a struct.
#[derive(Debug, Clone, PartialEq)]
pub struct Field {
    /// The member's name.
    pub name: String,
    /// The offset in bytes.
    pub offset: u32,
    /// The type of its scalars.
    pub scalar: ScalarKind,
    /// The size of one scalar in bytes.
    pub width: u32,
    /// The number of scalars.
    pub components: u32,
}

/// Validates the program and reads its interface; errors name the location in the original file.
///
/// # Errors
///
/// Returns [`ProgramError::Invalid`] if the program is not valid, and [`ProgramError::UnknownBinding`] if a binding has a type that no pass
/// binds.
pub fn reflect(linked: &LinkedProgram) -> Result<Reflection, ProgramError> {
    let module = validated(linked)?;
    let mut bindings = Vec::new();
    for (handle, variable) in module.global_variables.iter() {
        let (Some(place), Some(name)) = (variable.binding, &variable.name) else {
            continue;
        };
        let at = module.global_variables.get_span(handle).to_range().map_or(0, |range| range.start);
        let kind = binding_kind(&module, variable).ok_or_else(|| nothing_to_bind(linked, at, name))?;
        let role = role(name, &kind, &linked.entry, at);
        bindings.push(Binding { name: name.clone(), number: place.binding, kind, role });
    }
    bindings.sort_by_key(|binding| binding.number);
    let double = |inner: &TypeInner| inner.scalar().is_some_and(|scalar| scalar == naga::Scalar::F64);
    let doubles = module.types.iter().any(|(_, ty)| double(&ty.inner));
    let overrides = module.overrides.iter().filter_map(|(_, own)| own.name.clone()).collect();
    Ok(Reflection { entry: linked.entry.clone(), bindings, doubles, overrides })
}

/// Returns the size in bytes of one element of a list that a module binds, such as `corners` of `shape/triangle`, with 32-bit numbers.
///
/// # Errors
///
/// If there is no such module, or it does not bind such a list.
pub fn element_bytes(part_name: &str, list: &str) -> Result<u32, ProgramError> {
    let entry = format!("@compute @workgroup_size(1) fn entry() {{ _ = {list}[0]; }}\n");
    let built_in = |name: &str| part(name).map(Unit::from).ok_or_else(|| ProgramError::NoPart(name.to_owned()));
    let shared = vec![built_in("real/f32")?, built_in(part_name)?, Unit::generated("entry.wgsl", entry)];
    let linked = link(&Parts { shared, ..Parts::default() }, "entry")?;
    match reflect(&linked)?.bindings.iter().find(|binding| binding.name == list).map(|binding| &binding.kind) {
        Some(BindingKind::Storage { layout, .. }) => Ok(layout.span),
        _ => Err(nothing_to_bind(&linked, 0, list)),
    }
}

/// Reflects a pass as [`reflect`] does; it is an error if a binding has no role.
pub(super) fn reflect_pass(linked: &LinkedProgram) -> Result<Reflection, ProgramError> {
    let reflection = reflect(linked)?;
    for Binding { name, role, .. } in &reflection.bindings {
        if let Role::Other { at } = role {
            return Err(nothing_to_bind(linked, *at, name));
        }
    }
    Ok(reflection)
}

fn nothing_to_bind(linked: &LinkedProgram, at: usize, name: &str) -> ProgramError {
    ProgramError::UnknownBinding { place: linked.place(at), name: name.to_owned() }
}

/// Returns the role of a binding that is declared at `at` in the program of `entry`.
fn role(name: &str, kind: &BindingKind, entry: &str, at: usize) -> Role {
    if let BindingKind::Block { .. } = kind {
        return Role::Uniforms(entry.to_owned());
    }
    Role::of_renderer(name).unwrap_or_else(|| {
        let value = SceneValue::of(name);
        match kind {
            BindingKind::Texture(_) if value.name == PICTURE => Role::Picture(value.region),
            BindingKind::Uniform(_) | BindingKind::Storage { read_only: true, .. } => Role::Scene(value),
            _ => Role::Other { at },
        }
    })
}

fn binding_kind(module: &Module, variable: &naga::GlobalVariable) -> Option<BindingKind> {
    let inner = &module.types[variable.ty].inner;
    Some(match (variable.space, inner) {
        (AddressSpace::Uniform, TypeInner::Struct { members, span }) => match block(module, members) {
            Some(members) => BindingKind::Block { members, span: *span },
            None => BindingKind::Uniform(layout(module, inner)?),
        },
        (AddressSpace::Storage { access }, _) => {
            BindingKind::Storage { layout: layout(module, inner)?, read_only: !access.contains(StorageAccess::STORE) }
        }
        (AddressSpace::Handle, TypeInner::Image { class: ImageClass::Sampled { kind, .. }, .. }) => {
            BindingKind::Texture(*kind)
        }
        (AddressSpace::Handle, TypeInner::Image { class: ImageClass::Storage { format, .. }, .. }) => {
            BindingKind::StorageTexture(*format)
        }
        _ => return None,
    })
}

/// Returns the members of a struct of structs and arrays of them; `None` for any other struct.
fn block(module: &Module, members: &[naga::StructMember]) -> Option<Vec<BlockMember>> {
    let part = |member: &naga::StructMember| {
        let inner = &module.types[member.ty].inner;
        let whole = matches!(inner, TypeInner::Struct { .. } | TypeInner::Array { .. });
        let layout = layout(module, inner).filter(|layout| whole && !layout.fields.is_empty())?;
        let name = member.name.clone()?;
        Some(BlockMember { value: SceneValue::of(&name), name, offset: member.offset, layout })
    };
    members.iter().map(part).collect()
}

fn layout(module: &Module, inner: &TypeInner) -> Option<Layout> {
    match inner {
        TypeInner::Array { base, size, stride } => {
            let element = layout(module, &module.types[*base].inner)?;
            let count = match size {
                ArraySize::Constant(count) => Some(count.get()),
                _ => None,
            };
            Some(Layout { span: *stride, count, ..element })
        }
        TypeInner::Struct { members, span } => {
            let fields = members.iter().filter_map(|member| field(module, member)).collect();
            Some(Layout { fields, span: *span, count: Some(1) })
        }
        TypeInner::Scalar(scalar) | TypeInner::Atomic(scalar) => {
            Some(Layout { fields: Vec::new(), span: u32::from(scalar.width), count: Some(1) })
        }
        TypeInner::Matrix { columns, rows, scalar } => {
            let row = u32::from(u8::from(*rows).next_power_of_two()) * u32::from(scalar.width);
            Some(Layout { fields: Vec::new(), span: u32::from(u8::from(*columns)) * row, count: Some(1) })
        }
        TypeInner::Vector { size, scalar } => Some(Layout {
            fields: Vec::new(),
            span: u32::from(u8::from(*size)) * u32::from(scalar.width),
            count: Some(1),
        }),
        _ => None,
    }
}

/// Returns a member that the host writes, which is a scalar or a vector; `None` for others.
fn field(module: &Module, member: &naga::StructMember) -> Option<Field> {
    let (scalar, components) = match module.types[member.ty].inner {
        TypeInner::Scalar(scalar) | TypeInner::Atomic(scalar) => (scalar, 1),
        TypeInner::Vector { size, scalar } => (scalar, u32::from(u8::from(size))),
        TypeInner::Array { base, size: ArraySize::Constant(count), .. } => match module.types[base].inner {
            TypeInner::Scalar(scalar) | TypeInner::Atomic(scalar) => (scalar, count.get()),
            // Without padding between elements.
            TypeInner::Vector { size: size @ (VectorSize::Bi | VectorSize::Quad), scalar } => {
                (scalar, u32::from(u8::from(size)) * count.get())
            }
            _ => return None,
        },
        _ => return None,
    };
    let width = u32::from(scalar.width);
    Some(Field { name: member.name.clone()?, offset: member.offset, scalar: scalar.kind, width, components })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_has_no_role_is_refused_where_it_is_declared() {
        let text = "// A part.\n@group(0) @binding(1) var<storage, read_write> scratch: array<u32>;\n\
                    @compute @workgroup_size(1) fn entry() { scratch[0] = 1u; }\n";
        let shared = vec![Unit::user("law/own.wgsl", text)];
        let linked = link(&Parts { shared, ..Parts::default() }, "entry").unwrap();
        assert!(matches!(reflect(&linked).unwrap().bindings[0].role, Role::Other { .. }));
        let error = reflect_pass(&linked).unwrap_err().to_string();
        assert!(error.contains("law/own.wgsl:2") && error.contains("`scratch`"), "{error}");
    }
}
