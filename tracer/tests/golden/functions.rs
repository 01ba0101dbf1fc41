//! The internal functions against POV-Ray's values.

use super::data;
use minipov_tracer::graph::function::{Function, InternalFunction};
use minipov_tracer::graph::Shared;
use minipov_tracer::math::Vec3;
use minipov_tracer::texture::Builder;

#[test]
fn internal_functions_equal_povrays() {
    data::parse(include_str!("../golden_values/functions.txt")).check(1e-9, |case| {
        let mut words = case.split(' ');
        let number = words.next().and_then(|word| word.parse().ok()).expect("a number");
        let parameters: Vec<f64> = words.map(|word| word.parse().expect("a parameter")).collect();
        let node = Shared::new(Function::Internal(InternalFunction { number }));
        let function = Builder::default().function(&node).expect("a function");
        move |p: Vec3| {
            let arguments: Vec<f64> = [p.x, p.y, p.z].into_iter().chain(parameters.iter().copied()).collect();
            function.value(&arguments)
        }
    });
}
