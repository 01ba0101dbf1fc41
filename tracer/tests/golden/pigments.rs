//! Pigments against POV-Ray's `function { pigment { ... } }`, which has single precision.

use super::{data, sdl};
use minipov_tracer::pattern::SurfaceContext;

#[test]
fn pigments_equal_povrays() {
    data::parse(include_str!("../golden_values/pigments.txt")).check(1e-6, |case| {
        let (text, component) = case.split_once(" | ").expect("a component");
        let pigment = sdl::pigment(&mut sdl::Words(text));
        let components = ["red", "green", "blue", "filter", "transmit"];
        let index = components.iter().position(|c| *c == component).expect("a known one");
        move |p| {
            let c = pigment.color(p, &SurfaceContext::NONE);
            [c.rgb.r, c.rgb.g, c.rgb.b, c.filter, c.transmit][index]
        }
    });
}
