//! Paths as text.

use alloc::string::{String, ToString};

use crate::path::{Path, PathSegment};
use crate::vector::{distance, is_finite};
use crate::{CurveError, ParametricCurve, Point, Scalar};

/// A curve in the plane as the attribute `d` of an SVG path, with the shortest numbers that are read back the same.
///
/// Lines, quadratic and cubic segments and arcs of ellipses are written exactly, arcs up to rounding; other segments as
/// cubic ones within the tolerance, see [`Path::to_cubics`]. A segment that does not begin where the one before it ends
/// begins a new part, and a part that ends where it began is closed by `Z`.
///
/// ```
/// use basis_runtime::{Bezier, Path, to_svg};
///
/// let cubic = Bezier::from_points([[0.0_f32, 0.0], [0.1, 2.0], [3.0, -2.5], [4.0, 0.0]]);
/// assert_eq!(to_svg(&cubic, 1e-3).unwrap(), "M0 0C0.1 2 3-2.5 4 0");
/// let square = Path::rectangle([[1.0, 1.0], [2.0, 3.0]]);
/// assert_eq!(to_svg(&square, 1e-3).unwrap(), "M1 1L2 1L2 3L1 3L1 1Z");
/// ```
///
/// # Errors
/// [`CurveError::Dimension`] if the points have not two components, [`CurveError::Tolerance`] if the tolerance is not
/// positive and finite, even if no segment needs it, [`CurveError::NotFinite`] if a control point is not finite, and those of
/// [`Path::to_cubics`].
pub fn to_svg<P: Point>(
    curve: &(impl ParametricCurve<Point = P> + ?Sized),
    tolerance: P::Scalar,
) -> Result<String, CurveError> {
    if P::DIM != 2 {
        return Err(CurveError::Dimension { expected: 2, found: P::DIM });
    }
    if !(tolerance > P::Scalar::ZERO && tolerance.is_finite()) {
        return Err(CurveError::Tolerance { value: tolerance.to_f64() });
    }
    let path = Path::from_curve(curve);
    if !path.segments().iter().all(|s| s.control_points().iter().all(|&p| is_finite(p))) {
        return Err(CurveError::NotFinite);
    }
    let noise = P::Scalar::of(64.0) * P::Scalar::EPSILON * curve.extent();
    let mut text = String::new();
    let mut start: Option<P> = None;
    let mut here: Option<P> = None;
    for segment in path.segments() {
        // Segments whose ends differ by rounding meet.
        let meets = here.is_some_and(|here| distance(here, segment.start()) <= noise);
        if !meets {
            close(&mut text, start, here);
            text.push('M');
            numbers(&mut text, &[segment.start()]);
            start = Some(segment.start());
        }
        write(&mut text, segment, tolerance)?;
        here = Some(segment.end());
    }
    close(&mut text, start, here);
    Ok(text)
}

fn close<P: Point>(text: &mut String, start: Option<P>, here: Option<P>) {
    if start.is_some() && start == here {
        text.push('Z');
    }
}

fn write<P: Point>(
    text: &mut String,
    segment: &PathSegment<P>,
    tolerance: P::Scalar,
) -> Result<(), CurveError> {
    let points = segment.control_points();
    if segment.weights().is_some()
        && let Some(arc) = arc(segment)
    {
        text.push_str(&arc);
        numbers(text, &[segment.end()]);
        return Ok(());
    }
    let letter = match (points.len(), segment.weights()) {
        (1 | 2, _) => 'L',
        (3, None) => 'Q',
        (4, None) => 'C',
        _ => {
            let cubics = Path::from(segment.clone()).to_cubics(tolerance)?;
            return cubics.segments().iter().try_for_each(|cubic| write(text, cubic, tolerance));
        }
    };
    text.push(letter);
    numbers(text, &points[points.len().min(2) - 1..]);
    Ok(())
}

/// The beginning of the command of a quadratic segment that is an arc of an ellipse.
///
/// With equal weights at the ends and `w` in the middle, `w < 1`, the centre is `(M - w² P1) / (1 - w²)`, `M` the middle
/// of the chord, and `(P2 - P0) / (2 √(1 - w²))` and `w (P1 - centre)` are half axes that are conjugate. The axes are the
/// singular values of the matrix with these columns.
fn arc<P: Point>(segment: &PathSegment<P>) -> Option<String> {
    let (&[p0, p1, p2], &[w0, w1, w2]) = (segment.control_points(), segment.weights()?) else { return None };
    // Other weights of the ends only change the parameter.
    let square = (w1 * w1 / (w0 * w2)).to_f64();
    let rest = 1.0 - square;
    if rest.is_nan() || rest <= 1e-6 {
        return None;
    }
    let at = |p: P| [p.component(0).to_f64(), p.component(1).to_f64()];
    let [p0, p1, p2] = [p0, p1, p2].map(at);
    let weight = Scalar::sqrt(square);
    let mut columns = [[0.0; 2]; 2];
    for d in 0..2 {
        let centre = (f64::midpoint(p0[d], p2[d]) - square * p1[d]) / rest;
        columns[0][d] = (p2[d] - p0[d]) / (2.0 * Scalar::sqrt(rest));
        columns[1][d] = weight * (p1[d] - centre);
    }
    let [[a, c], [b, d]] = columns;
    // Eigenvalues and direction of the matrix times its transpose.
    let (xx, xy, yy) = (a * a + b * b, a * c + b * d, c * c + d * d);
    let determinant = a * d - b * c;
    let spread = Scalar::sqrt((xx - yy) * (xx - yy) + 4.0 * xy * xy);
    let long = Scalar::sqrt(f64::midpoint(xx + yy, spread));
    let short = determinant.abs() / long;
    if !(short > 0.0 && long.is_finite()) || short < 1e-9 * long {
        return None;
    }
    // On a circle the direction of the axes says nothing.
    let epsilon = P::Scalar::EPSILON.to_f64();
    let round = spread <= 64.0 * epsilon * (xx + yy);
    let angle = if round { 0.0 } else { 0.5 * Scalar::atan2(2.0 * xy, xx - yy) };
    let mut text = String::from("A");
    let mut add = |x: f64| {
        // Without the digits that carry rounding errors only.
        let digits = if epsilon > 1e-10 { 5 } else { 13 };
        let rounded = alloc::format!("{x:.digits$e}").parse().unwrap_or(x);
        let number = shortest(P::Scalar::of(rounded));
        separate(&mut text, &number);
    };
    let mean = f64::midpoint(long, short);
    add(if round { mean } else { long });
    add(if round { mean } else { short });
    add(angle.to_degrees());
    // The arc of a positive weight is the smaller part of the ellipse. From P0 to P2 by way of P1 it turns like these.
    let turn = (p1[0] - p0[0]) * (p2[1] - p1[1]) - (p1[1] - p0[1]) * (p2[0] - p1[0]);
    add(0.0);
    add(if turn > 0.0 { 1.0 } else { 0.0 });
    Some(text)
}

fn numbers<P: Point>(text: &mut String, points: &[P]) {
    for point in points {
        for d in 0..2 {
            separate(text, &shortest(point.component(d)));
        }
    }
}

/// The shortest number that is read back the same; where many zeros would have to be written, with an exponent.
fn shortest<S: Scalar>(number: S) -> String {
    let number = if number == S::ZERO { S::ZERO } else { number }; // no -0
    let size = number.abs().to_f64();
    let decimal = number.to_string();
    if size.is_finite() && size != 0.0 && !(1e-5..1e16).contains(&size) {
        with_exponent(&decimal)
    } else {
        decimal
    }
}

/// The number with the same digits and an exponent: `-1.25e-7` for `-0.000000125`.
fn with_exponent(decimal: &str) -> String {
    let (sign, size) = decimal.strip_prefix('-').map_or(("", decimal), |size| ("-", size));
    let (whole, fraction) = size.split_once('.').unwrap_or((size, ""));
    let all = alloc::format!("{whole}{fraction}");
    let digits = all.trim_start_matches('0');
    let exponent = digits.len() as isize - fraction.len() as isize - 1;
    let (first, rest) = digits.trim_end_matches('0').split_at(1);
    let point = if rest.is_empty() { "" } else { "." };
    alloc::format!("{sign}{first}{point}{rest}e{exponent}")
}

fn separate(text: &mut String, number: &str) {
    if !number.starts_with('-') && text.ends_with(|c: char| c.is_ascii_digit()) {
        text.push(' ');
    }
    text.push_str(number);
}
