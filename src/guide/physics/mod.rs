#![doc = links!()]
#![doc = include_str!("physics.md")]
#![allow(clippy::doc_markdown)]

use super::Page;

/// What there is on physics.
pub const CONTENTS: Page = Page {
    name: "physics",
    about: "what pictures of curved spacetimes show, and why",
    text: include_str!("physics.md"),
};

pages! {
    shadow: "the shadow of a black hole",
    luminet: "Luminet's disc",
    accretion: "a disc in colour",
    wormhole: "through a wormhole",
    warp_bubble: "a warp bubble",
    charged_holes: "two black holes at rest",
    fall: "a fall through a horizon",
    ergosphere: "in the ergosphere",
    motion: "what moves is seen where it was",
}
