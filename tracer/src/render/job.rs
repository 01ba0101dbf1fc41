//! A picture in the making: threads take tiles, the caller looks on, or stops it.

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex};

use rayon::prelude::*;

use super::tile::{tiles, Tile};
use super::view::View;
use super::Picture;
use crate::accel::Counters;
use crate::camera::Size;
use crate::function::patience;
use crate::graph::settings::RenderSettings;
use crate::graph::STACK_BYTES;
use crate::photon::PhotonMaps;
use crate::prepare::Scene;
use crate::radiosity::{Cache, Indirect, Settings};
use crate::shade::Tracer;

/// Everything that the threads of one render share.
pub struct Job {
    pub(super) scene: Scene,
    pub(super) settings: RenderSettings,
    tiles: Vec<Tile>,
    picture: Picture,
    done: AtomicUsize,
    cancelled: Arc<AtomicBool>,
    counters: Mutex<Counters>,
}

/// How far a render is, in pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Progress {
    /// Pixels finished.
    pub done: usize,
    /// Pixels asked for.
    pub total: usize,
}

impl Job {
    /// A render that has not started.
    pub fn new(scene: Scene, settings: &RenderSettings) -> Job {
        let (width, height) = (settings.width, settings.height);
        let part = |range: Option<(usize, usize)>, all: usize| match range {
            Some((start, end)) => start.min(all)..end.min(all),
            None => 0..all,
        };
        Job {
            scene,
            tiles: tiles(part(settings.columns, width), part(settings.rows, height)),
            picture: Picture::empty(width, height),
            settings: settings.clone(),
            done: AtomicUsize::new(0),
            cancelled: Arc::default(),
            counters: Mutex::default(),
        }
    }

    /// Takes over the finished tiles of an earlier attempt; `earlier` is the `Picture::unfinished` that it left.
    pub fn take_over(&mut self, earlier: Vec<[f32; 4]>) {
        let width = self.settings.width;
        self.tiles.retain(|tile| {
            tile.rows.clone().any(|y| tile.columns.clone().any(|x| earlier[y * width + x][0].is_nan()))
        });
        self.picture = Picture::begun(width, self.settings.height, earlier);
    }

    /// Renders until finished or cancelled.
    pub fn run(&self) {
        let cancelled = Arc::clone(&self.cancelled);
        let threads = rayon::ThreadPoolBuilder::new()
            .num_threads(self.settings.threads)
            .stack_size(STACK_BYTES)
            .start_handler(move |_| patience::heed(&cancelled))
            .build();
        match threads {
            Ok(pool) => pool.install(|| self.render_passes()),
            // Without threads of its own the render uses those that are there.
            Err(_) => self.render_passes(),
        }
    }

    fn render_passes(&self) {
        let photons = self.scene.photons.as_ref().map(|settings| self.shoot_photons(settings));
        let photons = photons.as_ref().filter(|map| !map.is_empty());
        let settings = self.scene.radiosity.as_ref();
        let gathered = settings.map(|settings| (settings, self.gather_light(settings, photons)));
        self.render_tiles(photons, gathered.as_ref().map(|(settings, cache)| (*settings, cache)));
    }

    /// A tracer for one thread.
    pub(super) fn tracer(&self) -> Tracer<'_> {
        Tracer::new(&self.scene, &self.cancelled)
    }

    /// Adds what a thread counted.
    pub(super) fn count(&self, tracer: &mut Tracer) {
        let counted = std::mem::take(&mut tracer.counters);
        self.counters.lock().expect("merging does not panic").merge(&counted);
    }

    fn render_tiles(&self, photons: Option<&PhotonMaps>, gathered: Option<(&Settings, &Cache)>) {
        let size = Size { width: self.settings.width, height: self.settings.height };
        self.tiles.par_iter().with_max_len(1).for_each_init(
            || self.tracer(),
            |tracer, tile| {
                if self.is_cancelled() {
                    return;
                }
                tracer.photons = photons;
                tracer.indirect = gathered.map(|(settings, cache)| {
                    Indirect::new(cache, settings.error_bound, !settings.always_sample)
                });
                let antialiasing = self.settings.antialiasing.as_ref();
                let colors = tile.render(&mut View { tracer, size }, antialiasing);
                // A tile cut short is no part of the picture.
                if self.is_cancelled() {
                    return;
                }
                self.picture.put(tile, &colors);
                self.count(tracer);
                self.done.fetch_add(colors.len(), Ordering::Relaxed);
            },
        );
    }

    /// Asks the threads to stop; tiles not finished by then are left out.
    pub fn cancel(&self) {
        self.cancelled.store(true, Ordering::Relaxed);
    }

    /// Whether `cancel` was called.
    pub fn is_cancelled(&self) -> bool {
        self.cancelled.load(Ordering::Relaxed)
    }

    /// How far it is.
    pub fn progress(&self) -> Progress {
        let total = self.tiles.iter().map(|t| t.columns.len() * t.rows.len()).sum();
        Progress { done: self.done.load(Ordering::Relaxed), total }
    }

    /// The picture so far.
    pub fn picture(&self) -> &Picture {
        &self.picture
    }

    /// What was counted so far.
    pub fn counters(&self) -> Counters {
        self.counters.lock().expect("merging does not panic").clone()
    }
}
