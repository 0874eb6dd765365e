//! Control nets for counterexamples: definite points in place of the given ones.

use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::rational::Rational;
use crate::theorem::{Form, PatchKind, Theorem, Unit};
use basis_prover::collections::list::{Listed, Mapped};
use basis_prover::collections::sort::sort_unique;

/// Nets with pseudo-random points that are tried after the regular one.
const ATTEMPTS: u64 = 12;

/// A place for each of the given points.
#[derive(Clone, Debug)]
pub(super) struct Net {
    points: Vec<Vec<Rational>>,
}

impl Net {
    /// The net with these places for the given points, or without any.
    ///
    /// # Errors
    /// When there is not one for each, or they have different dimensions.
    pub(super) fn given(theorem: &Theorem, places: &[Vec<Rational>]) -> Result<Self, &'static str> {
        if places.is_empty() {
            return Ok(Self { points: Vec::new() });
        }
        if places.len() != theorem.points.len() {
            return Err("there is not one place for each given point");
        }
        let least = if places.is_empty() { 0 } else { 2 };
        let dimension = theorem.dimension.or(places.first().map(Vec::len)).unwrap_or(0);
        let wrong = theorem.dimension.is_none() && dimension < least;
        if wrong || places.iter().any(|p| p.len() != dimension) {
            return Err("the control points have another dimension");
        }
        Ok(Self { points: places.to_vec() })
    }

    /// The places of the given points.
    pub(super) fn places(&self) -> &[Vec<Rational>] {
        &self.points
    }

    /// Points on the first axis of the plane, those that are not named at the origin.
    pub(super) fn on_a_line(theorem: &Theorem, places: &[(usize, Rational)]) -> Self {
        let dimension = dimension(theorem);
        let mut points = theorem.points.mapped(|_| vec![Rational::ZERO; dimension]);
        for (point, x) in places {
            points[*point][0] = x.clone();
        }
        Self { points }
    }

    /// The net with the coordinates that the variables have at a point.
    pub(super) fn from_coordinates(theorem: &Theorem, at: &[Rational]) -> Self {
        let coordinates = |vars: &[Var]| vars.mapped(|v| at[v.0].clone());
        Self { points: theorem.points.mapped(|p| coordinates(&p.coordinates)) }
    }
}

/// Nets in general position first, in the plane for curves and in space for surfaces; then points of which only one or
/// two are not zero, at which a form with few terms is seen to be different from zero.
pub(super) fn nets(theorem: &Theorem) -> impl Iterator<Item = Net> {
    let count = theorem.points.len();
    let dimension = dimension(theorem);
    // Without points all nets are alike.
    let attempts = if count == 0 { 0 } else { ATTEMPTS };
    let mut seed = 1;
    let random = move |attempt| {
        // In a space of as many dimensions as there are points, their dot products are independent.
        let wide = if attempt % 2 == 0 { dimension } else { count.clamp(2, 8) };
        let dimension = theorem.dimension.unwrap_or(wide);
        let points = (0..count).map(|_| (0..dimension).map(|_| small(&mut seed)).listed()).listed();
        Net { points }
    };
    let random = (0..attempts).map(random);
    core::iter::once_with(move || regular(theorem, dimension)).chain(random).chain(sparse(theorem))
}

/// The number of coordinates of a net.
fn dimension(theorem: &Theorem) -> usize {
    let curves = theorem.patches.iter().all(|p| p.kind == PatchKind::Curve);
    theorem.dimension.unwrap_or(if curves { 2 } else { 3 })
}

/// Nets of which two points are (1, 0, …) and (0, 1, …), the others zero.
pub(super) fn sparse(theorem: &Theorem) -> impl Iterator<Item = Net> {
    let (count, dimension) = (theorem.points.len(), dimension(theorem));
    let unit = move |k: usize, p: usize, q: usize| -> Vec<Rational> {
        let place = |c| i64::from((c == 0 && k == p) || (c == 1 && k == q));
        (0..dimension).map(|c| Rational::from(place(c))).listed()
    };
    let pairs = (0..count).flat_map(move |p| (p + 1..count.max(p + 2)).map(move |q| (p, q)));
    pairs.map(move |(p, q)| Net { points: (0..count).map(|k| unit(k, p, q)).listed() })
}

/// Points over a grid of their indices on a curved surface, each patch moved a little.
fn regular(theorem: &Theorem, dimension: usize) -> Net {
    let place = |patch: usize, index: &[i64]| -> Vec<Rational> {
        let (i, j) = (index.first().copied().unwrap_or(0), index.get(1).copied().unwrap_or(0));
        let shift = 4 * patch as i64;
        let (plane, height) = (index.len() == 1, i * i + i * j + 2 * j * j + shift);
        let list = if plane { [i + shift, height, i * i * i] } else { [i + shift, j, height] };
        (0..dimension).map(|k| Rational::from(list.get(k).copied().unwrap_or(i * j + k as i64))).listed()
    };
    Net { points: theorem.points.mapped(|p| place(p.patch, &p.index)) }
}

/// A small whole number from a linear congruential generator.
fn small(seed: &mut u64) -> Rational {
    *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    Rational::from((*seed >> 33) as i64 % 9 - 4)
}

/// A scalar with the coordinates, or the dot products, of a net put in.
pub(super) fn on_net(theorem: &Theorem, value: &Fraction, net: &Net) -> Fraction {
    let put = |p: &Poly| {
        let mut p = p.clone();
        for (point, place) in theorem.points.iter().zip(&net.points) {
            for (var, x) in point.coordinates.iter().zip(place) {
                p = p.at(*var, x);
            }
        }
        for (var, (a, b)) in &theorem.products {
            let pairs = net.points[*a].iter().zip(&net.points[*b]);
            p = p.at(*var, &pairs.fold(Rational::ZERO, |sum, (x, y)| &sum + &(x * y)));
        }
        p
    };
    // A denominator with coordinates in it vanishes for no net.
    Fraction::new(put(value.numer()), put(value.denom())).unwrap_or_else(Fraction::zero)
}

/// The coordinates of a vector on a net, each with its index in brackets; an outer product has one for each pair of
/// axes, and in the plane only one, which needs no index.
pub(super) fn parts(theorem: &Theorem, form: &Form, net: &Net) -> Vec<(String, Fraction)> {
    parts_along(theorem, form, &[form], net)
}

/// The parts of two vectors, along the same axes in the same order.
pub(super) fn parts_of_both(theorem: &Theorem, both: [&Form; 2], net: &Net) -> [Vec<(String, Fraction)>; 2] {
    both.map(|form| parts_along(theorem, form, &both, net))
}

/// The parts of a vector along the axes that occur in some vectors.
fn parts_along(theorem: &Theorem, form: &Form, axes: &[&Form], net: &Net) -> Vec<(String, Fraction)> {
    if let Some(dimension) = theorem.dimension {
        let mut occurring: Vec<Unit> = axes.iter().flat_map(|form| form.terms.keys()).copied().listed();
        sort_unique(&mut occurring);
        let outer = occurring.iter().any(|unit| matches!(unit, Unit::Pair(..)));
        let units: Vec<(String, Unit)> = if outer {
            occurring
                .into_iter()
                .map(|unit| match unit {
                    Unit::Pair(p, q) => (format!("[{p},{q}]"), unit),
                    Unit::Point(p) => (format!("[{p}]"), unit),
                })
                .listed()
        } else {
            (0..dimension).map(|k| (format!("[{k}]"), Unit::Point(k))).listed()
        };
        let part = |(label, unit): (String, Unit)| (label, on_net(theorem, &form.coefficient(unit), net));
        return units.into_iter().map(part).listed();
    }
    let dimension = net.points.first().map_or(0, Vec::len);
    let zeros = |labels: Vec<String>| labels.into_iter().map(|l| (l, Fraction::zero())).listed();
    let axes: Vec<(usize, usize)> =
        (0..dimension).flat_map(|i| (i + 1..dimension).map(move |j| (i, j))).listed();
    let mut vector = zeros((0..dimension).map(|k| format!("[{k}]")).listed());
    let mut outer =
        zeros(axes.mapped(|(i, j)| if dimension == 2 { String::new() } else { format!("[{i},{j}]") }));
    let mut is_outer = false;
    for (unit, value) in &form.terms {
        let value = &on_net(theorem, value, net);
        match unit {
            Unit::Point(p) => {
                for (part, x) in vector.iter_mut().zip(&net.points[*p]) {
                    part.1 = &part.1 + &(value * &Fraction::constant(x.clone()));
                }
            }
            Unit::Pair(p, q) => {
                is_outer = true;
                let (p, q) = (&net.points[*p], &net.points[*q]);
                for (part, (i, j)) in outer.iter_mut().zip(&axes) {
                    let minor = &(&p[*i] * &q[*j]) - &(&p[*j] * &q[*i]);
                    part.1 = &part.1 + &(value * &Fraction::constant(minor));
                }
            }
        }
    }
    if is_outer { outer } else { vector }
}

/// The control points of all patches for values of the scalars; none when every point is a definite one anyway. Points
/// that depend on scalars with irrational values are left out: the others determine them.
pub(super) fn evaluated(
    theorem: &Theorem,
    net: &Net,
    scalars: &[Rational],
    irrational: &[Var],
) -> Vec<(String, Vec<Rational>)> {
    let mut at = scalars.to_vec();
    for (point, place) in theorem.points.iter().zip(&net.points) {
        for (var, x) in point.coordinates.iter().zip(place) {
            at[var.0] = x.clone();
        }
    }
    let dimension = theorem.dimension.or(net.points.first().map(Vec::len)).unwrap_or(0);
    if dimension == 0 {
        // A claim about scalars alone: any points will do.
        return Vec::new();
    }
    let axis = |k: usize| (0..dimension).map(|c| Rational::from(i64::from(c == k))).listed();
    let units: Vec<Vec<Rational>> = match theorem.dimension {
        Some(_) => (0..dimension).map(axis).listed(),
        None => net.points.clone(),
    };
    let mut all = Vec::new();
    for patch in &theorem.patches {
        for point in &patch.points {
            if point.value.terms.values().any(|f| irrational.iter().any(|var| f.depends_on(*var))) {
                continue;
            }
            let Some(mut place) = point.value.eval(&at, &units) else { continue };
            place.resize(dimension, Rational::ZERO);
            all.push((crate::model::label(&patch.name, &point.index), place));
        }
    }
    let definite = theorem.points.is_empty()
        && theorem.patches.iter().all(|patch| {
            patch.points.iter().all(|p| p.value.terms.values().all(|f| f.as_constant().is_some()))
        });
    if definite { Vec::new() } else { all }
}
