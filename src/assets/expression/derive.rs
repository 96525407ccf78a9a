//! Derivatives of a graph's nodes, as nodes of the same graph.

use super::Function;
use super::graph::{Graph, Id, Node};
use super::variable::Variable;

/// The variables that change.
#[derive(Debug, Clone, Copy)]
enum Change {
    /// A single variable.
    Of(Variable),
    /// x, y, z and t, at these rates.
    Along([Id; 4]),
}

impl Graph {
    /// Returns ∂a/∂axis. At a kink of a, such as |x| at 0, it is the derivative of one side or between the two.
    pub(super) fn derivative(&mut self, a: Id, axis: Variable) -> Id {
        self.change(a, Change::Of(axis))
    }

    /// Returns the rate of change of a if x, y, z and t change at these rates.
    pub(super) fn rate(&mut self, a: Id, rates: [Id; 4]) -> Id {
        self.change(a, Change::Along(rates))
    }

    fn change(&mut self, a: Id, change: Change) -> Id {
        // Operands come before the nodes that use them, so a single upward pass suffices.
        let mut known: Vec<Option<Id>> = vec![None; a.index() + 1];
        for id in self.reached(&[a]) {
            let derivative = self.derivative_of(id, change, &|part| known[part.index()].unwrap_or(part));
            known[id.index()] = Some(derivative);
        }
        known[a.index()].unwrap_or(a)
    }

    /// Returns the derivative of a node, given the derivatives of its operands by `of`.
    fn derivative_of(&mut self, id: Id, change: Change, of: &dyn Fn(Id) -> Id) -> Id {
        match self.node(id) {
            // Functions of position need only first derivatives, which contain the direction of r and are not derived again.
            Node::Number(_) | Node::Direction(_) => self.constant(0.0),
            Node::ProgramOptions([a, b, c, d]) => self.choice(a, b, of(c), of(d)),
            Node::Variable(own) => self.rate_of(own, change),
            Node::Square => {
                let (two, half) = (self.constant(2.0), self.half_of_square(change));
                self.product(two, half)
            }
            Node::Distance => match change {
                Change::Of(axis) if Variable::PLACE.contains(&axis) => self.make(Node::Direction(axis)),
                _ => {
                    let half = self.half_of_square(change);
                    self.quotient(half, id)
                }
            },
            Node::Sum(a, b) => self.sum(of(a), of(b)),
            Node::Difference(a, b) => self.difference(of(a), of(b)),
            Node::Product(a, b) => {
                let left = self.product(of(a), b);
                let right = self.product(a, of(b));
                self.sum(left, right)
            }
            Node::Quotient(a, b) => {
                // (a′ − (a/b) b′)/b
                let change = self.product(id, of(b));
                let above = self.difference(of(a), change);
                self.quotient(above, b)
            }
            Node::Negative(a) => self.negative(of(a)),
            Node::Power(a, k) => self.derivative_of_power(a, k, change, of),
            Node::Call(function, a) => {
                let zero = self.number(of(a)) == Some(0.0);
                if zero { of(a) } else { self.derivative_of_call(function, id, a, of(a)) }
            }
            Node::Min(a, b) => self.choice(a, b, of(a), of(b)),
            Node::Max(a, b) => self.choice(b, a, of(a), of(b)),
        }
    }

    /// Returns the rate of change of a variable.
    fn rate_of(&mut self, own: Variable, change: Change) -> Id {
        match change {
            Change::Of(axis) => self.constant(f64::from(u8::from(own == axis))),
            Change::Along([x, y, z, t]) => {
                let rates = Variable::PLACE.into_iter().chain([Variable::TIME]).zip([x, y, z, t]);
                let rate = rates.into_iter().find(|(variable, _)| *variable == own);
                rate.map_or_else(|| self.constant(0.0), |(_, rate)| rate)
            }
        }
    }

    /// Returns x·x′, half of the derivative of r².
    fn half_of_square(&mut self, change: Change) -> Id {
        match change {
            Change::Of(axis) if Variable::PLACE.contains(&axis) => self.make(Node::Variable(axis)),
            Change::Of(_) => self.constant(0.0),
            Change::Along(rates) => {
                let mut sum = self.constant(0.0);
                for (axis, rate) in Variable::PLACE.into_iter().zip(rates) {
                    let own = self.make(Node::Variable(axis));
                    let product = self.product(own, rate);
                    sum = self.sum(sum, product);
                }
                sum
            }
        }
    }

    fn choice(&mut self, a: Id, b: Id, c: Id, d: Id) -> Id {
        if c == d { c } else { self.make(Node::ProgramOptions([a, b, c, d])) }
    }

    /// Returns k aᵏ⁻¹ a′; for rᵏ it is k rᵏ⁻² x, without a division by r for k ≥ 2.
    fn derivative_of_power(&mut self, a: Id, k: i32, change: Change, of: &dyn Fn(Id) -> Id) -> Id {
        let factor = self.constant(f64::from(k));
        let (less, inner) = match self.node(a) {
            Node::Distance => (self.power(a, k - 2), self.half_of_square(change)),
            _ => (self.power(a, k - 1), of(a)),
        };
        let product = self.product(less, inner);
        self.product(factor, product)
    }

    /// Returns the derivative of the call `id`, which is f(a); `inner` is a′.
    fn derivative_of_call(&mut self, function: Function, id: Id, a: Id, inner: Id) -> Id {
        let one = self.constant(1.0);
        let outer = match function {
            Function::Sqrt => {
                let two = self.constant(2.0);
                let below = self.product(two, id);
                return self.quotient(inner, below);
            }
            Function::Log => return self.quotient(inner, a),
            Function::Atan => {
                let square = self.product(a, a);
                let below = self.sum(one, square);
                return self.quotient(inner, below);
            }
            Function::Exp => id,
            Function::Sin => self.call(Function::Cos, a),
            Function::Cos => {
                let sine = self.call(Function::Sin, a);
                self.negative(sine)
            }
            Function::Tan => {
                let square = self.product(id, id);
                self.sum(one, square)
            }
            Function::Sinh => self.call(Function::Cosh, a),
            Function::Cosh => self.call(Function::Sinh, a),
            Function::Tanh => {
                let square = self.product(id, id);
                self.difference(one, square)
            }
            // If there is no derivative, the result is 0/0, which is not a number.
            Function::Abs if self.is_strict() => self.quotient(a, id),
            Function::Abs => self.call(Function::Sign, a),
            Function::Sign => self.constant(0.0),
        };
        self.product(outer, inner)
    }
}
