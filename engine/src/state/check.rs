//! Checks verdicts without the search that found them: proofs against statements, witnesses against expressions.

use super::gram::Gram;
use super::net::{Net, evaluated, on_net};
use super::{Assertion, Evidence, RankProof, Statement, StepProof, Witness, expressions, fixed, statements};
use super::{Inequality, independent, parallel, point, theorem};
use crate::algebra::algebraic::Algebraic;
use crate::algebra::fraction::Fraction;
use crate::algebra::matrix::determinant;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::Range;
use crate::algebra::rational::Rational;
use crate::algebra::univariate::Univariate;
use crate::algebra::work::Work;
use crate::collections::list::Mapped;
use crate::decide::{Computed, Coordinate, Table, Values, verify, verify_independence};
use crate::model::theorem::{Theorem, TheoremClaim, TheoremClaimKind};
use crate::model::{Claim, ClaimKind, Comparison, Family};

/// Checks that evidence proves a claim.
///
/// # Errors
/// What is wrong with it, in a sentence.
pub fn evidence(family: &Family, claim: &Claim, evidence: &Evidence) -> Result<(), String> {
    steps(&statements(family, claim), evidence)
}

/// Checks that the steps of evidence prove statements.
///
/// # Errors
/// What is wrong with it, in a sentence.
pub fn steps(statements: &[Statement], evidence: &Evidence) -> Result<(), String> {
    if statements.len() != evidence.steps.len() {
        return Err(format!("there are {} proofs for {} statements", evidence.steps.len(), statements.len()));
    }
    for (statement, step) in statements.iter().zip(&evidence.steps) {
        if statement.of != step.of {
            return Err(format!(
                "the proof of `{}` stands in the place of that of `{}`",
                step.of, statement.of
            ));
        }
        proof(statement, &step.proof).map_err(|e| format!("`{}`: {e}", step.of))?;
    }
    Ok(())
}

/// Checks that a proof shows a statement, about which nothing else is known; the Bernstein coefficients on all cells of its
/// certificates and the minors, in the order in which they stand there.
///
/// # Errors
/// What is wrong with it, in a sentence.
pub fn proof(statement: &Statement, proof: &StepProof) -> Result<Computed, String> {
    match (&statement.assertion, proof) {
        (Assertion::Zero(value), StepProof::Identity) => {
            if value.is_zero() {
                Ok(Computed::default())
            } else {
                Err(String::from("the expanded difference is not zero"))
            }
        }
        (Assertion::Sign { polynomial, relation, region }, StepProof::Sign(proof)) => {
            let cells = verify(polynomial, *relation, region, &proof.certificate, statement.budget)?;
            Ok(Computed { cells, minors: Vec::new() })
        }
        (Assertion::Squares { polynomial, relation, products }, StepProof::Squares(squares)) => {
            let gram = Gram::of(polynomial, products).ok_or("this is no sum of dot products")?;
            gram.check(*relation, squares).map(|()| Computed::default())
        }
        (Assertion::Independent { table, except, region }, StepProof::Independence(proof)) => {
            exceptions(table, except, region, proof)?;
            verify_independence(&table.rows, except, region, &proof.pieces, statement.budget)
        }
        _ => Err(String::from("the proof is one of another kind of statement")),
    }
}

/// Checks that the rows are dependent wherever the parameters have the values of an exception.
fn exceptions(
    table: &Table,
    except: &[Values],
    region: &crate::algebra::range::Region,
    proof: &RankProof,
) -> Result<(), String> {
    if proof.exceptions.len() != except.len() {
        return Err(String::from("there is not one combination for each exception"));
    }
    for (values, combination) in except.iter().zip(&proof.exceptions) {
        if values.iter().any(|(v, x)| !region.range(*v).contains(x)) {
            if !combination.is_empty() {
                return Err(String::from("there is a combination for an exception outside of the ranges"));
            }
            continue;
        }
        let at = |p: &Poly| values.iter().fold(p.clone(), |p, (v, x)| p.at(*v, x));
        if combination.len() != table.rows.len() || combination.iter().any(|p| at(p) != *p) {
            return Err(String::from("a combination has not one factor for each function"));
        }
        if combination.iter().all(Poly::is_zero) {
            return Err(String::from("all factors of a combination are zero"));
        }
        let content = combination.iter().fold(Rational::ZERO, |g, p| g.gcd(&p.numeric_content()));
        let lead = combination.iter().find_map(Poly::leading_term).is_some_and(|(_, c)| c.is_positive());
        if !content.is_one() || !lead {
            return Err(String::from(
                "the factors of a combination are not whole without a common factor, the leading one positive",
            ));
        }
        let width = table.rows.first().map_or(0, Vec::len);
        for column in 0..width {
            let terms = combination.iter().zip(&table.rows).map(|(c, row)| c * &at(&row[column]));
            if !terms.fold(Poly::zero(), |sum, p| &sum + &p).is_zero() {
                return Err(String::from("a combination of the functions does not vanish at its exception"));
            }
        }
    }
    Ok(())
}

/// Checks that a claim fails at a witness as it says.
///
/// # Errors
/// What is wrong with it, in a sentence.
pub fn witness(family: &Family, claim: &Claim, witness: &Witness) -> Result<(), String> {
    let point = point(family, claim, witness)?;
    if let ClaimKind::Independent(except) = &claim.kind {
        return dependence(family, (&claim.kind, except), witness, &point);
    }
    let expressions = expressions(family, claim);
    let Some((_, value)) = expressions.iter().find(|(of, _)| *of == witness.of) else {
        return Err(format!("the claim says nothing of `{}`", witness.of));
    };
    idle(family, &claim.kind, witness, &|var| value.depends_on(var))?;
    let found = match point.exact() {
        Some(exact) => value.eval(&exact).ok_or("a denominator vanishes at the point")?,
        None if vanishes(value, &point) => Rational::ZERO,
        None => return Err(format!("`{}` is not shown to be zero at the irrational point", witness.of)),
    };
    if found != witness.value {
        return Err(format!("the value of `{}` is {found}", witness.of));
    }
    let holds = match Inequality::of(family, &claim.kind) {
        None => found.is_zero(),
        Some(i) => i.relation.holds(&if i.negate { -&found } else { found }),
    };
    if holds { Err(format!("`{}` is as claimed at the point", witness.of)) } else { Ok(()) }
}

/// The value in a counterexample of a variable that does not matter for it, so that there is one counterexample only.
fn idle_value(kind: &ClaimKind, range: &Range) -> Rational {
    let by_sign = match kind {
        ClaimKind::Relation { comparison, .. } => {
            !matches!(comparison, Comparison::Equal | Comparison::NotEqual)
        }
        ClaimKind::Nonnegative | ClaimKind::Independent(_) => true,
        ClaimKind::PartitionOfUnity | ClaimKind::Symmetric | ClaimKind::Continuity(_) => false,
    };
    if by_sign { crate::decide::simple(range) } else { point::simple(range) }
}

/// Checks that the variables on which nothing depends have their one value. On a simplex this is for the shape parameters: its
/// coordinates depend on each other.
fn idle(
    family: &Family,
    kind: &ClaimKind,
    witness: &Witness,
    matters: &dyn Fn(Var) -> bool,
) -> Result<(), String> {
    let domain: &[_] = if family.is_simplex() { &[] } else { &family.domain };
    let given = fixed(kind);
    for parameter in family.shapes.iter().chain(domain) {
        let var = parameter.var;
        if matters(var) || given.iter().any(|(v, value)| *v == var || value.depends_on(var)) {
            continue;
        }
        let name = &parameter.name;
        let value = Coordinate::Rational(idle_value(kind, &parameter.range));
        if witness.at.iter().any(|(n, c)| n == name && *c != value) {
            return Err(format!("`{name}` does not matter: {} is written there", value.describe(name)));
        }
    }
    Ok(())
}

/// Checks that a claim of a theorem fails at a witness as it says.
///
/// # Errors
/// What is wrong with it, in a sentence.
pub fn theorem_witness(theorem: &Theorem, claim: &TheoremClaim, witness: &Witness) -> Result<(), String> {
    let names = theorem.scalars.iter().map(|p| &p.name);
    if !witness.at.iter().map(|(name, _)| name).eq(names) {
        return Err(String::from("the point has other coordinates than the theorem has scalars"));
    }
    let mut at = vec![Rational::ZERO; theorem.names.len()];
    let mut irrational = Vec::new();
    for ((name, c), scalar) in witness.at.iter().zip(&theorem.scalars) {
        let inside = match c {
            Coordinate::Rational(x) => {
                at[scalar.var.0] = x.clone();
                scalar.range.contains(x)
            }
            Coordinate::Algebraic(x) => {
                irrational.push((scalar.var, x));
                scalar.range.contains(x.low()) && scalar.range.contains(x.high())
            }
        };
        if !inside {
            return Err(format!("`{name}` is outside of its range"));
        }
    }
    if !irrational.is_empty() {
        let net = net_of(theorem, witness)?;
        let vars: Vec<Var> = irrational.iter().map(|(var, _)| *var).collect();
        if evaluated(theorem, &net, &at, &vars) != witness.net {
            return Err(String::from("the control points do not belong to the theorem"));
        }
        // Only inequalities between scalars and directions fail at irrational points alone.
        let (comparison, f) = match &claim.kind {
            TheoremClaimKind::Scalar(comparison, f) => (comparison, f),
            TheoremClaimKind::Parallel(a, b) => {
                let irrational: Vec<(Var, Algebraic)> =
                    irrational.into_iter().map(|(var, x)| (var, x.clone())).collect();
                let (left, right) = claim.text.split_once(" parallel ").unwrap_or((&claim.text, ""));
                let work = &mut Work::new(parallel::WORK);
                let said = witness.of == format!("dot({left}, {right})");
                if !said || !witness.value.is_zero() {
                    return Err(String::from("the claim says nothing of the value"));
                }
                let shown = parallel::one_vanishes(theorem, &net, [a, b], &at, &irrational, work);
                let wrong = || String::from("it is not shown that one side is zero and the other is not");
                return shown.then_some(()).ok_or_else(wrong);
            }
            TheoremClaimKind::Zero(_) => return Err(String::from("an equation fails at rational points")),
        };
        let strict = matches!(comparison, Comparison::Greater | Comparison::Less);
        let mut coordinates: Vec<Coordinate> = at.into_iter().map(Coordinate::Rational).collect();
        for (var, x) in irrational {
            coordinates[var.0] = Coordinate::Algebraic(x.clone());
        }
        let value = on_net(theorem, f, &net);
        let zero = strict && witness.value.is_zero() && vanishes(&value, &Point(coordinates));
        let right = zero && witness.of == claim.difference;
        return if right { Ok(()) } else { Err(String::from("the value is not shown to be zero")) };
    }
    let net = net_of(theorem, witness)?;
    if evaluated(theorem, &net, &at, &[]) != witness.net {
        return Err(String::from("the control points do not belong to the theorem"));
    }
    let known = theorem::contradictions(theorem, claim, &net, &at);
    match known.into_iter().find(|(of, _)| *of == witness.of) {
        Some((_, Some(value))) if value == witness.value => Ok(()),
        Some((of, Some(value))) => Err(format!("the value of `{of}` is {value}")),
        Some((of, None)) => Err(format!("`{of}` is as claimed at the point")),
        None => Err(format!("the claim says nothing of `{}`", witness.of)),
    }
}

/// The net of a witness: the places of the given points. One that is left out, because it is determined at an irrational
/// place, counts nowhere; whether others are missing is seen by who computes the points of this net.
fn net_of(theorem: &Theorem, witness: &Witness) -> Result<Net, String> {
    if witness.net.is_empty() {
        return Ok(Net::new(vec![Vec::new(); theorem.points.len()]));
    }
    let dimension = theorem.dimension.or(witness.net.first().map(|(_, place)| place.len())).unwrap_or(0);
    let place = |name: &String| {
        let named = witness.net.iter().find(|(n, _)| n == name);
        named.map_or_else(|| vec![Rational::ZERO; dimension], |(_, place)| place.clone())
    };
    let points: Vec<Vec<Rational>> = theorem.points.mapped(|p| place(&p.name));
    if theorem.dimension.is_none() && dimension < 2 && !points.is_empty()
        || points.iter().any(|p| p.len() != dimension)
    {
        return Err(String::from("the control points have another dimension"));
    }
    Ok(Net::new(points))
}

/// Coordinates by variable.
struct Point(Vec<Coordinate>);

impl Point {
    /// The coordinates, if all are rational.
    fn exact(&self) -> Option<Vec<Rational>> {
        let rational = |c: &Coordinate| match c {
            Coordinate::Rational(x) => Some(x.clone()),
            Coordinate::Algebraic(_) => None,
        };
        self.0.iter().map(rational).collect()
    }
}

/// The point of a witness, which must name every variable and lie in all ranges.
fn point(family: &Family, claim: &Claim, witness: &Witness) -> Result<Point, String> {
    let parameters: Vec<_> = family.shapes.iter().chain(family.domain_variables()).collect();
    let names = witness.at.iter().map(|(name, _)| name);
    // An irrational point of a simplex has no last coordinate.
    let independent = family.shapes.len() + family.domain.len();
    let rational = witness.at.iter().all(|(_, c)| matches!(c, Coordinate::Rational(_)));
    let complete = names.clone().eq(parameters.iter().map(|p| &p.name))
        || !rational && names.clone().eq(parameters[..independent].iter().map(|p| &p.name));
    if !complete {
        return Err(String::from("the point has other coordinates than the family has variables"));
    }
    for ((name, c), parameter) in witness.at.iter().zip(&parameters) {
        let range = &parameter.range;
        let inside = match c {
            Coordinate::Rational(x) => range.contains(x),
            Coordinate::Algebraic(x) => range.contains(x.low()) && range.contains(x.high()),
        };
        if !inside {
            return Err(format!("`{name}` is outside of its range"));
        }
    }
    if !rational && witness.at.len() > independent {
        // Barycentric coordinates sum to 1.
        let coordinates = witness.at[family.shapes.len()..].mapped(|(_, c)| c.clone());
        let sum = (0..coordinates.len()).fold(-&Poly::one(), |sum, k| &sum + &Poly::var(Var(k)));
        if !several(&sum, &coordinates) {
            return Err(String::from("the barycentric coordinates do not sum to 1"));
        }
    }
    if !rational {
        let coordinates: Vec<Coordinate> =
            witness.at.iter().take(independent).map(|(_, c)| c.clone()).collect();
        for (var, value) in fixed(&claim.kind) {
            let difference = value.as_poly().map(|p| &Poly::var(*var) - p);
            if !difference.is_some_and(|p| several(&p, &coordinates)) {
                return Err(format!("`{}` is not what the claim fixes", family.names[var.0]));
            }
        }
    }
    let point = Point(witness.at.iter().take(independent).map(|(_, c)| c.clone()).collect());
    if let Some(exact) = point.exact() {
        if let Some((_, Coordinate::Rational(last))) = witness.at.get(independent) {
            let sum = exact[family.shapes.len()..].iter().fold(last.clone(), |sum, x| &sum + x);
            if !sum.is_one() {
                return Err(String::from("the barycentric coordinates do not sum to 1"));
            }
        }
        for (var, value) in fixed(&claim.kind) {
            if value.eval(&exact).as_ref() != exact.get(var.0) {
                return Err(format!("`{}` is not what the claim fixes", family.names[var.0]));
            }
        }
    }
    Ok(point)
}

/// Whether a quotient is zero at a point with one irrational coordinate: whether its numerator and the polynomial of the
/// coordinate have a common factor with a root in the interval, in which the polynomial has only the one.
fn vanishes(value: &Fraction, point: &Point) -> bool {
    let mut rest = value.numer().clone();
    let mut irrational = None;
    for (k, c) in point.0.iter().enumerate() {
        match c {
            Coordinate::Rational(x) => rest = rest.at(Var(k), x),
            Coordinate::Algebraic(_) if !rest.depends_on(Var(k)) => {}
            Coordinate::Algebraic(x) if irrational.is_none() => irrational = Some((Var(k), x)),
            Coordinate::Algebraic(_) => return several(value.numer(), &point.0),
        }
    }
    let Some((var, x)) = irrational else { return rest.is_zero() };
    let Some(p) = Univariate::from_poly(&rest, var) else { return false };
    if p.is_zero() {
        return true;
    }
    let Some(common) = p.gcd(x.polynomial(), &mut Work::unlimited()) else { return false };
    common.sign_at(x.low()) * common.sign_at(x.high()) == -1
}

/// The same for several irrational coordinates.
fn several(value: &Poly, point: &[Coordinate]) -> bool {
    let mut rest = value.clone();
    let mut irrational = Vec::new();
    for (k, c) in point.iter().enumerate() {
        match c {
            Coordinate::Rational(x) => rest = rest.at(Var(k), x),
            Coordinate::Algebraic(x) => irrational.push((Var(k), x.clone())),
        }
    }
    crate::decide::is_zero(&rest, &irrational, &mut Work::new(ALGEBRAIC)) == Some(true)
}

/// The work for exact values at points with several irrational coordinates.
const ALGEBRAIC: u64 = 50_000_000;

/// Checks a witness against independence: a combination that vanishes, or a listed exception that is none.
fn dependence(
    family: &Family,
    (kind, except): (&ClaimKind, &[Values]),
    witness: &Witness,
    point: &Point,
) -> Result<(), String> {
    let table = super::coefficient_table(family);
    let (shapes, domain) = point.0.split_at(family.shapes.len());
    let at: Vec<(Var, Coordinate)> = shapes.iter().cloned().enumerate().map(|(k, c)| (Var(k), c)).collect();
    if super::named_point(family, &at, &[]).iter().skip(shapes.len()).zip(domain).any(|((_, a), b)| a != b) {
        return Err(String::from("the domain variables do not matter and have other values than usual"));
    }
    let in_domain = |var: Var| family.domain.iter().any(|p| p.var == var);
    idle(family, kind, witness, &|var| in_domain(var) || independent::depends_on(&table, var))?;
    let listed = |values: &Values| {
        values.iter().all(|(v, x)| matches!(shapes.get(v.0), Some(Coordinate::Rational(y)) if x == y))
    };
    let Some(exact) = point.exact() else {
        // Linear algebra over an extension of the rational numbers is left to the search.
        let mut budget = crate::decide::Budget::scaled(family.budget);
        let here: Vec<(Var, Coordinate)> =
            shapes.iter().cloned().enumerate().map(|(k, c)| (Var(k), c)).collect();
        let dependent = crate::decide::dependent_at(&table, &here, &mut budget) == Some(true);
        let as_said =
            witness.of == independent::SQUARES && witness.value.is_zero() && !except.iter().any(listed);
        return if dependent && as_said {
            Ok(())
        } else {
            Err(String::from("the functions are not shown to be dependent at the irrational point"))
        };
    };
    let rows: Vec<Vec<Rational>> = table.rows.mapped(|row| row.mapped(|p| p.eval(&exact)));
    let product =
        |a: &[Rational], b: &[Rational]| a.iter().zip(b).fold(Rational::ZERO, |s, (x, y)| &s + &(x * y));
    let gram = rows.mapped(|a| rows.mapped(|b| product(a, b)));
    let work = &mut crate::decide::Budget::scaled(family.budget).work;
    let spent = || String::from("the budget is spent on the determinant of the coefficients");
    let squares = determinant(gram, work).ok_or_else(spent)?;
    if witness.of == independent::SQUARES {
        return if squares == witness.value && !squares.is_zero() && except.iter().any(listed) {
            Ok(())
        } else {
            Err(format!("the sum of the squares of the maximal minors is {squares}"))
        };
    }
    if !squares.is_zero() || except.iter().any(listed) {
        return Err(String::from("the point does not contradict independence"));
    }
    let dependence = crate::decide::Dependence {
        point: shapes.iter().cloned().enumerate().map(|(k, c)| (Var(k), c)).collect(),
        combination: crate::algebra::matrix::vanishing_combination(&rows, work).map_err(|_| spent())?,
    };
    let expected = independent::dependent_at(family, &dependence);
    if expected.of == witness.of && witness.value.is_zero() {
        Ok(())
    } else {
        Err(format!("the combination that vanishes is `{}`", expected.of))
    }
}
