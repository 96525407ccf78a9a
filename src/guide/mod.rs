//! The guide: what a user needs to know, a page for each subject.
//!
//! *Idea.* A page is a Markdown file beside this one. One list makes it a module here, to be read in a browser, and a [`Page`], which
//! `bentray help` prints.
//!
//! | page | of what |
//! |---|---|
//! | [`scenes`] | the format, objects, materials, cameras, `--set`, and the scenes that are here |
//! | [`laws`] | how light travels: forces, flows, curves |
//! | [`media`] | glass, lenses and air; surfaces that refract |
//! | [`light`] | lamps, shadows, light from surface to surface, filters, dispersion |
//! | [`spacetimes`] | holes, observers, discs, wormholes, line elements, motion |
//! | [`accuracy`] | the automatic choice, methods, charts, checks |
//! | [`films`] | frames, large pictures, more samples later |
//! | [`diagrams`] | rays as tables and drawings |
//! | [`layers`] | what an EXR holds, and how to read it |
//! | [`performance`] | what the numbers mean, samples, schedules, benchmarks |
//! | [`scripts`] | results as JSON: what each key is |
//! | [`extending`] | laws of your own, the library, adding a kind |
//! | [`physics`] | what pictures of curved spacetimes show, and why: a page for each |

#![allow(clippy::doc_markdown)]

/// A page of the guide.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Page {
    /// Its topic, which is its file's name and its module's.
    pub name: &'static str,
    /// What it is of, in a few words.
    pub about: &'static str,
    /// All of it, as Markdown.
    pub text: &'static str,
}

/// Makes a module of each Markdown file beside the one that calls this, and lists them as [`Page`]s.
macro_rules! pages {
    ($($name:ident: $about:literal,)*) => {
        $(
            #[doc = include_str!(concat!(stringify!($name), ".md"))]
            pub mod $name {}
        )*

        /// The pages of this folder, in the order to read them in.
        pub const PAGES: &[$crate::guide::Page] = &[$($crate::guide::Page {
            name: stringify!($name),
            about: $about,
            text: include_str!(concat!(stringify!($name), ".md")),
        }),*];
    };
}

pub mod physics;

pages! {
    scenes: "the format, objects, materials, cameras, --set, and the scenes that are here",
    laws: "how light travels: forces, flows, curves",
    media: "glass, lenses and air; surfaces that refract",
    light: "lamps, shadows, light from surface to surface, filters, dispersion",
    spacetimes: "holes, observers, discs, wormholes, line elements, motion",
    accuracy: "the automatic choice, methods, charts, checks",
    films: "frames, large pictures, more samples later",
    diagrams: "rays as tables and drawings",
    layers: "what an EXR holds, and how to read it",
    performance: "what the numbers mean, samples, schedules, benchmarks",
    scripts: "results as JSON: what each key is",
    extending: "laws of your own, the library, adding a kind",
}

/// Every page: those of the guide, then those on physics.
pub fn pages() -> impl Iterator<Item = &'static Page> {
    PAGES.iter().chain([&physics::CONTENTS]).chain(physics::PAGES)
}

#[cfg(doctest)]
#[doc = include_str!("../../README.md")]
mod readme {}
