//! What a figure is: a picture with its parameters and what was measured in it.

use std::error::Error;

use serde_json::{Map, Value};

use crate::draw::plot::Plot;
use crate::draw::scene::{Scene, View};

/// A figure that can be drawn.
pub(crate) struct Figure {
    /// Names the file.
    pub(crate) id: String,
    pub(crate) title: String,
    draw: Box<dyn Fn() -> Result<Drawing, Box<dyn Error>>>,
}

impl Figure {
    pub(crate) fn new(
        id: impl Into<String>,
        title: impl Into<String>,
        draw: impl Fn() -> Result<Drawing, Box<dyn Error>> + 'static,
    ) -> Self {
        Self { id: id.into(), title: title.into(), draw: Box::new(draw) }
    }

    pub(crate) fn draw(&self) -> Result<Drawing, Box<dyn Error>> {
        (self.draw)()
    }
}

/// The picture of a figure and what is known about it.
pub(crate) struct Drawing {
    pub(crate) picture: Picture,
    /// The shape values, angles and points that make the figure.
    pub(crate) params: Facts,
    /// Numbers that were measured in it.
    pub(crate) facts: Facts,
    /// What one should see, in a sentence or two.
    pub(crate) note: String,
}

/// A picture that is not yet written.
pub(crate) enum Picture {
    Curves(Plot),
    Surfaces(Scene, View),
}

/// Named values in the order in which they were added.
#[derive(Clone, Debug, Default)]
pub(crate) struct Facts(pub(crate) Map<String, Value>);

impl Facts {
    pub(crate) fn with(mut self, name: &str, value: impl Into<Value>) -> Self {
        self.0.insert(name.to_owned(), value.into());
        self
    }

    /// The values as a line of text.
    pub(crate) fn caption(&self) -> String {
        let parts: Vec<String> =
            self.0.iter().map(|(name, value)| format!("{name} = {}", shown(value))).collect();
        parts.join(", ")
    }
}

/// A value as it is written by hand: numbers with few digits, lists in brackets.
pub(crate) fn shown(value: &Value) -> String {
    match value {
        Value::Number(n) if n.is_f64() => number(n.as_f64().unwrap_or(f64::NAN)),
        Value::String(text) => text.clone(),
        Value::Bool(true) => String::from("yes"),
        Value::Bool(false) => String::from("no"),
        Value::Null => String::from("–"),
        Value::Array(values) => {
            let parts: Vec<String> = values.iter().map(shown).collect();
            format!("({})", parts.join(", "))
        }
        other => other.to_string(),
    }
}

/// A number with few digits, its sign as in print.
pub(crate) fn number(x: f64) -> String {
    let text = if x == 0.0 {
        String::from("0")
    } else if (1e-3..1e5).contains(&x.abs()) {
        let text = format!("{x:.4}");
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        format!("{x:.1e}")
    };
    text.replace('-', "−")
}
