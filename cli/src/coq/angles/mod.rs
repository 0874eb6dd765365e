//! Families in sin and cos of an angle: each function is stated as it is written, and again as a quotient of polynomials in
//! the tangent of half the angle, with a lemma that says that these agree. A proof puts the second one in place of the
//! first, derivatives by the chain rule, and goes on as that of any other quotient.

mod place;
mod proof;
mod refuted;
mod turn;

use std::cell::RefCell;
use std::rc::Rc;

use basis_engine::Family;
use basis_engine::formulas::{Circular, Definition, Formulas, Role, Sign, Term};
use basis_kernel::Proof;

use super::formula::Writer;
use super::frame::range_data;
use super::theorem::Missing;
pub(super) use turn::Turn;
use turn::{Linear, circular};

/// The number π where it stands outside of angles: a variable of which nothing is known.
const PI: usize = (1 << 16) - 1;

/// A family with an angle, and everything that its theorems mention.
pub(super) struct Angular<'a> {
    pub(super) family: &'a Family,
    pub(super) formulas: &'a Formulas,
    pub(super) turn: Turn<'a>,
    /// The identifiers of the definitions.
    pub(super) definitions: &'a [String],
    /// The identifiers of the variables.
    pub(super) names: &'a [String],
    /// Why no denominator vanishes.
    pub(super) obligations: &'a [&'a Proof],
    /// Which definitions are about the angle.
    pub(super) turning: Vec<bool>,
}

/// Whether a definition is about the angle: itself, or by one that it calls.
pub(super) fn angular(formulas: &Formulas) -> Vec<bool> {
    let mut all: Vec<bool> = Vec::new();
    for definition in &formulas.definitions {
        all.push(any(&definition.value, &|term| match term {
            Term::Circular(..) | Term::Pi => true,
            Term::Call(f, _) => all.get(*f).copied().unwrap_or(false),
            _ => false,
        }));
    }
    all
}

/// Whether something is so of a part of a formula.
fn any(term: &Term, found: &dyn Fn(&Term) -> bool) -> bool {
    found(term)
        || match term {
            Term::Number(_) | Term::Variable(_) | Term::Pi => false,
            Term::Neg(x) | Term::Power(x, _) | Term::Circular(_, x) => any(x, found),
            Term::Sum(parts) => parts.iter().any(|(_, x)| any(x, found)),
            Term::Product(parts) => parts.iter().any(|(_, x)| any(x, found)),
            Term::Call(_, args) => args.iter().any(|x| any(x, found)),
            Term::Derivative { body, at, .. } => any(body, found) || any(at, found),
            Term::Integral { body, low, high, .. } => any(body, found) || any(low, found) || any(high, found),
        }
}

const INTEGRAL: Missing = "an integral beside an angle";

const OTHER: Missing = "an angle in another form than sin and cos of it and of its double";

impl Angular<'_> {
    /// The number of the domain variable.
    fn variable(&self) -> usize {
        self.turn.angle.itself.0
    }

    /// The number of its tangent.
    fn tangent(&self) -> usize {
        self.turn.angle.var.0
    }

    /// The same formula in tangents, given what stands for those of angles.
    fn put(&self, term: &Term, angles: &[(usize, Term)]) -> Result<Term, Missing> {
        let again = |term: &Term| self.put(term, angles);
        Ok(match term {
            Term::Pi => Term::Variable(PI),
            Term::Variable(v) if angles.iter().any(|(a, _)| a == v) => {
                return Err("a variable beside its sine");
            }
            Term::Number(_) | Term::Variable(_) => term.clone(),
            Term::Neg(x) => Term::Neg(Rc::new(again(x)?)),
            Term::Sum(parts) => {
                Term::Sum(parts.iter().map(|(s, x)| Ok((*s, again(x)?))).collect::<Result<_, Missing>>()?)
            }
            Term::Product(parts) => {
                Term::Product(parts.iter().map(|(r, x)| Ok((*r, again(x)?))).collect::<Result<_, Missing>>()?)
            }
            Term::Power(x, n) => Term::Power(Rc::new(again(x)?), *n),
            Term::Circular(f, x) => {
                let (k, tangent) = self.multiple(x, angles).ok_or(OTHER)?;
                circular(*f, k, &tangent).ok_or(OTHER)?
            }
            Term::Call(f, args) if self.turning[*f] => {
                let (last, shapes) = args.split_last().ok_or(OTHER)?;
                let mut own = shapes.iter().map(again).collect::<Result<Vec<_>, _>>()?;
                own.push(self.tangent_of(last, angles).ok_or("a function at another angle")?);
                Term::Call(*f, own)
            }
            Term::Call(f, args) => Term::Call(*f, args.iter().map(again).collect::<Result<_, _>>()?),
            Term::Derivative { body, bound, at } => {
                if !self.is_angle(body, *bound) {
                    let (body, at) = (Rc::new(again(body)?), Rc::new(again(at)?));
                    return Ok(Term::Derivative { body, bound: *bound, at });
                }
                let inner = [angles, &[(*bound, Term::Variable(*bound))]].concat();
                let body = Rc::new(self.put(body, &inner)?);
                let x = self.tangent_of(at, angles).ok_or("a derivative at another angle")?;
                let at = Rc::new(x.clone());
                self.chain(Term::Derivative { body, bound: *bound, at }, &x)?
            }
            Term::Integral { .. } => return Err(INTEGRAL),
        })
    }

    /// A derivative in the tangent, times that of the tangent.
    fn chain(&self, slope: Term, x: &Term) -> Result<Term, Missing> {
        let square = Term::Power(Rc::new(x.clone()), 2);
        let sum = Term::Sum(vec![(Sign::Plus, Term::integer(1)), (Sign::Plus, square)]);
        let half = Term::Product(vec![(Role::Factor, sum), (Role::Divisor, Term::integer(2))]);
        Ok(slope.by(self.put(&self.turn.slope(), &[])?.by(half)))
    }

    /// Whether a variable is an angle in a formula.
    fn is_angle(&self, body: &Term, variable: usize) -> bool {
        let is = |x: &Term| any(x, &|part| *part == Term::Variable(variable));
        any(body, &|part| match part {
            Term::Circular(_, x) => is(x),
            Term::Call(f, args) => self.turning[*f] && args.last().is_some_and(is),
            Term::Derivative { body, bound, at } => is(at) && self.is_angle(body, *bound),
            _ => false,
        })
    }

    /// Which multiple of φ an angle is, and the tangent of half of φ.
    fn multiple(&self, argument: &Term, angles: &[(usize, Term)]) -> Option<(i64, Term)> {
        angles.iter().find_map(|(variable, x)| {
            let linear = Linear::of(argument, *variable)?;
            Some((self.turn.multiple(&linear)?, x.clone()))
        })
    }

    /// The tangent at a place: an angle itself, a number, or an angle on the way back.
    fn tangent_of(&self, at: &Term, angles: &[(usize, Term)]) -> Option<Term> {
        if let Term::Variable(v) = at {
            return angles.iter().find(|(a, _)| a == v).map(|(_, x)| x.clone());
        }
        let fixed = Linear::of(at, usize::MAX).and_then(|at| self.turn.tangent_at(&at)).map(Term::integer);
        fixed.or_else(|| {
            let back = |(v, x): &(usize, Term)| {
                Some(turn::reflected(self.turn.reflection(&Linear::of(at, *v)?)?, x))
            };
            angles.iter().find_map(back)
        })
    }

    /// A definition in tangents, with the lemma that it is the same.
    pub(super) fn definition(&self, place: usize, definition: &Definition) -> Result<Definition, Missing> {
        let last = definition.parameters.len().checked_sub(1).ok_or(OTHER)?;
        let value = self.put(&definition.value, &[(last, Term::Variable(last))])?;
        if !self.turning[place] || any(&value, &|part| *part == Term::Variable(PI)) {
            return Err("a function with pi outside of an angle");
        }
        let mut parameters = definition.parameters.clone();
        parameters[last] = String::from("x");
        Ok(Definition { name: format!("{}'t", definition.name), parameters, value, ..definition.clone() })
    }

    /// The lemma that a definition is its form in tangents.
    pub(super) fn lemma(&self, place: usize, parameters: &[String]) -> Result<String, Missing> {
        let name = &self.definitions[place];
        let definition = &self.formulas.definitions[place];
        let (t, shapes) = parameters.split_last().ok_or(OTHER)?;
        let last = shapes.len();
        let steps =
            self.steps(&definition.value, &[(last, t.clone())], "H'", &|v| parameters.get(v).cloned())?;
        let steps = steps.iter().map(String::as_str).chain(["reflexivity"]).collect::<Vec<_>>().join(". ");
        let given = shapes.iter().flat_map(|p| [p.as_str(), " "]).collect::<String>();
        Ok(format!(
            "Lemma {name}'angle : forall {} : R, - PI < {} < PI ->\n  {name} {given}{t} = {name}'t {given}({}).\n\
             Proof. intros {} H'. unfold {name}, {name}'t. {steps}. Qed.\n\n",
            parameters.join(" "),
            self.turn.text(t),
            self.turn.tangent_text(t),
            parameters.join(" "),
        ))
    }

    /// Steps that put tangents in place of angles in a goal: `angles` with their names, `bounds` that of the hypothesis
    /// about the innermost one.
    fn steps(
        &self,
        term: &Term,
        angles: &[(usize, String)],
        bounds: &str,
        names: &dyn Fn(usize) -> Option<String>,
    ) -> Result<Vec<String>, Missing> {
        let mut derivatives: Vec<String> = Vec::new();
        let mut calls: Vec<usize> = Vec::new();
        let mut reflections: Vec<String> = Vec::new();
        let mut sines: Vec<String> = Vec::new();
        self.each(term, &mut |part| {
            let writer = Writer { definitions: self.definitions, variables: names };
            match part {
                Term::Derivative { body, bound, at } if self.is_angle(body, *bound) => {
                    let step = self.derivative_step((body, *bound, at), angles, bounds, names)?;
                    if !derivatives.contains(&step) {
                        derivatives.push(step);
                    }
                }
                Term::Call(f, args) if self.turning[*f] => {
                    if !calls.contains(f) {
                        calls.push(*f);
                    }
                    let step = args.last().and_then(|at| self.reflection_step(at, angles, bounds, &writer));
                    reflections.extend(step.filter(|step| !reflections.contains(step)));
                }
                Term::Circular(f, x) => {
                    let own = angles
                        .iter()
                        .find_map(|(v, name)| Some((self.turn.multiple(&Linear::of(x, *v)?)?, name)));
                    let (k, t) = own.ok_or(OTHER)?;
                    let of = match f {
                        Circular::Sin => "sin",
                        Circular::Cos => "cos",
                    };
                    let kind = if k == 1 { "half" } else { "twice" };
                    let (argument, phi) = (writer.argument(x), self.turn.text(t));
                    let step = format!("rewrite ({of}_{kind} {argument} ({phi}) ltac:(field) {bounds})");
                    if !sines.contains(&step) {
                        sines.push(step);
                    }
                }
                _ => {}
            }
            Ok(())
        })?;
        let calls = calls.into_iter();
        let calls = calls
            .map(|f| format!("rewrite ?{}'angle by first [exact {bounds} | angle]", self.definitions[f]));
        Ok([derivatives, calls.collect(), reflections, sines].concat())
    }

    /// The step that puts a quotient in place of the tangent of an angle on its way back.
    fn reflection_step(
        &self,
        at: &Term,
        angles: &[(usize, String)],
        bounds: &str,
        writer: &Writer<'_>,
    ) -> Option<String> {
        let own =
            |(v, name): &(usize, String)| Some((self.turn.reflection(&Linear::of(at, *v)?)?, name.clone()));
        let (k, t) = angles.iter().find_map(own)?;
        let (p, q) = (self.turn.text(&writer.argument(at)), self.turn.text(&t));
        let known = format!("ltac:(first [exact {bounds} | angle])");
        Some(format!("rewrite (tan_mirror ({p}) ({q}) ({k}) ltac:(field) ltac:(lia) {known} ltac:(angle))"))
    }

    /// Does something with all parts of a formula that no derivative surrounds; derivatives are parts themselves.
    fn each(&self, term: &Term, with: &mut dyn FnMut(&Term) -> Result<(), Missing>) -> Result<(), Missing> {
        with(term)?;
        match term {
            Term::Number(_) | Term::Variable(_) | Term::Pi | Term::Circular(..) => Ok(()),
            Term::Neg(x) | Term::Power(x, _) => self.each(x, with),
            Term::Sum(parts) => parts.iter().try_for_each(|(_, x)| self.each(x, with)),
            Term::Product(parts) => parts.iter().try_for_each(|(_, x)| self.each(x, with)),
            Term::Call(_, args) => args.iter().try_for_each(|x| self.each(x, with)),
            Term::Derivative { body, bound, .. } if self.is_angle(body, *bound) => Ok(()),
            Term::Derivative { .. } => Err("a derivative in a shape parameter beside an angle"),
            Term::Integral { .. } => Err(INTEGRAL),
        }
    }

    /// The step that puts the derivative in the tangent in place of one in the angle.
    fn derivative_step(
        &self,
        (body, bound, at): (&Rc<Term>, usize, &Rc<Term>),
        angles: &[(usize, String)],
        bounds: &str,
        names: &dyn Fn(usize) -> Option<String>,
    ) -> Result<String, Missing> {
        let depth = angles.len();
        let (u, h) = (format!("u'{depth}"), format!("B'{depth}"));
        let inner: Vec<(usize, String)> = angles.iter().cloned().chain([(bound, u.clone())]).collect();
        let inner_names = |v: usize| if v == bound { Some(u.clone()) } else { names(v) };
        let known: Vec<(usize, Term)> = angles.iter().map(|(v, _)| (*v, Term::Variable(*v))).collect();
        let in_tangents = self.put(body, &[&known[..], &[(bound, Term::Variable(bound))]].concat())?;
        let texts = |v: usize| {
            let angle = angles.iter().find(|(a, _)| *a == v);
            angle.map_or_else(|| names(v), |(_, name)| Some(format!("({})", self.turn.tangent_text(name))))
        };
        let writer = Writer { definitions: self.definitions, variables: names };
        let own = self.all_in_tangents();
        let tangent_writer = Writer { definitions: &own, variables: &texts };
        let place = writer.argument(at);
        let link = self.steps(body, &inner, &h, &inner_names)?;
        let link = link.iter().map(String::as_str).chain(["reflexivity"]).collect::<Vec<_>>().join("; ");
        // The variables of the body in tangents: shape parameters, and the tangents around.
        let occurs = |v: usize| any(&in_tangents, &|part| *part == Term::Variable(v));
        let (mut env, mut values, mut ranges) = (Vec::new(), Vec::new(), Vec::new());
        for p in self.family.shapes.iter().filter(|p| occurs(p.var.0)) {
            env.push(p.var.0);
            values.push(names(p.var.0).ok_or(OTHER)?);
            ranges.push(range_data(&p.range));
        }
        for (v, name) in angles {
            env.push(*v);
            values.push(self.turn.tangent_text(name));
            ranges.push(String::from("(Inf, Inf)"));
        }
        if occurs(PI) {
            env.push(PI);
            values.push(String::from("PI"));
            ranges.push(String::from("(Inf, Inf)"));
        }
        let x = self.tangent_of(at, &known).ok_or("a derivative at another angle")?;
        let here = match &**at {
            Term::Variable(_) => String::new(),
            _ => format!("{}; ", self.fixed(at)?),
        };
        let cuts: Vec<String> = (0..=env.len()).map(|k| format!("Cut {k} (0) Direct Direct")).collect();
        let exists = format!(
            "ltac:({here}refine (ex_derive_by [{}] [{}] {} {} [{}] _ _); [run | box])",
            ranges.join("; "),
            cuts.join("; "),
            tangent_writer.body(&in_tangents, bound, &env),
            tangent_writer.data(&x, &env),
            values.join("; "),
        );
        let inside = format!("ltac:(first [exact {bounds} | angle])");
        Ok(format!(
            "rewrite (derive_angle_is {} {} {} {} {place} ltac:(intros {u} {h}; cbv beta; {link}) {inside} {exists})",
            writer.derived_function(body, bound),
            tangent_writer.derived_function(&in_tangents, bound),
            writer.argument(&self.turn.slope()),
            writer.argument(&Term::Number(self.turn.shift.clone()).by(Term::Pi)),
        ))
    }

    /// The identifier of a definition in tangents.
    fn in_tangents(&self, place: usize, name: &str) -> String {
        if self.turning[place] { format!("{name}'t") } else { name.to_string() }
    }

    /// The identifiers of all definitions, of those about the angle in tangents.
    pub(super) fn all_in_tangents(&self) -> Vec<String> {
        self.definitions.iter().enumerate().map(|(k, name)| self.in_tangents(k, name)).collect()
    }

    /// The step that gives the tangent at a number its value.
    fn fixed(&self, at: &Term) -> Result<String, Missing> {
        let k = self.turn.tangent_at(&Linear::of(at, usize::MAX).ok_or(OTHER)?).ok_or(OTHER)?;
        let writer = Writer { definitions: &[], variables: &|_| None };
        let phi = self.turn.text(&writer.argument(at));
        Ok(format!("rewrite (tan_at ({phi}) ({k}) ltac:(field) ltac:(lia))"))
    }

    /// The numbers at which functions of the angle are taken, and their derivatives.
    fn numbers(&self, term: &Term) -> Vec<Term> {
        let found = RefCell::new(Vec::new());
        let add = |at: &Term| {
            if Linear::of(at, usize::MAX).is_some() && !found.borrow().contains(at) {
                found.borrow_mut().push(at.clone());
            }
        };
        any(term, &|part| {
            match part {
                Term::Call(f, args) if self.turning[*f] => args.iter().last().into_iter().for_each(add),
                Term::Derivative { body, bound, at } if self.is_angle(body, *bound) => add(at),
                _ => {}
            }
            false
        });
        found.into_inner()
    }
}
