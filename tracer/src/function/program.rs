//! The steps of a function, and the machine that runs them.

use std::sync::Arc;

use super::callee::Callee;
use super::operators::{Binary, Unary};
use super::patience;

/// One step. `R` names a value: numbered values while compiling, registers in a finished program.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(missing_docs)] // each does what it is named after: `to` takes what is made of the others
pub enum Step<R = u16> {
    Add {
        to: R,
        a: R,
        b: R,
    },
    Sub {
        to: R,
        a: R,
        b: R,
    },
    Mul {
        to: R,
        a: R,
        b: R,
    },
    Div {
        to: R,
        a: R,
        b: R,
    },
    Unary {
        operator: Unary,
        to: R,
        a: R,
    },
    Binary {
        operator: Binary,
        to: R,
        a: R,
        b: R,
    },
    Copy {
        to: R,
        a: R,
    },
    /// Goes on at step `target`, unless `a` is negative.
    UnlessNegative {
        a: R,
        target: u32,
    },
    /// Goes on at step `target`, unless `a` is 0.
    UnlessZero {
        a: R,
        target: u32,
    },
    Jump {
        target: u32,
    },
    /// Starts `sum` or `prod`; with nothing to do, goes on at step `end`.
    Loop {
        product: bool,
        total: R,
        index: R,
        first: R,
        last: R,
        end: u32,
    },
    /// Ends a turn; with more to do, goes back to step `body`.
    Turn {
        product: bool,
        total: R,
        index: R,
        last: R,
        value: R,
        body: u32,
    },
    /// Makes call number `site`.
    Call {
        site: u32,
    },
}

/// A call: what is called, the values it is given, and where the components of its value go.
#[derive(Clone, Debug)]
pub struct Site<R = u16> {
    /// What is called.
    pub callee: Arc<Callee>,
    /// What it is given.
    pub arguments: Box<[R]>,
    /// Where the components go, from the first.
    pub results: Box<[R]>,
}

/// A compiled function of numbers.
#[derive(Clone, Debug)]
pub struct Program {
    pub(super) steps: Vec<Step>,
    pub(super) sites: Vec<Site>,
    /// What stands in the registers at the start: room for the arguments, the constants, then zeros; as long as one of
    /// `SIZES`.
    pub(super) start: Vec<f64>,
    pub(super) arguments: usize,
    pub(super) result: u16,
}

/// How many registers there can be: powers of two, up to what a 16-bit number can name.
pub(super) const SIZES: [usize; 4] = [16, 64, 512, 1 << 16];

impl Program {
    /// Whether there are loops in it, or in what it calls: `sum`, `prod`.
    pub fn loops(&self) -> bool {
        let own = self.steps.iter().any(|step| matches!(step, Step::Loop { .. }));
        own || self.sites.iter().any(|site| site.callee.loops())
    }

    /// The value for these arguments; missing ones are 0.
    #[inline]
    pub fn value(&self, arguments: &[f64]) -> f64 {
        if let Ok(start) = <[f64; SIZES[0]]>::try_from(&self.start[..]) {
            return self.run(&mut { start }, arguments);
        }
        if let Ok(start) = <[f64; SIZES[1]]>::try_from(&self.start[..]) {
            return self.run(&mut { start }, arguments);
        }
        if let Ok(start) = <[f64; SIZES[2]]>::try_from(&self.start[..]) {
            return self.run(&mut { start }, arguments);
        }
        let start: Result<Box<[f64; SIZES[3]]>, _> = self.start.clone().into_boxed_slice().try_into();
        start.map_or(0.0, |mut registers| self.run(&mut registers, arguments))
    }

    /// Runs in `N` registers, a power of two, so that masking a number to stay below it costs nothing.
    fn run<const N: usize>(&self, registers: &mut [f64; N], arguments: &[f64]) -> f64 {
        for (register, &argument) in registers.iter_mut().zip(arguments.iter().take(self.arguments)) {
            *register = argument;
        }
        macro_rules! at {
            ($r:expr) => {
                registers[$r as usize & (N - 1)]
            };
        }
        let mut next = 0;
        while let Some(step) = self.steps.get(next) {
            next += 1;
            match *step {
                Step::Add { to, a, b } => at!(to) = at!(a) + at!(b),
                Step::Sub { to, a, b } => at!(to) = at!(a) - at!(b),
                Step::Mul { to, a, b } => at!(to) = at!(a) * at!(b),
                Step::Div { to, a, b } => at!(to) = at!(a) / at!(b),
                Step::Unary { operator, to, a } => at!(to) = operator.apply(at!(a)),
                Step::Binary { operator, to, a, b } => at!(to) = operator.apply(at!(a), at!(b)),
                Step::Copy { to, a } => at!(to) = at!(a),
                Step::UnlessNegative { a, target } => {
                    let negative = at!(a) < 0.0;
                    next = if negative { next } else { target as usize };
                }
                Step::UnlessZero { a, target } => {
                    let zero = at!(a) == 0.0;
                    next = if zero { next } else { target as usize };
                }
                Step::Jump { target } => next = target as usize,
                Step::Loop { product, total, index, first, last, end } => {
                    let endless = at!(last) - at!(first) > patience::MOST_TURNS;
                    at!(total) = if endless { f64::NAN } else { f64::from(u8::from(product)) };
                    at!(index) = at!(first);
                    let any = at!(first) <= at!(last) && !endless;
                    next = if any { next } else { end as usize };
                }
                Step::Turn { product, total, index, last, value, body } => {
                    at!(total) = if product { at!(total) * at!(value) } else { at!(total) + at!(value) };
                    at!(index) += 1.0;
                    let more = at!(index) <= at!(last);
                    if more && at!(index) as u64 % patience::TURNS_AT_ONCE == 0 && patience::is_over() {
                        return f64::NAN;
                    }
                    next = if more { body as usize } else { next };
                }
                Step::Call { site } => {
                    if patience::is_over() {
                        return f64::NAN;
                    }
                    let site = &self.sites[site as usize];
                    let mut given = [0.0; 16];
                    let mut many = Vec::new();
                    let values = match given.get_mut(..site.arguments.len()) {
                        Some(values) => values,
                        None => {
                            many.resize(site.arguments.len(), 0.0);
                            &mut many[..]
                        }
                    };
                    for (value, &r) in values.iter_mut().zip(&site.arguments) {
                        *value = at!(r);
                    }
                    if let [to] = *site.results {
                        at!(to) = site.callee.value(values);
                    } else {
                        let components = site.callee.components(values);
                        for (&to, component) in site.results.iter().zip(components) {
                            at!(to) = component;
                        }
                    }
                }
            }
        }
        at!(self.result)
    }
}
