//! The closed domain of a function of several variables, a product of intervals and simplices: its faces, its points,
//! and how points and equations are written.

use std::rc::Rc;

use super::numbers;
use super::point::{Point, constant};
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Monomial, Poly, Var};
use crate::algebra::range::Range;
use crate::algebra::rational::Rational;
use crate::algebra::real::field::Element;
use crate::algebra::work::Work;
use crate::model::{Factor, Family};
use basis_kernel::{Domain, Quotient, Relation, Simplex, Statement};
use basis_prover::collections::list::{Listed, Mapped};
use basis_prover::{Coordinate, Failure, decide, within};

/// The steps of the lattice on which signs are looked at.
const STEPS: i64 = 6;

/// A product of intervals and simplices.
#[derive(Clone)]
pub(super) struct Product {
    parts: Vec<Part>,
    /// The names of all variables.
    names: Vec<String>,
}

/// A facet: what is put in place of one of the variables of the domain, the domain of the others, and the equation.
pub(super) struct Facet {
    pub(super) fixed: (Var, Poly),
    pub(super) domain: Product,
    pub(super) equation: String,
}

/// A factor of a domain.
#[derive(Clone)]
enum Part {
    Interval {
        var: Var,
        low: Rational,
        high: Rational,
        /// Of an angle its own name, and what it is at some of its tangents.
        angle: Option<(String, Vec<(Rational, String)>)>,
    },
    /// The independent barycentric coordinates, and the name of the last one.
    Simplex {
        vars: Vec<Var>,
        last: String,
        /// The names of all coordinates in the order of the spec.
        order: Vec<String>,
    },
}

/// A face, the image of the points of a smaller product.
#[derive(Clone, Debug, Default)]
pub(super) struct Face {
    /// The variables that are free on it, with the numbers between which they are.
    pub(super) free: Vec<(Var, Rational, Rational)>,
    /// The others in terms of these.
    fixed: Vec<(Var, Poly)>,
}

impl Face {
    /// A function on the face.
    pub(super) fn restricted(&self, f: &Fraction) -> Option<Fraction> {
        let put = |f: Fraction, (var, p): &(Var, Poly)| f.substitute(*var, &Fraction::from(p.clone()));
        self.fixed.iter().try_fold(f.clone(), put)
    }

    /// The point of the domain for one in the free variables.
    pub(super) fn image(&self, mut point: Point, work: &mut Work) -> Option<Point> {
        for (var, p) in &self.fixed {
            let x = point.eval(p, work)?;
            point = point.with(*var, x);
        }
        Some(point)
    }

    fn product(&self, other: &Self) -> Self {
        let free = [&self.free[..], &other.free].concat();
        Self { free, fixed: [&self.fixed[..], &other.fixed].concat() }
    }
}

impl Part {
    fn vars(&self) -> &[Var] {
        match self {
            Self::Interval { var, .. } => core::slice::from_ref(var),
            Self::Simplex { vars, .. } => vars,
        }
    }

    fn faces(&self) -> Vec<Face> {
        match self {
            Self::Interval { var, low, high, .. } => {
                let end =
                    |x: &Rational| Face { free: Vec::new(), fixed: vec![(*var, Poly::constant(x.clone()))] };
                let whole = Face { free: vec![(*var, low.clone(), high.clone())], fixed: Vec::new() };
                vec![end(low), end(high), whole]
            }
            Self::Simplex { vars, .. } => {
                // Coordinates that are not 0: those whose bit is set, the last one has the highest bit.
                let face = |set: u32| {
                    let mut inside =
                        vars.iter().enumerate().filter(|(k, _)| set >> k & 1 == 1).map(|(_, v)| *v).listed();
                    let mut face = Face::default();
                    let dependent = if set >> vars.len() & 1 == 1 { None } else { inside.pop() };
                    let sum = inside.iter().fold(Poly::zero(), |sum, v| &sum + &Poly::var(*v));
                    for var in vars {
                        if inside.contains(var) {
                            face.free.push((*var, Rational::ZERO, Rational::ONE));
                        } else {
                            let rest =
                                if dependent == Some(*var) { &Poly::one() - &sum } else { Poly::zero() };
                            face.fixed.push((*var, rest));
                        }
                    }
                    face
                };
                (1..1 << (vars.len() + 1)).map(face).listed()
            }
        }
    }
}

impl Product {
    /// The factors of the domain of a family that contain variables of a function, and the function in those
    /// barycentric coordinates of which it has the fewest; `None` if an end is not finite.
    pub(super) fn of(family: &Family, f: &Fraction) -> Option<(Self, Fraction)> {
        let mut all = Self { parts: Vec::new(), names: family.names.clone() };
        let mut f = f.clone();
        for factor in family.factors() {
            match factor {
                Factor::Interval(p) if f.depends_on(p.var) => {
                    let (low, high) = p.range.finite()?;
                    let (low, high) = (low.clone(), high.clone());
                    let angle = family.analytic.angle(p.var).map(|angle| {
                        let mut known = vec![(low.clone(), angle.ends[0].clone())];
                        known.push((high.clone(), angle.ends[1].clone()));
                        known.retain(|(_, text)| !text.is_empty());
                        (angle.name.clone(), known)
                    });
                    all.parts.push(Part::Interval { var: p.var, low, high, angle });
                }
                Factor::Simplex(own, last) if own.iter().any(|p| f.depends_on(p.var)) => {
                    let vars = own.mapped(|p| p.var);
                    let mut last_name = last.name.clone();
                    let others = |f: &Fraction| vars.iter().filter(|var| f.depends_on(**var)).count();
                    let rest = |sum: Fraction, v: &Var| &sum - &Fraction::var(*v);
                    let rest = vars.iter().fold(Fraction::constant(Rational::ONE), rest);
                    for var in &vars {
                        let other = f.substitute(*var, &rest)?;
                        if others(&other) < others(&f) {
                            f = other;
                            core::mem::swap(&mut last_name, all.names.get_mut(var.0)?);
                            break;
                        }
                    }
                    let order = factor.variables().map(|p| p.name.clone()).listed();
                    all.parts.push(Part::Simplex { vars, last: last_name, order });
                }
                _ => {}
            }
        }
        Some((all, f))
    }

    /// The facets.
    pub(super) fn facets(&self) -> Vec<Facet> {
        let mut all = Vec::new();
        for (k, part) in self.parts.iter().enumerate() {
            let without = |part: Option<Part>| {
                let mut parts = self.parts.clone();
                parts.splice(k..=k, part);
                Self { parts, names: self.names.clone() }
            };
            match part {
                Part::Interval { var, low, high, .. } => {
                    for end in [low, high] {
                        let fixed = (*var, Poly::constant(end.clone()));
                        let equation = self.value(*var, end);
                        all.push(Facet { fixed, domain: without(None), equation });
                    }
                }
                Part::Simplex { vars, last, order } => {
                    let mut facet = |vars: Vec<Var>, last: &str, fixed: (Var, Poly), zero: &str| {
                        let smaller = Part::Simplex { vars, last: last.to_owned(), order: order.clone() };
                        let smaller = Some(smaller).filter(|part| !part.vars().is_empty());
                        all.push(Facet { fixed, domain: without(smaller), equation: format!("{zero} = 0") });
                    };
                    for var in vars {
                        let others = vars.iter().copied().filter(|v| v != var).listed();
                        facet(others, last, (*var, Poly::zero()), self.name(*var));
                    }
                    if let Some((var, others)) = vars.split_last() {
                        let rest = others.iter().fold(Poly::one(), |rest, v| &rest - &Poly::var(*v));
                        facet(others.to_vec(), self.name(*var), (*var, rest), last);
                    }
                }
            }
        }
        all
    }

    /// `x = 1/2`, of an angle that is known `t = pi/2`.
    fn value(&self, var: Var, x: &Rational) -> String {
        self.known(var, x).unwrap_or_else(|| format!("{} = {x}", self.name(var)))
    }

    /// The same for any number.
    pub(super) fn at(&self, var: Var, x: &Coordinate) -> String {
        match x {
            Coordinate::Rational(x) => self.value(var, x),
            Coordinate::Algebraic(_) => format!("{} = {}", self.name(var), numbers::text(x)),
        }
    }

    /// An angle that is known by its tangent, `t = pi/2`.
    fn known(&self, var: Var, x: &Rational) -> Option<String> {
        let (name, all) = self.parts.iter().find_map(|part| match part {
            Part::Interval { var: own, angle, .. } if *own == var => angle.as_ref(),
            _ => None,
        })?;
        all.iter().find(|(known, _)| known == x).map(|(_, text)| format!("{name} = {text}"))
    }

    /// The name of an independent variable.
    pub(super) fn name(&self, var: Var) -> &str {
        self.names.get(var.0).map_or("", String::as_str)
    }

    /// The number of dimensions.
    pub(super) fn dimension(&self) -> usize {
        self.parts.iter().map(|part| part.vars().len()).sum()
    }

    /// The independent variables.
    pub(super) fn vars(&self) -> Vec<Var> {
        self.parts.iter().flat_map(|part| part.vars().iter().copied()).listed()
    }

    /// All faces, corners and the whole domain among them.
    pub(super) fn faces(&self) -> Vec<Face> {
        let mut all = vec![Face::default()];
        for part in &self.parts {
            let own = part.faces();
            all = all.iter().flat_map(|face| own.iter().map(move |other| face.product(other))).listed();
        }
        all
    }

    /// The corners.
    pub(super) fn corners(&self) -> Vec<Vec<(Var, Rational)>> {
        let corners = self.faces().into_iter().filter(|face| face.free.is_empty());
        let coordinate = |(var, p): &(Var, Poly)| (*var, p.as_constant().unwrap_or(Rational::ZERO));
        corners.map(|face| face.fixed.mapped(coordinate)).listed()
    }

    /// Points on a lattice with this many steps along each edge.
    pub(super) fn lattice(&self, steps: i64) -> Vec<Vec<(Var, Rational)>> {
        let mut all: Vec<Vec<(Var, Rational)>> = vec![Vec::new()];
        for part in &self.parts {
            for var in part.vars() {
                let of_part = |point: &[(Var, Rational)]| {
                    let own = point.iter().filter(|(v, _)| part.vars().contains(v));
                    own.fold(Rational::ZERO, |sum, (_, x)| &sum + x)
                };
                let mut longer = Vec::new();
                for point in &all {
                    for k in 0..=steps {
                        let share = Rational::new(k, steps);
                        let x = match part {
                            Part::Interval { low, high, .. } => low + &(&(high - low) * &share),
                            Part::Simplex { .. } if &of_part(point) + &share > Rational::ONE => break,
                            Part::Simplex { .. } => share,
                        };
                        longer.push([&point[..], &[(*var, x)]].concat());
                    }
                }
                all = longer;
            }
        }
        all
    }

    /// The lengths of the sides of the box around the domain.
    pub(super) fn sides(&self) -> Vec<(Var, Rational)> {
        let side = |part: &Part| match part {
            Part::Interval { var, low, high, .. } => vec![(*var, high - low)],
            Part::Simplex { vars, .. } => vars.mapped(|var| (*var, Rational::ONE)),
        };
        self.parts.iter().flat_map(side).listed()
    }

    /// Functions of the coordinates that are ≥ 0 on the domain and nowhere else together.
    fn inequalities(&self) -> Vec<Poly> {
        let mut all = Vec::new();
        for part in &self.parts {
            match part {
                Part::Interval { var, low, high, .. } => {
                    all.push(&Poly::var(*var) - &Poly::constant(low.clone()));
                    all.push(&Poly::constant(high.clone()) - &Poly::var(*var));
                }
                Part::Simplex { vars, .. } => {
                    all.extend(vars.iter().map(|var| Poly::var(*var)));
                    all.push(vars.iter().fold(Poly::one(), |rest, var| &rest - &Poly::var(*var)));
                }
            }
        }
        all
    }

    /// Whether a point lies in the domain.
    pub(super) fn contains(&self, point: &mut Point, work: &mut Work) -> Option<bool> {
        for p in self.inequalities() {
            let value = point.eval(&p, work)?;
            if point.sign(&value, work)? < 0 {
                return Some(false);
            }
        }
        Some(true)
    }

    /// Whether a point with rational coordinates lies in the domain.
    pub(super) fn has(&self, point: &[(Var, Rational)]) -> bool {
        self.inequalities().iter().all(|p| at(p, point).is_some_and(|x| !x.is_negative()))
    }

    /// Decides the sign of a quotient on the domain, with this much work.
    pub(super) fn decide(&self, value: Quotient, relation: Relation, units: u64) -> Result<(), Failure> {
        let sign = Statement::Sign { value, relation, domain: Rc::new(self.of_statements()) };
        within(units, &mut || decide(sign.clone(), &Vec::new(), 1).map(drop))
    }

    /// The domain of statements.
    fn of_statements(&self) -> Domain {
        let mut domain = Domain::default();
        for part in &self.parts {
            match part {
                Part::Interval { var, low, high, .. } => {
                    domain.region.ranges.push((*var, Range::closed(low.clone(), high.clone())));
                }
                Part::Simplex { vars, .. } => {
                    domain.simplices.push(Simplex { variables: vars.clone(), sum: Rational::ONE });
                }
            }
        }
        domain
    }

    /// `(u, v, w) = (1/3, 1/3, 1/3)`, `x = 1/2` for a single variable.
    pub(super) fn written(&self, point: &Point, work: &mut Work) -> Option<String> {
        let (mut names, mut values) = (Vec::new(), Vec::new());
        for part in &self.parts {
            let own = match part {
                Part::Interval { var, .. } => vec![self.name(*var).to_owned()],
                Part::Simplex { order, .. } => order.clone(),
            };
            for name in own {
                // On a facet the others are 0.
                let x = point.number(&self.coordinate(&name, point).unwrap_or_default(), work)?;
                let known = match (part, &x) {
                    (Part::Interval { var, .. }, Coordinate::Rational(x)) => self.known(*var, x),
                    _ => None,
                };
                match known.as_deref().and_then(|known| known.split_once(" = ")) {
                    Some((name, text)) => {
                        names.push(name.to_owned());
                        values.push(text.to_owned());
                    }
                    None => {
                        names.push(name);
                        values.push(numbers::text(&x));
                    }
                }
            }
        }
        if let ([name], [value]) = (&names[..], &values[..]) {
            return Some(format!("{name} = {value}"));
        }
        Some(format!("({}) = ({})", names.join(", "), values.join(", ")))
    }

    /// `f = 0` as `2*u = 1` or `u^2 + v^2 = w`: of the ways to write a function of barycentric coordinates the
    /// shortest.
    pub(super) fn equation(&self, f: &Poly) -> String {
        if let [var] = f.variables()[..]
            && let [c, d] = &f.coefficients_in(var)[..]
            && let Some(known) = (-c)
                .as_constant()
                .zip(d.as_constant())
                .and_then(|(c, d)| self.known(var, &c.checked_div(&d)?))
        {
            return known;
        }
        let mut ways: Vec<(Poly, Vec<String>)> = vec![(f.clone(), self.names.clone())];
        for part in &self.parts {
            let Part::Simplex { vars, last, .. } = part else { continue };
            for (p, names) in ways.clone() {
                for var in vars {
                    // The variable stands for the last coordinate from here on.
                    let sum = vars.iter().fold(Poly::zero(), |sum, v| &sum + &Poly::var(*v));
                    let mut names = names.clone();
                    if let Some(name) = names.get_mut(var.0) {
                        name.clone_from(last);
                    }
                    ways.push((p.substitute(*var, &(&Poly::one() - &sum)), names));
                }
            }
        }
        let text = |(p, names): &(Poly, Vec<String>)| {
            let mut p = p.normalized();
            let signs = |p: &Poly, sign: i32| p.terms().filter(|(_, c)| c.signum() == sign).count();
            if signs(&p, -1) > signs(&p, 1) {
                p = -&p;
            }
            let part = |sign: i32, all: bool| {
                let own =
                    |(m, c): &(&Monomial, &Rational)| c.signum() == sign && (all || m.total_degree() > 0);
                Poly::from_terms(p.terms().filter(own).map(|(m, c)| (m.clone(), c.clone())))
            };
            // Without minus signs where it can be; a number stands on the right.
            let (mut left, mut right) = (part(1, true), -&part(-1, true));
            if part(-1, false).is_zero() {
                left = part(1, false);
                right = &left - &p;
            } else if part(1, false) != left && !part(1, false).is_zero() {
                core::mem::swap(&mut left, &mut right);
            }
            if let (1, 1, Some((_, c))) = (left.len(), left.total_degree(), left.leading_term())
                && right.as_constant().is_some()
            {
                let unit = c.recip().unwrap_or(Rational::ONE);
                (left, right) = (left.scale(&unit), right.scale(&unit));
            }
            format!("{} = {}", left.display(names), right.display(names))
        };
        let texts = ways.mapped(text);
        texts.into_iter().min_by_key(|text| text.chars().count()).unwrap_or_default()
    }
}

impl Product {
    /// The coordinate of this name at a point.
    fn coordinate(&self, name: &str, point: &Point) -> Option<Element> {
        for part in &self.parts {
            let (vars, last) = match part {
                Part::Interval { var, .. } => (core::slice::from_ref(var), None),
                Part::Simplex { vars, last, .. } => (&vars[..], Some(last)),
            };
            if let Some(var) = vars.iter().find(|var| self.names.get(var.0).is_some_and(|own| own == name)) {
                return Some(point.element(*var));
            }
            if last.is_some_and(|last| last == name) {
                let sum = vars.iter().fold(Element::default(), |sum, var| sum.add(&point.element(*var)));
                return Some(constant(&Rational::ONE).add(&sum.scale(&Rational::from(-1))));
            }
        }
        None
    }

    /// Whether more than one point of the domain has the coordinates of a point in these variables.
    pub(super) fn is_line(&self, used: &[Var], point: &mut Point, work: &mut Work) -> Option<bool> {
        for part in &self.parts {
            if part.vars().iter().all(|var| used.contains(var)) {
                continue;
            }
            let Part::Simplex { vars, .. } = part else { return Some(true) };
            let own = vars.iter().filter(|var| used.contains(var));
            let rest = own.fold(Poly::one(), |rest, var| &rest - &Poly::var(*var));
            let rest = point.eval(&rest, work)?;
            if point.sign(&rest, work)? > 0 {
                return Some(true);
            }
        }
        Some(false)
    }

    /// Whether a polynomial has values of both signs at some points.
    pub(super) fn changes_sign(&self, p: &Poly) -> bool {
        let signs = self.signs(p);
        signs.contains(&1) && signs.contains(&-1)
    }

    /// The signs of a polynomial at some points, each once.
    pub(super) fn signs(&self, p: &Poly) -> Vec<i32> {
        let mut signs = Vec::new();
        for point in self.corners().into_iter().chain(self.lattice(STEPS)) {
            let sign = at(p, &point).map_or(0, |x| x.signum());
            if sign != 0 && !signs.contains(&sign) {
                signs.push(sign);
            }
            if signs.len() == 2 {
                break;
            }
        }
        signs
    }

    /// The range of an independent variable.
    pub(super) fn range(&self, var: Var) -> Option<(Rational, Rational)> {
        let of = |part: &Part| match part {
            Part::Interval { var: own, low, high, .. } if *own == var => Some((low.clone(), high.clone())),
            Part::Simplex { vars, .. } if vars.contains(&var) => Some((Rational::ZERO, Rational::ONE)),
            _ => None,
        };
        self.parts.iter().find_map(of)
    }
}

/// The value of a polynomial at a rational point; `None` where it contains other variables.
pub(super) fn at(p: &Poly, point: &[(Var, Rational)]) -> Option<Rational> {
    point.iter().fold(p.clone(), |p, (var, x)| p.at(*var, x)).as_constant()
}
