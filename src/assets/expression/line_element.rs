//! Line elements: ds² as the user writes it, in x, y, z, t and their differentials, with all quantities that light needs.
//!
//! *Theory.* Q(x; U) is the line element with the differentials replaced by dx/dτ and so on. P = ½∂Q/∂U is U with its index lowered,
//! and ∂P/∂U the metric. Up to its parametrization, light follows d(gU) = ½∂ₓQ, so g U′ is ½∂ₓQ minus the change of P along U.
//!
//! *Practice.* Derivatives by the differentials come first, because they
//! do not involve the position; a single derivative by position follows.

use glam::{DMat4, DVec3, DVec4};

use super::spacetime::{ALL, PLACE, Reader, Wrong};
use super::{Field, FormulaError, Graph, Id, Node, Spacetime, Variable, check};

/// The square of the lapse at which rays end by default, 0.03².
const LEAST_LAPSE_2: f64 = 0.0009;

/// A line element and the quantities derived from it.
#[derive(Debug, Clone)]
pub struct LineElement {
    written: Spacetime,
    graph: Graph,
    /// The components xx, xy, xz, yy, yz, zz, xt, yt, zt, tt.
    metric: [Id; 10],
    /// The components x, y, z and t of g U′, up to the parametrization.
    force: [Id; 4],
    scale: Id,
    /// The gradient and the value of a function that is below 0 where rays end.
    gap: Option<[Id; 4]>,
    /// The gradient and the value of the squared lapse, unless the metric changes with t.
    lapse: Option<[Id; 4]>,
}

/// The arguments at which a line element is evaluated.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spot {
    /// The position: x, y and z.
    pub x: DVec3,
    /// The time t.
    pub t: f64,
    /// The side of a throat: 1, or −1 on the far side.
    pub side: f64,
}

impl Spot {
    /// Returns the values of the variables, with the differentials `u`.
    fn values(self, u: DVec4) -> [f64; 9] {
        [self.x.x, self.x.y, self.x.z, u.x, u.y, u.z, u.w, self.t, self.side]
    }
}

/// The indices of g's components among the ten.
const PLACES: [[usize; 4]; 4] = [[0, 1, 2, 6], [1, 3, 4, 7], [2, 4, 5, 8], [6, 7, 8, 9]];

impl LineElement {
    /// Parses a written spacetime.
    ///
    /// # Errors
    ///
    /// The first error, with the text that contains it.
    pub fn parse(written: Spacetime) -> Result<Self, Wrong> {
        let mut reader = Reader::new(written.axes);
        reader.name_all(&written)?;
        let inside = |field: Field| move |error| (field, error);
        let tree = reader.tree(&written.line_element, &ALL).map_err(inside(Field::LineElement))?;
        let scale = reader.tree(&written.scale, &PLACE).map_err(inside(Field::Scale))?;
        let captured = written.captured.as_ref().map(|text| reader.comparison(text)).transpose();
        let captured = captured.map_err(inside(Field::Captured))?;
        let mut graph = reader.graph;
        let q = graph.of_tree(&tree);
        let scale = graph.of_tree(&scale);
        let differentials = Variable::DIFFERENTIALS;
        let half = graph.constant(0.5);
        let lowered = differentials.map(|d| {
            let slope = graph.derivative(q, d);
            graph.product(half, slope)
        });
        let metric = [(0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2), (0, 3), (1, 3), (2, 3), (3, 3)]
            .map(|(i, k): (usize, usize)| graph.derivative(lowered[i], differentials[k]));
        let force = force(&mut graph, q, lowered);
        let timeless = !graph.reached(&[q]).iter().any(|id| graph.node(*id) == Node::Variable(Variable::TIME));
        let lapse = timeless.then(|| lapse_squared(&mut graph, metric));
        let gap = match captured {
            Some(sides) => {
                let [least, most] = sides.map(|side| graph.of_tree(&side));
                Some(graph.difference(least, most))
            }
            None => lapse.filter(|lapse| graph.number(*lapse).is_none()).map(|lapse| {
                let least = graph.constant(LEAST_LAPSE_2);
                graph.difference(lapse, least)
            }),
        };
        let [gap, lapse] = [gap, lapse].map(|value| value.map(|value| with_gradient(&mut graph, value)));
        let found = Self { written, graph, metric, force, scale, gap, lapse };
        found.check_degree(q, lowered)?;
        found.check_numbers()?;
        Ok(found)
    }

    fn wrong(&self, problem: &str, help: &str) -> Wrong {
        let place = 0..self.written.line_element.len();
        (Field::LineElement, FormulaError { place, problem: problem.to_owned(), help: help.to_owned() })
    }

    /// Checks that every term contains two differentials.
    fn check_degree(&self, q: Id, lowered: [Id; 4]) -> Result<(), Wrong> {
        let curved = self.graph.reached(&self.metric);
        let is_differential =
            |id: &Id| Variable::DIFFERENTIALS.iter().any(|d| self.graph.node(*id) == Node::Variable(*d));
        let mut left = curved.iter().any(is_differential);
        for place in [[1.3, -0.7, 2.1], [-4.2, 3.1, 0.9], [11.0, 7.0, -13.0]] {
            let [x, y, z] = place;
            let spot = Spot { x: DVec3::new(x, y, z), t: 0.37, side: 1.0 };
            let values = self.graph.evaluate(&spot.values(DVec4::ZERO));
            left |= lowered.iter().chain([&q]).any(|id| values[id.index()].abs() > 0.0);
        }
        let help = "for example -dt^2 + dx^2 + dy^2 + dz^2";
        if left { Err(self.wrong("each term of a line element requires two differentials", help)) } else { Ok(()) }
    }

    fn check_numbers(&self) -> Result<(), Wrong> {
        let all: Vec<Id> = self.metric.iter().chain(&self.force).copied().collect();
        let inside = |field: Field| move |error| (field, error);
        check(&self.written.line_element, &self.graph, &all).map_err(inside(Field::LineElement))?;
        check(&self.written.scale, &self.graph, &[self.scale]).map_err(inside(Field::Scale))?;
        let captured = self.written.captured.as_deref().unwrap_or_default();
        let gap = self.gap.map_or_else(Vec::new, |gap| gap.to_vec());
        check(captured, &self.graph, &gap).map_err(inside(Field::Captured))?;
        if self.depends_on(&gap, Variable::TIME) {
            let problem = "the capture condition cannot depend on t".to_owned();
            return Err((Field::Captured, FormulaError { place: 0..captured.len(), problem, help: String::new() }));
        }
        Ok(())
    }

    fn depends_on(&self, roots: &[Id], variable: Variable) -> bool {
        self.graph.reached(roots).iter().any(|id| self.graph.node(*id) == Node::Variable(variable))
    }

    /// Returns the spacetime as written.
    #[must_use]
    pub fn written(&self) -> &Spacetime {
        &self.written
    }

    /// Returns `true` if the metric or the scale changes with t.
    #[must_use]
    pub fn depends_on_time(&self) -> bool {
        let all: Vec<Id> = self.metric.iter().chain([&self.scale]).copied().collect();
        self.depends_on(&all, Variable::TIME)
    }

    /// Returns `true` if the spacetime is static, that is invariant under time reversal.
    #[must_use]
    pub fn is_static(&self) -> bool {
        let shift = &self.metric[6..9];
        !self.depends_on_time() && shift.iter().all(|id| self.graph.number(*id) == Some(0.0))
    }

    /// Returns g at a position and a time, with the spatial components before the time component.
    #[must_use]
    pub fn metric(&self, spot: Spot) -> DMat4 {
        let values = self.graph.evaluate(&spot.values(DVec4::NAN));
        DMat4::from_cols_array_2d(&PLACES.map(|row| row.map(|k| values[self.metric[k].index()])))
    }

    /// Returns the characteristic length scale at a position and a time.
    #[must_use]
    pub fn scale(&self, spot: Spot) -> f64 {
        self.graph.evaluate(&spot.values(DVec4::NAN))[self.scale.index()].abs()
    }

    /// Returns g U′ at a position, up to the parametrization.
    #[must_use]
    pub fn force(&self, spot: Spot, u: DVec4) -> DVec4 {
        let values = self.graph.evaluate(&spot.values(u));
        DVec4::from_array(self.force.map(|id| values[id.index()]))
    }

    /// Returns the gradient and the value of the function that is below 0 where rays end.
    #[must_use]
    pub fn gap(&self, spot: Spot) -> Option<DVec4> {
        let values = self.graph.evaluate(&spot.values(DVec4::NAN));
        Some(DVec4::from_array(self.gap?.map(|id| values[id.index()])))
    }

    /// Returns the graph, and its nodes of the metric, the force, the scale and the function that is below 0 where rays end.
    #[must_use]
    pub fn graph(&self) -> (&Graph, [Id; 10], [Id; 4], Id, Option<[Id; 4]>) {
        (&self.graph, self.metric, self.force, self.scale, self.gap)
    }

    /// Returns the nodes of the gradient and of the value of the squared lapse, unless the metric changes with t.
    #[must_use]
    pub fn lapse(&self) -> Option<[Id; 4]> {
        self.lapse
    }
}

/// Line elements are equal if their texts are.
impl PartialEq for LineElement {
    fn eq(&self, other: &Self) -> bool {
        self.written == other.written
    }
}

/// Returns ½∂ₓQ minus the change of P along U.
fn force(graph: &mut Graph, q: Id, lowered: [Id; 4]) -> [Id; 4] {
    let half = graph.constant(0.5);
    let rates = Variable::DIFFERENTIALS.map(|d| graph.make(Node::Variable(d)));
    let [x, y, z] = Variable::PLACE;
    let axes = [x, y, z, Variable::TIME];
    [0, 1, 2, 3].map(|k: usize| {
        let slope = graph.derivative(q, axes[k]);
        let own = graph.product(half, slope);
        let change = graph.rate(lowered[k], rates);
        graph.difference(own, change)
    })
}

/// Returns the derivatives of a value by x, y and z, and the value.
fn with_gradient(graph: &mut Graph, value: Id) -> [Id; 4] {
    let [x, y, z] = Variable::PLACE.map(|axis| graph.derivative(value, axis));
    [x, y, z, value]
}

/// Returns α² = −det g/det γ.
fn lapse_squared(graph: &mut Graph, metric: [Id; 10]) -> Id {
    let [above, below] = [4, 3].map(|size| determinant(graph, metric, &(0..size).collect::<Vec<_>>(), 0));
    let ratio = graph.quotient(above, below);
    graph.negative(ratio)
}

/// Returns the determinant of the rows from `row` on, and of these columns.
fn determinant(graph: &mut Graph, metric: [Id; 10], columns: &[usize], row: usize) -> Id {
    if columns.is_empty() {
        return graph.constant(1.0);
    }
    let mut sum = graph.constant(0.0);
    for (k, column) in columns.iter().enumerate() {
        let own = metric[PLACES[row][*column]];
        let others: Vec<usize> = columns.iter().copied().filter(|other| other != column).collect();
        let rest = determinant(graph, metric, &others, row + 1);
        let product = graph.product(own, rest);
        sum = if k % 2 == 0 { graph.sum(sum, product) } else { graph.difference(sum, product) };
    }
    sum
}
