//! Host values by the names that WGSL has for them: what a kind tells its shader.

use std::borrow::Cow;

use glam::{DVec2, DVec3, DVec4};

/// A member's value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Value {
    /// f32 or f64, as WGSL has it; so are the vectors of them.
    Float(f64),
    /// u32.
    Uint(u32),
    /// vec2f.
    Vec2(DVec2),
    /// vec3f.
    Vec3(DVec3),
    /// vec4f.
    Vec4(DVec4),
    /// vec2u.
    Uint2([u32; 2]),
    /// vec3u.
    Uint3([u32; 3]),
    /// vec4u.
    Uint4([u32; 4]),
}

/// The members of a WGSL struct, in any order.
pub type Row = Vec<(Cow<'static, str>, Value)>;

/// The rows of a binding: one for a struct, as many as it has elements for an array.
#[derive(Debug, Clone, PartialEq)]
pub struct Binding {
    /// The variable's name in WGSL.
    pub name: Cow<'static, str>,
    /// Its elements.
    pub rows: Vec<Row>,
}

impl Binding {
    /// One struct.
    #[must_use]
    pub fn one(name: &'static str, row: Row) -> Self {
        Self { name: name.into(), rows: vec![row] }
    }

    /// An array of structs.
    #[must_use]
    pub fn list(name: &'static str, rows: Vec<Row>) -> Self {
        Self { name: name.into(), rows }
    }
}

/// `member: Kind(value), …` as a [`Row`].
macro_rules! row {
    ($($member:ident: $kind:ident($value:expr)),* $(,)?) => {
        vec![$((stringify!($member).into(), $crate::model::Value::$kind($value))),*]
    };
}
pub(crate) use row;
