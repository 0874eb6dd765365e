//! Families on simplices, boxes and products of both: values, and the table from which everything else follows.
//!
//! A family that is raised from a lowest order is planned as the functions of that order and the steps, written out, to
//! its own; each step is a sum of products of nonnegative coordinates with functions, so it keeps signs and small
//! relative errors.

pub mod form;

use self::form::{PatchForm, PatchFunction, exponents, multi_indices, raised};
use super::{Builder, Input, Let, Node, Plan, Ref};
use crate::algebra::poly::Poly;
use crate::algebra::rational::Rational;
use crate::model::{Family, Function};
use basis_prover::collections::list::{Listed, Mapped};
use basis_prover::collections::map::SortedMap;

/// Longer sums are not written out, but on products of simplices and intervals.
const MAX_TERMS: usize = 15;

/// The longest sum that is written out there.
const MAX_ON_PRODUCTS: usize = 512;

/// A family on a simplex or a box, as it is evaluated.
#[cfg_attr(any(test, feature = "rounding"), derive(Clone, Debug))]
pub struct PatchPlans<'a> {
    /// The family.
    pub family: &'a Family,
    /// The form of the functions, or of those of the lowest order.
    pub form: PatchForm,
    /// How often these are raised by `b[I] = Σ_j x_j b[I − e_j]`.
    pub steps: u32,
}

/// The Bernstein weights of the functions: a table with few different entries.
#[cfg_attr(any(test, feature = "rounding"), derive(Clone, Debug))]
pub struct Table {
    /// The different entries.
    pub entries: Plan,
    /// Which of them stands where: one row for each Bernstein coefficient, in it one place for each function. The table
    /// of a family that is raised is that of the lowest order.
    pub places: Vec<usize>,
}

impl<'a> PatchPlans<'a> {
    /// The form of a family; `None` when it is too large.
    pub fn new(family: &'a Family) -> Option<Self> {
        let steps = recursion(family);
        let functions = if steps > 0 { &family.base } else { &family.functions };
        let form = PatchForm::of_functions(family, functions)?;
        let terms = |f: &PatchFunction| f.inner.iter().filter(|c| !c.is_zero()).count();
        if family.is_product() && form.functions.iter().any(|f| terms(f) > MAX_ON_PRODUCTS) {
            return None;
        }
        Some(Self { family, form, steps })
    }

    /// The functions that are written out: all, or those of the lowest order.
    pub fn functions(&self) -> &'a [Function] {
        if self.steps > 0 { &self.family.base } else { &self.family.functions }
    }

    /// The number of coordinates of a point of the domain.
    pub fn corners(&self) -> usize {
        self.family.domain.len() + self.family.simplices.len()
    }

    /// The degrees of the functions of the family, by group of coordinates.
    pub fn degrees(&self) -> Vec<u32> {
        self.form.degrees.mapped(|degree| degree + self.steps)
    }

    /// The sum of the indices of the functions of the lowest order.
    pub fn lowest(&self) -> u32 {
        self.family.base.first().map_or(0, |f| f.index.iter().sum::<i64>() as u32)
    }

    /// The number of Bernstein coefficients of each function of the family.
    pub fn coefficients(&self) -> usize {
        exponents(&self.form.groups, &self.degrees()).len()
    }

    /// The values of all functions.
    pub fn values(&self) -> Plan {
        let mut builder = Builder::of(self.family);
        self.coordinates(&mut builder);
        let values = self.form.functions.mapped(|f| self.value(f, &mut builder));
        if self.steps == 0 {
            let values = builder.cut_off(values, &self.family.nonnegative);
            return builder.finish(values);
        }
        let (lists, values) = self.raised(&mut builder, values);
        builder.finish_with(lists, vec![values])
    }

    /// All coordinates with their names: x0, x1, … of a simplex, x0, s0, x1, s1, … of a box, both of a product.
    fn coordinates(&self, builder: &mut Builder) {
        let mut next = 0;
        for group in &self.form.groups {
            let k = next;
            let Some((low, high)) = &group.range else {
                next += group.vars.len() + 1;
                for k in k..next {
                    let x = builder.input(Input::Coordinate(k));
                    builder.coordinates.push((format!("x{k}"), x));
                }
                continue;
            };
            next += 1;
            let (s_name, x_name) = (format!("s{k}"), format!("x{k}"));
            let t = builder.input(Input::Coordinate(k));
            let [s, x] = builder.unit([low, high], t, &[s_name.clone(), x_name.clone()]);
            builder.coordinates.extend([(x_name, x), (s_name, s)]);
        }
    }

    /// The steps of the recursion, written out: lists of the functions of each order, and the last of them.
    fn raised(&self, builder: &mut Builder, values: Vec<Ref>) -> (Vec<Let>, Ref) {
        let corners = self.corners();
        let name = || vec![String::from("b")];
        let mut list = builder.push(Node::List(values));
        let mut lists = vec![Let { names: name(), value: list }];
        let last = self.lowest() + self.steps;
        for order in self.lowest()..last {
            let before = multi_indices(corners, order);
            let parts = (0..before.len()).map(|place| builder.push(Node::Part(list, place))).listed();
            let mut entries = Vec::new();
            for mut index in multi_indices(corners, order + 1) {
                let mut sum: Option<Ref> = None;
                for j in 0..corners {
                    if index[j] == 0 {
                        continue;
                    }
                    index[j] -= 1;
                    let place = before.binary_search(&index).unwrap_or(0);
                    index[j] += 1;
                    let term = builder.push(Node::Product(builder.coordinates[j].1, parts[place]));
                    sum = Some(match sum {
                        None => term,
                        Some(sum) => builder.push(Node::Sum(sum, term)),
                    });
                }
                // An index of an order above 0 has a part above 0.
                entries.extend(sum);
            }
            if order + 1 == last {
                entries = builder.cut_off(entries, &self.family.nonnegative);
            }
            list = builder.push(Node::List(entries));
            lists.push(Let { names: name(), value: list });
        }
        (lists, list)
    }

    /// content · h² · Σ inner · monomial · powers, over the denominator.
    fn value(&self, f: &PatchFunction, builder: &mut Builder) -> Ref {
        let mut product: Vec<Ref> = Vec::new();
        if !f.content.is_one() {
            product.push(builder.number(f.content.clone()));
        }
        if let Some((degrees, root)) = &f.square {
            let root = self.sum(root, degrees, builder);
            product.push(builder.squared(root));
        }
        match f.inner.as_slice() {
            [] => return builder.number(Rational::ZERO),
            [one] if one.is_one() => {}
            [one] => product.push(builder.scalar(one)),
            _ => product.push(self.sum(&f.inner, &f.inner_degrees, builder)),
        }
        product.extend(builder.monomial(&f.powers));
        product.extend(builder.reciprocal(&f.denom));
        builder.product(&product)
    }

    /// A sum: written out as long as it is short, which is faster, else by nested multiplication in a loop.
    fn sum(&self, coefficients: &[Poly], degrees: &[u32], builder: &mut Builder) -> Ref {
        let present = coefficients.iter().filter(|c| !c.is_zero()).count();
        if present > MAX_TERMS && !self.family.is_product() {
            let coefficients = coefficients.mapped(|c| builder.scalar(c));
            let at = builder.coordinates.mapped(|(_, x)| *x);
            return builder.push(if self.family.is_simplex() {
                Node::SimplexSum { coefficients, at, degree: degrees[0] }
            } else {
                let units = at.chunks(2).map(|pair| [pair[1], pair[0]]).listed();
                Node::BoxSum { coefficients, degrees: degrees.to_vec(), units }
            });
        }
        let mut sum: Option<Ref> = None;
        let terms = coefficients.iter().zip(exponents(&self.form.groups, degrees));
        for (c, e) in terms.filter(|(c, _)| !c.is_zero()) {
            let negative = c.as_constant().is_some_and(|c| c.is_negative());
            let c = if negative { -c } else { c.clone() };
            let monomial = builder.monomial(&e);
            let factor = (!c.is_one() || monomial.is_none()).then(|| builder.scalar(&c));
            let term = builder.product(&factor.into_iter().chain(monomial).listed());
            sum = Some(match (sum, negative) {
                (None, false) => term,
                (None, true) => builder.neg(term),
                (Some(sum), false) => builder.push(Node::Sum(sum, term)),
                (Some(sum), true) => builder.push(Node::Difference(sum, term)),
            });
        }
        // A function with coefficients is not 0.
        sum.unwrap_or_else(|| builder.number(Rational::ZERO))
    }

    /// The Bernstein coefficients, one column for each function.
    pub fn table(&self) -> Table {
        let mut builder = Builder::of(self.family);
        let mut known: SortedMap<(&Poly, &Poly), usize> = SortedMap::new();
        let mut entries: Vec<Ref> = Vec::new();
        let (zero, one) = (Poly::zero(), Poly::one());
        let mut places: Vec<usize> = Vec::new();
        for row in 0..self.form.coefficients() {
            for f in &self.form.functions {
                let c = &f.bernstein[row];
                let key = if c.is_zero() { (&zero, &one) } else { (c, &f.denom) };
                let place = *known.get_or_insert_with(key, || {
                    entries.push(builder.quotient(key.0, key.1));
                    entries.len() - 1
                });
                places.push(place);
            }
        }
        Table { entries: builder.finish(entries), places }
    }
}

/// How many steps b[I] = Σ_j x_j b[I − e_j] lead from the functions of the lowest order to those of the family; 0 when
/// its recursion is another one.
fn recursion(family: &Family) -> u32 {
    let corners = family.domain.len() + 1;
    if !family.is_simplex() || !lattice(&family.base, corners) || !lattice(&family.functions, corners) {
        return 0;
    }
    let order = |functions: &[Function]| functions.first().map_or(0, |f| f.index.iter().sum::<i64>());
    let steps = order(&family.functions) - order(&family.base);
    let mut functions = family.base.clone();
    for _ in 0..steps {
        functions = raised(family, &functions);
    }
    let same = functions.iter().zip(&family.functions).all(|(a, b)| a.index == b.index && a.value == b.value);
    if steps > 0 && same { steps as u32 } else { 0 }
}

/// Whether the functions are those of all indices (i, j, …) with one sum.
pub(crate) fn lattice(functions: &[Function], corners: usize) -> bool {
    let Some(first) = functions.first().filter(|f| f.index.len() == corners) else { return false };
    // The model has checked that there is no gap.
    u32::try_from(first.index.iter().sum::<i64>())
        .is_ok_and(|order| multi_indices(corners, order).len() == functions.len())
}
