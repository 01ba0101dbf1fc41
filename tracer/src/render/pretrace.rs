//! SDL: `radiosity { pretrace_start F pretrace_end F }`: coarse passes that gather light before the picture is rendered.

use std::sync::Mutex;

use rayon::prelude::*;

use super::view::View;
use super::Job;
use crate::camera::Size;
use crate::photon::PhotonMaps;
use crate::radiosity::{Cache, Gathered, Indirect, Settings};

/// Places of a pass that one thread takes at a time, along each axis.
const SIDE: usize = 8;

impl Job {
    /// Fills the cache in ever finer passes; each sees what the passes before it gathered.
    pub(super) fn gather_light(&self, settings: &Settings, photons: Option<&PhotonMaps>) -> Cache {
        let size = Size { width: self.settings.width, height: self.settings.height };
        let width = size.width as f64;
        let [start, end] = settings.pretrace.map(|share| (share * width).max(1.0));
        let mut cache = Cache::default();
        let mut step = start;
        loop {
            for gathered in self.pass(settings, photons, &cache, size, step) {
                cache.insert(gathered, gathered.reach(settings.bound(gathered.bounces)));
            }
            if step <= end || self.is_cancelled() {
                return cache;
            }
            step = (step / 2.0).max(end);
        }
    }

    /// Light gathered at every `step`th pixel, in an order that does not depend on threads.
    fn pass(
        &self,
        settings: &Settings,
        photons: Option<&PhotonMaps>,
        cache: &Cache,
        size: Size,
        step: f64,
    ) -> Vec<Gathered> {
        let count = |length: usize| (length as f64 / step).ceil() as usize;
        let (columns, rows) = (count(size.width), count(size.height));
        let blocks = columns.div_ceil(SIDE) * rows.div_ceil(SIDE);
        let found = Mutex::new(Vec::new());
        (0..blocks).into_par_iter().with_max_len(1).for_each(|block| {
            let across = columns.div_ceil(SIDE);
            let (left, top) = (block % across * SIDE, block / across * SIDE);
            let bound = settings.error_bound * settings.low_error_factor;
            let mut tracer = self.tracer();
            tracer.photons = photons;
            tracer.indirect = Some(Indirect::new(cache, bound, false));
            for y in top..(top + SIDE).min(rows) {
                for x in left..(left + SIDE).min(columns) {
                    let at = |i: usize, length: usize| ((i as f64 + 0.5) * step).min(length as f64 - 0.5);
                    View { tracer: &mut tracer, size }.sample(at(x, size.width), at(y, size.height));
                }
            }
            self.count(&mut tracer);
            let own = tracer.indirect.map(|indirect| indirect.own.all().to_vec()).unwrap_or_default();
            found.lock().expect("no thread panics with the list in hand").push((block, own));
        });
        let mut found = found.into_inner().expect("no thread panics with the list in hand");
        found.sort_unstable_by_key(|(block, _)| *block);
        found.into_iter().flat_map(|(_, own)| own).collect()
    }
}
