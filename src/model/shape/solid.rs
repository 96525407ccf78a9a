//! Solids: shapes as the shaders test them, and what they are told of each.

use std::fmt;

use glam::{DVec3, DVec4};

use super::Shape;
use crate::assets::Transform;
use crate::model::{Row, Value, row};

/// What is known of a solid.
pub struct Solid {
    /// The name of its WGSL part in `shaders/shape/`, in those of its functions, and in capitals of its code.
    pub name: &'static str,
    /// Its lists in WGSL; none for triangles, which lie in a structure always.
    pub lists: Option<Lists>,
}

/// The lists of a solid in WGSL, and their rows.
pub struct Lists {
    /// All of them, with what is asked for at a hit.
    pub placed: &'static str,
    /// What a test needs.
    pub row: fn(&Placed) -> Row,
    /// Does it lie in y = 0 of its own space?
    pub flat: bool,
}

impl Solid {
    /// Returns a solid that has lists, by the name of that of all of them.
    pub(super) const fn listed(name: &'static str, placed: &'static str, row: fn(&Placed) -> Row, flat: bool) -> Self {
        Self { name, lists: Some(Lists { placed, row, flat }) }
    }

    /// Returns the name of the list of those on which rays end.
    #[must_use]
    pub fn opaque_list(&self) -> String {
        format!("{}_list", self.name)
    }

    /// Returns the name of the list of those with a side that rays can be on.
    #[must_use]
    pub fn sided_list(&self) -> String {
        format!("sided_{}_list", self.name)
    }
}

/// A shape in its place.
#[derive(Debug, Clone, Copy)]
pub struct Placed {
    /// Its centre.
    pub center: DVec3,
    /// For spheres the radius, for disks the hole's, in own units.
    pub number: f64,
    /// Rows of the affine map from the scene's space to the shape's own.
    pub rows: [DVec4; 3],
}

impl Placed {
    /// A shape in a place.
    #[must_use]
    pub fn new(shape: &dyn Shape, place: &Transform) -> Self {
        let inverse = place.0.inverse();
        let m = inverse.matrix3.transpose();
        let t = inverse.translation;
        let rows = [m.x_axis.extend(t.x), m.y_axis.extend(t.y), m.z_axis.extend(t.z)];
        Self { center: place.0.translation, number: shape.number(place), rows }
    }

    /// Centre and radius.
    pub(super) fn ball(&self) -> Row {
        row! { center: Vec3(self.center), radius: Float(self.number) }
    }

    /// The map to its own space.
    #[must_use]
    pub fn space(&self) -> Row {
        let [x, y, z] = self.rows;
        row! { row_x: Vec4(x), row_y: Vec4(y), row_z: Vec4(z) }
    }

    /// The map, and its number as this member.
    pub(super) fn space_and(&self, member: &'static str) -> Row {
        self.space().into_iter().chain([(member.into(), Value::Float(self.number))]).collect()
    }
}

impl PartialEq for Solid {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}

impl Eq for Solid {}

impl fmt::Debug for Solid {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name)
    }
}
