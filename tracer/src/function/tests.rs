//! Expressions against values that POV-Ray 3.7 printed, and against themselves compiled in other ways.

use super::Function;
use crate::graph::function::{
    Accumulate, AccumulateKind, Call, Constant, Expression, ExpressionFunction, Function as Node, Operation,
    Parameter, Spline, SplineFunction, SplineKind,
};
use crate::graph::Shared;
use crate::texture::Builder;

fn number(value: f64) -> Expression {
    Expression::Constant(Constant { value })
}

fn parameter(index: usize) -> Expression {
    Expression::Parameter(Parameter { index })
}

fn operation(operator: &str, operands: &[Expression]) -> Expression {
    Expression::Operation(Operation { operator: operator.into(), operands: operands.to_vec() })
}

fn accumulate(
    operator: AccumulateKind,
    index: usize,
    bounds: [Expression; 2],
    body: Expression,
) -> Expression {
    let [first, last] = bounds;
    Expression::Accumulate(Shared::new(Accumulate { operator, index, first, last, body }))
}

fn node(parameters: usize, body: Expression) -> Shared<Node> {
    let parameters = (0..parameters).map(|i| format!("p{i}")).collect();
    Shared::new(Node::Expression(ExpressionFunction { parameters, body }))
}

fn compiled(parameters: usize, body: Expression) -> Function {
    Builder::default().function(&node(parameters, body)).expect("a function")
}

/// The value of an operator or float function, of numbers known when compiling and of arguments: both must agree.
fn value(operator: &str, operands: &[f64]) -> f64 {
    let constants: Vec<_> = operands.iter().map(|&o| number(o)).collect();
    let parameters: Vec<_> = (0..operands.len()).map(parameter).collect();
    let folded = compiled(0, operation(operator, &constants)).value(&[]);
    let run = compiled(operands.len(), operation(operator, &parameters)).value(operands);
    assert_eq!(folded.to_bits(), run.to_bits(), "{operator} {operands:?}: {folded} {run}");
    run
}

#[test]
fn operators_are_those_of_povray() {
    let (inf, nan) = (f64::INFINITY, f64::NAN);
    let cases: &[(&str, &[f64], f64)] = &[
        ("/", &[1.0, 0.0], inf),
        ("/", &[-1.0, 0.0], -inf),
        ("log", &[1000.0], 3.0),
        ("ln", &[0.0], -inf),
        ("pow", &[0.0, 0.0], 1.0),
        ("pow", &[0.0, -1.0], inf),
        ("pow", &[-2.0, 3.0], -8.0),
        ("mod", &[-7.0, 3.0], -1.0),
        ("int", &[-2.5], -2.0),
        ("int", &[1e12], -2147483648.0),
        ("int", &[nan], -2147483648.0),
        ("atan2", &[0.0, 0.0], 0.0),
        ("floor", &[-0.5], -1.0),
        ("=", &[1.0, 1.000_000_000_01], 0.0),
        ("<", &[1.0, 1.000_000_000_01], 1.0),
        ("|", &[0.0, 1e-12], 1.0),
        ("&", &[1.0, -0.1], 1.0),
        ("&", &[0.0, 1.0], 0.0),
        ("max", &[1.0, nan], 1.0),
        ("min", &[nan, 1.0], 1.0),
        (">", &[nan, 1.0], 1.0),
        (">=", &[nan, 1.0], 1.0),
        ("!=", &[nan, 1.0], 1.0),
        ("select", &[-1e-12, 1.0, 2.0, 3.0], 1.0),
        ("select", &[0.0, 1.0, 2.0, 3.0], 2.0),
        ("select", &[1e-12, 1.0, 2.0, 3.0], 3.0),
        ("select", &[nan, 1.0, 2.0, 3.0], 3.0),
        ("select", &[-1.0, 1.0, 2.0], 1.0),
        ("select", &[0.0, 1.0, 2.0], 2.0),
        ("max", &[0.0, 2.0, -3.0, 1.0], 2.0),
    ];
    for &(operator, operands, expected) in cases {
        assert_eq!(value(operator, operands), expected, "{operator} {operands:?}");
    }
    for (operator, operands) in
        [("sqrt", &[-1.0][..]), ("acos", &[2.0]), ("mod", &[5.0, 0.0]), ("/", &[0.0, 0.0])]
    {
        assert!(value(operator, operands).is_nan(), "{operator} {operands:?}");
    }
}

#[test]
fn loops_run_from_first_to_last() {
    let sum = |index| {
        let bounds = [number(1.5), parameter(0)];
        compiled(1, accumulate(AccumulateKind::Sum, index, bounds, parameter(index)))
    };
    assert_eq!(sum(1).value(&[3.5]), 7.5);
    assert_eq!(sum(1).value(&[3.4]), 4.0);
    assert_eq!(sum(1).value(&[1.0]), 0.0);
    // The sum of the factorials up to n: values from outside a loop live through all its turns.
    let factorial = accumulate(AccumulateKind::Product, 2, [number(1.0), parameter(1)], parameter(2));
    let scaled = operation("*", &[operation("sqrt", &[parameter(0)]), factorial]);
    let total = compiled(1, accumulate(AccumulateKind::Sum, 1, [number(1.0), parameter(0)], scaled));
    assert_eq!(total.value(&[4.0]), 66.0);
}

/// What a branch computes must not be taken for known after it.
#[test]
fn branches_know_nothing_of_each_other() {
    let square = operation("*", &[parameter(0), parameter(0)]);
    let select = operation("select", &[parameter(0), square.clone(), number(5.0)]);
    let both = compiled(1, operation("+", &[select, square]));
    assert_eq!(both.value(&[-3.0]), 18.0);
    assert_eq!(both.value(&[3.0]), 14.0);
}

/// Nested sums of a function of two arguments: `g(a, b) = a*b + f(b)`, `f(a) = a - 1`, through calls worked in.
#[test]
fn called_functions_are_worked_in() {
    let f = node(1, operation("-", &[parameter(0), number(1.0)]));
    let call = |function: &Shared<Node>, arguments: Vec<Expression>| {
        Expression::Call(Call { function: function.clone(), arguments, component: None })
    };
    let product = operation("*", &[parameter(0), parameter(1)]);
    let g = node(2, operation("+", &[product, call(&f, vec![parameter(1)])]));
    let h = compiled(2, call(&g, vec![parameter(1), call(&g, vec![parameter(0), number(2.0)])]));
    // g(3, 2) = 7, g(4, 7) = 34.
    assert_eq!(h.value(&[3.0, 4.0]), 34.0);
}

/// A function too large to be worked into its callers is called, and gives the same.
#[test]
fn large_functions_are_called() {
    let mut body = parameter(0);
    let mut expected = 1.5_f64;
    for i in 0..150 {
        body = operation("+", &[operation("sin", &[body]), number(f64::from(i))]);
        expected = expected.sin() + f64::from(i);
    }
    let large = node(1, body);
    let call = |argument| {
        Expression::Call(Call { function: large.clone(), arguments: vec![argument], component: None })
    };
    let twice = (0..30).fold(parameter(0), |inner, _| call(inner));
    let result =
        std::iter::successors(Some(1.5), |&x| Some((0..150).fold(x, |x: f64, i| x.sin() + f64::from(i))));
    assert_eq!(compiled(1, call(parameter(0))).value(&[1.5]), expected);
    assert_eq!(Some(compiled(1, twice).value(&[1.5])), result.take(31).last());
}

/// Many values alive at once need many registers.
#[test]
fn many_values_at_once() {
    for count in [10, 40, 300, 2000] {
        let terms: Vec<_> =
            (0..count).map(|i| operation("+", &[parameter(0), number(f64::from(i))])).collect();
        let sines: Vec<_> = terms.iter().map(|t| operation("sin", std::slice::from_ref(t))).collect();
        let balanced = |mut level: Vec<Expression>| {
            while level.len() > 1 {
                level = level
                    .chunks(2)
                    .map(|c| if c.len() == 2 { operation("+", c) } else { c[0].clone() })
                    .collect();
            }
            level.remove(0)
        };
        let forward = balanced(sines.clone());
        let backward = balanced(sines.into_iter().rev().collect());
        let both = compiled(1, operation("-", &[forward, backward]));
        assert!(both.value(&[0.7]).abs() < 1e-9, "{count}");
    }
}

#[test]
fn splines_pass_through_their_points() {
    let points: Vec<_> =
        [0.0, 1.0, 2.5, 3.0, 4.0].iter().map(|&t: &f64| (t, [t * t, 1.0 - t, t.sin(), 2.0, 0.0])).collect();
    for kind in [SplineKind::Linear, SplineKind::Quadratic, SplineKind::Cubic, SplineKind::Natural] {
        let spline = Shared::new(Spline { kind, points: points.clone(), size: 4 });
        let function =
            Builder::default().function(&Shared::new(Node::Spline(SplineFunction { spline }))).expect("");
        assert_eq!(function.size(), 4);
        for (t, value) in &points[1..4] {
            let found = function.components(&[*t]);
            assert!(found.iter().zip(value).all(|(a, b)| (a - b).abs() < 1e-12), "{kind:?} {t} {found:?}");
        }
        for beyond in [f64::NEG_INFINITY, -1.0, 9.0, f64::INFINITY, f64::NAN] {
            assert!(function.components(&[beyond]).iter().all(|c| c.is_finite()), "{kind:?} {beyond}");
        }
    }
}
