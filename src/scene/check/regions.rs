//! Interiors that overlap: which of them is there has to be said.

use crate::scene::Object;

/// What is wrong with the interiors, and what would be right.
pub fn ambiguous(objects: &[Object]) -> Option<(String, String)> {
    const MOST: usize = 32;
    let count = objects.iter().filter(|object| object.interior().is_some()).count();
    if count > MOST {
        let problem = format!("{count} objects with an interior are more than {MOST}, which a ray can be in at once");
        return Some((problem, "make one mesh of those that have the same medium".to_owned()));
    }
    None
}
