#![doc = links!()]
#![doc = include_str!("physics.md")]
#![allow(clippy::doc_markdown)]

use super::Page;

/// The list of pages on physics.
pub const CONTENTS: Page =
    Page { name: "physics", about: "what images of curved spacetimes show, and why", text: include_str!("physics.md") };

pages! {
    shadow: "the shadow of a black hole",
    luminet: "Luminet's disk",
    accretion: "an accretion disk in color",
    fall: "a fall through a horizon",
    ergosphere: "in the ergosphere",
    motion: "moving objects are seen where they were",
    wormhole: "through a wormhole",
    charged_holes: "two black holes at rest",
    warp_bubble: "a warp bubble",
}
