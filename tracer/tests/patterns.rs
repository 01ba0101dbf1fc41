//! Patterns, waves and warps against POV-Ray's `function { pattern { ... } }`.

mod golden;

use golden::sdl;
use minipov_tracer::pattern::SurfaceContext;

#[test]
fn patterns_equal_povrays() {
    golden::parse(include_str!("data/patterns.txt")).check(1e-9, |case| {
        let pattern = sdl::pattern(case);
        move |p| pattern.value(p, &SurfaceContext::NONE)
    });
}
