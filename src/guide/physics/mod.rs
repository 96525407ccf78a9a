//! What the pictures of curved spacetimes show, and why: a page for each. Units are such that G = c = 1.
//!
//! | page | its scenes |
//! |---|---|
//! | [`shadow`] | `kerr.toml` |
//! | [`luminet`] | `luminet.toml` |
//! | [`accretion`] | `accretion.toml` |
//! | [`wormhole`] | `ellis.toml`, `wormhole.toml`, `morris_thorne.toml` |
//! | [`warp_bubble`] | `warp_bubble.toml` |
//! | [`charged_holes`] | `two_holes.toml`, `holes_in_expanding_space.toml` |
//! | [`fall`] | `fall.toml` |
//! | [`ergosphere`] | `ergosphere.toml` |
//! | [`motion`] | `passing.toml`, `hot_spot.toml` |

#![allow(clippy::doc_markdown)]

#[doc = include_str!("shadow.md")]
pub mod shadow {}
#[doc = include_str!("luminet.md")]
pub mod luminet {}
#[doc = include_str!("accretion.md")]
pub mod accretion {}
#[doc = include_str!("wormhole.md")]
pub mod wormhole {}
#[doc = include_str!("warp_bubble.md")]
pub mod warp_bubble {}
#[doc = include_str!("charged_holes.md")]
pub mod charged_holes {}
#[doc = include_str!("fall.md")]
pub mod fall {}
#[doc = include_str!("ergosphere.md")]
pub mod ergosphere {}
#[doc = include_str!("motion.md")]
pub mod motion {}
