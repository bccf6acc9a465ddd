//! Long work in a thread of its own, so that Ctrl-C and other Python threads stay alive.

use pyo3::prelude::*;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::Mutex;
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::thread;
use std::time::Duration;

/// How often signals are looked for.
const PAUSE: Duration = Duration::from_millis(50);

enum Event<T> {
    Step(String),
    Done(thread::Result<T>),
}

/// Runs `task` without the interpreter's lock. `progress` is called with the name of each step.
/// After Ctrl-C the caller gets `KeyboardInterrupt` at once; the thread ends with its task.
pub fn work<T: Send + 'static>(
    py: Python<'_>,
    progress: Option<Py<PyAny>>,
    task: impl FnOnce(&dyn Fn(&str)) -> T + Send + 'static,
) -> PyResult<T> {
    let (sender, receiver) = channel();
    let receiver = Mutex::new(receiver);
    thread::spawn(move || {
        let step = |step: &str| {
            // The receiver is gone after an interrupt; nobody needs the step then.
            let _ = sender.send(Event::Step(step.to_owned()));
        };
        let done = catch_unwind(AssertUnwindSafe(|| task(&step)));
        let _ = sender.send(Event::Done(done));
    });
    loop {
        match py.detach(|| wait(&receiver)) {
            Ok(Event::Step(step)) => {
                if let Some(progress) = &progress {
                    progress.call1(py, (step,))?;
                }
            }
            Ok(Event::Done(Ok(answer))) => return Ok(answer),
            Ok(Event::Done(Err(panic))) => resume_unwind(panic),
            Err(RecvTimeoutError::Timeout) => py.check_signals()?,
            Err(RecvTimeoutError::Disconnected) => {
                return Err(super::error::failed("the work ended without an answer"));
            }
        }
    }
}

fn wait<T>(receiver: &Mutex<Receiver<Event<T>>>) -> Result<Event<T>, RecvTimeoutError> {
    match receiver.lock() {
        Ok(receiver) => receiver.recv_timeout(PAUSE),
        Err(_) => Err(RecvTimeoutError::Disconnected),
    }
}
