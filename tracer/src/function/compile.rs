//! From a body's tree to steps over numbered values: constants are worked out, equal parts computed once, called
//! functions worked in.

use std::collections::HashMap;
use std::sync::Arc;

use super::callee::Callee;
use super::operators::{Binary, Unary};
use super::program::{Site, Step};
use super::registers;
use super::Program;
use crate::graph::function::{Accumulate, AccumulateKind, Call, Expression, Operation};
use crate::texture::Builder;

/// The number of a value while compiling.
pub type Value = u32;

/// Functions are worked into their callers up to this many steps; then they are called.
const MOST_INLINED: usize = 3000;

/// What makes two steps equal.
#[derive(Clone, PartialEq, Eq, Hash)]
enum Key {
    Unary(Unary, Value),
    Binary(Binary, Value, Value),
    Call(usize, Box<[Value]>),
}

/// A program in the making.
pub struct Compiler<'a> {
    builder: &'a mut Builder,
    pub(super) steps: Vec<Step<Value>>,
    pub(super) sites: Vec<Site<Value>>,
    /// The constants among the values: the first after the arguments.
    pub(super) constants: Vec<(Value, f64)>,
    constant_index: HashMap<u64, Value>,
    known: HashMap<Key, Value>,
    pub(super) arguments: usize,
    pub(super) values: Value,
}

impl<'a> Compiler<'a> {
    /// For a function of so many arguments, which are the first values.
    pub fn new(builder: &'a mut Builder, arguments: usize) -> Compiler<'a> {
        Compiler {
            builder,
            steps: Vec::new(),
            sites: Vec::new(),
            constants: Vec::new(),
            constant_index: HashMap::new(),
            known: HashMap::new(),
            arguments,
            values: arguments as Value,
        }
    }

    /// The whole program; None where it is too large.
    pub fn program(mut self, body: &Expression) -> Option<Program> {
        let scope: Vec<Value> = (0..self.arguments as Value).collect();
        let result = self.expression(body, &scope);
        registers::assign(self, result)
    }

    fn value(&mut self) -> Value {
        self.values += 1;
        self.values - 1
    }

    fn constant(&mut self, number: f64) -> Value {
        if let Some(&known) = self.constant_index.get(&number.to_bits()) {
            return known;
        }
        let value = self.value();
        self.constant_index.insert(number.to_bits(), value);
        self.constants.push((value, number));
        value
    }

    fn number(&self, value: Value) -> Option<f64> {
        self.constants.binary_search_by_key(&value, |c| c.0).ok().map(|i| self.constants[i].1)
    }

    /// The value of a piece of the body, whose parameters have the values of `scope`.
    fn expression(&mut self, node: &Expression, scope: &[Value]) -> Value {
        match node {
            Expression::Constant(constant) => self.constant(constant.value),
            Expression::Parameter(parameter) => match scope.get(parameter.index) {
                Some(&value) => value,
                None => self.constant(0.0),
            },
            Expression::Operation(operation) => self.operation(operation, scope),
            Expression::Call(call) => self.call(call, scope),
            Expression::Accumulate(accumulate) => self.accumulate(accumulate, scope),
        }
    }

    fn operation(&mut self, node: &Operation, scope: &[Value]) -> Value {
        if node.operator == "select" {
            return self.select(&node.operands, scope);
        }
        let operands: Vec<Value> = node.operands.iter().map(|o| self.expression(o, scope)).collect();
        match (operands.as_slice(), Unary::named(&node.operator), Binary::named(&node.operator)) {
            (&[a], Some(operator), _) => self.unary(operator, a),
            (&[first, ref others @ ..], _, Some(operator)) => {
                others.iter().fold(first, |a, &b| self.binary(operator, a, b))
            }
            _ => self.constant(0.0),
        }
    }

    fn unary(&mut self, operator: Unary, a: Value) -> Value {
        if let Some(a) = self.number(a) {
            return self.constant(operator.apply(a));
        }
        let key = Key::Unary(operator, a);
        self.once(key, |to| Step::Unary { operator, to, a })
    }

    fn binary(&mut self, operator: Binary, a: Value, b: Value) -> Value {
        match (operator, self.number(a), self.number(b)) {
            (_, Some(a), Some(b)) => return self.constant(operator.apply(a, b)),
            (Binary::Pow, _, Some(exponent)) => {
                if let Some(value) = self.power(a, exponent) {
                    return value;
                }
            }
            _ => {}
        }
        self.once(Key::Binary(operator, a, b), |to| match operator {
            Binary::Add => Step::Add { to, a, b },
            Binary::Sub => Step::Sub { to, a, b },
            Binary::Mul => Step::Mul { to, a, b },
            Binary::Div => Step::Div { to, a, b },
            _ => Step::Binary { operator, to, a, b },
        })
    }

    /// Small whole powers are products.
    fn power(&mut self, a: Value, exponent: f64) -> Option<Value> {
        if ![1.0, 2.0, 3.0, 4.0].contains(&exponent) {
            return None;
        }
        let square = (exponent > 1.0).then(|| self.binary(Binary::Mul, a, a));
        Some(match (square, exponent as u8) {
            (Some(square), 2) => square,
            (Some(square), 3) => self.binary(Binary::Mul, square, a),
            (Some(square), _) => self.binary(Binary::Mul, square, square),
            (None, _) => a,
        })
    }

    /// The value of a step that has been made before, or is made now.
    fn once(&mut self, key: Key, step: impl FnOnce(Value) -> Step<Value>) -> Value {
        if let Some(&known) = self.known.get(&key) {
            return known;
        }
        let to = self.value();
        self.steps.push(step(to));
        self.known.insert(key, to);
        to
    }

    /// `select(a, b, c[, d])`: only the branch that is taken is computed.
    fn select(&mut self, operands: &[Expression], scope: &[Value]) -> Value {
        let [test, negative, others @ ..] = operands else { return self.constant(0.0) };
        let test = self.expression(test, scope);
        if let Some(number) = self.number(test) {
            let taken = match others {
                _ if number < 0.0 => negative,
                [zero, _] if number == 0.0 => zero,
                [.., last] => last,
                [] => negative,
            };
            return self.expression(taken, scope);
        }
        let to = self.value();
        let mut to_end = Vec::new();
        let otherwise = self.branch(|at| Step::UnlessNegative { a: test, target: at }, negative, to, scope);
        to_end.push(otherwise);
        if let [zero, _] = others {
            to_end.push(self.branch(|at| Step::UnlessZero { a: test, target: at }, zero, to, scope));
        }
        if let Some(last) = others.last() {
            let before = self.known.clone();
            let a = self.expression(last, scope);
            self.steps.push(Step::Copy { to, a });
            self.known = before;
        }
        let end = self.steps.len() as u32;
        for jump in to_end {
            self.steps[jump] = Step::Jump { target: end };
        }
        to
    }

    /// A branch behind its condition; the place of the jump at its end, which is still to be aimed.
    fn branch(
        &mut self,
        condition: impl Fn(u32) -> Step<Value>,
        body: &Expression,
        to: Value,
        scope: &[Value],
    ) -> usize {
        let start = self.steps.len();
        self.steps.push(condition(0));
        // What only a branch computes is unknown outside.
        let before = self.known.clone();
        let a = self.expression(body, scope);
        self.known = before;
        self.steps.push(Step::Copy { to, a });
        self.steps.push(Step::Jump { target: 0 });
        self.steps[start] = condition(self.steps.len() as u32);
        self.steps.len() - 1
    }

    fn accumulate(&mut self, node: &Accumulate, scope: &[Value]) -> Value {
        let product = node.operator == AccumulateKind::Product;
        let (first, last) = (self.expression(&node.first, scope), self.expression(&node.last, scope));
        let (total, index) = (self.value(), self.value());
        let start = self.steps.len();
        self.steps.push(Step::Loop { product, total, index, first, last, end: 0 });
        let mut inner = scope.to_vec();
        let unset = self.constant(0.0);
        inner.resize(inner.len().max(node.index + 1), unset);
        inner[node.index] = index;
        let before = self.known.clone();
        let value = self.expression(&node.body, &inner);
        self.known = before;
        self.steps.push(Step::Turn { product, total, index, last, value, body: start as u32 + 1 });
        let end = self.steps.len() as u32;
        self.steps[start] = Step::Loop { product, total, index, first, last, end };
        total
    }

    fn call(&mut self, node: &Call, scope: &[Value]) -> Value {
        let arguments: Vec<Value> = node.arguments.iter().map(|a| self.expression(a, scope)).collect();
        let component = node.component.unwrap_or(0);
        let key = Key::Call(node.function.address(), arguments.clone().into());
        if let crate::graph::Function::Expression(function) = &*node.function {
            if let Some(&known) = self.known.get(&key) {
                return known;
            }
            if self.steps.len() < MOST_INLINED {
                let value = self.expression(&function.body, &arguments);
                self.known.insert(key, value);
                return value;
            }
        }
        let Some(function) = self.builder.function(&node.function) else { return self.constant(0.0) };
        if let Callee::Transform(transform) = &*function.callee {
            return self.transformed(transform, &arguments, component);
        }
        let size = function.size as Value;
        let first = match self.known.get(&key) {
            Some(&known) => known,
            None => {
                let first = self.values;
                self.values += size;
                let results = (first..first + size).collect();
                self.sites.push(Site {
                    callee: Arc::clone(&function.callee),
                    arguments: arguments.into(),
                    results,
                });
                self.steps.push(Step::Call { site: self.sites.len() as u32 - 1 });
                self.known.insert(key, first);
                first
            }
        };
        first + component.min(size as usize - 1) as Value
    }

    /// One component of a transformed point, as a row of sums.
    fn transformed(
        &mut self,
        transform: &crate::math::Transform,
        arguments: &[Value],
        component: usize,
    ) -> Value {
        let row = component.min(2);
        let origin = transform.point(crate::math::Vec3::ZERO)[row];
        let axes = [crate::math::Vec3::X, crate::math::Vec3::Y, crate::math::Vec3::Z];
        let mut sum = self.constant(origin);
        for (&argument, axis) in arguments.iter().zip(axes) {
            let factor = transform.direction(axis)[row];
            if factor != 0.0 {
                let factor = self.constant(factor);
                let term = self.binary(Binary::Mul, factor, argument);
                sum = self.binary(Binary::Add, sum, term);
            }
        }
        sum
    }
}
