//! Families as exact tables of functions over a domain and shape parameters.

use core::ops::Range as Places;
use std::borrow::Cow;
use std::rc::Rc;

use basis_kernel::{Domain, Simplex};

use super::angle::Analytic;
use super::chart::{self, Constraint, Piece};
use super::obligation::Obligation;
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::{DisplayRange as _, Range, Region};
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::diagnostic::Place;
use crate::source::SourceId;
use basis_prover::collections::list::{Listed, Mapped};

/// A family of basis functions of one order.
#[derive(Clone, Debug)]
pub struct Family {
    /// The name.
    pub name: String,
    /// The doc comment, one string a line.
    pub doc: Vec<String>,
    /// The values of the index parameters, such as n = 3.
    pub order: Vec<(String, i64)>,
    /// The spec that defines it.
    pub source: SourceId,
    /// Where its name stands.
    pub place: Place,
    /// The names of all variables: the shape parameters, then the domain variables.
    pub names: Vec<String>,
    /// The shape parameters, variables 0, 1, …
    pub shapes: Vec<Parameter>,
    /// What is assumed of the shape parameters beside their ranges.
    pub constraints: Vec<Constraint>,
    /// The shape parameters that an assumed equation determines, with their values.
    pub determined: Vec<(String, Fraction)>,
    /// The independent domain variables, the variables after the shape parameters: those of intervals, and of each
    /// simplex all but the last barycentric coordinate.
    pub domain: Vec<Parameter>,
    /// The simplices among the factors of the domain: none for an interval or a box.
    pub simplices: Vec<Barycentric>,
    /// What goes beyond quotients of polynomials: which variables are angles, and π.
    pub analytic: Analytic,
    /// The name that the functions share.
    pub function_name: String,
    /// The functions in the order of their indices.
    pub functions: Vec<Function>,
    /// The statements that define them, as lines of the spec without `base`; none where each function has one of its own,
    /// or the spec is no text.
    pub written: Vec<String>,
    /// What stands below the fraction line of the functions once it is the same for all of them; 1 where no domain
    /// variable stands below one.
    pub over: Poly,
    /// The families on the spans, in their order; none for a domain of one span. Of several the other fields are those of
    /// the first one.
    pub pieces: Vec<Rc<Family>>,
    /// The functions of the lowest order, when these were raised from them.
    pub base: Vec<Function>,
    /// Which functions were proved to be nonnegative; empty before claims are decided. Generated code cuts them off at 0
    /// where rounding could make them negative.
    pub nonnegative: Vec<bool>,
    /// Of polynomials that are evaluated in place of functions in which a variable stands beside its sine: how far they
    /// are from these, for each function for which it is known; `None` for all other families.
    pub truncations: Option<Vec<Option<Truncation>>>,
    /// What holds on the declared ranges, so that the formulas mean something.
    pub obligations: Vec<Obligation>,
    /// The factor of the usual work that the provers may spend on a claim.
    pub budget: u32,
}

/// How far a quotient P/Q that is evaluated in place of a function A/B may be from it: |A − P| ≤ `above`·`ends` and |B
/// − Q| ≤ `below` on the ranges of the variables, where `ends` = yⁱ(1 − y)ʲ divides P.
#[derive(Clone, Debug)]
pub struct Truncation {
    /// Of the numerator.
    pub above: Rational,
    /// Of the denominator.
    pub below: Rational,
    /// The powers i and j.
    pub ends: [u32; 2],
    /// Q
    pub divisor: Poly,
}

/// Whether it is found how far polynomials are from the functions in whose place they are evaluated: only bounds of
/// rounding errors need it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Truncations {
    /// It is found.
    Found,
    /// It is left out.
    LeftOut,
}

/// A shape parameter or a domain variable.
#[derive(Clone, Debug)]
pub struct Parameter {
    /// The name as it is written.
    pub name: String,
    /// The doc comment, one string a line.
    pub doc: Vec<String>,
    /// Where it is declared.
    pub place: Place,
    /// The variable.
    pub var: Var,
    /// The declared range; for a domain variable both ends are finite. Of a range that depends on other parameters the
    /// numbers between which it lies.
    pub range: Range,
}

/// A triangle or tetrahedron, the domain or a factor of it.
#[derive(Clone, Debug)]
pub struct Barycentric {
    /// The places of its independent coordinates among the independent domain variables.
    pub places: Places<usize>,
    /// The last coordinate, 1 minus the others; it does not occur in the functions.
    pub last: Parameter,
}

/// A factor of a domain.
#[derive(Clone, Copy, Debug)]
pub enum Factor<'a> {
    /// An interval.
    Interval(&'a Parameter),
    /// A simplex: its independent coordinates and the last one.
    Simplex(&'a [Parameter], &'a Parameter),
}

impl<'a> Factor<'a> {
    /// The variables, of a simplex all barycentric coordinates.
    pub fn variables(self) -> impl Iterator<Item = &'a Parameter> {
        let (independent, last) = match self {
            Self::Interval(only) => (core::slice::from_ref(only), None),
            Self::Simplex(independent, last) => (independent, Some(last)),
        };
        independent.iter().chain(last)
    }
}

/// A basis function.
#[derive(Clone, Debug)]
pub struct Function {
    /// The index, 2 for `b[2]`.
    pub index: Vec<i64>,
    /// The function: a quotient of two polynomials in the domain variables and shape parameters, whose denominator
    /// vanishes nowhere on the declared ranges.
    pub value: Fraction,
}

impl Family {
    /// The name with the order, such as `Bernstein(3)`.
    pub fn title(&self) -> String {
        if self.order.is_empty() {
            return self.name.clone();
        }
        let values: Vec<String> = self.order.mapped(|(_, v)| v.to_string());
        format!("{}({})", self.name, values.join(", "))
    }

    /// The name of a function, such as `b[2]`.
    pub fn function_label(&self, position: usize) -> String {
        label(&self.function_name, &self.functions[position].index)
    }

    /// Whether the domain is a triangle or a tetrahedron.
    pub fn is_simplex(&self) -> bool {
        matches!(self.simplices.as_slice(), [only] if only.places.len() == self.domain.len())
    }

    /// Whether the domain is a product of a simplex and something else.
    pub fn is_product(&self) -> bool {
        !self.simplices.is_empty() && !self.is_simplex()
    }

    /// The factors of the domain, in the order of the spec.
    pub fn factors(&self) -> Vec<Factor<'_>> {
        let mut all = Vec::new();
        let mut k = 0;
        while let Some(variable) = self.domain.get(k) {
            match self.simplices.iter().find(|s| s.places.start == k) {
                Some(simplex) => {
                    all.push(Factor::Simplex(&self.domain[simplex.places.clone()], &simplex.last));
                    k = simplex.places.end;
                }
                None => {
                    all.push(Factor::Interval(variable));
                    k += 1;
                }
            }
        }
        all
    }

    /// All domain variables in the order of the spec; of a simplex all barycentric coordinates.
    pub fn domain_variables(&self) -> impl Iterator<Item = &Parameter> {
        self.factors().into_iter().flat_map(Factor::variables)
    }

    /// The domain as the spec writes it, such as `0 <= t <= 1` or `triangle (u, v, w), -1 <= z <= 1`.
    pub fn domain_text(&self) -> String {
        let factors = self.factors().mapped(|factor| match factor {
            Factor::Interval(p) => self.declared(p),
            Factor::Simplex(independent, _) => {
                let kind = if independent.len() == 2 { "triangle" } else { "tetrahedron" };
                let names: Vec<&str> = factor.variables().map(|p| p.name.as_str()).listed();
                format!("{kind} ({})", names.join(", "))
            }
        });
        factors.join(", ")
    }

    /// The independent domain variables that stand for intervals.
    fn intervals(&self) -> impl Iterator<Item = &Parameter> {
        let on_simplex = |k: usize| self.simplices.iter().any(|s| s.places.contains(&k));
        self.domain.iter().enumerate().filter(move |(k, _)| !on_simplex(*k)).map(|(_, p)| p)
    }

    /// The simplices of the domain, as the kernel knows them.
    fn corners(&self) -> impl Iterator<Item = Simplex> {
        self.simplices.iter().map(|s| Simplex {
            variables: self.domain[s.places.clone()].mapped(|p| p.var),
            sum: Rational::ONE,
        })
    }

    /// The declared ranges of all independent variables; of a simplex the surrounding box.
    pub fn region(&self) -> Region {
        let declared = self.shapes.iter().chain(&self.domain).map(|p| (p.var, p.range.clone()));
        Region { ranges: declared.chain(self.analytic.ranges.iter().cloned()).listed() }
    }

    /// The declared ranges of the shape parameters.
    pub fn shape_region(&self) -> Region {
        let declared = self.shapes.iter().map(|p| (p.var, p.range.clone()));
        Region { ranges: declared.chain(self.analytic.ranges.iter().cloned()).listed() }
    }

    /// The range of a shape parameter or domain variable as it is written, such as `0 <= θ <= pi/2`.
    pub fn declared(&self, parameter: &Parameter) -> String {
        if !self.pieces.is_empty() && self.domain.iter().any(|p| p.var == parameter.var) {
            let spans: Vec<String> =
                self.pieces.iter().flat_map(|piece| piece.domain.iter().map(|p| piece.declared(p))).listed();
            return spans.join(", ");
        }
        match self.analytic.angle(parameter.var) {
            Some(angle) => angle.declared.clone(),
            None => parameter.range.display(&parameter.name).to_string(),
        }
    }

    /// The name of a shape parameter or domain variable: of one that stands in sin, exp or the like its own, not that of its
    /// tangent.
    pub fn name_of<'a>(&'a self, parameter: &'a Parameter) -> &'a str {
        self.analytic.angle(parameter.var).map_or(&parameter.name, |angle| &angle.name)
    }

    /// A shape parameter and its value, `λ = 1`; of an angle as it is written, `α = pi` and not `tan(α/4) = 1`, where that
    /// is known.
    pub fn shape_value(&self, var: Var, value: &Rational) -> String {
        let range = self.shapes.iter().find(|p| p.var == var).map(|p| &p.range);
        let angle = range.and_then(|range| self.analytic.value_named(var, value, range));
        angle.unwrap_or_else(|| format!("{} = {value}", self.names[var.0]))
    }

    /// The derivative of a function in a variable; `None` when the work is spent.
    pub fn derivative_within(&self, f: &Fraction, var: Var, work: &mut Work) -> Option<Fraction> {
        self.analytic.derivative_within(f, var, work)
    }

    /// The two ends of the domain of a family on an interval, for reading.
    pub fn end_texts(&self) -> Option<[String; 2]> {
        let (var, low, high) = self.interval()?;
        let angle = self.analytic.angle(var);
        Some(angle.map_or_else(|| [low.to_string(), high.to_string()], |a| a.ends.clone()))
    }

    /// The only domain variable and the two ends of its range; `None` when there are several.
    pub fn interval(&self) -> Option<(Var, &Rational, &Rational)> {
        let ([only], []) = (self.domain.as_slice(), self.simplices.as_slice()) else { return None };
        let (low, high) = only.range.finite()?;
        Some((only.var, low, high))
    }

    /// The value of a function at the lower or the upper end of an interval: put in place of the variable in sines and the
    /// like, and of the variable itself beside them. `None` when there is none, or the work is spent.
    pub fn at_end(&self, f: &Fraction, upper: bool, work: &mut Work) -> Option<Fraction> {
        let (var, low, high) = self.interval()?;
        let end = Fraction::constant(if upper { high } else { low }.clone());
        let value = f.substitute_within(var, &end, work).ok()??;
        let value = match self.analytic.angle(var) {
            Some(angle) => {
                value.substitute_within(angle.itself, &angle.limits[usize::from(upper)], work).ok()??
            }
            None => value,
        };
        Some(self.analytic.reduced(value))
    }

    /// The lower and the upper end of every independent domain variable; of barycentric coordinates 0 and 1.
    pub fn ends(&self) -> Vec<(Fraction, Fraction)> {
        self.domain
            .iter()
            .filter_map(|p| p.range.finite())
            .map(|(low, high)| (Fraction::constant(low.clone()), Fraction::constant(high.clone())))
            .listed()
    }

    /// Whether the domain is without some of its ends, as for `domain 0 <= t < 1;`.
    pub fn leaves_an_end_out(&self) -> bool {
        self.domain.iter().any(|p| !p.range.low.is_included() || !p.range.high.is_included())
    }

    /// All points of the domain with all shape values.
    pub fn points(&self) -> Domain {
        let mut domain = Domain::of(self.shape_region());
        domain.region.ranges.extend(self.intervals().map(|p| (p.var, p.range.clone())));
        domain.simplices.extend(self.corners());
        domain
    }

    /// The parts of the points that a claim is about, without the variables that are fixed, each as the image of a box;
    /// the shape parameters alone, or with the domain variables that stand for intervals. Those that are `first` depend
    /// on no others.
    pub fn pieces(&self, fixed: &[(Var, Fraction)], first: &[Var], shapes_only: bool) -> Vec<Piece> {
        let whole = self.shapes_as_written(fixed, first);
        let mut pieces = chart::pieces(&whole.ranges, &whole.premises);
        if !shapes_only {
            for piece in &mut pieces {
                piece.ranges.extend(self.free_intervals(fixed));
            }
        }
        pieces
    }

    /// The same points as one box, in which the conditions on shape parameters are premises.
    pub(crate) fn box_as_written(&self, fixed: &[(Var, Fraction)]) -> Piece {
        let mut whole = self.shapes_as_written(fixed, &[]);
        whole.ranges.extend(self.free_intervals(fixed));
        whole
    }

    /// The shape values in this way, those first that are `first`, with what depends on them.
    fn shapes_as_written(&self, fixed: &[(Var, Fraction)], first: &[Var]) -> Piece {
        let free = |var: &Var| fixed.iter().all(|(v, _)| v != var);
        let mut ranges: Vec<(Var, Range)> = Vec::new();
        let rank = |p: &&Parameter| first.contains(&p.var);
        let (early, late): (Vec<&Parameter>, Vec<&Parameter>) = self.shapes.iter().partition(rank);
        for p in early.into_iter().chain(late).filter(|p| free(&p.var)) {
            ranges.push((p.var, p.range.clone()));
        }
        ranges.extend(self.analytic.ranges.iter().filter(|(v, _)| free(v)).cloned());
        let put = |p: &Poly| {
            let value = fixed.iter().try_fold(Fraction::from(p.clone()), |f, (v, x)| f.substitute(*v, x));
            // The sign of a quotient is that of the product.
            value.map_or_else(|| p.clone(), |f| f.numer() * f.denom())
        };
        let premises = self.constraints.mapped(|c| (put(&c.value), c.relation));
        Piece { premises, ..Piece::plain(ranges) }
    }

    /// The domain variables that stand for intervals, as far as they are not fixed.
    fn free_intervals(&self, fixed: &[(Var, Fraction)]) -> impl Iterator<Item = (Var, Range)> {
        let free = |p: &&Parameter| fixed.iter().all(|(v, _)| *v != p.var);
        self.intervals().filter(free).map(|p| (p.var, p.range.clone()))
    }

    /// The family where a claim fixes shape parameters: without these, and with their values in the angles that depend on
    /// them, such as one that ends at α where α = π/2. `None` where an angle has no value there.
    pub(crate) fn where_fixed(&self, fixed: &[(Var, Fraction)]) -> Option<Cow<'_, Self>> {
        let is_fixed = |var: Var| fixed.iter().any(|(v, _)| *v == var);
        if !self.shapes.iter().any(|p| is_fixed(p.var)) {
            return Some(Cow::Borrowed(self));
        }
        let put = |f: &Fraction| fixed.iter().try_fold(f.clone(), |f, (var, x)| f.substitute(*var, x));
        let mut family = self.clone();
        let fixed_shape = |var: Var| self.shapes.iter().any(|p| p.var == var) && is_fixed(var);
        family.analytic.angles.retain(|angle| !fixed_shape(angle.var));
        for angle in &mut family.analytic.angles {
            (angle.low, angle.width) = (put(&angle.low)?, put(&angle.width)?);
            angle.limits = [put(&angle.limits[0])?, put(&angle.limits[1])?];
            for (_, image) in &mut angle.mirror {
                *image = put(image)?;
            }
        }
        family.shapes.retain(|p| !is_fixed(p.var));
        Some(Cow::Owned(family))
    }

    /// What is assumed of the shape parameters beside their ranges.
    pub fn assumed(&self) -> impl Iterator<Item = &Constraint> {
        self.constraints.iter().filter(|constraint| !constraint.is_end)
    }

    /// The parts of all points, as boxes and simplices: of the shape parameters alone, or with the domain.
    pub fn parts(&self, shapes_only: bool) -> Vec<(Piece, Rc<Domain>)> {
        let whole = |piece: Piece| {
            let mut domain = piece.domain();
            if !shapes_only {
                domain.simplices.extend(self.corners());
            }
            (piece, Rc::new(domain))
        };
        self.pieces(&[], &[], shapes_only).into_iter().map(whole).listed()
    }

    /// Whether a domain variable stands below the fraction line of a function.
    pub fn is_rational(&self) -> bool {
        !self.over.is_one()
    }

    /// Polynomials that are linearly dependent in the domain variables at exactly those shape values at which the
    /// functions are: each function times a polynomial that vanishes nowhere, the same for all functions of a rational
    /// family, and [`Family::numerator_factor`] otherwise.
    pub fn numerators(&self) -> Vec<Poly> {
        let rational = self.is_rational();
        self.functions.mapped(|f| {
            if rational {
                // `over` is a multiple of every denominator.
                &self.over.div_exact(f.value.denom()).unwrap_or_else(Poly::one) * f.value.numer()
            } else {
                f.value.numer().clone()
            }
        })
    }

    /// What a function is multiplied by in [`Family::numerators`], up to a factor that all functions share.
    pub fn numerator_factor(&self, position: usize) -> Poly {
        if self.is_rational() { Poly::one() } else { self.functions[position].value.denom().clone() }
    }

    /// The highest degree in a domain variable of the functions, or of their numerators over a common denominator.
    pub fn degree(&self, var: Var) -> u32 {
        let own = |f: &Function| f.value.numer().degree(var);
        if self.is_rational() {
            let over = self.over.degree(var);
            let degree = |f: &Function| over - f.value.denom().degree(var) + own(f);
            return self.functions.iter().map(degree).max().unwrap_or(0);
        }
        self.functions.iter().map(own).max().unwrap_or(0)
    }
}

/// `b[2,0,1]`.
pub(crate) fn label(name: &str, index: &[i64]) -> String {
    let index: Vec<String> = index.mapped(i64::to_string);
    format!("{name}[{}]", index.join(","))
}
