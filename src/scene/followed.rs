//! A text with all settings of a scene's ray integration, which an image stores, so that another scene can use identical settings.

use super::{Override, Rays, Scene, SceneError};
use crate::model::{Control, Method, method};

/// The keys in addition to those of the method, including a key that only an automatic choice of method has.
const OTHERS: [&str; 4] = ["max_segments", "precision", "closed_forms", "accuracy"];

impl Scene {
    /// Returns the scene with a method chosen for it.
    #[must_use]
    pub fn followed_by(&self, method: Method, control: Control, closed_forms: bool) -> Self {
        Self { rays: Rays { auto: None, method, control, closed_forms, ..self.rays.clone() }, ..self.clone() }
    }
}

impl Rays {
    /// Returns the method with all of its settings, and the other keys of `[rays]` that affect the results, as a table of the scene format.
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

/// Returns the keys of `[rays]` that affect the integration of rays.
pub fn followed_keys() -> impl Iterator<Item = &'static str> {
    method::setting_keys().into_iter().chain(OTHERS)
}

/// Returns the overrides that give a scene the settings of [`Rays::followed`], whatever it specifies.
///
/// # Errors
///
/// Returns [`SceneError::Override`] if `followed` is not a text of [`Rays::followed`].
pub fn follow_as(followed: &str) -> Result<Vec<Override>, SceneError> {
    let wrong = || SceneError::Override(format!("`{followed}` does not describe the integration of rays"));
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
