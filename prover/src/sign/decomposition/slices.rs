//! Step 6 for p > 0: the open faces of the box one by one, and on an open box the slices in which p can vanish.
//!
//! Between neighbouring roots of the projection to one variable, either p has a zero in every slice or in none; so a
//! slice at one rational number decides for all of them, a slice at a rational root for itself. What is left are zeros
//! all of whose coordinates are irrational roots of the projections to each of the variables: finitely many points.

use core::slice;

use super::projection::{all_roots, levels, univariates};
use super::zeros::{Near, near};
use crate::algebra::poly::Var;
use crate::algebra::range::Range;
use crate::algebra::rational::Rational;
use crate::algebra::real::algebraic::Algebraic;
use crate::algebra::real::roots::{Root, between_roots};
use crate::budget::Budget;
use crate::collections::list::{Listed, Mapped};
use crate::collections::sort::sort_by;
use crate::coordinate::Coordinate;
use crate::method::Method;
use crate::sign::outcome::{Outcome, Prove, spent};
use crate::sign::problem::{Point, Problem, open, rational};
use basis_kernel::Relation;
use basis_kernel::{Base, Section, SignProof, Slices};

/// The most faces of a box.
const MAX_FACES: usize = 1000;
/// The most combinations of irrational coordinates.
const MAX_BOXES: usize = 20_000;

/// Decides p > 0 in two variables or more.
pub(in crate::sign) fn by_faces(problem: &Problem, budget: &mut Budget, prove: Prove) -> Option<Outcome> {
    let closed = |r: &Range| r.low.is_included() || r.high.is_included();
    if !problem.ranges.iter().any(|(_, r)| closed(r)) {
        return if budget.allows(Method::Cells) { by_slices(problem, budget, prove) } else { None };
    }
    if !budget.allows(Method::Faces) {
        return None;
    }
    let mut hardest = Method::Faces;
    let mut certificates = Vec::new();
    for face in faces(&problem.ranges)? {
        let fixed: Vec<(Var, Rational)> = face.iter().filter_map(|(v, x)| Some((*v, x.clone()?))).listed();
        let mut part = problem.clone();
        for (v, x) in &fixed {
            part = part.fix(*v, x);
        }
        for (_, range) in &mut part.ranges {
            *range = open(range);
        }
        match prove(&part, Relation::Positive, budget) {
            Outcome::Proved(method, certificate) => {
                hardest = hardest.max(method);
                certificates.push(certificate);
            }
            Outcome::Refuted(mut point) => {
                point.extend(rational(fixed));
                return Some(Outcome::Refuted(problem.complete(point)));
            }
            unknown @ Outcome::Unknown(_) => return Some(unknown),
        }
    }
    Some(Outcome::Proved(hardest, SignProof::Faces(certificates)))
}

/// A face: by variable the open range or an end.
type Face = Vec<(Var, Option<Rational>)>;

/// The relatively open faces that belong to a box; `None` when there are too many.
fn faces(ranges: &[(Var, Range)]) -> Option<Vec<Face>> {
    let mut faces = vec![Vec::new()];
    for (var, range) in ranges {
        let ends = [&range.low, &range.high].into_iter().filter(|e| e.is_included());
        let mut choices = vec![None];
        choices.extend(ends.map(|e| e.value().cloned()));
        let extended = faces.iter().flat_map(|face: &Face| {
            choices.iter().map(move |choice| {
                let mut face = face.clone();
                face.push((*var, choice.clone()));
                face
            })
        });
        faces = extended.listed();
        if faces.len() > MAX_FACES {
            return None;
        }
    }
    Some(faces)
}

/// Decides p > 0 on a box without its faces.
fn by_slices(problem: &Problem, budget: &mut Budget, prove: Prove) -> Option<Outcome> {
    let start = problem.nonzero_point(&problem.poly)?;
    if problem.value(&start).is_negative() {
        return Some(Outcome::Refuted(rational(start)));
    }
    let mut order: Vec<Var> = problem.ranges.mapped(|(v, _)| *v);
    // Variables of low degree are better projected away.
    sort_by(&mut order, |v, w| problem.poly.degree(*w).cmp(&problem.poly.degree(*v)));
    let mut bases = Vec::new();
    let mut unknown = None;
    for var in order {
        match base(problem, var, budget, prove) {
            Sliced::Zero(point) => return Some(Outcome::Refuted(problem.complete(point))),
            Sliced::Unknown(left) => unknown = unknown.or(Some(left)),
            Sliced::Base(base, irrational) if irrational.is_empty() => {
                let slices = Slices { bases: vec![base], boxes: Vec::new() };
                return Some(Outcome::Proved(Method::Cells, SignProof::Slices(slices)));
            }
            Sliced::Base(base, irrational) => bases.push((var, base, irrational)),
        }
    }
    if let Some(left) = unknown {
        return Some(Outcome::Unknown(left));
    }
    sort_by(&mut bases, |a, b| a.0.cmp(&b.0));
    let mut combinations: Vec<Vec<(Var, Algebraic)>> = vec![Vec::new()];
    for (var, _, irrational) in &bases {
        let extended = combinations.iter().flat_map(|c| {
            irrational.iter().map(move |x| {
                let mut c = c.clone();
                c.push((*var, x.clone()));
                c
            })
        });
        combinations = extended.take(MAX_BOXES + 1).listed();
        if combinations.len() > MAX_BOXES {
            return Some(spent(problem, "irrational points"));
        }
    }
    let mut boxes = Vec::with_capacity(combinations.len());
    for combination in combinations {
        match near(&problem.poly, combination, &mut budget.work) {
            Some(Near::Positive(ends)) => boxes.push(ends),
            Some(Near::Negative(point)) => return Some(Outcome::Refuted(rational(point))),
            Some(Near::Zero(point)) => {
                let tidy = point
                    .into_iter()
                    .map(|(v, x)| Some((v, Coordinate::Algebraic(x.tidy(&mut budget.work)?))));
                let tidy: Option<Point> = tidy.collect();
                return Some(tidy.map_or_else(|| spent(problem, "irrational points"), Outcome::Refuted));
            }
            None => return Some(spent(problem, "irrational points")),
        }
    }
    let bases = bases.into_iter().map(|(_, base, _)| base).listed();
    Some(Outcome::Proved(Method::Cells, SignProof::Slices(Slices { bases, boxes })))
}

enum Sliced {
    /// The slices at rational numbers contain no zero; the irrational sections.
    Base(Base, Vec<Algebraic>),
    Zero(Point),
    Unknown(String),
}

/// Looks for zeros in the slices that fix one variable.
fn base(problem: &Problem, var: Var, budget: &mut Budget, prove: Prove) -> Sliced {
    let out_of_work = || match spent(problem, "projections") {
        Outcome::Unknown(left) => Sliced::Unknown(left),
        _ => Sliced::Unknown(String::new()),
    };
    let trailing = problem.ranges.len() > 2;
    let Some(levels) =
        levels(slice::from_ref(&problem.poly), &problem.ranges, Some(var), trailing, &mut budget.work)
    else {
        return out_of_work();
    };
    let range = problem.range(var);
    let found = (|| {
        let polys = univariates(&levels.sets[0], var)?;
        let mut roots = all_roots(&polys, &range, &mut budget.work)?;
        for (k, root) in &mut roots {
            root.detect_rational(&polys[*k], &mut budget.work)?;
        }
        Some((polys, roots))
    })();
    let Some((polys, roots)) = found else { return out_of_work() };
    let mut decide = |x: &Rational| match prove(&problem.fix(var, x), Relation::Positive, budget) {
        Outcome::Proved(_, certificate) => Ok(certificate),
        Outcome::Refuted(mut point) => {
            point.push((var, Coordinate::Rational(x.clone())));
            Err(Sliced::Zero(point))
        }
        Outcome::Unknown(left) => Err(Sliced::Unknown(left)),
    };
    let (mut sections, mut sectors, mut irrational) = (Vec::new(), Vec::new(), Vec::new());
    let mut unknown = None;
    // Sections first: a zero at a rational root is a simple witness.
    for (k, root) in &roots {
        match root {
            Root::Exact(x) => match decide(x) {
                Ok(certificate) => sections.push(Section::Exact(x.clone(), Box::new(certificate))),
                Err(zero @ Sliced::Zero(_)) => return zero,
                Err(other) => unknown = unknown.or(Some(other)),
            },
            Root::Between(a, b) => {
                let Some(x) = Algebraic::new(&polys[*k], a.clone(), b.clone()) else { return out_of_work() };
                // The interval of the root as it is: short ones are for the point of a witness only.
                irrational.push(x);
                sections.push(Section::Between(a.clone(), b.clone()));
            }
        }
    }
    let roots: Vec<Root> = roots.into_iter().map(|(_, root)| root).listed();
    for x in between_roots(&roots, range.low.value(), range.high.value()) {
        match decide(&x) {
            Ok(certificate) => sectors.push((x, certificate)),
            Err(zero @ Sliced::Zero(_)) => return zero,
            Err(other) => unknown = unknown.or(Some(other)),
        }
    }
    unknown.unwrap_or(Sliced::Base(
        Base { order: levels.order, levels: levels.sets, sections, sectors },
        irrational,
    ))
}
