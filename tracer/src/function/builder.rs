//! From the graph's functions to compiled ones; shared nodes are compiled once.

use std::sync::Arc;

use super::callee::Callee;
use super::compile::Compiler;
use super::internal::Internal;
use super::{Function, Spline};
use crate::graph::{function as graph, Shared};
use crate::texture::Builder;

impl Builder {
    /// A function of the graph, compiled when first met; None for one that cannot be called yet, which is noted.
    pub fn function(&mut self, node: &Shared<graph::Function>) -> Option<Function> {
        if let Some(known) = self.functions.get(&node.address()) {
            return known.clone();
        }
        let made = self.compile(node);
        self.functions.insert(node.address(), made.clone());
        made
    }

    fn compile(&mut self, node: &graph::Function) -> Option<Function> {
        let (callee, size) = match node {
            graph::Function::Expression(function) => {
                let compiler = Compiler::new(self, function.parameters.len());
                let Some(program) = compiler.program(&function.body) else {
                    self.leave_out("function with more than 65536 values at once");
                    return None;
                };
                (Callee::Program(program), 1)
            }
            graph::Function::Internal(internal) => {
                let Some(function) = Internal::new(internal.number, self.noise_generator) else {
                    self.leave_out(&format!("internal({})", internal.number));
                    return None;
                };
                (Callee::Internal(function), 1)
            }
            graph::Function::Pattern(function) => {
                (Callee::Pattern(self.pattern(&function.pattern, &function.modifiers)?), 1)
            }
            graph::Function::Pigment(function) => (Callee::Pigment(self.pigment(&function.pigment)), 5),
            graph::Function::Transform(function) => (Callee::Transform(function.transform), 3),
            graph::Function::Spline(function) => {
                let spline = &function.spline;
                (Callee::Spline(Spline::new(spline.kind, &spline.points)), spline.size.clamp(1, 5))
            }
        };
        Some(Function { callee: Arc::new(callee), size })
    }
}
