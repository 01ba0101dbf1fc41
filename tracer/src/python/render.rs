//! Rendering from Python: a job that runs on its own threads and is asked how far it is.

use std::sync::Arc;
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

use numpy::ndarray::Array3;
use numpy::{IntoPyArray, PyArray3, PyReadonlyArray3};
use pyo3::exceptions::{PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::accel::RayKind;
use crate::graph::settings::RenderSettings;
use crate::graph::{collect_unsupported, scene::Scene, Unsupported, STACK_BYTES};
use crate::prepare::prepare;
use crate::render::Job;

/// A render in progress.
#[pyclass]
pub struct RenderJob {
    job: Arc<Job>,
    threads: Option<JoinHandle<Duration>>,
    unsupported: Vec<Unsupported>,
    prepare_time: Duration,
    trace_time: Duration,
}

#[pymethods]
impl RenderJob {
    /// Prepares the scene and starts rendering; `earlier` is what `unfinished` gave for a job that was cancelled.
    #[new]
    #[pyo3(signature = (scene, settings, earlier = None))]
    fn new(
        py: Python<'_>,
        scene: &Bound<'_, PyAny>,
        settings: RenderSettings,
        earlier: Option<PyReadonlyArray3<'_, f32>>,
    ) -> PyResult<RenderJob> {
        let earlier = earlier.map(|pixels| begun(&pixels, &settings)).transpose()?;
        let started = Instant::now();
        let scene = scene.clone().unbind();
        let made = py.detach(|| {
            on_deep_stack(move || {
                let (scene, mut unsupported) = Python::attach(|py| {
                    let scene = scene.into_bound(py);
                    collect_unsupported(|| scene.extract::<Scene>())
                })?;
                let (scene, left_out) = prepare(&scene, &settings);
                unsupported.extend(left_out);
                let mut job = Job::new(scene, &settings);
                if let Some(earlier) = earlier {
                    job.take_over(earlier);
                }
                PyResult::Ok((Arc::new(job), unsupported))
            })
        })?;
        let (job, unsupported) = made?;
        let prepare_time = started.elapsed();
        let running = Arc::clone(&job);
        let threads = std::thread::Builder::new().name("render".into()).spawn(move || {
            let started = Instant::now();
            running.run();
            started.elapsed()
        })?;
        Ok(RenderJob { job, threads: Some(threads), unsupported, prepare_time, trace_time: Duration::ZERO })
    }

    /// Pixels finished and pixels in all.
    fn progress(&self) -> (usize, usize) {
        let progress = self.job.progress();
        (progress.done, progress.total)
    }

    /// Whether the render has ended, for whatever reason.
    fn is_finished(&self) -> bool {
        self.threads.as_ref().is_none_or(JoinHandle::is_finished)
    }

    /// Asks the render to stop; tiles being traced are still finished.
    fn cancel(&self) {
        self.job.cancel();
    }

    /// The pixels so far: (height, width, 4) of float32, zeros where there are none.
    fn snapshot<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray3<f32>>> {
        self.array(py, self.job.picture().snapshot())
    }

    /// The pixels so far, NaN where there are none.
    fn unfinished<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray3<f32>>> {
        self.array(py, self.job.picture().unfinished())
    }

    /// Waits for the end.
    fn wait(&mut self, py: Python<'_>) -> PyResult<()> {
        if let Some(threads) = self.threads.take() {
            self.trace_time = py
                .detach(|| threads.join())
                .map_err(|_| PyRuntimeError::new_err("the renderer failed; this is a bug in minipov"))?;
        }
        Ok(())
    }

    /// What the scene asks for and the core leaves out: (feature, source) pairs.
    fn unsupported(&self) -> Vec<(String, String)> {
        self.unsupported.iter().map(|u| (u.feature.clone(), u.source.clone())).collect()
    }

    /// What was counted so far, and the seconds spent in each phase.
    fn statistics<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let counters = self.job.counters();
        let rays = PyDict::new(py);
        for (name, kind) in [
            ("camera", RayKind::Camera),
            ("reflected", RayKind::Reflected),
            ("shadow", RayKind::Shadow),
            ("radiosity", RayKind::Radiosity),
            ("photon", RayKind::Photon),
        ] {
            rays.set_item(name, counters.rays[kind as usize])?;
        }
        let tests = PyDict::new(py);
        for (name, count) in counters.tests_by_shape() {
            tests.set_item(name, count)?;
        }
        let statistics = PyDict::new(py);
        statistics.set_item("rays", rays)?;
        statistics.set_item("tests", tests)?;
        statistics.set_item("cells", counters.cells)?;
        statistics.set_item("boxes", counters.boxes)?;
        statistics.set_item("inside_tests", counters.inside)?;
        statistics.set_item("prepare_seconds", self.prepare_time.as_secs_f64())?;
        statistics.set_item("trace_seconds", self.trace_time.as_secs_f64())?;
        Ok(statistics)
    }
}

/// Runs in a thread whose stack holds the deepest scene that is allowed.
fn on_deep_stack<T: Send>(work: impl FnOnce() -> T + Send) -> PyResult<T> {
    std::thread::scope(|scope| {
        let thread = std::thread::Builder::new().stack_size(STACK_BYTES).spawn_scoped(scope, work)?;
        thread
            .join()
            .map_err(|_| PyRuntimeError::new_err("preparing the scene failed; this is a bug in minipov"))
    })
}

impl RenderJob {
    fn array<'py>(&self, py: Python<'py>, pixels: Vec<[f32; 4]>) -> PyResult<Bound<'py, PyArray3<f32>>> {
        let picture = self.job.picture();
        let values = pixels.into_iter().flatten().collect();
        let pixels = Array3::from_shape_vec((picture.height, picture.width, 4), values)
            .map_err(|e| PyRuntimeError::new_err(e.to_string()))?;
        Ok(pixels.into_pyarray(py))
    }
}

/// The pixels of an earlier attempt, which has to have the same size.
fn begun(pixels: &PyReadonlyArray3<'_, f32>, settings: &RenderSettings) -> PyResult<Vec<[f32; 4]>> {
    let pixels = pixels.as_array();
    if pixels.dim() != (settings.height, settings.width, 4) {
        return Err(PyValueError::new_err("the earlier picture has another size"));
    }
    Ok(pixels.rows().into_iter().map(|pixel| [pixel[0], pixel[1], pixel[2], pixel[3]]).collect())
}

impl Drop for RenderJob {
    /// A job nobody waits for stops soon.
    fn drop(&mut self) {
        self.job.cancel();
    }
}
