//! A custom law in WGSL: a scene specifies the file, its parameters, and the variables of the derivative.
//!
//! *Practice.* The file implements the contract of the built-in laws in `shaders/law/`, as far as `depends` requires:
//!
//! | `depends` | required function |
//! |---|---|
//! | `"place"` | `fn law_acceleration(x: Real3, held: Real) -> Real3`, and `law_ray_constant` if each ray stores a constant |
//! | `"velocity"` | `fn law_acceleration_by_velocity(x: Real3, v: Real3) -> Real3`: the acceleration by position and velocity |
//! | `"time"` | `fn law_acceleration_by_time(x: Real3, v: Real3, tau: Real) -> Real3`: the acceleration by position, velocity and τ from the ray's start |
//! | `"flow"` | `fn flow_field(x: Real3) -> Real3`: the velocity of a first-order law |
//!
//! The file may also define `law_start`, `law_projected` and `law_scale` (`flow_time` for a flow), and otherwise uses the defaults.
//! Parameters are members of `law`: a number is a `Real`, an array of 2 to 4 numbers a vector. Other names are private to the file. Loops
//! are `for` loops with a constant number of iterations, and there are no bindings.

use std::fmt::Write as _;
use std::sync::Arc;

use glam::{DVec2, DVec3, DVec4};

use super::sources::OWN_SPEED;
use super::{CharacteristicSurface, Kind, Law, LawProperties, Order, UsualSteps};
use crate::assets::Files;
use crate::document::reader::TableReader;
use crate::document::values::{Parsed, array, length, number, positive_length, text, word};
use crate::document::{Node, Value as Written, keys};
use crate::model::{Anchor, Binding, Capture, Promise, Row, UserWgsl, Value, Wgsl, row};

/// The description of this law.
pub static KIND: Kind = Kind {
    name: "wgsl",
    keys: keys! {
        file: "file" = "none", "WGSL file of the law";
        code: "text" = "none", "WGSL of the law, instead of a file";
        depends: "place | velocity | time | flow" = "place",
            "variables of the acceleration, which determine the functions of the file; flow for a first-order law, \
             which defines the velocity";
        scale: "number above 0" = "1",
            "length scale of the law, in scene units (time scale of a flow); steps are a fraction of it, unless the file defines law_scale";
        capture_spheres: "[[x, y, z, radius], ...]" = "[]", "spheres that capture inward rays, in scene units";
        parameters: "table of numbers, and of arrays of 2 to 4" = "{}", "members of `law` in the WGSL file";
    },
    read: |table, files| {
        let depends = &[
            ("place", Depends::Place),
            ("velocity", Depends::Velocity),
            ("time", Depends::Time),
            ("flow", Depends::Flow),
        ];
        let file = source(table, files);
        let depends = table.or("depends", Depends::Place, word(depends));
        let scale = table.or("scale", 1.0, positive_length);
        let captures = captures(table);
        let parameters = parameters(table, file.as_ref().map(|(_, text)| &**text));
        let (file, text) = file?;
        Some(Arc::new(CustomLaw { file, text, depends, scale, captures: captures?, parameters: parameters? }))
    },
};

/// Returns the name and the text of the law's WGSL.
fn source(table: &TableReader, files: &mut Files) -> Option<(String, Arc<str>)> {
    match (table.node("file"), table.node("code")) {
        (Some(_), Some(_)) => {
            table.fault(&["code"], "a law has either a file or code", "remove one of the two");
            None
        }
        (_, Some(node)) => Some(("law.code".to_owned(), table.reader.accept(text(node))?.into())),
        (None, None) => {
            table.required_node("file", "\"law.wgsl\"");
            None
        }
        (Some(node), None) => files.text(table.reader, node),
    }
}

/// Reads the capture spheres; all are read before the first error returns.
fn captures(table: &TableReader) -> Option<Vec<Capture>> {
    let Some(node) = table.node("capture_spheres") else { return Some(Vec::new()) };
    let Written::Array(items) = &node.value else {
        table.reader.fault(node.expected("spheres, [[x, y, z, radius], ...]"));
        return None;
    };
    let capture = |node: &Node| {
        let [x, y, z, radius] = array("a sphere, [x, y, z, radius]", length)(node)?;
        let sphere = Capture { anchor: Anchor::center(DVec3::new(x, y, z)), radius };
        if radius > 0.0 { Ok(sphere) } else { Err(node.fault("the radius must be above 0", "")) }
    };
    let all: Vec<Option<Capture>> = items.iter().map(|node| table.reader.accept(capture(node))).collect();
    all.into_iter().collect()
}

/// Reads the parameters; all are read before the first error returns.
fn parameters(table: &TableReader, text: Option<&str>) -> Option<Vec<(String, Value)>> {
    let Some(own) = table.node("parameters") else { return Some(Vec::new()) };
    let own = table.reader.open("law.parameters", own)?;
    let read = |(name, node): (&str, &Node)| {
        let used = || is_used(name, node, text);
        let value = own.reader.accept(is_name(name, node).and_then(|()| used()).and_then(|()| parameter(node)))?;
        Some((name.to_owned(), value))
    };
    let all: Vec<Option<_>> = own.entries().map(read).collect();
    all.into_iter().collect()
}

fn is_name(name: &str, node: &Node) -> Parsed<()> {
    let fits = name.starts_with(|c: char| c.is_ascii_alphabetic())
        && name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
        && !name.contains("__");
    let problem = || format!("`{name}` is not a valid WGSL name");
    if fits {
        Ok(())
    } else {
        Err(node.fault(problem(), "use letters, digits and single underscores, and begin with a letter"))
    }
}

/// Checks that the file uses the parameter; otherwise, one of the two is misspelled.
fn is_used(name: &str, node: &Node, text: Option<&str>) -> Parsed<()> {
    let mut words = text.into_iter().flat_map(|text| text.split(|c: char| !c.is_ascii_alphanumeric() && c != '_'));
    if text.is_none() || words.any(|word| word == name) {
        return Ok(());
    }
    Err(node.fault(
        format!("the WGSL file of the law does not use `{name}`"),
        format!("use law.{name} there, or remove this parameter"),
    ))
}

fn parameter(node: &Node) -> Parsed<Value> {
    let Written::Array(items) = &node.value else { return number(node).map(Value::Float) };
    match *items.iter().map(number).collect::<Parsed<Vec<f64>>>()? {
        [x, y] => Ok(Value::Vec2(DVec2::new(x, y))),
        [x, y, z] => Ok(Value::Vec3(DVec3::new(x, y, z))),
        [x, y, z, w] => Ok(Value::Vec4(DVec4::new(x, y, z, w))),
        _ => Err(node.expected("a number, or an array of 2 to 4 numbers")),
    }
}

/// The variables on which the derivative of a custom law depends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Depends {
    /// Second order with dependence on position alone.
    Place,
    /// Second order with dependence on position and velocity.
    Velocity,
    /// Second order with dependence on position, velocity and τ.
    Time,
    /// First order.
    Flow,
}

/// A custom law from a file.
#[derive(Debug, Clone, PartialEq)]
pub struct CustomLaw {
    /// The name of the file in error messages.
    pub file: String,
    /// The WGSL code.
    pub text: Arc<str>,
    /// The variables on which the derivative depends.
    pub depends: Depends,
    /// The length over which the law changes, in scene units; for a flow, the time.
    pub scale: f64,
    /// The regions in which rays that move inwards end.
    pub captures: Vec<Capture>,
    /// The members of `law`.
    pub parameters: Vec<(String, Value)>,
}

impl CustomLaw {
    /// Returns the functions that the file must or may define.
    fn promises(&self) -> Vec<Promise> {
        let all = [
            Promise::usual("fn law_start(x: Real3, v: Real3) -> Phase", "law/start_as_given"),
            Promise::usual("fn law_projected(p: Phase) -> Phase", "law/projected_as_is"),
            Promise::usual("fn law_scale(p: Phase) -> Real", "law/scale_given"),
        ];
        let own = match self.depends {
            Depends::Place => vec![
                Promise::required("fn law_acceleration(x: Real3, held: Real) -> Real3"),
                Promise::usual("fn law_ray_constant(p: Phase) -> Real", "law/no_constant"),
            ],
            Depends::Velocity => {
                vec![Promise::required("fn law_acceleration_by_velocity(x: Real3, v: Real3) -> Real3")]
            }
            Depends::Time => {
                let required = Promise::required("fn law_acceleration_by_time(x: Real3, v: Real3, tau: Real) -> Real3");
                return vec![required, all[1].clone(), all[2].clone()];
            }
            Depends::Flow => {
                let time = Promise::usual("fn flow_time() -> Real", "law/time_given");
                return vec![Promise::required("fn flow_field(x: Real3) -> Real3"), time];
            }
        };
        own.into_iter().chain(all).collect()
    }

    /// Returns the WGSL declarations of the uniforms for parameters and scale.
    fn declared(&self) -> String {
        let mut text = String::from("struct LawScale {\n    scale: Real,\n}\n\nvar<uniform> own_scale: LawScale;\n");
        if !self.parameters.is_empty() {
            text += "\nstruct Law {\n";
            for (name, value) in &self.parameters {
                let ty = match value {
                    Value::Vec2(_) => "Real2",
                    Value::Vec3(_) => "Real3",
                    Value::Vec4(_) => "Real4",
                    _ => "Real",
                };
                // Writing to a String cannot fail.
                let _ = writeln!(text, "    {name}: {ty},");
            }
            text += "}\n\nvar<uniform> law: Law;\n";
        }
        text
    }
}

impl Law for CustomLaw {
    fn parts(&self) -> Vec<Wgsl> {
        let shared: &[&'static str] = match self.depends {
            Depends::Place => &["law/accelerated"],
            Depends::Velocity => &["law/by_velocity"],
            Depends::Time => &["law/by_time", "law/start_as_given"],
            Depends::Flow => &["law/flow"],
        };
        let declared = Wgsl::Text { file: "generated/law.wgsl".into(), text: self.declared().into() };
        let own = UserWgsl { file: self.file.clone(), text: Arc::clone(&self.text), promises: self.promises() };
        Wgsl::parts(shared).into_iter().chain([declared, Wgsl::Own(own)]).collect()
    }

    fn values(&self) -> Vec<Binding> {
        let scale = Binding::one("own_scale", row! { scale: Float(self.scale) });
        let parameters: Row = self.parameters.iter().map(|(name, value)| (name.clone().into(), *value)).collect();
        let law = (!parameters.is_empty()).then(|| Binding::one("law", parameters));
        [scale].into_iter().chain(law).collect()
    }

    /// The steps are scaled, because the author specifies the scale over which the law changes.
    fn facts(&self) -> LawProperties<'_> {
        let time = "a law that depends on τ would restart at τ = 0 at each surface";
        let by = |order| LawProperties { order, refuses_interiors: Some(OWN_SPEED), ..LawProperties::default() };
        let facts = match self.depends {
            Depends::Place => by(Order::Place),
            Depends::Velocity => by(Order::General),
            Depends::Time => LawProperties { carries_time: true, refuses_surfaces: Some(time), ..by(Order::General) },
            Depends::Flow => LawProperties::flow(),
        };
        LawProperties { usual_steps: UsualSteps::Scaled, ..facts }
    }

    fn captures(&self, _: Option<&dyn Fn(DVec3) -> f64>) -> Vec<Capture> {
        self.captures.clone()
    }

    fn landmarks(&self) -> Vec<CharacteristicSurface> {
        let sphere =
            |capture: &Capture| CharacteristicSurface::sphere("capture", capture.anchor.position, capture.radius, true);
        self.captures.iter().map(sphere).collect()
    }
}
