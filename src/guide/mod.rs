//! The user's guide, a page for each subject.
//!
//! *Idea.* A page is a Markdown file beside this one. One list makes it a module here, to be read in a browser, and a [`Page`], which
//! `bentray help` prints.
//!
//! | page | contents |
//! |---|---|
//! | [`scenes`] | the file format, objects, materials, cameras, `--set`, and the sample scenes |
//! | [`laws`] | how light travels: forces, flows, curves |
//! | [`media`] | glass, lenses and air; surfaces that refract |
//! | [`light`] | lights, shadows, path tracing, absorption, dispersion |
//! | [`spacetimes`] | black holes, observers, disks, wormholes, custom metrics, motion |
//! | [`accuracy`] | choosing a method automatically, charts, checks |
//! | [`films`] | animation, large images, distributed rendering, adding samples later |
//! | [`diagrams`] | rays as tables and diagrams |
//! | [`layers`] | the layers of an EXR, and how to read them |
//! | [`performance`] | program output, sampling, memory, kernel scheduling, benchmarks |
//! | [`scripts`] | results as JSON: the meaning of each key |
//! | [`extending`] | custom laws, the library, adding a kind |
//! | [`physics`] | what images of curved spacetimes show, and why: a page for each |

#![allow(clippy::doc_markdown)]
// Pages name the file that a link leads to; `links` names the module for rustdoc, though it would find some by itself.
#![allow(rustdoc::redundant_explicit_links)]

/// A page of the guide.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Page {
    /// The topic, which is the name of the file and of the module.
    pub name: &'static str,
    /// The contents, in a few words.
    pub about: &'static str,
    /// The page in Markdown.
    pub text: &'static str,
}

/// Where links between pages lead in a browser's documentation. A page's own definitions, at its end, lead to files; of two
/// definitions Markdown takes the first.
macro_rules! links {
    () => {
        "\
         [`scenes`]: crate::guide::scenes\n\
         [`laws`]: crate::guide::laws\n\
         [`media`]: crate::guide::media\n\
         [`light`]: crate::guide::light\n\
         [`spacetimes`]: crate::guide::spacetimes\n\
         [`accuracy`]: crate::guide::accuracy\n\
         [`films`]: crate::guide::films\n\
         [`diagrams`]: crate::guide::diagrams\n\
         [`layers`]: crate::guide::layers\n\
         [`performance`]: crate::guide::performance\n\
         [`scripts`]: crate::guide::scripts\n\
         [`extending`]: crate::guide::extending\n\
         [`physics`]: crate::guide::physics\n\
         [`shadow`]: crate::guide::physics::shadow\n\
         [`luminet`]: crate::guide::physics::luminet\n\
         [`accretion`]: crate::guide::physics::accretion\n\
         [`wormhole`]: crate::guide::physics::wormhole\n\
         [`warp_bubble`]: crate::guide::physics::warp_bubble\n\
         [`charged_holes`]: crate::guide::physics::charged_holes\n\
         [`fall`]: crate::guide::physics::fall\n\
         [`ergosphere`]: crate::guide::physics::ergosphere\n\
         [`motion`]: crate::guide::physics::motion\n\
         "
    };
}

/// Makes a module of each Markdown file beside the one that calls this, and lists them as [`Page`]s.
macro_rules! pages {
    ($($name:ident: $about:literal,)*) => {
        $(
            #[doc = links!()]
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
    scenes: "the file format, objects, materials, cameras, --set, and the sample scenes",
    laws: "how light travels: forces, flows, curves",
    media: "glass, lenses and air; surfaces that refract",
    light: "lights, shadows, path tracing, absorption, dispersion",
    spacetimes: "black holes, observers, disks, wormholes, custom metrics, motion",
    accuracy: "choosing a method automatically, charts, checks",
    films: "animation, large images, distributed rendering, adding samples later",
    diagrams: "rays as tables and diagrams",
    layers: "the layers of an EXR, and how to read them",
    performance: "program output, sampling, memory, kernel scheduling, benchmarks",
    scripts: "results as JSON: the meaning of each key",
    extending: "custom laws, the library, adding a kind",
}

impl Page {
    /// Returns the page as a terminal shows it: links to other pages are the commands that print those.
    #[must_use]
    pub fn shown(&self) -> String {
        let (text, links) = self.text.rsplit_once("\n\n").unwrap_or((self.text, ""));
        let links: Option<Vec<&str>> =
            links.lines().map(|line| Some(line.strip_prefix("[`")?.split_once("`]: ")?.0)).collect();
        let Some(links) = links else { return self.text.to_owned() };
        let mut shown = text.to_owned() + "\n";
        for name in links {
            let command = format!("`bentray help {name}`");
            shown = shown
                .replace(&format!("][`{name}`]"), &format!("] ({command})"))
                .replace(&format!("[`{name}`]"), &command);
        }
        shown
    }
}

/// Every page: those of the guide, then those on physics.
pub fn pages() -> impl Iterator<Item = &'static Page> {
    PAGES.iter().chain([&physics::CONTENTS]).chain(physics::PAGES)
}

#[cfg(doctest)]
#[doc = include_str!("../../README.md")]
mod readme {}

#[cfg(test)]
mod tests {
    use super::*;

    /// A page that is missing there would have rustdoc lead to a file that it does not write.
    #[test]
    fn links_name_the_module_of_every_page() {
        let is_named = |page: &Page, module: &str| links!().contains(&format!("[`{0}`]: {module}::{0}\n", page.name));
        assert!(PAGES.iter().chain([&physics::CONTENTS]).all(|page| is_named(page, "crate::guide")));
        assert!(physics::PAGES.iter().all(|page| is_named(page, "crate::guide::physics")));
    }
}
