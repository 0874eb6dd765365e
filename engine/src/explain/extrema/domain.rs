//! The closed domain of a function of several variables, a product of intervals and simplices: its faces, its points, and how
//! points and equations are written.

use std::rc::Rc;

use super::numbers;
use super::point::{Point, constant};
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::Range;
use crate::algebra::rational::Rational;
use crate::algebra::real::field::Element;
use crate::algebra::work::Work;
use crate::model::{Factor, Family};
use basis_kernel::{Domain, Simplex};
use basis_prover::collections::list::{Listed, Mapped};

/// A product of intervals and simplices.
pub(super) struct Product {
    parts: Vec<Part>,
    names: Vec<String>,
}

/// A factor of a domain.
enum Part {
    Interval {
        var: Var,
        name: String,
        low: Rational,
        high: Rational,
    },
    /// The independent barycentric coordinates, and the name of the last one.
    Simplex {
        vars: Vec<Var>,
        names: Vec<String>,
        last: String,
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
    /// The factors of the domain of a family that contain variables of a function; `None` if an end is not finite.
    pub(super) fn of(family: &Family, f: &Fraction) -> Option<Self> {
        let mut parts = Vec::new();
        for factor in family.factors() {
            match factor {
                Factor::Interval(p) if f.depends_on(p.var) => {
                    let (low, high) = p.range.finite()?;
                    let (low, high) = (low.clone(), high.clone());
                    parts.push(Part::Interval { var: p.var, name: p.name.clone(), low, high });
                }
                Factor::Simplex(own, last) if own.iter().any(|p| f.depends_on(p.var)) => {
                    parts.push(Part::Simplex {
                        vars: own.mapped(|p| p.var),
                        names: own.mapped(|p| p.name.clone()),
                        last: last.name.clone(),
                    })
                }
                _ => {}
            }
        }
        Some(Self { parts, names: family.names.clone() })
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

    /// The domain of statements.
    pub(super) fn domain(&self) -> Rc<Domain> {
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
        Rc::new(domain)
    }

    /// `(u, v, w) = (1/3, 1/3, 1/3)`, `x = 1/2` for a single variable.
    pub(super) fn written(&self, point: &Point, work: &mut Work) -> Option<String> {
        let (mut names, mut values) = (Vec::new(), Vec::new());
        for part in &self.parts {
            let own = part.vars().mapped(|var| point.element(*var));
            let mut all = own.clone();
            match part {
                Part::Interval { name, .. } => names.push(name.clone()),
                Part::Simplex { names: own_names, last, .. } => {
                    names.extend(own_names.iter().cloned());
                    names.push(last.clone());
                    let sum = own.iter().fold(Element::default(), |sum, x| sum.add(x));
                    all.push(constant(&Rational::ONE).add(&sum.scale(&Rational::from(-1))));
                }
            }
            for x in &all {
                values.push(numbers::text(&point.number(x, work)?));
            }
        }
        if let ([name], [value]) = (&names[..], &values[..]) {
            return Some(format!("{name} = {value}"));
        }
        Some(format!("({}) = ({})", names.join(", "), values.join(", ")))
    }

    /// `f = 0` as `2*u = 1` or `u^2 + v^2 = w`: of the ways to write a function of barycentric coordinates the shortest.
    pub(super) fn equation(&self, f: &Poly) -> String {
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
            if p.terms().filter(|(_, c)| c.is_negative()).count()
                > p.terms().filter(|(_, c)| c.is_positive()).count()
            {
                p = -&p;
            }
            let constant =
                p.terms().find(|(m, _)| m.total_degree() == 0).map_or(Rational::ZERO, |(_, c)| c.clone());
            let above = &p - &Poly::constant(constant.clone());
            let (above, right) = match above.leading_term() {
                // A single variable has no factor.
                Some((_, c)) if above.len() == 1 && above.total_degree() == 1 => {
                    let unit = c.recip().unwrap_or(Rational::ONE);
                    (above.scale(&unit), &-&constant * &unit)
                }
                Some((_, c)) if c.is_negative() && above.terms().all(|(_, c)| c.is_negative()) => {
                    (-&above, constant)
                }
                _ => (above, -&constant),
            };
            format!("{} = {right}", above.display(names))
        };
        let texts = ways.mapped(text);
        texts.into_iter().min_by_key(|text| text.chars().count()).unwrap_or_default()
    }
}

impl Product {
    /// The only coordinate of which a polynomial is a function, with the variable that stands for it in a polynomial in one
    /// variable; nothing for functions of several.
    pub(super) fn of_one(&self, p: &Poly) -> Option<(String, Var, Poly)> {
        if let [var] = p.variables()[..] {
            return Some((self.names.get(var.0)?.clone(), var, p.clone()));
        }
        for part in &self.parts {
            let Part::Simplex { vars, last, .. } = part else { continue };
            let (var, sum) = (*vars.first()?, vars.iter().fold(Poly::zero(), |sum, v| &sum + &Poly::var(*v)));
            let of_last = p.substitute(var, &(&Poly::one() - &sum));
            if of_last.variables() == [var] {
                return Some((last.clone(), var, of_last));
            }
        }
        None
    }

    /// The coordinate of this name at a point.
    pub(super) fn coordinate(&self, name: &str, point: &Point) -> Option<Element> {
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
