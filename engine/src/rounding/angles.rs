//! Coordinates and tangents: the inputs of values that come out of sines, exponentials and the like, and how far they are
//! off.
//!
//! The values of a family with angles or exponentials are quotients of polynomials in two coordinates s and x, products of
//! numbers and a sine or an exponential of the distance from an end of the domain, and in tangents of shape parameters.
//! Each of them is computed as its exact value times 1 + δ, |δ| ≤ w u, and has a share in the error as roundings have.
//!
//! A quotient of degree 0 is the same for all multiples of s and x. So it is enough to look at s = 1 − y, x = y, 0 ≤ y
//! ≤ 1, and what both coordinates are off by has no share, such as the error of a sine by which both are divided.
//!
//! The numbers w are sums of what is assumed of elementary functions, [`ULP`], of the roundings, and of relative errors of
//! arguments times |d ln f/d ln a|, which is at most
//!
//! - 1 for sin a, |a| ≤ 2, and for exp(−2a) − 1, a ≥ 0; 1 + 2a for exp(2a) − 1;
//! - |a tan a| for cos a, |2a| for exp(−2a);
//! - 1 + tan² a for tan a, and π/2 for |a| ≤ π/4.
//!
//! What is of higher order in them is less than w² 2⁻²⁰ u. They hold for the steps and for `Chart` of the runtime, which
//! has the ends of a domain in two parts instead of three.

use super::exact::{is_float, is_power_of_two};
use super::{Inputs, least_multiple, rest};
use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::{Range, Region};
use crate::algebra::rational::Rational;
use crate::model::angle::{Analytic, Angle, Kind};
use crate::model::{Family, Parameter};
use crate::plan::Input;
use crate::plan::interval::form::RationalForm;
use crate::plan::interval::rational;
use crate::steps::{Builder, Function, Step, Steps, elementary};
use basis_prover::collections::list::{Listed, Mapped};

/// How many u the sine, cosine, exponential and `exp_m1` of the standard library of a language are off: one unit in the
/// last place, which is at most 2u of the value.
const ULP: i64 = 2;

/// The tangent, which the runtime computes as a quotient of sine and cosine.
const TANGENT: i64 = 2 * ULP + 1;

/// The hyperbolic tangent, which the runtime computes as −e/(2 + e), e = exp(−2x) − 1.
const HYPERBOLIC: i64 = 2 * ULP + 2;

/// The distance from an end that is no float: three roundings, or near the end two and those of its parts.
const TO_A_NUMBER: i64 = 3;

/// What bounds assume of the elementary functions of a language, for families that need these.
pub const ASSUMED: &str = "as long as sines, cosines, tangents and exponentials of the library are within one unit in the last place, hyperbolic tangents within two; the float next to an end of the domain that is none, such as pi/2, is taken for that end";

/// Whether the values of a family are computed by elementary functions, so that bounds assume something of these.
pub fn needs_functions(family: &Family) -> bool {
    let pieces = family.pieces.iter().map(|piece| &**piece);
    pieces.chain([family]).any(|piece| piece.analytic.is_transcendental())
}

/// The values on a span as steps whose inputs are the coordinates and the tangents.
pub(super) struct OnCoordinates {
    pub(super) steps: Steps,
    pub(super) inputs: Inputs,
    /// Whether a float is compared with the lower end as it is.
    pub(super) starts_at_float: bool,
}

/// An end of a domain.
struct End {
    /// Of a number.
    known: Option<Rational>,
    /// How many u the distance from it is off.
    distance: i64,
}

/// How many u something is off.
fn u(count: i64) -> Rational {
    Rational::from(count)
}

impl OnCoordinates {
    /// `None` where nothing is known of how far the coordinates or tangents are off.
    pub(super) fn new(family: &Family, form: &RationalForm) -> Option<Self> {
        let steps = values(family, form);
        let angle = family.analytic.angle(form.numerators.var);
        let ends = match angle {
            Some(angle) => [end(family, angle, 0)?, end(family, angle, 1)?],
            None => [&form.numerators.low, &form.numerators.high].map(|end| number(end.clone())),
        };
        // Polynomials on a domain that ends at shape parameters: the runtime evaluates them in another association.
        if !form.divides(family) {
            return None;
        }
        let off = match angle.filter(|angle| angle.kind != Kind::Linear) {
            Some(_) if !is_homogeneous(&steps) => return None,
            Some(angle) if angle.kind == Kind::Circular => circular(angle, &ends)?,
            Some(angle) => hyperbolic(angle, &ends)?,
            None => linear(&ends),
        };
        let starts_at_float = ends[0].distance < TO_A_NUMBER;
        Some(Self { inputs: inputs(family, &steps, &off)?, steps, starts_at_float })
    }
}

/// The values of all functions from the coordinates s and x and the tangents of shape parameters.
fn values(family: &Family, form: &RationalForm) -> Steps {
    let mut builder = Builder::without_scales();
    if !form.is_tabulated {
        let outputs = builder.plan(&rational::values(family, form));
        return builder.finish(&outputs);
    }
    let entries = builder.plan(&rational::numerators(family, form));
    let count = form.numerators.len().max(1);
    let [s, x] = [0, 1].map(|k| builder.input(Input::Coordinate(k)));
    let mut outputs = Vec::new();
    for k in 0..form.numerators.len() {
        let column = entries.chunks(count).map(|row| row[k]).listed();
        let value = builder.bernstein(&column, s, x);
        outputs.push(if family.nonnegative.get(k) == Some(&true) { builder.cut_off(value) } else { value });
    }
    builder.finish(&outputs)
}

/// The inputs of the steps; `None` where a shape parameter stands beside its tangent, or nothing is known of a tangent.
fn inputs(family: &Family, steps: &Steps, coordinates: &[Rational; 2]) -> Option<Inputs> {
    let angles = &family.analytic.angles;
    let shapes = family.shapes.len();
    let mut ranges: Vec<(Var, Range)> = family.shapes.mapped(|p| (p.var, p.range.clone()));
    let first = ranges.iter().map(|(v, _)| v.0 + 1).max().unwrap_or(0);
    let y = Var(first);
    ranges.push((y, Range::unit()));
    let mut off = Vec::new();
    for input in steps.inputs() {
        let (value, weight) = match input {
            Input::Coordinate(0) => (&Poly::one() - &Poly::var(y), coordinates[0].clone()),
            Input::Coordinate(_) => (Poly::var(y), coordinates[1].clone()),
            Input::Shape(k) if k >= shapes => {
                let (part, angle) = ((k - shapes) / angles.len(), &angles[(k - shapes) % angles.len()]);
                let parameter = family.shapes.iter().find(|p| p.var == angle.var)?;
                tangent(angle, parameter, part)?
            }
            Input::Shape(k) => {
                let angle = family.analytic.angle(family.shapes[k].var);
                if angle.is_some_and(|angle| angle.kind != Kind::Linear) {
                    return None;
                }
                continue;
            }
            _ => return None,
        };
        off.push((input, value, in_all(&weight)));
    }
    let shapes = family.shapes.mapped(|p| p.var);
    Some(Inputs {
        region: Region { ranges },
        shapes,
        coordinates: vec![y],
        points: Vec::new(),
        ones: false,
        off,
    })
}

/// With what is of higher order, rounded up to a number of few digits.
fn in_all(weight: &Rational) -> Rational {
    let small = &(weight * &rest::unit()) * &Rational::from(16);
    least_multiple(&(weight * &(&Rational::ONE + &small)), 256)
}

/// A tangent x, or 1 − x, or 1 + x, with how many u it is off.
fn tangent(angle: &Angle, parameter: &Parameter, part: usize) -> Option<(Poly, Rational)> {
    let x = Poly::var(angle.var);
    if !angle.low.is_zero() || !angle.width.as_constant()?.is_one() {
        return None;
    }
    let is_exact = is_power_of_two(&angle.speed());
    let value = match part {
        0 => x,
        1 => &Poly::one() - &x,
        _ => &Poly::one() + &x,
    };
    let own = match (angle.kind, part) {
        (Kind::Circular, 0) if is_exact => u(TANGENT),
        (Kind::Circular, 0) => {
            let (low, high) = parameter.range.finite()?;
            let most = if low.abs() > high.abs() { low.abs() } else { high.abs() };
            &u(TANGENT) + &(&u(2) * &(&Rational::ONE + &(&most * &most)))
        }
        // tan(π/4 − a)·(1 + tan a), 0 ≤ tan a ≤ 1
        (Kind::Circular, _) => {
            let (low, high) = parameter.range.finite()?;
            if !is_exact || low.is_negative() || *high > Rational::ONE {
                return None;
            }
            let of_distance = &u(TO_A_NUMBER) * &Rational::new(11, 7);
            let of_sum = &(&u(TANGENT) * &Rational::new(1, 2)) + &Rational::ONE;
            &(&of_distance + &of_sum) + &u(TANGENT + 1)
        }
        (_, 0) => u(HYPERBOLIC + if is_exact { 0 } else { 2 }),
        // 2/(2 + e), of which e is at most all.
        _ if is_exact => u(ULP + 2),
        _ => return None,
    };
    Some((value, own))
}

/// A number as an end.
fn number(value: Rational) -> End {
    let distance = match () {
        () if value.is_zero() => 0,
        () if is_float(&value) => 1,
        () => TO_A_NUMBER,
    };
    End { known: Some(value), distance }
}

/// An end that is a number, or a multiple of a shape parameter by a power of 2; `None` for any other one, of which the
/// float may be farther off than the parameter is from it.
fn end(family: &Family, angle: &Angle, k: usize) -> Option<End> {
    let limit = &angle.limits[k];
    if let Some(value) = family.analytic.number(limit) {
        return Some(number(value));
    }
    let form = limit.as_poly()?;
    let (monomial, c) = form.leading_term()?;
    let is_float = form.len() == 1 && monomial.total_degree() == 1 && is_power_of_two(c);
    is_float.then_some(End { known: None, distance: 1 })
}

/// ψ at an end that is a number.
fn turn(angle: &Angle, end: &Rational) -> Rational {
    let shift = if angle.turns { angle.shift.clone() } else { &angle.shift * &Analytic::pi() };
    &angle.speed() * &(end - &shift)
}

/// How many u the arguments of the functions are off, which are the rate times the distances from both ends.
fn arguments(angle: &Angle, ends: &[End; 2]) -> [i64; 2] {
    let by_rate = if is_power_of_two(&angle.speed()) { 0 } else { 2 };
    ends.each_ref().map(|end| end.distance + by_rate)
}

/// s = sin b cos ψ0, x = sin a cos ψ1, up to a common factor.
fn circular(angle: &Angle, ends: &[End; 2]) -> Option<[Rational; 2]> {
    let of_ends = ends.each_ref().map(|end| end.known.as_ref().map(|end| turn(angle, end)));
    match &of_ends {
        [Some(low), Some(high)] if high - low <= u(2) => {}
        // The other end is less than π/2.
        [Some(low), None] if !low.is_negative() => {}
        _ => return None,
    }
    let is_exact = is_power_of_two(&angle.speed());
    // A cosine times a power of two, with the product.
    let factor = |end: &Option<Rational>| match end {
        Some(end) if end.is_zero() => Some(u(0)),
        Some(end) => Some(&of_cosine(end)? + &u(ULP + 1)),
        None => is_exact.then(|| u(ULP + 1)),
    };
    let [after, before] = arguments(angle, ends);
    Some([&u(before + ULP) + &factor(&of_ends[0])?, &u(after + ULP) + &factor(&of_ends[1])?])
}

/// A bound of |ψ tan ψ|.
fn of_cosine(psi: &Rational) -> Option<Rational> {
    if psi.abs() > Rational::new(3, 2) {
        return None;
    }
    let product = &elementary(Function::Tan, psi)? * psi;
    Some(&product.abs() + &rest::unit())
}

/// s = (1 − exp(−2b))·(1 + exp(−2ψ0)), x = (exp(2a) − 1)·(1 + exp(−2ψ1)), up to a common factor.
fn hyperbolic(angle: &Angle, ends: &[End; 2]) -> Option<[Rational; 2]> {
    let of_ends = ends.each_ref().map(|end| end.known.as_ref().map(|end| turn(angle, end)));
    let is_exact = is_power_of_two(&angle.speed());
    // 2 + e, e = exp(−2ψ) − 1, times a power of two, with the product
    let factor = |end: &Option<Rational>| match end {
        Some(end) if end.is_zero() => Some(u(0)),
        Some(end) => Some(&u(ULP + 2) + &(&end.abs() * &u(2))),
        None => is_exact.then(|| u(ULP + 2)),
    };
    let [after, before] = arguments(angle, ends);
    let mut risen = u(after + ULP);
    if after > 0 {
        let [Some(low), Some(high)] = &of_ends else { return None };
        risen += &(&(high - low) * &u(2 * after));
    }
    Some([&u(before + ULP) + &factor(&of_ends[0])?, &risen + &factor(&of_ends[1])?])
}

/// The distances from both ends, divided by the width; their sum is 1, so that the width counts.
fn linear(ends: &[End; 2]) -> [Rational; 2] {
    let width = match ends {
        _ if ends.iter().any(|end| end.distance == TO_A_NUMBER) => 4,
        [End { known: Some(low), .. }, End { known: Some(high), .. }] if is_power_of_two(&(high - low)) => 0,
        [End { distance: 0, .. }, _] => 1,
        _ => 2,
    };
    [u(ends[1].distance + width), u(ends[0].distance + width)]
}

/// Whether all values are quotients of degree 0 in the coordinates.
fn is_homogeneous(steps: &Steps) -> bool {
    // The degree of each step; `None` for 0, which has any.
    let mut degrees: Vec<Option<i64>> = Vec::new();
    for step in &steps.steps {
        let of = |k: &usize| degrees[*k];
        degrees.push(match step {
            Step::Input(Input::Coordinate(_)) => Some(1),
            Step::Constant(c) if c.is_zero() => None,
            Step::Input(_) | Step::Constant(_) => Some(0),
            Step::Neg(a) | Step::CutOff(a) => of(a),
            Step::Add(a, b) | Step::Sub(a, b) => match (of(a), of(b)) {
                (Some(a), Some(b)) if a != b => return false,
                (a, b) => a.or(b),
            },
            Step::Mul(a, b) => of(a).zip(of(b)).map(|(a, b)| a + b),
            Step::Div(a, b) => of(a).zip(of(b)).map(|(a, b)| a - b),
            Step::Call(..) | Step::Unless(..) | Step::Less(..) => return false,
        });
    }
    steps.outputs.iter().all(|output| degrees[*output].is_none_or(|degree| degree == 0))
}
