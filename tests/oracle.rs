//! (see suite.rs)
