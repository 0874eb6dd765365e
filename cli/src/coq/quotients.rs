//! Quotients that the engine brings into lowest terms: (t³ − t)/(t² − t) is t + 1 for it, and has no value at 0 for Coq.

use std::rc::Rc;

use basis_engine::Family;
use basis_engine::algebra::fraction::Fraction;
use basis_engine::algebra::poly::{Poly, Var};
use basis_engine::algebra::work::Work;
use basis_engine::formulas::{Formulas, Role, Sign, Term};
use basis_engine::model::obligation::{Goal, Obligation};
use basis_kernel::{Certificate, Domain, Proof, Quotient, Relation, Statement};

/// Whether a formula divides by a polynomial that vanishes on the domain, because its zeros cancel; also if nothing shows that
/// it does not, or that takes too much work to see.
///
/// `functions` are those of the family, or of one of its spans.
pub(super) fn cancel(
    family: &Family,
    formulas: &Formulas,
    functions: &[usize],
    obligations: &[&Obligation],
) -> bool {
    if !formulas.definitions.iter().any(|d| divides(&d.value)) {
        return false;
    }
    let nonzero: Vec<&Poly> = obligations
        .iter()
        .filter_map(|o| match &o.goal {
            Goal::Nonzero(poly, _) => Some(poly),
            Goal::Holds(_) => None,
        })
        .collect();
    let mut reader = Reader { read: Vec::new(), work: Work::usual(1) };
    for definition in &formulas.definitions {
        let Some(read) = reader.definition(&definition.value) else { return true };
        reader.read.push(read);
    }
    functions.iter().any(|f| {
        let own = formulas.definitions[*f].parameters.iter();
        let places: Option<Vec<Var>> =
            own.map(|p| family.names.iter().position(|name| name == p).map(Var)).collect();
        let Some(places) = places else { return true };
        reader.read[*f].1.iter().any(|divisor| {
            let renamed = Fraction::from(divisor.clone()).rename(&places);
            let left = without(renamed.quotient().numerator, &nonzero);
            !vanishes_nowhere(left, family)
        })
    })
}

/// Whether a formula divides by something else than a number.
fn divides(term: &Term) -> bool {
    match term {
        Term::Number(_) | Term::Variable(_) | Term::Pi => false,
        Term::Neg(x) | Term::Power(x, _) | Term::Circular(_, x) => divides(x),
        Term::Sum(parts) => parts.iter().any(|(_, x)| divides(x)),
        Term::Product(parts) => parts
            .iter()
            .any(|(role, x)| *role == Role::Divisor && !matches!(x, Term::Number(_)) || divides(x)),
        Term::Call(_, args) => args.iter().any(divides),
        Term::Derivative { body, at, .. } => divides(body) || divides(at),
        Term::Integral { body, low, high, .. } => divides(body) || divides(low) || divides(high),
    }
}

/// Whether a formula has an integral of something that is divided by its variable, for which `Basis.v` computes no
/// antiderivative.
pub(super) fn integrated(term: &Term, formulas: &Formulas) -> bool {
    match term {
        Term::Number(_) | Term::Variable(_) | Term::Pi => false,
        Term::Neg(x) | Term::Power(x, _) | Term::Circular(_, x) => integrated(x, formulas),
        Term::Sum(parts) => parts.iter().any(|(_, x)| integrated(x, formulas)),
        Term::Product(parts) => parts.iter().any(|(_, x)| integrated(x, formulas)),
        Term::Call(f, args) => {
            let value = &formulas.definitions[*f].value;
            integrated(value, formulas) || args.iter().any(|x| integrated(x, formulas))
        }
        Term::Derivative { body, at, .. } => integrated(body, formulas) || integrated(at, formulas),
        Term::Integral { body, bound, low, high } => {
            divided_by(body, *bound, formulas)
                || [body, low, high].into_iter().any(|x| integrated(x, formulas))
        }
    }
}

/// Whether something is divided by what contains a variable.
fn divided_by(term: &Term, var: usize, formulas: &Formulas) -> bool {
    let again = |term: &Term| divided_by(term, var, formulas);
    match term {
        Term::Number(_) | Term::Variable(_) | Term::Pi => false,
        Term::Neg(x) | Term::Power(x, _) | Term::Circular(_, x) => again(x),
        Term::Sum(parts) => parts.iter().any(|(_, x)| again(x)),
        Term::Product(parts) => {
            parts.iter().any(|(role, x)| *role == Role::Divisor && contains(x, var) || again(x))
        }
        Term::Call(f, args) => {
            let value = &formulas.definitions[*f].value;
            let inside = |(k, x): (usize, &Term)| contains(x, var) && divided_by(value, k, formulas);
            args.iter().any(again) || args.iter().enumerate().any(inside)
        }
        Term::Derivative { body, bound, at } => {
            again(body) || again(at) || contains(at, var) && divided_by(body, *bound, formulas)
        }
        Term::Integral { body, low, high, .. } => [body, low, high].into_iter().any(|x| again(x)),
    }
}

/// Whether a variable occurs.
fn contains(term: &Term, var: usize) -> bool {
    match term {
        Term::Number(_) | Term::Pi => false,
        Term::Variable(v) => *v == var,
        Term::Neg(x) | Term::Power(x, _) | Term::Circular(_, x) => contains(x, var),
        Term::Sum(parts) => parts.iter().any(|(_, x)| contains(x, var)),
        Term::Product(parts) => parts.iter().any(|(_, x)| contains(x, var)),
        Term::Call(_, args) => args.iter().any(|x| contains(x, var)),
        Term::Derivative { body, at, .. } => contains(body, var) || contains(at, var),
        Term::Integral { body, low, high, .. } => [body, low, high].into_iter().any(|x| contains(x, var)),
    }
}

/// A polynomial without the factors that it has in common with given ones.
fn without(mut poly: Poly, nonzero: &[&Poly]) -> Poly {
    loop {
        let before = poly.total_degree();
        for known in nonzero {
            if let Some(reduced) = Fraction::new(poly.clone(), (*known).clone()) {
                poly = reduced.quotient().numerator;
            }
        }
        if poly.total_degree() == before {
            return poly;
        }
    }
}

/// Whether Bernstein coefficients, by which `Basis.v` tries, show that a polynomial vanishes nowhere.
fn vanishes_nowhere(poly: Poly, family: &Family) -> bool {
    let domain = Rc::new(Domain::of(family.region()));
    [-&poly, poly].into_iter().any(|p| {
        let (value, domain) = (Quotient::from(p), Rc::clone(&domain));
        let statement = Statement::Sign { value, relation: Relation::Positive, domain };
        Proof::new(Rc::new(statement), Certificate::Direct, &mut Work::usual(1)).is_ok()
    })
}

/// The value of a formula in lowest terms, and the polynomials by which it divides.
type Read = (Fraction, Vec<Poly>);

/// Reads formulas as fractions.
struct Reader {
    /// The definitions, as functions of their parameters.
    read: Vec<Read>,
    work: Work,
}

/// Where the parameters of a definition stand while its arguments take their place.
const APART: usize = 1000;

impl Reader {
    fn definition(&mut self, term: &Term) -> Option<Read> {
        let mut divisors = Vec::new();
        let value = self.value(term, &mut divisors)?;
        Some((value, divisors))
    }

    fn value(&mut self, term: &Term, divisors: &mut Vec<Poly>) -> Option<Fraction> {
        Some(match term {
            Term::Number(x) => Fraction::constant(x.clone()),
            Term::Variable(v) => Fraction::var(Var(*v)),
            Term::Pi | Term::Circular(..) | Term::Integral { .. } => return None,
            Term::Neg(x) => {
                let x = self.value(x, divisors)?;
                Fraction::zero().sub_within(&x, &mut self.work)?
            }
            Term::Sum(parts) => {
                let mut sum = Fraction::zero();
                for (sign, part) in parts {
                    let part = self.value(part, divisors)?;
                    sum = match sign {
                        Sign::Plus => sum.add_within(&part, &mut self.work)?,
                        Sign::Minus => sum.sub_within(&part, &mut self.work)?,
                    };
                }
                sum
            }
            Term::Product(parts) => {
                let mut product = Fraction::from(Poly::one());
                for (role, part) in parts {
                    let part = self.value(part, divisors)?;
                    product = match role {
                        Role::Factor => product.mul_within(&part, &mut self.work)?,
                        Role::Divisor => {
                            divisors.push(part.quotient().numerator);
                            product.div_within(&part, &mut self.work).ok()??
                        }
                    };
                }
                product
            }
            Term::Power(x, n) => {
                let x = self.value(x, divisors)?;
                let mut power = Fraction::from(Poly::one());
                for _ in 0..*n {
                    power = power.mul_within(&x, &mut self.work)?;
                }
                power
            }
            Term::Call(f, args) => {
                let args: Vec<Fraction> =
                    args.iter().map(|x| self.value(x, divisors)).collect::<Option<_>>()?;
                let (value, own) = self.read.get(*f)?.clone();
                for divisor in own {
                    let put = self.applied(&Fraction::from(divisor), &args)?;
                    divisors.push(put.quotient().numerator);
                }
                self.applied(&value, &args)?
            }
            Term::Derivative { body, bound, at } => {
                let mut own = Vec::new();
                let value = self.value(body, &mut own)?.derivative_within(Var(*bound), &mut self.work)?;
                let at = self.value(at, divisors)?;
                for divisor in own {
                    let put = Fraction::from(divisor).substitute_within(Var(*bound), &at, &mut self.work);
                    divisors.push(put.ok()??.quotient().numerator);
                }
                value.substitute_within(Var(*bound), &at, &mut self.work).ok()??
            }
        })
    }

    /// A function of the variables 0, 1, … at arguments.
    fn applied(&mut self, value: &Fraction, args: &[Fraction]) -> Option<Fraction> {
        let apart: Vec<Var> = (0..args.len()).map(|k| Var(APART + k)).collect();
        let mut value = value.rename(&apart);
        for (var, arg) in apart.iter().zip(args) {
            value = value.substitute_within(*var, arg, &mut self.work).ok()??;
        }
        Some(value)
    }
}
