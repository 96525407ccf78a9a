//! Host values with the names of WGSL members, which kinds pass to their shaders.

use std::borrow::Cow;

use glam::{DVec2, DVec3, DVec4};

/// The value of a member.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Value {
    /// An f32 or f64, as declared in WGSL; this also applies to vectors of floats.
    Float(f64),
    /// A u32.
    Uint(u32),
    /// A vec2f.
    Vec2(DVec2),
    /// A vec3f.
    Vec3(DVec3),
    /// A vec4f.
    Vec4(DVec4),
    /// A vec2u.
    Uint2([u32; 2]),
    /// A vec3u.
    Uint3([u32; 3]),
    /// A vec4u.
    Uint4([u32; 4]),
}

/// The members of a WGSL struct, in any order.
pub type Row = Vec<(Cow<'static, str>, Value)>;

/// The rows of a binding: one for a struct, one per element for an array.
#[derive(Debug, Clone, PartialEq)]
pub struct Binding {
    /// The name of the variable in WGSL.
    pub name: Cow<'static, str>,
    /// The elements.
    pub rows: Vec<Row>,
}

impl Binding {
    /// Creates a binding of one struct.
    #[must_use]
    pub fn one(name: &'static str, row: Row) -> Self {
        Self { name: name.into(), rows: vec![row] }
    }

    /// Creates a binding of an array of structs.
    #[must_use]
    pub fn list(name: impl Into<Cow<'static, str>>, rows: Vec<Row>) -> Self {
        Self { name: name.into(), rows }
    }
}

/// Writes `member: Kind(value), …` as a [`Row`].
macro_rules! row {
    ($($member:ident: $kind:ident($value:expr)),* $(,)?) => {
        vec![$((stringify!($member).into(), $crate::model::Value::$kind($value))),*]
    };
}
pub(crate) use row;

/// Declares the parameters of a kind, each once: `field: Type as Value = reading,` declares a field of the struct, reads it as an `Option`,
/// and passes it to WGSL as a member of this name unless `as Value` is missing. All are read before the first error returns.
macro_rules! fields {
    ($(#[$meta:meta])* $kind:ident($($given:ident: $given_type:ty),*) {
        $($(#[$doc:meta])* $field:ident: $type:ty $(as $value:ident)? = $read:expr,)*
    }) => {
        $(#[$meta])*
        #[derive(Debug, Clone, PartialEq)]
        pub struct $kind {
            $($(#[$doc])* pub $field: $type,)*
        }

        impl $kind {
            pub(super) fn read($($given: $given_type),*) -> Option<Self> {
                $(let $field: Option<$type> = $read;)*
                Some(Self { $($field: $field?),* })
            }

            fn row(&self) -> $crate::model::Row {
                vec![$($((stringify!($field).into(), $crate::model::Value::$value(self.$field)),)?)*]
            }
        }
    };
}
pub(crate) use fields;
