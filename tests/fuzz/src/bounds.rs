//! How much time and memory a reader may take.

use std::alloc::System;
use std::panic;
use std::sync::Once;
use std::time::{Duration, Instant};

use cap::Cap;

use super::readers::{LEAST_MIB, Reader};

#[global_allocator]
static MEMORY: Cap<System> = Cap::new(System, usize::MAX);

/// The limit of time for any reader.
const LONGEST: Duration = Duration::from_secs(1);

/// Reads these bytes. Ends the process if the reader exceeds its memory limit, and panics if it exceeds its time limit.
pub fn within(reader: &Reader, bytes: &[u8]) {
    // The message of a panic also takes memory, which does not count for the reader.
    static SAID: Once = Once::new();
    SAID.call_once(|| {
        let say = panic::take_hook();
        panic::set_hook(Box::new(move |panic| {
            MEMORY.set_limit(usize::MAX).expect("the limit is above the memory in use");
            say(panic);
        }));
    });
    let most = (LEAST_MIB << 20) + (reader.kib_per_byte << 10) * bytes.len();
    let mut took = Duration::MAX;
    // Other programs may delay one attempt, but hardly all of them.
    for _ in 0..3 {
        let begun = Instant::now();
        MEMORY.set_limit(MEMORY.allocated() + most).expect("the limit is above the memory in use");
        (reader.read)(bytes);
        MEMORY.set_limit(usize::MAX).expect("the limit is above the memory in use");
        took = begun.elapsed();
        if took <= LONGEST {
            return;
        }
    }
    panic!("{}: {} bytes took {took:?}", reader.name, bytes.len());
}
