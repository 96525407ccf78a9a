//! The limit on the triangles of a mesh. A file with more is rejected as soon as its header, or the part read so far, shows it.
//!
//! *Practice.* Listing the devices takes longer than reading a small mesh, so the
//! list is requested only when a mesh has more triangles than every device can hold.

use std::fmt;
use std::sync::{Arc, OnceLock};

use crate::assets::format_error::FormatError;

/// The largest number of triangles that a mesh may have. Clones share the answer.
#[derive(Clone, Default)]
pub struct Capacity(Option<Arc<Asked>>);

struct Asked {
    always: u64,
    ask: Box<dyn Fn() -> Option<Held> + Send + Sync>,
    answer: OnceLock<Option<Held>>,
}

/// The number of triangles that a device can hold.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Held {
    /// The device's name.
    pub device: String,
    /// The number of triangles of all meshes together.
    pub triangles: u64,
}

impl fmt::Debug for Capacity {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.debug_tuple("Capacity").field(&self.0.as_ref().map(|asked| asked.always)).finish()
    }
}

impl Capacity {
    /// Creates a capacity that calls `ask` when a mesh has more than `always` triangles; if `ask` returns `None`, there is no limit.
    pub fn new(always: u64, ask: impl Fn() -> Option<Held> + Send + Sync + 'static) -> Self {
        Self(Some(Arc::new(Asked { always, ask: Box::new(ask), answer: OnceLock::new() })))
    }

    /// Checks the number of triangles that a file has, or that have been read from it so far.
    pub(super) fn check(&self, triangles: u64) -> Result<(), FormatError> {
        let Some(asked) = self.0.as_ref().filter(|asked| triangles > asked.always) else { return Ok(()) };
        match asked.answer.get_or_init(|| (asked.ask)()) {
            Some(Held { device, triangles: most }) if triangles > *most => Err(FormatError(format!(
                "the mesh has {triangles} or more triangles, and {device} supports at most {most}; use a coarser \
                 mesh, or another device"
            ))),
            _ => Ok(()),
        }
    }
}
