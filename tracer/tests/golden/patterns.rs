//! Patterns, waves and warps against POV-Ray's `function { pattern { ... } }`.

use super::{data, sdl};
use minipov_tracer::pattern::SurfaceContext;

#[test]
fn patterns_equal_povrays() {
    data::parse(include_str!("../golden_values/patterns.txt")).check(1e-9, |case| {
        let pattern = sdl::pattern(case);
        move |p| pattern.value(p, &SurfaceContext::NONE)
    });
}
