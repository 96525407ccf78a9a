//! What happens at Ctrl-C, and where the system asks the process to end.
//!
//! *Practice.* Files under way are removed and the process ends with 130: whatever stood there before is as it was. A film first finishes the
//! frame in hand, and ends at once if it is asked again.

use std::sync::atomic::{AtomicBool, Ordering};

use signal_hook::low_level::exit;

use crate::output::abandon_unfinished;

/// What shells see of a process that was interrupted.
pub(super) const INTERRUPTED: u8 = 130;

/// Is there more to come behind what is in hand, so that it is worth finishing?
static FINISHES: AtomicBool = AtomicBool::new(false);
/// Was it asked to end?
static ASKED: AtomicBool = AtomicBool::new(false);

/// From now on.
pub(super) fn listen() {
    let end = || {
        let first = !ASKED.swap(true, Ordering::SeqCst);
        if first && FINISHES.load(Ordering::SeqCst) {
            tell!("stopping after this frame; once more to stop at once");
            return;
        }
        // Nobody begins another file before the process is gone. It goes at once: what else is done at an end would take the driver
        // from under the render that is still running, and some drivers crash then.
        let _held = abandon_unfinished();
        exit(i32::from(INTERRUPTED));
    };
    // Where there are no signals to listen to, what is under way ends as the system has it.
    let _ = ctrlc::set_handler(end);
}

/// Frames follow each other: what is in hand is finished before the process ends.
pub(super) fn finish_first() {
    FINISHES.store(true, Ordering::SeqCst);
}

/// Was it asked to end?
pub(super) fn is_asked() -> bool {
    ASKED.load(Ordering::SeqCst)
}
