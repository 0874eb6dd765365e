//! Inequalities on the declared ranges, by the decision procedure for signs of polynomials.

use super::{Evidence, Step, StepProof, Verdict, Witness, named_point, point};
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::{Range, Region};
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::collections::list::Mapped;
use crate::decide::{self, Budget, Coordinate, Decision, Relation};
use crate::model::{ClaimKind, Comparison, Family};

/// Coordinates of the variables of a family, and the last barycentric one where it is needed.
type FamilyPoint = (Vec<(Var, Coordinate)>, Option<Coordinate>);

/// An inequality `sign`·x ≥ 0 or > 0 between an expression x and zero as one of a polynomial on a box.
pub(super) struct Inequality<'a> {
    family: &'a Family,
    chart: Chart,
    pub(super) relation: Relation,
    /// Whether −x ≥ 0 (> 0) is meant.
    pub(super) negate: bool,
}

impl<'a> Inequality<'a> {
    /// What a claim says of each of its expressions; `None` for equations and independence.
    pub(super) fn of(family: &'a Family, kind: &ClaimKind) -> Option<Self> {
        let (relation, negate) = match kind {
            ClaimKind::Nonnegative => (Relation::NonNegative, false),
            ClaimKind::Relation { comparison, .. } => match comparison {
                Comparison::Equal | Comparison::NotEqual => return None,
                Comparison::Greater => (Relation::Positive, false),
                Comparison::GreaterEqual => (Relation::NonNegative, false),
                Comparison::Less => (Relation::Positive, true),
                Comparison::LessEqual => (Relation::NonNegative, true),
            },
            _ => return None,
        };
        Some(Self { family, chart: Chart::new(family, super::fixed(kind)), relation, negate })
    }

    /// The box.
    pub(super) const fn region(&self) -> &Region {
        &self.chart.region
    }

    /// The polynomial whose sign on the box is that of the expression.
    pub(super) fn polynomial(&self, value: &Fraction) -> Poly {
        let signed = if self.negate { -value } else { value.clone() };
        self.chart.pull_back(&numerator_with_sign(&signed, self.family))
    }

    /// The point of the family's variables, irrational values of what is fixed included, with the last barycentric coordinate.
    fn point(&self, point: &[(Var, Coordinate)], fixed: &[(Var, Fraction)]) -> Option<FamilyPoint> {
        let (mut point, last) = self.chart.point(point)?;
        let irrational: Vec<Var> =
            point.iter().filter(|(_, c)| matches!(c, Coordinate::Algebraic(_))).map(|(v, _)| *v).collect();
        for (var, f) in fixed.iter().filter(|(_, f)| irrational.iter().any(|v| f.depends_on(*v))) {
            let value = image(f.as_poly()?, &point)?;
            point.push((*var, value));
        }
        Some((point, last))
    }

    /// Decides every expression; the first failure is the witness.
    pub(super) fn decide(&self, kind: &ClaimKind, expressions: Vec<(String, Fraction)>) -> Verdict {
        let family = self.family;
        let mut steps = Vec::new();
        let mut hardest: Option<decide::Method> = None;
        let mut undecided = None;
        for (of, value) in expressions {
            let polynomial = self.polynomial(&value);
            match decide::decide(
                &polynomial,
                self.relation,
                self.region(),
                &mut Budget::scaled(family.budget),
            ) {
                Decision::Proved(proof) => {
                    hardest = Some(hardest.map_or(proof.method, |m| m.max(proof.method)));
                    steps.push(Step { of, proof: StepProof::Sign(proof) });
                }
                Decision::Refuted(witness) => match self.point(&witness.point, super::fixed(kind)) {
                    Some(point) => {
                        let fixed = super::fixed(kind);
                        return Verdict::Refuted(refutation(
                            family,
                            &of,
                            &value,
                            &point,
                            &witness.value,
                            fixed,
                        ));
                    }
                    None => {
                        undecided = undecided.or(Some(format!(
                            "`{of}` fails, but at a point that is irrational in several ways"
                        )));
                    }
                },
                Decision::Undecided(left) => undecided = undecided.or(Some(format!("`{of}`: {left}"))),
            }
        }
        match undecided {
            Some(left) => Verdict::Undecided(left),
            None => Verdict::Proved(Evidence {
                method: hardest.map_or_else(String::new, |m| m.to_string()),
                steps,
            }),
        }
    }
}

/// Polynomials with the signs of the functions, and the box on which to look at them.
#[cfg(any(test, feature = "tools"))]
pub(crate) fn functions(family: &Family) -> (Vec<Poly>, Region) {
    let chart = Chart::new(family, &[]);
    let all = family.functions.iter().map(|f| chart.pull_back(&numerator_with_sign(&f.value, family)));
    (all.collect(), chart.region)
}

/// A polynomial with the sign of a quotient: the denominator, in shape parameters only, vanishes nowhere on their
/// ranges, so that its sign at one point is its sign everywhere.
fn numerator_with_sign(value: &Fraction, family: &Family) -> Poly {
    if value.as_poly().is_some() {
        return value.numer().clone();
    }
    let at: Vec<Rational> = family.shapes.mapped(|p| point::simple(&p.range));
    if value.denom().eval(&at).is_negative() { -value.numer() } else { value.numer().clone() }
}

fn refutation(
    family: &Family,
    of: &str,
    value: &Fraction,
    (point, last): &FamilyPoint,
    zero: &Rational,
    fixed: &[(Var, Fraction)],
) -> Witness {
    let exact = point.iter().all(|(_, c)| matches!(c, Coordinate::Rational(_)));
    let coordinates = point::coordinates(point, family.names.len());
    let shown = if exact { value.eval(&coordinates) } else { None };
    // At an irrational point the value is an exact zero.
    let shown = shown.unwrap_or_else(|| zero.clone());
    let mut at = named_point(family, point, fixed);
    if let (false, Some(name), Some(last)) = (exact, &family.dependent, last) {
        at.retain(|(n, _)| *n != name.name);
        at.push((name.name.clone(), last.clone()));
    }
    let mut result = Witness {
        of: of.to_string(),
        at,
        idle: Vec::new(),
        value: shown,
        net: Vec::new(),
        notes: Vec::new(),
    };
    result.notes.push(format!("`{of}` is {} at {}", result.value, result.point()));
    result
}

/// The box on which an inequality is decided, and the way from it to the variables of the family.
///
/// A simplex is the image of the unit box under u = c(1 − s₁), v = c·s₁(1 − s₂), w = c·s₁s₂(1 − s₃), …, where c is what fixed
/// coordinates leave of 1; a coordinate that is free but expressed by the others is c·s₁s₂… .
struct Chart {
    region: Region,
    /// The domain variables as polynomials in the variables of the box; empty on a box, where they are the same.
    by: Vec<(Var, Poly)>,
    /// The last barycentric coordinate in the same way, unless what is fixed is no polynomial.
    last: Option<Poly>,
}

impl Chart {
    fn new(family: &Family, fixed: &[(Var, Fraction)]) -> Self {
        let free = |v: &Var| fixed.iter().all(|(f, _)| f != v);
        let mut region = family.region();
        region.ranges.retain(|(v, _)| free(v));
        let on_simplex: Vec<Var> = family.domain.iter().map(|p| p.var).filter(free).collect();
        if !family.is_simplex() || on_simplex.is_empty() {
            return Self { region, by: Vec::new(), last: None };
        }
        region.ranges.retain(|(v, _)| !on_simplex.contains(v));
        let mut by = Vec::new();
        let mut rest = Poly::constant(point::left_on_simplex(family, fixed));
        for (k, var) in on_simplex.iter().enumerate() {
            let s = Var(family.names.len() + k);
            region.ranges.push((s, Range::unit()));
            let coordinate = &rest * &(&Poly::one() - &Poly::var(s));
            rest = &rest * &Poly::var(s);
            by.push((*var, coordinate));
        }
        // 1 minus the others, what is fixed included.
        let mut last = Some(Poly::one());
        for parameter in &family.domain {
            let own = by.iter().find(|(v, _)| *v == parameter.var).map(|(_, p)| p.clone());
            let value = own.or_else(|| {
                let (_, f) = fixed.iter().find(|(v, _)| *v == parameter.var)?;
                Some(by.iter().fold(f.as_poly()?.clone(), |p, (v, by)| p.substitute(*v, by)))
            });
            last = last.zip(value).map(|(last, p)| &last - &p);
        }
        Self { region, by, last }
    }

    fn pull_back(&self, polynomial: &Poly) -> Poly {
        self.by.iter().fold(polynomial.clone(), |p, (var, by)| p.substitute(*var, by))
    }

    /// The point of the family's variables, with the last barycentric coordinate; `None` when a coordinate is no affine image of
    /// an irrational one.
    fn point(&self, point: &[(Var, Coordinate)]) -> Option<FamilyPoint> {
        if self.by.is_empty() {
            return Some((point.to_vec(), None));
        }
        let in_box = |v: &Var| self.by.iter().any(|(_, p)| p.depends_on(*v));
        let mut result: Vec<(Var, Coordinate)> = point.iter().filter(|(v, _)| !in_box(v)).cloned().collect();
        for (var, by) in &self.by {
            result.push((*var, image(by, point)?));
        }
        let last = match &self.last {
            Some(by) => Some(image(by, point)?),
            None => None,
        };
        Some((result, last))
    }
}

/// The value of a polynomial that is of degree 1 in the only irrational coordinate that occurs.
fn image(by: &Poly, point: &[(Var, Coordinate)]) -> Option<Coordinate> {
    let mut rest = by.clone();
    for (var, c) in point {
        if let Coordinate::Rational(x) = c {
            rest = rest.at(*var, x);
        }
    }
    if let Some(value) = rest.as_constant() {
        return Some(Coordinate::Rational(value));
    }
    let (var, x) = point.iter().find_map(|(v, c)| match c {
        Coordinate::Algebraic(x) if rest.depends_on(*v) => Some((*v, x)),
        _ => None,
    })?;
    match &rest.coefficients_in(var)[..] {
        [a, b] => {
            let moved = x.affine(&a.as_constant()?, &b.as_constant()?)?;
            Some(Coordinate::Algebraic(moved.tidy(&mut Work::new(TIDYING))?))
        }
        _ => None,
    }
}

/// The work for writing an irrational coordinate with short numbers.
const TIDYING: u64 = 1_000_000;
