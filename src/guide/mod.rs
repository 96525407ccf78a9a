//! The guide: what a user needs to know, a page for each subject.
//!
//! | page | of what |
//! |---|---|
//! | [`physics`] | what the pictures of curved spacetimes show, and why |

pub mod physics;
