//! How a scene's rays are followed, as a text that says all of it: what a picture keeps, and what has another scene follow its rays
//! the same way.

use super::{Override, Rays, Scene, SceneError};
use crate::model::{Control, Method, method};

/// What takes part in it besides the method's own keys, and what only a method that is still to be found has.
const OTHERS: [&str; 4] = ["max_segments", "precision", "closed_forms", "accuracy"];

impl Scene {
    /// Returns the scene with a method that is chosen for it.
    #[must_use]
    pub fn followed_by(&self, method: Method, control: Control, closed_forms: bool) -> Self {
        Self { rays: Rays { auto: None, method, control, closed_forms, ..self.rays.clone() }, ..self.clone() }
    }
}

impl Rays {
    /// The method with all of its settings, and what else of `[rays]` makes the same numbers, as a table of the scene format.
    #[must_use]
    pub fn followed(&self) -> String {
        let mut all = method::settings(self.method, self.control);
        all.push(("max_segments", self.max_segments.to_string()));
        all.push(("precision", format!("\"{}\"", self.precision.name())));
        if self.closed_forms != self.method.kind.closed_forms {
            all.push(("closed_forms", self.closed_forms.to_string()));
        }
        let all: Vec<String> = all.into_iter().map(|(key, value)| format!("{key} = {value}")).collect();
        format!("{{ {} }}", all.join(", "))
    }
}

/// Keys of `[rays]` that say how rays are followed.
pub fn followed_keys() -> impl Iterator<Item = &'static str> {
    method::setting_keys().into_iter().chain(OTHERS)
}

/// What has a scene follow its rays as [`Rays::followed`] says, whatever it says itself.
pub fn follow_as(followed: &str) -> Result<Vec<Override>, SceneError> {
    let wrong = || SceneError::Override(format!("`{followed}` does not say how rays are followed"));
    let table: toml::Table = toml::from_str(&format!("rays = {followed}")).map_err(|_| wrong())?;
    let said = table.get("rays").and_then(toml::Value::as_table).filter(|said| said.contains_key("method"));
    let known: Vec<&str> = followed_keys().collect();
    let mut all: Vec<Override> = known.iter().map(|key| Override::without("rays", key)).collect();
    for (key, value) in said.ok_or_else(wrong)? {
        if !known.contains(&key.as_str()) {
            return Err(wrong());
        }
        all.push(format!("rays.{key}={value}").parse()?);
    }
    Ok(all)
}
