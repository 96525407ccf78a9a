//! How much time and memory a reader may take.

use std::alloc::System;
use std::panic;
use std::sync::Once;
use std::time::{Duration, Instant};

use cap::Cap;

use super::readers::{LEAST_MIB, Reader};

#[global_allocator]
static MEMORY: Cap<System> = Cap::new(System, usize::MAX);

/// Longer than anything here may be read for.
const LONGEST: Duration = Duration::from_secs(1);

/// Reads these bytes. It ends the process where that takes more memory than it may, and panics where it takes too long.
pub fn within(reader: &Reader, bytes: &[u8]) {
    // What is said of a panic takes memory too, and is not the reader's.
    static SAID: Once = Once::new();
    SAID.call_once(|| {
        let say = panic::take_hook();
        panic::set_hook(Box::new(move |panic| {
            MEMORY.set_limit(usize::MAX).expect("it is above what there is");
            say(panic);
        }));
    });
    let most = (LEAST_MIB << 20) + (reader.kib_per_byte << 10) * bytes.len();
    let mut took = Duration::MAX;
    // Something else may have been busy, but not every time.
    for _ in 0..3 {
        let begun = Instant::now();
        MEMORY.set_limit(MEMORY.allocated() + most).expect("it is above what there is");
        (reader.read)(bytes);
        MEMORY.set_limit(usize::MAX).expect("it is above what there is");
        took = begun.elapsed();
        if took <= LONGEST {
            return;
        }
    }
    panic!("{}: {} bytes took {took:?}", reader.name, bytes.len());
}
