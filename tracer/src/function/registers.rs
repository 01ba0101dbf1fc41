//! Numbered values share registers: each stands in one from the step that makes it to the last that uses it.

use super::compile::{Compiler, Value};
use super::program::{Site, Step, SIZES};
use super::Program;

/// The finished program, or None if it needs more registers than a number can name.
pub fn assign(compiler: Compiler, result: Value) -> Option<Program> {
    let Compiler { steps, sites, constants, arguments, values, .. } = compiler;
    let lives = lives(&steps, &sites, values as usize);
    let mut register: Vec<Option<u16>> = vec![None; values as usize];
    let mut start = vec![0.0; arguments];
    (0..arguments).for_each(|i| register[i] = Some(i as u16));
    for &(value, number) in &constants {
        register[value as usize] = Some(u16::try_from(start.len()).ok()?);
        start.push(number);
    }
    let pinned = start.len();
    let mut used = pinned;
    let mut free: Vec<u16> = Vec::new();
    // Values by the step after which nothing needs them.
    let mut ending: Vec<Vec<Value>> = vec![Vec::new(); steps.len()];
    for (value, life) in lives.iter().enumerate() {
        if register[value].is_none() && value as Value != result {
            if let Some(life) = life {
                ending[life.last].push(value as Value);
            }
        }
    }
    for (at, step) in steps.iter().enumerate() {
        let mut full = false;
        each_made(step, &sites, |value| {
            if register[value as usize].is_none() {
                let taken = free.pop().or_else(|| {
                    used += 1;
                    u16::try_from(used - 1).ok()
                });
                full |= taken.is_none();
                register[value as usize] = taken;
            }
        });
        if full {
            return None;
        }
        free.extend(ending[at].iter().filter_map(|&value| register[value as usize]));
    }
    let of = |value: Value| register[value as usize].unwrap_or(0);
    let sites = sites
        .into_iter()
        .map(|site| Site {
            callee: site.callee,
            arguments: site.arguments.iter().map(|&v| of(v)).collect(),
            results: site.results.iter().map(|&v| of(v)).collect(),
        })
        .collect();
    let steps = steps.iter().map(|step| renamed(step, of)).collect();
    start.resize(SIZES.into_iter().find(|&size| size >= used)?, 0.0);
    Some(Program { steps, sites, start, arguments, result: of(result) })
}

/// First and last step at which a value must stand in its register.
#[derive(Clone, Copy)]
struct Life {
    first: usize,
    last: usize,
}

fn lives(steps: &[Step<Value>], sites: &[Site<Value>], values: usize) -> Vec<Option<Life>> {
    let mut lives: Vec<Option<Life>> = vec![None; values];
    let loops: Vec<(usize, usize)> = steps
        .iter()
        .enumerate()
        .filter_map(|(at, step)| match step {
            Step::Loop { end, .. } => Some((at, *end as usize - 1)),
            _ => None,
        })
        .collect();
    for (at, step) in steps.iter().enumerate() {
        each_made(step, sites, |value| {
            let life = lives[value as usize].get_or_insert(Life { first: at, last: at });
            life.last = at;
        });
        each_used(step, sites, |value| {
            // Arguments and constants, which are made by no step, keep their registers anyway.
            let Some(life) = &mut lives[value as usize] else { return };
            // What a loop uses but does not make must last through all its turns.
            let around = loops.iter().filter(|&&(start, end)| start < at && at <= end && life.first <= start);
            life.last = around.map(|&(_, end)| end).fold(life.last.max(at), usize::max);
        });
    }
    lives
}

/// Calls `visit` with every value that a step makes.
fn each_made(step: &Step<Value>, sites: &[Site<Value>], mut visit: impl FnMut(Value)) {
    match *step {
        Step::Add { to, .. } | Step::Sub { to, .. } | Step::Mul { to, .. } | Step::Div { to, .. } => {
            visit(to)
        }
        Step::Unary { to, .. } | Step::Binary { to, .. } | Step::Copy { to, .. } => visit(to),
        Step::Loop { total, index, .. } => {
            visit(total);
            visit(index);
        }
        Step::Call { site } => sites[site as usize].results.iter().for_each(|&v| visit(v)),
        Step::UnlessNegative { .. } | Step::UnlessZero { .. } | Step::Jump { .. } | Step::Turn { .. } => {}
    }
}

/// Calls `visit` with every value that a step uses.
fn each_used(step: &Step<Value>, sites: &[Site<Value>], mut visit: impl FnMut(Value)) {
    match *step {
        Step::Add { a, b, .. }
        | Step::Sub { a, b, .. }
        | Step::Mul { a, b, .. }
        | Step::Div { a, b, .. }
        | Step::Binary { a, b, .. } => {
            visit(a);
            visit(b);
        }
        Step::Unary { a, .. } | Step::Copy { a, .. } => visit(a),
        Step::UnlessNegative { a, .. } | Step::UnlessZero { a, .. } => visit(a),
        Step::Jump { .. } => {}
        Step::Loop { first, last, .. } => {
            visit(first);
            visit(last);
        }
        Step::Turn { total, index, last, value, .. } => {
            [total, index, last, value].into_iter().for_each(visit)
        }
        Step::Call { site } => sites[site as usize].arguments.iter().for_each(|&v| visit(v)),
    }
}

/// The same step over registers.
fn renamed(step: &Step<Value>, of: impl Fn(Value) -> u16) -> Step {
    match *step {
        Step::Add { to, a, b } => Step::Add { to: of(to), a: of(a), b: of(b) },
        Step::Sub { to, a, b } => Step::Sub { to: of(to), a: of(a), b: of(b) },
        Step::Mul { to, a, b } => Step::Mul { to: of(to), a: of(a), b: of(b) },
        Step::Div { to, a, b } => Step::Div { to: of(to), a: of(a), b: of(b) },
        Step::Unary { operator, to, a } => Step::Unary { operator, to: of(to), a: of(a) },
        Step::Binary { operator, to, a, b } => Step::Binary { operator, to: of(to), a: of(a), b: of(b) },
        Step::Copy { to, a } => Step::Copy { to: of(to), a: of(a) },
        Step::UnlessNegative { a, target } => Step::UnlessNegative { a: of(a), target },
        Step::UnlessZero { a, target } => Step::UnlessZero { a: of(a), target },
        Step::Jump { target } => Step::Jump { target },
        Step::Loop { product, total, index, first, last, end } => {
            Step::Loop { product, total: of(total), index: of(index), first: of(first), last: of(last), end }
        }
        Step::Turn { product, total, index, last, value, body } => {
            Step::Turn { product, total: of(total), index: of(index), last: of(last), value: of(value), body }
        }
        Step::Call { site } => Step::Call { site },
    }
}
