//! Solids: the forms of shapes that shaders test, with their data.

use std::fmt;

use glam::{DVec3, DVec4};

use super::Shape;
use crate::assets::Transform;
use crate::model::{Row, Value, row};

/// The description of a solid.
pub struct Primitive {
    /// The name of the WGSL module in `shaders/shape/`, which is also in its functions and, in capitals, in its code.
    pub name: &'static str,
    /// The lists in WGSL; `None` for triangles, which are always in an acceleration structure.
    pub lists: Option<Lists>,
}

/// The lists of a solid in WGSL and their rows.
pub struct Lists {
    /// The name of the list of all solids of this kind, with the data of a hit.
    pub placed: &'static str,
    /// The data of an intersection test.
    pub row: fn(&Placed) -> Row,
    /// Is `true` if the solid is in the plane y = 0 of object space.
    pub flat: bool,
}

impl Primitive {
    /// Creates a solid with lists; `placed` is the name of the list of all solids of this kind.
    pub(super) const fn listed(name: &'static str, placed: &'static str, row: fn(&Placed) -> Row, flat: bool) -> Self {
        Self { name, lists: Some(Lists { placed, row, flat }) }
    }

    /// Returns the name of the list of solids on which rays end.
    #[must_use]
    pub fn opaque_list(&self) -> String {
        format!("{}_list", self.name)
    }

    /// Returns the name of the list of solids whose side rays track.
    #[must_use]
    pub fn sided_list(&self) -> String {
        format!("sided_{}_list", self.name)
    }
}

/// A placed shape.
#[derive(Debug, Clone, Copy)]
pub struct Placed {
    /// The center.
    pub center: DVec3,
    /// The radius of a sphere, or the inner radius of a disk in object units.
    pub number: f64,
    /// The rows of the affine map from the scene to object space.
    pub rows: [DVec4; 3],
}

impl Placed {
    /// Creates a placed shape.
    #[must_use]
    pub fn new(shape: &dyn Shape, place: &Transform) -> Self {
        let inverse = place.0.inverse();
        let m = inverse.matrix3.transpose();
        let t = inverse.translation;
        let rows = [m.x_axis.extend(t.x), m.y_axis.extend(t.y), m.z_axis.extend(t.z)];
        Self { center: place.0.translation, number: shape.number(place), rows }
    }

    /// Returns the center and radius.
    pub(super) fn ball(&self) -> Row {
        row! { center: Vec3(self.center), radius: Float(self.number) }
    }

    /// Returns the map to object space.
    #[must_use]
    pub fn space(&self) -> Row {
        let [x, y, z] = self.rows;
        row! { row_x: Vec4(x), row_y: Vec4(y), row_z: Vec4(z) }
    }

    /// Returns the map, and the number as this member.
    pub(super) fn space_and(&self, member: &'static str) -> Row {
        self.space().into_iter().chain([(member.into(), Value::Float(self.number))]).collect()
    }
}

impl PartialEq for Primitive {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}

impl Eq for Primitive {}

impl fmt::Debug for Primitive {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name)
    }
}
