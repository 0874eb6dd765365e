//! Values in arguments: names with numbers, ranges and points, and what is wrong with those that cannot be read.

use basis_engine::algebra::rational::{self, Rational, ToFloat as _};

use crate::eval::number::Number;

/// A name with its values, such as `t=1/2`, `θ=pi/3` or `t=0..1:1/10`.
#[derive(Clone, Debug)]
pub(crate) struct Axis {
    /// The name as it is typed.
    pub(crate) name: String,
    /// The values.
    pub(crate) values: Vec<Number>,
    /// Whether they are given by their ends and a step.
    pub(crate) stepped: bool,
}

/// More values than this are not made of one step.
const MAX_STEPS: i64 = 100_000;

/// A name with one value, or with several from one to another in steps.
pub(super) fn axis(text: &str) -> Result<Axis, String> {
    let (name, value) = named(text)?;
    let number = |text: &str| Number::parse(text.trim()).ok_or_else(|| inexact(text.trim()));
    let Some((low, rest)) = value.split_once("..") else {
        return Ok(Axis { name: name.to_string(), values: vec![number(value)?], stepped: false });
    };
    let rest = rest.strip_prefix('=').unwrap_or(rest);
    let Some((high, step)) = rest.split_once(':') else {
        return Err(format!("the step is missing; write it after a colon, as in {name}={low}..{rest}:1/10"));
    };
    let (low, high, step) = (number(low)?, number(high)?, number(step)?);
    if !step.value().is_positive() {
        return Err(format!(
            "the step {step} is not positive; values go from the smaller to the greater one"
        ));
    }
    let most = step.steps(&low, &high).filter(|most| *most < MAX_STEPS);
    match most {
        Some(most) if most >= 0 => {
            let values = (0..=most).map(|k| low.plus(&step, k)).collect();
            Ok(Axis { name: name.to_string(), values, stepped: true })
        }
        Some(_) => Err(format!("the range {low}..{high} is empty; write the smaller value first")),
        None => Err(format!("there are more than {MAX_STEPS} steps of {step} from {low} to {high}")),
    }
}

/// A shape parameter with what it is drawn for.
#[derive(Clone, Debug)]
pub(crate) struct ShapeArgument {
    /// The name as it is typed.
    pub(crate) name: String,
    /// One value, or several.
    pub(crate) values: ShapeValues,
}

/// The values of a shape parameter.
#[derive(Clone, Debug)]
pub(crate) enum ShapeValues {
    /// One.
    One(Number),
    /// Several, from one to another.
    Between(Number, Number),
}

/// A shape parameter with one value or a range of them: `λ=1/2`, `λ=-3..1`.
pub(super) fn shape(text: &str) -> Result<ShapeArgument, String> {
    let exact = |value: &str| Number::parse(value).ok_or_else(|| inexact(value));
    let Some((left, right)) = text.split_once("..") else {
        let (name, value) = named(text)?;
        return Ok(ShapeArgument { name: name.to_string(), values: ShapeValues::One(exact(value)?) });
    };
    let (name, low) = named(left)?;
    let (name, low) = (name.to_string(), exact(low)?);
    let right = right.strip_prefix('=').unwrap_or(right).trim();
    let high = Number::parse(right).ok_or_else(|| {
        format!("`{right}` is not an exact number; a range of values is written {name}=-3..1")
    })?;
    if low.value() >= high.value() {
        return Err(format!("the range {low}..{high} is empty; write the smaller value first"));
    }
    Ok(ShapeArgument { name, values: ShapeValues::Between(low, high) })
}

/// A point of the plane: `1,2`.
pub(super) fn point(text: &str) -> Result<[f64; 2], String> {
    let wrong = || {
        format!(
            "`{text}` is not a point; write two numbers with a comma, and spaces between points: \"0,0 1,2\""
        )
    };
    let (x, y) = text.split_once(',').ok_or_else(wrong)?;
    let number = |text: &str| rational::parse(text.trim()).map(|x| x.to_f64()).filter(|x| x.abs() < 1e12);
    Ok([number(x).ok_or_else(wrong)?, number(y).ok_or_else(wrong)?])
}

/// The highest order of derivatives.
pub(super) fn order(text: &str) -> Result<u32, String> {
    text.parse()
        .map_err(|_| String::from("the highest order of derivatives is a whole number, such as 0 or 2"))
}

/// A name and what stands after its `=`.
fn named(text: &str) -> Result<(&str, &str), String> {
    let Some((name, value)) = text.split_once('=') else {
        let comma = if rational::parse(text).is_some() {
            "; decimals are written with a point, as in t=0.5"
        } else {
            ""
        };
        return Err(format!("write a name and its value, such as t=1/2{comma}"));
    };
    let (name, value) = (name.trim(), value.trim());
    if name.is_empty() {
        return Err(String::from("the name is missing; write it before the `=`, as in t=1/2"));
    }
    if value.is_empty() {
        return Err(format!("the value is missing; write it after the `=`, as in {name}=1/2"));
    }
    Ok((name, value))
}

/// What is wrong with a value that is no number.
fn inexact(value: &str) -> String {
    if divides_by_zero(value) {
        return format!("`{value}` divides by zero");
    }
    if let Some(radians) = in_radians(value) {
        return format!("`{value}` is in degrees, and angles are in radians; write {radians}");
    }
    format!(
        "`{value}` is not an exact number; write a whole number, a fraction or a decimal, such as 2, -1/3 or 0.62"
    )
}

/// `pi/4` for `45deg` or `45°`.
fn in_radians(value: &str) -> Option<String> {
    let degrees = ["degrees", "deg", "°"].iter().find_map(|unit| value.strip_suffix(unit))?;
    let turns = rational::parse(degrees.trim())?.checked_div(&Rational::from(180))?;
    let (above, below) = (turns.numer(), turns.denom());
    let factor = match above.to_string().as_str() {
        "0" => return Some(String::from("0")),
        "1" => String::new(),
        "-1" => String::from("-"),
        factor => format!("{factor}*"),
    };
    let below = if below.is_one() { String::new() } else { format!("/{below}") };
    Some(format!("{factor}pi{below}"))
}

fn divides_by_zero(value: &str) -> bool {
    value.split_once('/').is_some_and(|(numer, denom)| {
        rational::parse(numer).is_some() && rational::from_decimal(denom.trim()).is_some_and(|d| d.is_zero())
    })
}
