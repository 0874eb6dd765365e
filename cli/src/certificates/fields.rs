//! Reads JSON strictly: every field is expected, and nothing else is there.

use serde_json::{Map, Value};

/// The fields of an object that have not been read yet.
pub(super) struct Fields<'j> {
    left: Vec<(&'j str, &'j Value)>,
}

impl<'j> Fields<'j> {
    /// Those of an object.
    pub(super) fn of(value: &'j Value) -> Result<Self, String> {
        let object: &Map<String, Value> = value.as_object().ok_or("an object is expected")?;
        Ok(Self { left: object.iter().map(|(k, v)| (k.as_str(), v)).collect() })
    }

    /// A field that must be there.
    pub(super) fn take(&mut self, name: &str) -> Result<&'j Value, String> {
        self.take_if_any(name).ok_or_else(|| format!("`{name}` is missing"))
    }

    /// A field that may be there.
    pub(super) fn take_if_any(&mut self, name: &str) -> Option<&'j Value> {
        let at = self.left.iter().position(|(k, _)| *k == name)?;
        Some(self.left.remove(at).1)
    }

    /// A text that must be there.
    pub(super) fn text(&mut self, name: &str) -> Result<&'j str, String> {
        self.take(name)?.as_str().ok_or_else(|| format!("`{name}` is not a text"))
    }

    /// A list that must be there.
    pub(super) fn list(&mut self, name: &str) -> Result<&'j [Value], String> {
        list(self.take(name)?).map_err(|_| format!("`{name}` is not a list"))
    }

    /// Texts that must be there.
    pub(super) fn texts(&mut self, name: &str) -> Result<Vec<&'j str>, String> {
        self.list(name)?
            .iter()
            .map(|v| v.as_str().ok_or_else(|| format!("`{name}` is not a list of texts")))
            .collect()
    }

    /// An error if a field has not been read.
    pub(super) fn end(self) -> Result<(), String> {
        match self.left.first() {
            None => Ok(()),
            Some((name, _)) => Err(format!("`{name}` does not belong here")),
        }
    }
}

/// A list.
pub(super) fn list(value: &Value) -> Result<&[Value], String> {
    value.as_array().map(Vec::as_slice).ok_or_else(|| String::from("a list is expected"))
}

/// A text.
pub(super) fn text(value: &Value) -> Result<&str, String> {
    value.as_str().ok_or_else(|| String::from("a text is expected"))
}

/// A position in a list.
pub(super) fn position(value: &Value) -> Result<usize, String> {
    let number = value.as_u64().and_then(|k| usize::try_from(k).ok());
    number.ok_or_else(|| String::from("a whole number that is not negative is expected"))
}
