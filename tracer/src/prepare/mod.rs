//! From the scene graph to an immutable scene of numbered parts.

mod lights;
mod quality;
mod scene;
mod textures;

pub use quality::Quality;
pub use scene::Scene;

use crate::accel::AcceleratorKind;
use crate::atmosphere::{Atmosphere, Sky};
use crate::camera::Camera;
use crate::geometry;
use crate::graph::settings::{Accelerator, RenderSettings};
use crate::graph::{self, Shared, Unsupported};
use crate::media::Media;
use crate::noise::NoiseGenerator;
use crate::photon;
use crate::radiosity::Settings;
use crate::shade::Layering;
use crate::subsurface;
use crate::texture::Builder;

/// Makes a scene ready for rendering; what cannot be rendered is left out and listed.
pub fn prepare(scene: &graph::scene::Scene, settings: &RenderSettings) -> (Scene, Vec<Unsupported>) {
    let kind = match settings.accelerator {
        Accelerator::Linear => AcceleratorKind::Linear,
        Accelerator::Spheres => AcceleratorKind::Spheres,
        Accelerator::Hierarchy => AcceleratorKind::Hierarchy,
        Accelerator::Grid => AcceleratorKind::Grid,
        Accelerator::Octree => AcceleratorKind::Octree,
    };
    let objects: Vec<_> = scene.objects.iter().cloned().chain(lights::visible(scene)).collect();
    let global = &scene.settings;
    let mut patterns = Builder::new(i64::from(global.noise_generator), global.number_of_waves as usize);
    let (geometry, mut unsupported) = geometry::prepare(&objects, kind, &mut patterns);
    let quality = Quality::new(settings.quality);
    let (textures, dresses) = textures::prepare(scene, &geometry, &quality, &mut patterns);
    let (lights, light_sets) = lights::prepare(scene, &geometry, kind, &mut patterns, &mut unsupported);
    let camera = Camera::new(&scene.camera, &mut patterns);
    let media: Vec<Box<[Media]>> = geometry
        .interiors
        .iter()
        .map(|worn| {
            let fill = |media: &Shared<_>| Media::new(media, worn.space.clone(), &mut patterns);
            worn.item.media.iter().map(fill).collect()
        })
        .collect();
    let air = scene.media.iter().map(|media| Media::new(media, None, &mut patterns)).collect();
    let interiors = geometry.interiors.iter().map(|worn| (*worn.item).clone()).collect();
    let sky = Sky::new(scene, settings.alpha, &mut patterns);
    let atmosphere = Atmosphere::new(scene, &quality);
    leave_out_settings(global, &mut patterns);
    unsupported.append(&mut patterns.unsupported);
    let uses_uv = patterns.uses_uv || geometry.uses_uv();
    let mut prepared = Scene {
        geometry,
        textures,
        dresses,
        interiors,
        has_media: media.iter().any(|list| !list.is_empty()),
        media,
        air,
        lights,
        light_sets,
        camera,
        sky,
        atmosphere,
        quality,
        photons: photons(scene, &quality),
        radiosity: radiosity(scene, &quality),
        subsurface: subsurface(scene, &quality),
        uses_uv,
        layering: Layering::of_version(scene.version),
        max_trace_level: global.max_trace_level,
        adc_bailout: global.adc_bailout,
        irid_wavelength: global.irid_wavelength,
        noise_generator: NoiseGenerator::from_number(i64::from(global.noise_generator)),
    };
    prepared.place_camera();
    (prepared, unsupported)
}

/// Notes what of `global_settings` does nothing.
fn leave_out_settings(global: &graph::settings::GlobalSettings, patterns: &mut Builder) {
    if global
        .photons
        .as_ref()
        .is_some_and(|photons| photons.save_file.is_some() || photons.load_file.is_some())
    {
        patterns.leave_out("files of photons");
    }
    if global.subsurface.as_ref().is_some_and(|subsurface| subsurface.radiosity) {
        patterns.leave_out("radiosity under surfaces");
    }
}

/// How photons are shot, if they are.
fn photons(scene: &graph::scene::Scene, quality: &Quality) -> Option<photon::Settings> {
    let photons = scene.settings.photons.as_ref().filter(|_| quality.reflection);
    photons.map(|photons| photon::Settings::new(photons, &scene.settings))
}

/// How light between surfaces is gathered, if it is.
fn radiosity(scene: &graph::scene::Scene, quality: &Quality) -> Option<Settings> {
    scene.settings.radiosity.as_ref().filter(|_| quality.volumes).map(Settings::from)
}

/// How light under surfaces is sampled, if it is.
fn subsurface(scene: &graph::scene::Scene, quality: &Quality) -> Option<subsurface::Settings> {
    let settings = scene.settings.subsurface.as_ref().filter(|_| quality.volumes)?;
    Some(subsurface::Settings { many: settings.samples.0, once: settings.samples.1 })
}
