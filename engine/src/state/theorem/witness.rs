//! Counterexamples as witnesses that show a claim about a theorem to be false.

use basis_prover::collections::list::Listed;
use basis_prover::{Coordinate, Counterexample, typical};

use super::net::{Net, evaluated, nets, sparse};
use crate::algebra::poly::Var;
use crate::algebra::range::Range;
use crate::algebra::rational::Rational;
use crate::claim::{Claim, ClaimKind, Comparison};
use crate::model::{Parameter, label};
use crate::state::verdict::{Verdict, Witness};
use crate::theorem::{Form, Theorem, Unit};

/// Regular nets have at most this number of points that matter.
const MAX_REGULAR: usize = 8;

/// A witness from a counterexample to what the claim says of the points of a net; without one, of any points.
pub(super) fn witness(
    theorem: &Theorem,
    of: String,
    net: Option<&Net>,
    found: &Counterexample,
    negate: bool,
) -> Witness {
    let mut at = vec![Rational::ZERO; theorem.names.len()];
    let mut named = Vec::new();
    let mut irrational = Vec::new();
    let given = |var: Var| found.point.iter().find(|(v, _)| *v == var).map(|(_, c)| c.clone());
    // Of a part of the values the image of the point of its box.
    let own =
        |p: &Parameter| (p.var, given(p.var).unwrap_or_else(|| Coordinate::Rational(typical(&p.range))));
    let values = theorem.part.image(&theorem.scalars.iter().map(own).listed());
    for scalar in &theorem.scalars {
        let Some((_, value)) = values.iter().find(|(var, _)| *var == scalar.var) else {
            irrational.push(scalar.var);
            continue;
        };
        let value = value.clone();
        match &value {
            Coordinate::Rational(x) => at[scalar.var.0] = x.clone(),
            Coordinate::Algebraic(_) => irrational.push(scalar.var),
        }
        named.push((scalar.name.clone(), value));
    }
    let mut notes = Vec::new();
    for var in theorem.points.iter().flat_map(|point| &point.coordinates) {
        match given(*var) {
            Some(Coordinate::Rational(x)) => at[var.0] = x,
            Some(c @ Coordinate::Algebraic(_)) => {
                irrational.push(*var);
                notes.push(c.describe(&theorem.names[var.0]));
            }
            None => {}
        }
    }
    let mut witness = Witness::at_point(of, named, found, negate);
    witness.notes = notes;
    witness.given = net.map_or_else(Vec::new, |net| net.places().to_vec());
    let own = Net::from_coordinates(theorem, &at);
    witness.net = evaluated(theorem, net.unwrap_or(&own), &at, &irrational);
    witness
}

/// The verdict with a witness; texts leave out the scalars and points that do not matter to the claim.
pub(super) fn explained(theorem: &Theorem, claim: &Claim, mut witness: Witness, what: &str) -> Verdict {
    witness.idle = idle(theorem, &claim.kind);
    let at = witness.point();
    let place = if at.is_empty() { String::new() } else { format!(" at {at}") };
    witness.notes.push(format!("{what} `{}` = {}{place}", witness.of, witness.value_text()));
    let equation = matches!(
        claim.kind,
        ClaimKind::Vector { .. } | ClaimKind::Scalar { comparison: Comparison::Equal, .. }
    );
    if !equation {
        // The sign of a scalar without a range is easily forgotten.
        let value_of = |scalar: &Parameter| witness.at.iter().find(|(name, _)| *name == scalar.name);
        let values = theorem.scalars.iter().filter_map(|scalar| Some((scalar, value_of(scalar)?)));
        let any = values.filter(|(scalar, (_, value))| {
            scalar.range == Range::all()
                && claim.kind.depends_on(scalar.var)
                && matches!(value, Coordinate::Rational(x) if !x.is_positive())
        });
        let notes: Vec<String> = any
            .map(|(scalar, _)| {
                let name = &scalar.name;
                format!("`{name}` can be any number; `scalar 0 < {name};` declares it positive")
            })
            .listed();
        witness.notes.extend(notes);
    }
    Verdict::Refuted(Box::new(witness))
}

/// Nets that show two things to be different, such as a person can read: with most points in one place if there are
/// many.
pub(super) fn witness_nets(theorem: &Theorem, claim: &Claim) -> impl Iterator<Item = Net> {
    let idle = idle(theorem, &claim.kind);
    let used = theorem.points.iter().filter(|point| !idle.contains(&point.name)).count();
    let first = if used > MAX_REGULAR { Some(sparse(theorem)) } else { None };
    first.into_iter().flatten().chain(nets(theorem))
}

/// The scalars on which a claim does not depend, and the points: those that it does not contain once determined points
/// are expressed by given ones.
fn idle(theorem: &Theorem, kind: &ClaimKind) -> Vec<String> {
    let forms: &[&Form] = match kind {
        ClaimKind::Vector { value, .. } => &[value],
        ClaimKind::Parallel { left, right } => &[&left.value, &right.value],
        _ => &[],
    };
    let mut used = Vec::new();
    if theorem.dimension.is_none() {
        for unit in forms.iter().flat_map(|form| form.terms.keys()) {
            match unit {
                Unit::Point(p) => used.push(*p),
                Unit::Pair(p, q) => used.extend([*p, *q]),
            }
        }
    }
    let products = theorem.products.iter().filter(|(var, _)| kind.depends_on(*var));
    used.extend(products.flat_map(|(_, (p, q))| [*p, *q]));
    let matters = |label: &String| {
        let mut given = theorem.points.iter().enumerate().filter(|(_, point)| point.name == *label);
        given.any(|(k, point)| used.contains(&k) || point.coordinates.iter().any(|var| kind.depends_on(*var)))
    };
    // What is assumed of a scalar together with one that matters has to hold at the point, too.
    let premises = theorem.scalar_domain();
    let related = |var: Var| {
        let mut own = premises.premises.iter().map(|(g, _)| g).filter(|g| g.depends_on(var));
        own.any(|g| g.variables().into_iter().any(|other| kind.depends_on(other)))
    };
    let alone = theorem.scalars.iter().filter(|p| !kind.depends_on(p.var) && !related(p.var));
    let scalars = alone.map(|p| p.name.clone());
    let labels = theorem
        .patches
        .iter()
        .flat_map(|patch| patch.points.iter().map(|point| label(&patch.name, &point.index)));
    scalars.chain(labels.filter(|label| !matters(label))).listed()
}
