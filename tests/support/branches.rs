//! Finds branches on values that are fixed before a program runs, in naga's form of the program.
//!
//! Every value of a program has an origin: constants (overrides among them), the uniforms of the scene, or computations per
//! ray, pixel or dispatch. The origin of a value is the latest of the origins of its operands. A variable has the origin of
//! the value written to it, if it is written once and at the outermost level of a function, which is how uniforms are copied.
//! A parameter has the origin that all calls agree on, and a result the origin that all returns agree on. Any variable that
//! changes, such as a loop counter, belongs to a ray.
//!
//! Some branches are allowed. A module may branch on a function with a constant result, such as `layers_wanted()` of a module
//! without layers: modules for a choice return a constant, and compilers drop such a branch. A branch may read `frame` and
//! `dispatch`, which tiles and dispatches write. A loop may count up to a number that the scene fixes. Buffers and textures
//! belong to a pass, because other passes write them.

use std::collections::HashMap;

use bentray::program::{LinkedProgram, validated};
use naga::{AddressSpace, Block, Expression, Function, Handle, Module, Statement};

/// The origin of a value.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Default)]
enum Origin {
    /// A constant in the text.
    #[default]
    Constant,
    /// The constant result of a call of a module's function.
    Answer,
    /// The uniforms of the scene.
    Scene,
    /// Any other origin.
    Varying,
}

/// Uniforms that the scene does not fix.
const APART: [&str; 2] = ["frame", "dispatch"];

/// A variable, a parameter, or the result of a function.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
enum Slot {
    Global(usize),
    Local(usize, usize),
    Parameter(usize, usize),
    Result(usize),
}

/// A branch on a value that a scene or a module fixes: its file and its condition.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct Branch {
    pub file: String,
    pub condition: String,
}

/// Returns the fixed branches of a program.
pub fn fixed_branches(linked: &LinkedProgram) -> Vec<Branch> {
    let module = validated(linked).unwrap_or_else(|error| panic!("{error}"));
    let mut analysis = Analysis::of(&module);
    while analysis.pass() {}
    let mut found: Vec<Branch> = analysis.branches().into_iter().map(|span| branch(linked, span)).collect();
    found.sort();
    found.dedup();
    found
}

fn branch(linked: &LinkedProgram, span: naga::Span) -> Branch {
    let range = span.to_range().unwrap_or_default();
    Branch { file: linked.place(range.start).file, condition: without_numbers(&linked.source[range]) }
}

/// Removes the numbers that copies have at the end of their names.
fn without_numbers(condition: &str) -> String {
    let is_word = |c: char| c.is_alphanumeric() || c == '_';
    let words = condition.split_inclusive(|c| !is_word(c)).map(|piece| {
        let end = piece.trim_end_matches(|c| !is_word(c)).len();
        let name = piece[..end].trim_end_matches(|c: char| c.is_ascii_digit());
        let name = name.strip_suffix('_').filter(|_| name.len() < end).unwrap_or(&piece[..end]);
        format!("{name}{}", &piece[end..])
    });
    words.collect()
}

struct Analysis<'a> {
    module: &'a Module,
    /// All functions; entry points follow the others.
    functions: Vec<&'a Function>,
    origins: HashMap<Slot, Origin>,
    /// The number of writes to a variable.
    writes: HashMap<Slot, usize>,
}

impl<'a> Analysis<'a> {
    fn of(module: &'a Module) -> Self {
        let functions = module.functions.iter().map(|(_, function)| function);
        let functions = functions.chain(module.entry_points.iter().map(|entry| &entry.function)).collect();
        let mut analysis = Self { module, functions, origins: HashMap::new(), writes: HashMap::new() };
        for (k, function) in analysis.functions.clone().into_iter().enumerate() {
            for (local, variable) in function.local_variables.iter().filter(|(_, variable)| variable.init.is_some()) {
                analysis.writes.insert(Slot::Local(k, local.index()), usize::from(variable.init.is_some()));
            }
            // The arguments that a device passes to an entry point.
            let handed = if k < module.functions.len() { 0 } else { function.arguments.len() };
            for i in 0..handed {
                analysis.origins.insert(Slot::Parameter(k, i), Origin::Varying);
            }
            analysis.count_writes(k, &function.body, true);
        }
        analysis
    }

    fn count_writes(&mut self, k: usize, block: &Block, is_outermost: bool) {
        for statement in block {
            // A store in a branch or a loop, or through a pointer, can have any of several values.
            match statement {
                Statement::Store { pointer, .. } => self.write(k, *pointer, if is_outermost { 1 } else { 2 }),
                Statement::Atomic { pointer, .. } => self.write(k, *pointer, 2),
                Statement::Call { arguments, .. } => arguments.iter().for_each(|i| self.write(k, *i, 2)),
                _ => {}
            }
            for inner in blocks(statement) {
                self.count_writes(k, inner, is_outermost && matches!(statement, Statement::Block(_)));
            }
        }
    }

    fn write(&mut self, k: usize, pointer: Handle<Expression>, times: usize) {
        if let Some(slot) = self.variable(k, pointer) {
            *self.writes.entry(slot).or_default() += times;
        }
    }

    /// Returns the variable that an expression points into.
    fn variable(&self, k: usize, pointer: Handle<Expression>) -> Option<Slot> {
        match self.functions[k].expressions[pointer] {
            Expression::Access { base, .. } | Expression::AccessIndex { base, .. } => self.variable(k, base),
            Expression::LocalVariable(local) => Some(Slot::Local(k, local.index())),
            Expression::GlobalVariable(global) => Some(Slot::Global(global.index())),
            _ => None,
        }
    }

    /// Raises origins by all that functions write, return and pass to calls; returns `false` if nothing changed.
    fn pass(&mut self) -> bool {
        let mut raised = false;
        for k in 0..self.functions.len() {
            let function = self.functions[k];
            let values = self.values(k);
            let mut found = Vec::new();
            for (local, variable) in function.local_variables.iter() {
                let init = variable.init.map_or(Origin::Constant, |init| values[init.index()]);
                found.push((Slot::Local(k, local.index()), init));
            }
            self.written(k, &function.body, &values, &mut found);
            for (slot, origin) in found {
                let origin =
                    if self.writes.get(&slot).is_some_and(|times| *times > 1) { Origin::Varying } else { origin };
                let known = self.origins.entry(slot).or_default();
                raised |= origin > *known;
                *known = origin.max(*known);
            }
        }
        raised
    }

    fn written(&self, k: usize, block: &Block, values: &[Origin], found: &mut Vec<(Slot, Origin)>) {
        for statement in block {
            match statement {
                Statement::Store { pointer, value } => {
                    found.extend(self.variable(k, *pointer).map(|slot| (slot, values[value.index()])));
                }
                Statement::Return { value: Some(value) } => found.push((Slot::Result(k), values[value.index()])),
                Statement::Call { function, arguments, .. } => {
                    let given = arguments.iter().map(|argument| values[argument.index()]).enumerate();
                    found.extend(given.map(|(i, origin)| (Slot::Parameter(function.index(), i), origin)));
                    let pointed = arguments.iter().filter_map(|argument| self.variable(k, *argument));
                    found.extend(pointed.map(|slot| (slot, Origin::Constant)));
                }
                _ => {}
            }
            for inner in blocks(statement) {
                self.written(k, inner, values, found);
            }
        }
    }

    /// Returns the origins of a function's expressions.
    fn values(&self, k: usize) -> Vec<Origin> {
        let mut values = Vec::new();
        for (_, expression) in self.functions[k].expressions.iter() {
            values.push(self.value(k, expression, &values));
        }
        values
    }

    fn value(&self, k: usize, expression: &Expression, values: &[Origin]) -> Origin {
        let of = |handles: &[Handle<Expression>]| handles.iter().map(|handle| values[handle.index()]).max();
        let slot = |slot: Slot| self.origins.get(&slot).copied().unwrap_or_default();
        let all = match expression {
            Expression::Literal(_) | Expression::Constant(_) | Expression::Override(_) | Expression::ZeroValue(_) => {
                None
            }
            Expression::Compose { components, .. } => of(components),
            Expression::Access { base, index } => of(&[*base, *index]),
            Expression::AccessIndex { base: value, .. }
            | Expression::Splat { value, .. }
            | Expression::Swizzle { vector: value, .. }
            | Expression::Load { pointer: value }
            | Expression::Unary { expr: value, .. }
            | Expression::Relational { argument: value, .. }
            | Expression::As { expr: value, .. } => of(&[*value]),
            Expression::Binary { left, right, .. } => of(&[*left, *right]),
            Expression::Select { condition, accept, reject } => of(&[*condition, *accept, *reject]),
            Expression::Math { arg, arg1, arg2, arg3, .. } => {
                of(&[Some(*arg), *arg1, *arg2, *arg3].into_iter().flatten().collect::<Vec<_>>())
            }
            Expression::FunctionArgument(i) => Some(slot(Slot::Parameter(k, *i as usize))),
            Expression::LocalVariable(local) => Some(slot(Slot::Local(k, local.index()))),
            Expression::GlobalVariable(global) => Some(self.global(*global)),
            Expression::CallResult(function) => Some(slot(Slot::Result(function.index())).max(Origin::Answer)),
            _ => Some(Origin::Varying),
        };
        all.unwrap_or_default()
    }

    fn global(&self, global: Handle<naga::GlobalVariable>) -> Origin {
        let variable = &self.module.global_variables[global];
        match variable.space {
            AddressSpace::Private => self.origins.get(&Slot::Global(global.index())).copied().unwrap_or_default(),
            AddressSpace::Uniform if !APART.contains(&variable.name.as_deref().unwrap_or_default()) => Origin::Scene,
            _ => Origin::Varying,
        }
    }

    /// Returns the conditions that a scene or a constant fixes.
    fn branches(&self) -> Vec<naga::Span> {
        let mut found = Vec::new();
        for (k, function) in self.functions.iter().enumerate() {
            let values = self.values(k);
            let mut asked = Vec::new();
            self.conditions(k, &function.body, &mut asked);
            let fixed = asked
                .into_iter()
                .filter(|condition| matches!(values[condition.index()], Origin::Constant | Origin::Scene));
            found.extend(fixed.map(|condition| function.expressions.get_span(condition)));
        }
        found
    }

    fn conditions(&self, k: usize, block: &Block, asked: &mut Vec<Handle<Expression>>) {
        let function = self.functions[k];
        for statement in block {
            match statement {
                Statement::If { condition, .. } => asked.push(*condition),
                Statement::Switch { selector, .. } => asked.push(*selector),
                Statement::Loop { break_if, .. } => asked.extend(break_if),
                // naga writes `a && b` and `a || b` as branches that set a variable without a name.
                Statement::Store { pointer, value } => {
                    let is_own = matches!(function.expressions[*pointer], Expression::LocalVariable(local)
                        if function.local_variables[local].name.is_none());
                    let is_written_out = matches!(function.expressions[*value], Expression::Literal(_));
                    asked.extend((is_own && !is_written_out).then_some(value));
                }
                _ => {}
            }
            for inner in blocks(statement) {
                self.conditions(k, inner, asked);
            }
        }
    }
}

/// Returns the blocks in a statement.
fn blocks(statement: &Statement) -> Vec<&Block> {
    match statement {
        Statement::Block(block) => vec![block],
        Statement::If { accept, reject, .. } => vec![accept, reject],
        Statement::Switch { cases, .. } => cases.iter().map(|case| &case.body).collect(),
        Statement::Loop { body, continuing, .. } => vec![body, continuing],
        _ => Vec::new(),
    }
}
