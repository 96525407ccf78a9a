//! The devices that are open, and work on them.

use std::collections::HashMap;
use std::sync::{Mutex, PoisonError, mpsc};
use std::time::Duration;

use bentray::gpu::Gpu;
use bentray::progress::Progress;
use pyo3::prelude::*;

use crate::display::Display;
use crate::errors::{DeviceError, device_error};

/// The time between two looks for a signal, such as Ctrl-C.
const LOOK: Duration = Duration::from_millis(20);

/// A device, which stays open until the process ends.
#[derive(Clone, Copy)]
pub struct Device {
    pub gpu: &'static Gpu,
    progress: &'static Progress,
    /// The process that has opened it.
    process: u32,
}

/// Returns the device with a name that contains `name`, by default the best one; it is opened once.
pub fn open(name: Option<&str>) -> PyResult<Device> {
    static OPEN: Mutex<Option<HashMap<Option<String>, Device>>> = Mutex::new(None);
    let mut open = OPEN.lock().unwrap_or_else(PoisonError::into_inner);
    let all = open.get_or_insert_default();
    let key = name.map(str::to_owned);
    if let Some(device) = all.get(&key) {
        return device.checked();
    }
    if let Some(other) = all.values().next() {
        other.checked()?;
    }
    let progress = Progress::watched();
    let gpu = Gpu::open(name).map_err(|error| device_error(&error))?.reporting(progress.clone());
    let device =
        Device { gpu: Box::leak(Box::new(gpu)), progress: Box::leak(Box::new(progress)), process: std::process::id() };
    all.insert(key, device);
    Ok(device)
}

impl Device {
    /// Returns the device, or an error in a forked process: drivers have threads, which a fork does not copy.
    pub fn checked(self) -> PyResult<Self> {
        if self.process == std::process::id() {
            return Ok(self);
        }
        let problem = "the device was opened before this process was forked, and a fork cannot use it; start processes \
                       with multiprocessing.get_context(\"spawn\"), or open the device after the fork";
        Err(DeviceError::new_err(problem))
    }

    /// Runs `work` on another thread, while other Python threads go on. A signal cancels it: its exception is returned instead.
    pub fn run<T: Send>(self, py: Python, work: impl FnOnce() -> T + Send) -> PyResult<T> {
        py.detach(|| {
            std::thread::scope(|scope| {
                let (done, ended) = mpsc::channel();
                let worker = scope.spawn(move || {
                    let result = work();
                    // The receiver outlives the worker.
                    let _ = done.send(());
                    result
                });
                let mut interrupted = None;
                let mut display = Display::new(self.progress);
                while let Err(mpsc::RecvTimeoutError::Timeout) = ended.recv_timeout(LOOK) {
                    if interrupted.is_none()
                        && let Err(signal) = Python::attach(|py| py.check_signals()).and_then(|()| display.draw())
                    {
                        self.progress.cancel();
                        interrupted = Some(signal);
                    }
                }
                drop(display);
                let result = worker.join();
                if let Some(signal) = interrupted {
                    self.progress.resume();
                    return Err(signal);
                }
                result.map_err(|_| DeviceError::new_err("the work on the device ended unexpectedly"))
            })
        })
    }
}
