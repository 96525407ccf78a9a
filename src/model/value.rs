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
    pub fn list(name: impl Into<Cow<'static, str>>, rows: Vec<Row>) -> Self {
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

/// The numbers of a kind, each stated once: `field: Type as Value = reading,` is a field of the struct, how it is read as an `Option`, and
/// the member of its name in WGSL; without `as Value` there is no such member. All are read before any is missed.
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
