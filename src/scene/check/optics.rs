//! What light goes through: the law and the interiors together, for what neither can say alone.

use crate::scene::document::reader::TableReader;
use crate::scene::{
    FlowOrder, Law, Material, MaterialKind, Medium, Object, Precision, SchwarzschildForm, Segment, Substance,
};

/// As much of a scene as decides how its rays can be followed.
pub struct Optics<'a> {
    /// None if it cannot be used.
    pub law: Option<&'a Law>,
    /// Those that can be used.
    pub objects: &'a [Object],
    /// Theirs.
    pub materials: &'a [Material],
}

impl Optics<'_> {
    fn interiors(&self) -> impl Iterator<Item = &Medium> {
        self.objects.iter().filter_map(|object| Some(&object.interior()?.medium))
    }

    fn has_mirror(&self) -> bool {
        let mirror = |material: usize| self.materials.get(material).is_some_and(|m| m.kind == MaterialKind::Mirror);
        self.objects.iter().any(|object| matches!(object.substance, Substance::Opaque(index) if mirror(index)))
    }

    /// Is light bent anywhere?
    pub fn bends(&self) -> bool {
        self.law.is_none_or(|law| *law != Law::Straight) || self.interiors().any(Medium::bends)
    }

    /// Is there a medium that bends light?
    pub fn has_medium(&self) -> bool {
        matches!(self.law, Some(Law::Medium(_))) || self.interiors().any(Medium::bends)
    }

    /// Is there an interior whose paths have no closed form? `ends` where they end at a given τ.
    pub fn has_solved_interior(&self, ends: bool) -> bool {
        self.interiors().any(|medium| !medium.has_closed_form(ends))
    }

    /// Is a method needed besides closed forms?
    pub fn needs_solver(&self, ends: bool) -> bool {
        let law = match self.law {
            Some(Law::Straight) | None => false,
            Some(Law::Medium(medium)) => !medium.has_closed_form(ends),
            Some(_) => true,
        };
        law || self.has_solved_interior(ends)
    }

    /// What does not go with surfaces that rays go on from.
    pub fn check(&self, table: &TableReader, segment: Segment, asymptotic: bool, precision: Precision) {
        let clear = self.interiors().next().is_some();
        if !clear && !self.has_mirror() {
            return;
        }
        if matches!(segment, Segment::Chord { .. }) {
            let problem = "rays that go on from surfaces need arcs: a chord does not end on the path";
            table.fault(&["segment"], problem, "use segment = \"arc\"");
        }
        if asymptotic && clear {
            let problem = "`asymptotic` is for scenes without interiors";
            table.fault(&["asymptotic"], problem, "leave it out");
        }
        if precision == Precision::Half {
            let problem = "16 bits are too few for rays that go on from surfaces";
            table.fault(&["precision"], problem, "use f32 or f64");
        }
        let refused = match self.law {
            Some(Law::Flow { order: FlowOrder::Velocity, .. }) => {
                Some("an orbit of a flow has no direction of its own")
            }
            Some(Law::Sources(_) | Law::Flow { .. }) if clear => Some(
                "an interior needs a law by which light has no speed of its own: straight, schwarzschild or medium",
            ),
            Some(Law::Schwarzschild { form: SchwarzschildForm::Geodesic, .. }) if clear => {
                Some("interiors go with the path form of the schwarzschild law")
            }
            _ => None,
        };
        if let Some(problem) = refused {
            table.fault(&[], problem, "take the interiors and mirrors out of the scene, or change its law");
        }
    }
}
