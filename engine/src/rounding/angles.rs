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
use super::{Inputs, least_multiple, rest, with_points};
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::{Range, Region};
use crate::algebra::rational::Rational;
use crate::model::angle::{Analytic, Angle, Kind};
use crate::model::{Family, Parameter};
use crate::plan::Input;
use crate::plan::interval::form::RationalForm;
use crate::plan::interval::rational;
use crate::steps::point::{Association, of_curve};
use crate::steps::{Builder, Function, Step, Steps, elementary, sums};
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
const FUNCTIONS: &str = "as long as sines, cosines, tangents and exponentials of the library are within one unit in the last place, hyperbolic tangents within two";

/// What a float is taken for where an end or a knot is none, without the article.
pub const NEAREST: &str =
    "float next to an end or a knot that is none, such as pi/2 or 1/3, is taken for that end or knot";

/// For which coordinates on simplices bounds hold: elsewhere those of formulas that are homogeneous in them.
pub const BARYCENTRIC: &str = "where the barycentric coordinates add up to 1";

/// Whether the values of a family are computed by elementary functions, so that bounds assume something of these.
pub fn needs_functions(family: &Family) -> bool {
    all_spans(family).any(|piece| piece.analytic.is_transcendental())
}

/// Whether an end of the domain or a knot is no float for some shape values.
pub fn has_ends_beside_floats(family: &Family) -> bool {
    all_spans(family).any(|piece| {
        let Some((var, low, high)) = piece.interval() else { return false };
        let ends = match piece.analytic.angle(var) {
            Some(angle) => angle.limits.clone(),
            None => [low, high].map(|end| Fraction::constant(end.clone())),
        };
        ends.iter()
            .any(|end| piece.analytic.number(end).map_or_else(|| !is_parameter(end), |end| !is_float(&end)))
    })
}

fn all_spans(family: &Family) -> impl Iterator<Item = &Family> {
    family.pieces.iter().map(|piece| &**piece).chain([family])
}

/// What the bounds of a family assume; `None` where that is nothing.
pub fn assumed(family: &Family) -> Option<String> {
    let texts = [
        (!family.simplices.is_empty(), String::from(BARYCENTRIC)),
        (needs_functions(family), String::from(FUNCTIONS)),
        (has_ends_beside_floats(family), format!("the {NEAREST}")),
    ];
    let texts = texts.into_iter().filter_map(|(is_so, text)| is_so.then_some(text)).listed();
    (!texts.is_empty()).then(|| texts.join("; "))
}

/// The values on a span as steps whose inputs are the coordinates and the tangents.
pub(super) struct OnCoordinates {
    pub(super) steps: Steps,
    pub(super) inputs: Inputs,
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
    /// Those of a span, in parts of it on which the runtime does the same. `None` where nothing is known of how far the
    /// coordinates or tangents are off.
    pub(super) fn new(family: &Family, form: &RationalForm) -> Option<Vec<Self>> {
        if !form.divides(family) {
            let off = linear(&ends(family, form)?);
            let mut all = Vec::new();
            for (k, half) in halves().into_iter().enumerate() {
                let steps = in_coordinate(k, family, form);
                let inputs = inputs(family, &steps, &off, half, 0)?;
                all.push(Self { steps, inputs });
            }
            return Some(all);
        }
        let mut builder = Builder::without_scales();
        let outputs = builder.plan(&rational::values(family, form));
        Some(vec![Self::of(builder.finish(&outputs), family, form, 0)?])
    }

    /// The point of a curve on a span, with the binding of its control points.
    pub(super) fn of_point(family: &Family, form: &RationalForm, association: Association) -> Option<Self> {
        Self::of(of_curve(family, form, association), family, form, form.numerators.len())
    }

    /// Steps in the coordinates, and in that many control points.
    pub(super) fn of(steps: Steps, family: &Family, form: &RationalForm, points: usize) -> Option<Self> {
        let off = off(family, form, &steps)?;
        Some(Self { inputs: inputs(family, &steps, &off, Range::unit(), points)?, steps })
    }
}

/// Where s, and where x, is the smaller one of both coordinates: where they are nearly the same, either may be that of the floats.
fn halves() -> [Range; 2] {
    let beyond = &Rational::new(1, 2) + &Rational::new(1, 1 << 10);
    [Range::closed(&Rational::ONE - &beyond, Rational::ONE), Range::closed(Rational::ZERO, beyond)]
}

/// The ends of a span.
fn ends(family: &Family, form: &RationalForm) -> Option<[End; 2]> {
    Some(match family.analytic.angle(form.numerators.var) {
        Some(angle) => [end(family, angle, 0)?, end(family, angle, 1)?],
        None => [&form.numerators.low, &form.numerators.high].map(|end| number(end.clone())),
    })
}

/// How many u both coordinates are off, if steps are made of them.
pub(super) fn off(family: &Family, form: &RationalForm, steps: &Steps) -> Option<[Rational; 2]> {
    let ends = ends(family, form)?;
    match family.analytic.angle(form.numerators.var).filter(|angle| angle.kind != Kind::Linear) {
        Some(_) if !is_homogeneous(steps) => None,
        Some(angle) if angle.kind == Kind::Circular => circular(angle, &ends),
        Some(angle) => hyperbolic(angle, &ends),
        None => Some(linear(&ends)),
    }
}

/// The values of all functions from the coordinates s and x, whose sum is 1, where the k-th of both is the smaller one.
fn in_coordinate(k: usize, family: &Family, form: &RationalForm) -> Steps {
    let mut builder = Builder::in_coordinate(k);
    if !form.is_tabulated {
        let outputs = builder.plan(&rational::values(family, form));
        return builder.finish(&outputs);
    }
    let entries = builder.plan(&rational::numerators(family, form));
    let count = form.numerators.len().max(1);
    let [s, x] = [0, 1].map(|k| builder.input(Input::Coordinate(k)));
    let mut outputs = Vec::new();
    for place in 0..form.numerators.len() {
        let column = entries.chunks(count).map(|row| row[place]).listed();
        let value = builder.bernstein_in(k, &column, s, x);
        let is_nonnegative = family.nonnegative.get(place) == Some(&true);
        outputs.push(if is_nonnegative { builder.cut_off(value) } else { value });
    }
    builder.finish(&outputs)
}

/// The inputs of the steps; `None` where a shape parameter stands beside its tangent, or nothing is known of a tangent.
pub(super) fn inputs(
    family: &Family,
    steps: &Steps,
    coordinates: &[Rational; 2],
    place: Range,
    points: usize,
) -> Option<Inputs> {
    let angles = &family.analytic.angles;
    let shapes = family.shapes.len();
    let mut ranges: Vec<(Var, Range)> = family.shapes.mapped(|p| (p.var, p.range.clone()));
    let first = ranges.iter().map(|(v, _)| v.0 + 1).max().unwrap_or(0);
    let y = Var(first);
    ranges.push((y, place));
    let points = with_points(&mut ranges, points);
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
            Input::Point(_) => continue,
            _ => return None,
        };
        off.push((input, value, in_all(&weight)));
    }
    let shapes = family.shapes.mapped(|p| p.var);
    let (region, coordinates) = (Region { ranges }, vec![y]);
    Some(Inputs {
        region,
        shapes,
        of_intervals: coordinates.clone(),
        coordinates,
        simplices: Vec::new(),
        points,
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

/// An end that is a number, a multiple of a shape parameter by a power of 2, or a sum of such multiples; `None` for any
/// other one, of which the float may be farther off than the parameter is from it.
fn end(family: &Family, angle: &Angle, k: usize) -> Option<End> {
    let limit = &angle.limits[k];
    if let Some(value) = family.analytic.number(limit) {
        return Some(number(value));
    }
    let distance = if is_parameter(limit) { 1 } else { TO_A_NUMBER };
    (distance == 1 || sums(family, angle).is_some()).then_some(End { known: None, distance })
}

/// Whether an end is a multiple of a shape parameter by a power of 2.
fn is_parameter(end: &Fraction) -> bool {
    let Some(form) = end.as_poly() else { return false };
    let is_power = |c: &Rational| is_power_of_two(c);
    form.len() == 1 && form.leading_term().is_some_and(|(m, c)| m.total_degree() == 1 && is_power(c))
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
