//! Reads the values that `tests/tracer/golden_values.py` asked POV-Ray for.

use minipov_tracer::math::{vec3, Vec3};

/// One file: the points, and for each case the value at each point.
pub struct Golden {
    pub points: Vec<Vec3>,
    pub cases: Vec<(String, Vec<f64>)>,
}

fn numbers(text: &str) -> Vec<f64> {
    text.split_whitespace().map(|v| v.parse().expect("a number")).collect()
}

pub fn parse(text: &str) -> Golden {
    let (cases, points): (Vec<_>, Vec<_>) = text.lines().partition(|l| l.contains(':'));
    Golden {
        points: points.into_iter().map(numbers).map(|p| vec3(p[0], p[1], p[2])).collect(),
        cases: cases
            .into_iter()
            .map(|l| l.rsplit_once(':').expect("a case"))
            .map(|(name, values)| (name.to_owned(), numbers(values)))
            .collect(),
    }
}

impl Golden {
    /// Panics with a list of the cases of which a value is further than `tolerance` from `value(case)(point)`.
    pub fn check<F: Fn(Vec3) -> f64>(&self, tolerance: f64, value: impl Fn(&str) -> F) {
        let mut failures = Vec::new();
        for (name, expected) in &self.cases {
            let Ok(f) = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| value(name))) else {
                failures.push(format!("{name}: not built"));
                continue;
            };
            // Where POV-Ray itself has no number, anything goes.
            let wrong = |&(p, e): &(&Vec3, &f64)| {
                let close = (f(*p) - e).abs() <= tolerance * (1.0 + e.abs());
                !close && !e.is_nan()
            };
            let all: Vec<_> = self.points.iter().zip(expected).filter(wrong).collect();
            if let Some((p, e)) = all.first() {
                failures.push(format!("{name}: {} wrong, at {p:?} {} for {e}", all.len(), f(**p)));
            }
        }
        assert!(failures.is_empty(), "{} of {}:\n{}", failures.len(), self.cases.len(), failures.join("\n"));
    }
}
