//! Equations: expand, subtract, and nothing or something is left.

use basis_kernel::Statement;
use basis_prover::collections::list::{Listed, Mapped};

use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, PolyExt, Var};
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::claim::{ClaimKind, Joint};
use crate::model::angle::Kind;
use crate::model::{Factor, Family, Function, Parameter};
use crate::plural::abbreviated;
use crate::state::verdict::Witness;

/// Σ bᵢ = 1; `None` when the work is spent on the common denominator.
pub(super) fn partition_of_unity(family: &Family, work: &mut Work) -> Option<Vec<(String, Fraction)>> {
    let mut sum = Fraction::constant(-&Rational::ONE);
    for function in &family.functions {
        sum = sum.add_within(&function.value, work)?;
    }
    let labels: Vec<String> = (0..family.functions.len()).map(|k| family.function_label(k)).listed();
    Some(vec![(format!("{} - 1", labels.join(" + ")), sum)])
}

/// On an interval bᵢ(t) = bₙ₋ᵢ(low + high − t), on a box the same in every variable; on a simplex any two corners
/// can be exchanged together with their indices, and so all of them. On a product the same in every factor.
pub(super) fn symmetric(family: &Family, work: &mut Work) -> Option<Vec<(String, Fraction)>> {
    let mut differences = Vec::new();
    for motion in motions(family) {
        for (k, function) in family.functions.iter().enumerate() {
            // Its partner is looked for among all functions, its terms are moved, all arguments are written down.
            let terms = function.value.numer().len() + function.value.denom().len();
            work.spend((family.functions.len() / 2 + 10 * (terms + family.domain.len())) as u64)?;
            let Some(moved_index) = motion.index(&function.index) else {
                if let Some(moved) = motion.apply(&function.value) {
                    differences.push(unnumbered(family, &motion, k, &moved, work)?);
                }
                continue;
            };
            let Some(other) = family.functions.iter().position(|f| f.index == moved_index) else { continue };
            // A motion is its own inverse: what holds for a function holds for its partner.
            if other < k {
                continue;
            }
            let Some(moved) = motion.apply(&family.functions[other].value) else { continue };
            let (this, that) = (family.function_label(k), family.function_label(other));
            let of = format!("{this} - {that}({})", motion.arguments(family));
            differences.push((of, function.value.sub_within(&moved, work)?));
        }
    }
    Some(differences)
}

/// What symmetry says: this function is that one with these arguments in place of the domain variables, of a simplex all
/// barycentric coordinates, for each motion that generates the symmetries of the domain.
#[cfg(any(test, feature = "tools"))]
pub(crate) fn moves(family: &Family) -> Vec<(usize, usize, Vec<Poly>)> {
    let mut all = Vec::new();
    for motion in motions(family) {
        for (k, function) in family.functions.iter().enumerate() {
            let arguments = motion.all_arguments(family);
            match motion.index(&function.index) {
                Some(moved) => {
                    let other = family.functions.iter().position(|f| f.index == moved);
                    all.extend(other.filter(|other| *other >= k).map(|other| (k, other, arguments)));
                }
                None => {
                    let Some(moved) = motion.apply(&function.value) else { continue };
                    let other = family.functions.iter().position(|f| f.value == moved).unwrap_or(k);
                    all.push((other, k, arguments));
                }
            }
        }
    }
    all
}

/// Whether the indices of the functions say nothing about the domain.
fn is_unnumbered(family: &Family) -> bool {
    family.pieces.is_empty()
        && motions(family)
            .iter()
            .any(|motion| family.functions.iter().any(|f| motion.index(&f.index).is_none()))
}

/// In a numbering that says nothing about the domain, a moved function must be one of the functions: its difference
/// from that one, or from the function itself if it is none of them.
fn unnumbered(
    family: &Family,
    motion: &Motion,
    k: usize,
    moved: &Fraction,
    work: &mut Work,
) -> Option<(String, Fraction)> {
    let other = family.functions.iter().position(|f| f.value == *moved).unwrap_or(k);
    let (this, that) = (family.function_label(k), family.function_label(other));
    let of = format!("{that} - {this}({})", motion.arguments(family));
    Some((of, family.functions[other].value.sub_within(moved, work)?))
}

/// A motion of the domain onto itself with what it does to the indices.
struct Motion {
    /// New values of the independent variables that it moves.
    by: Vec<(Var, Poly)>,
    /// New values of variables that are angles, after the others.
    angles: Vec<(Var, Fraction)>,
    /// The same for reading, the dependent variable of a simplex included.
    shown: Vec<(Var, String)>,
    /// The two places of an index that change: two equal ones are reversed, up to the last index; `None` when the
    /// indices are not those of the coordinates.
    places: Option<(usize, usize)>,
    last: Vec<i64>,
}

impl Motion {
    fn index(&self, index: &[i64]) -> Option<Vec<i64>> {
        let mut moved = index.to_vec();
        let (a, b) = self.places?;
        if a == b {
            moved[a] = self.last[a] - index[a];
        } else {
            moved.swap(a, b);
        }
        Some(moved)
    }

    /// The new values of all domain variables in their order, for reading.
    fn arguments(&self, family: &Family) -> String {
        let shown = |var| self.shown.iter().find(|(v, _)| *v == var).map(|(_, text)| text.clone());
        let all = family.domain_variables();
        let all = all.map(|p| shown(p.var).unwrap_or_else(|| family.name_of(p).to_string())).listed();
        all.join(", ")
    }

    /// The new values of all domain variables in their order.
    #[cfg(any(test, feature = "tools"))]
    fn all_arguments(&self, family: &Family) -> Vec<Poly> {
        let of = |p: &Parameter| {
            let moved = self.by.iter().find(|(v, _)| *v == p.var);
            moved.map_or_else(|| Poly::var(p.var), |(_, by)| by.clone())
        };
        let mut all = Vec::new();
        for factor in family.factors() {
            let (independent, is_simplex) = match factor {
                Factor::Interval(only) => (core::slice::from_ref(only), false),
                Factor::Simplex(independent, _) => (independent, true),
            };
            let own: Vec<Poly> = independent.iter().map(of).listed();
            let rest = own.iter().fold(Poly::one(), |rest, p| &rest - p);
            all.extend(own);
            all.extend(is_simplex.then_some(rest));
        }
        all
    }

    /// The function at the moved point.
    fn apply(&self, f: &Fraction) -> Option<Fraction> {
        // First the variables that take the places of others, all at once; then at most one that takes the place of an
        // expression: it keeps its name meanwhile, because what occurs in the expression is renamed already.
        let width = self
            .by
            .iter()
            .map(|(v, _)| v.0 + 1)
            .chain(f.numer().variables().last().map(|v| v.0 + 1))
            .chain(f.denom().variables().last().map(|v| v.0 + 1))
            .max()?;
        let mut names: Vec<Var> = (0..width).map(Var).listed();
        let mut substituted = None;
        for (var, value) in &self.by {
            match value.variables().as_slice() {
                [only] if *value == Poly::var(*only) => names[var.0] = *only,
                _ => substituted = Some((*var, value)),
            }
        }
        let moved = |p: &Poly| {
            let renamed = p.rename(&names);
            substituted.map_or_else(|| renamed.clone(), |(var, value)| renamed.substitute(var, value))
        };
        if !self.angles.is_empty() {
            // Each value contains its own variable only, and what is fixed.
            let renamed = Fraction::new(moved(f.numer()), moved(f.denom()))?;
            return self.angles.iter().try_fold(renamed, |f, (var, value)| f.substitute(*var, value));
        }
        let denom = f.denom();
        let fixed = self.by.iter().all(|(var, _)| !denom.depends_on(*var));
        Fraction::new(moved(f.numer()), if fixed { denom.clone() } else { moved(denom) })
    }
}

/// Motions that generate all symmetries of the domain: of each factor by itself.
fn motions(family: &Family) -> Vec<Motion> {
    let Some(last) = family.functions.last().map(|f| f.index.clone()) else { return Vec::new() };
    let factors = family.factors();
    let count = |factor: &Factor<'_>| factor.variables().count();
    let numbered = last.len() == factors.iter().map(count).sum::<usize>();
    let mut all = Vec::new();
    let mut place = 0;
    for factor in &factors {
        match factor {
            Factor::Interval(variable) => all.extend(reversal(family, variable, place, &last)),
            Factor::Simplex(independent, dependent) => {
                for k in 0..independent.len() {
                    all.push(exchange((independent, dependent), k, place, &last));
                }
            }
        }
        place += count(factor);
    }
    for motion in &mut all {
        motion.places = motion.places.filter(|_| numbered);
    }
    all
}

/// Two neighbouring coordinates of a simplex are exchanged, the independent ones followed by the dependent one; they begin
/// at a place of the index.
fn exchange(
    (independent, dependent): (&[Parameter], &Parameter),
    k: usize,
    place: usize,
    last: &[i64],
) -> Motion {
    let rest = || independent.iter().fold(Poly::one(), |rest, p| &rest - &Poly::var(p.var));
    let coordinate = |k: usize| independent.get(k).map_or_else(rest, |p| Poly::var(p.var));
    let moved = |(k, other): (usize, usize)| Some((independent.get(k)?.var, coordinate(other)));
    let [this, that] = [&independent[k], independent.get(k + 1).unwrap_or(dependent)];
    Motion {
        by: [(k, k + 1), (k + 1, k)].into_iter().filter_map(moved).listed(),
        angles: Vec::new(),
        shown: vec![(this.var, that.name.clone()), (that.var, this.name.clone())],
        places: Some((place + k, place + k + 1)),
        last: last.to_vec(),
    }
}

/// An interval is reversed, whose variable has a place in the index.
fn reversal(family: &Family, variable: &Parameter, place: usize, last: &[i64]) -> Option<Motion> {
    let (low, high) = variable.range.finite()?;
    let angle = family.analytic.angle(variable.var);
    let angles = angle.map_or_else(Vec::new, |a| a.mirror.clone());
    let reversed = match angle {
        Some(_) => Poly::var(variable.var),
        None => &Poly::constant(low + high) - &Poly::var(variable.var),
    };
    let shown = match (angles.last(), angle) {
        (Some(_), Some(a)) if a.ends[0] == "0" => format!("{} - {}", a.ends[1], a.name),
        (Some((_, itself)), _) => itself.display(&family.names),
        (None, _) => reversed.display(&family.names).to_string(),
    };
    Some(Motion {
        by: vec![(variable.var, reversed)],
        angles,
        shown: vec![(variable.var, shown)],
        places: Some((place, place)),
        last: last.to_vec(),
    })
}

/// Neighbouring segments over control points P[0], P[1], … and P[1], P[2], … have the same derivatives of every order
/// up to `order` where they meet: b[i] at the lower end is b[i + 1] at the upper end, and what has no partner
/// vanishes. `None` where a value has no form.
pub(super) fn continuity(family: &Family, joint: &Joint) -> Option<Vec<(String, Fraction)>> {
    let mut differences = Vec::new();
    let len = family.functions.len();
    let [low_text, high_text] = family.end_texts()?;
    // By function and order.
    let at = |upper: bool| -> Option<Vec<Vec<Fraction>>> {
        let work = &mut Work::unlimited();
        let of = |f: &Function| family.derivatives_at_end(&f.value, joint.order, upper, work);
        family.functions.iter().map(of).collect()
    };
    let (at_low, at_high) = (at(false)?, at(true)?);
    let last_at = |k: usize, order: u32| at_high.get(k)?.get(order as usize);
    let name = |k: usize, order: u32, end: &str| {
        let b = family.function_label(k);
        match order {
            0 => format!("{b}({end})"),
            1 => format!("D({b})({end})"),
            _ => format!("D({b}, {order})({end})"),
        }
    };
    // The next segment may have other shape values.
    let aside = joint.free.iter().map(|p| p.var.0 + 1).max().unwrap_or(0).max(family.names.len());
    let next = |mut f: Fraction| {
        // Another value of an angle would be another one of its tangent.
        if family.analytic.angles.iter().any(|a| f.depends_on(a.itself)) {
            return None;
        }
        for (k, shape) in family.shapes.iter().enumerate() {
            f = f.substitute(shape.var, &Fraction::var(Var(aside + k)))?;
        }
        for (k, by) in joint.next.iter().enumerate() {
            f = f.substitute(Var(aside + k), by)?;
        }
        Some(f)
    };
    let next_at = |k: usize, order: u32| {
        let f = at_low[k].get(order as usize)?.clone();
        if joint.next.is_empty() { Some(f) } else { next(f) }
    };
    for order in 0..=joint.order {
        for k in 0..=len {
            let mut difference = Fraction::zero();
            let mut parts = Vec::new();
            // A denominator vanishes nowhere on the domain, so that there is a value at its ends.
            if let Some(before) = k.checked_sub(1) {
                difference = next_at(before, order)?;
                parts.push(name(before, order, &low_text));
            }
            if k < len {
                difference = &difference - last_at(k, order)?;
                parts.push(name(k, order, &high_text));
            }
            let of = if k == 0 { format!("-{}", parts.concat()) } else { parts.join(" - ") };
            differences.push((of, difference));
        }
    }
    Some(differences)
}

/// A function, and names, in the variables themselves where their ranges end at shape parameters: in place of the part y of
/// the way between the ends that stands for one, x = low + width·y.
fn in_variables(family: &Family, f: Fraction) -> (Fraction, Vec<String>) {
    let mut names = family.names.clone();
    let mut f = f;
    for angle in family.analytic.angles.iter().filter(|a| a.kind == Kind::Linear) {
        let rise = &Fraction::var(angle.var) - &angle.low;
        let Some(own) = rise.checked_div(&angle.width) else { continue };
        if let Some(put) = f.substitute(angle.var, &own) {
            f = put;
            names[angle.var.0].clone_from(&angle.name);
        }
    }
    (f, names)
}

/// What it means that an expression is not as claimed.
pub(super) fn notes(family: &Family, kind: &ClaimKind, witness: &Witness) -> Vec<String> {
    let of = &witness.of;
    let point = witness.point();
    let here = if point.is_empty() { String::new() } else { format!("at {point} ") };
    let place = if point.is_empty() { String::new() } else { format!(" at {point}") };
    if !matches!(witness.refutation().statement(), Statement::Zero { .. }) {
        let mut all = vec![format!("`{of}` is {}{place}", witness.value_text())];
        if matches!(kind, ClaimKind::TotallyPositive) {
            all.push(String::from(
                "of totally positive functions, and of their Wronskians in ascending order, none is negative",
            ));
        }
        return all;
    }
    let expressions =
        basis_prover::working(family.budget, &mut |work| super::expressions(family, kind, false, work));
    let own = expressions.unwrap_or_default().into_iter().find(|(label, ..)| label == of);
    // What is too long to be expanded once more has only its value.
    let is_known = own.is_some();
    let difference = own.map_or_else(Fraction::zero, |(_, value, _)| value);
    let (readable, mut names) = in_variables(family, difference.clone());
    if let ClaimKind::Continuity(joint) = kind {
        names.extend(joint.free.iter().map(|p| p.name.clone()));
    }
    // A formula in tangents of halves is not what was written, and long.
    let in_tangents =
        family.analytic.angles.iter().any(|a| a.kind != Kind::Linear && difference.depends_on(a.var));
    let shown = abbreviated(&readable.display(&names));
    let is_number = difference.as_constant().is_some();
    match kind {
        ClaimKind::PartitionOfUnity => {
            let one = Fraction::constant(Rational::ONE);
            let value = match &witness.shown {
                Some(value) => format!("1 + {value}"),
                None => (&witness.value + &Rational::ONE).to_string(),
            };
            if in_tangents || !is_known {
                return vec![format!("the sum of the functions is {value}{place}")];
            }
            let sum = abbreviated(&(&readable + &one).display(&names));
            vec![format!("the sum of the functions is `{sum}`"), format!("{here}it is {value}")]
        }
        ClaimKind::Continuity(joint) => {
            let all = continuity(family, joint).unwrap_or_default();
            let k = all.iter().position(|(label, _)| label == of).unwrap_or(0);
            let order = k / (family.functions.len() + 1);
            vec![
                format!("the derivatives of order {order} of neighbouring segments differ where they meet"),
                format!("`{of}` is `{shown}`"),
            ]
        }
        ClaimKind::Relation { differences, fixed, .. } => {
            let at = if fixed.is_empty() {
                String::new()
            } else {
                format!(" at {}", describe_fixed(family, fixed))
            };
            let sides = differences.iter().map(|(_, d)| d).find(|d| d.text == *of && d.value == difference);
            let (left, right) = sides.map(|d| (d.left.as_str(), d.right.as_str())).unwrap_or_default();
            let by = if in_tangents { String::new() } else { format!(" by `{shown}`") };
            let mut notes = vec![format!("`{left}`{at} differs from `{right}`{by}")];
            if !is_number {
                notes.push(format!("{here}the difference is {}", witness.value_text()));
            }
            notes
        }
        ClaimKind::Symmetric if is_unnumbered(family) => vec![
            String::from("a function, once moved, is not among the functions and differs from itself"),
            format!("`{of}` is {}{place}", witness.value_text()),
        ],
        _ if is_number && is_known => vec![format!("`{of}` is {}", witness.value_text())],
        _ if in_tangents || !is_known => vec![format!("`{of}` is {}{place}", witness.value_text())],
        _ => vec![format!("`{of}` is `{shown}`"), format!("{here}it is {}", witness.value_text())],
    }
}

/// The values that a block fixes; of an angle the angle, not its tangent as well.
fn describe_fixed(family: &Family, fixed: &[(Var, Fraction)]) -> String {
    let is_fixed = |var: Var| fixed.iter().any(|(v, _)| *v == var);
    let is_said = |var: Var| {
        family.analytic.angles.iter().any(|a| a.var == var && a.itself != var && is_fixed(a.itself))
    };
    let said = fixed.iter().filter(|(v, _)| !is_said(*v)).listed();
    said.mapped(|(v, f)| format!("{} = {}", family.names[v.0], f.display(&family.names))).join(", ")
}
