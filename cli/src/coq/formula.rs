//! Formulas twice: as a reader of Coq sees them, and as the data of `Basis.v` whose value they are.

use basis_engine::algebra::poly::{Poly, Var};
use basis_engine::algebra::rational::Rational;
use basis_engine::formulas::{Circular, Comparison, Role, Sign, Term};

/// The identifiers of definitions and variables.
pub(super) struct Writer<'a> {
    /// By the place of a definition.
    pub(super) definitions: &'a [String],
    /// By the number of a variable; of variables that stand for something else, nothing.
    pub(super) variables: &'a dyn Fn(usize) -> Option<String>,
}

/// How tight a text binds: a looser part inside a tighter one needs brackets.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Binding {
    Sum,
    Product,
    Power,
    Application,
    Atom,
}

impl Writer<'_> {
    /// A formula as text.
    pub(super) fn text(&self, term: &Term) -> String {
        self.at_least(term, Binding::Sum, &mut Vec::new())
    }

    /// A formula as an argument of a function.
    pub(super) fn argument(&self, term: &Term) -> String {
        self.at_least(term, Binding::Atom, &mut Vec::new())
    }

    /// A comparison as text.
    pub(super) fn compared(&self, left: &Term, comparison: Comparison, right: &Term) -> String {
        format!("{} {} {}", self.text(left), comparison.symbol(), self.text(right))
    }

    /// That a function has a derivative, and which.
    pub(super) fn derived(&self, body: &Term, bound: usize, at: &Term, value: &Term) -> String {
        let function = self.function(body, bound, &mut Vec::new());
        format!("is_derive {function} {} {}", self.argument(at), self.argument(value))
    }

    /// That a function has an integral between bounds, and which.
    pub(super) fn integrated(
        &self,
        body: &Term,
        bound: usize,
        [low, high]: [&Term; 2],
        value: &Term,
    ) -> String {
        let function = self.function(body, bound, &mut Vec::new());
        format!("is_RInt {function} {} {} {}", self.argument(low), self.argument(high), self.argument(value))
    }

    /// What is differentiated, as a function.
    pub(super) fn derived_function(&self, body: &Term, bound: usize) -> String {
        self.function(body, bound, &mut Vec::new())
    }

    fn function(&self, body: &Term, bound: usize, around: &mut Vec<usize>) -> String {
        around.push(bound);
        let text = format!("(fun {} => {})", inner(around.len()), self.at_least(body, Binding::Sum, around));
        around.pop();
        text
    }

    fn at_least(&self, term: &Term, wanted: Binding, around: &mut Vec<usize>) -> String {
        let (text, binding) = self.parts(term, around);
        if binding < wanted { format!("({text})") } else { text }
    }

    /// `around` has the variables of the derivatives and integrals around, the outermost first.
    fn parts(&self, term: &Term, around: &mut Vec<usize>) -> (String, Binding) {
        match term {
            Term::Number(n) => (number(n), Binding::Atom),
            Term::Pi => (String::from("PI"), Binding::Atom),
            Term::Circular(f, x) => {
                let name = match f {
                    Circular::Sin => "sin",
                    Circular::Cos => "cos",
                };
                (format!("{name} {}", self.at_least(x, Binding::Atom, around)), Binding::Application)
            }
            Term::Variable(v) => match around.iter().rposition(|bound| bound == v) {
                Some(depth) => (inner(depth + 1), Binding::Atom),
                None => {
                    let text = (self.variables)(*v).unwrap_or_else(|| format!("missing'{v}"));
                    // A coordinate is the value of a function.
                    let binding = if text.contains(' ') { Binding::Application } else { Binding::Atom };
                    (text, binding)
                }
            },
            Term::Neg(x) => (format!("(- {})", self.at_least(x, Binding::Atom, around)), Binding::Atom),
            Term::Sum(parts) => {
                let mut text = String::new();
                for (k, (sign, part)) in parts.iter().enumerate() {
                    text += match (k, sign) {
                        (0, _) => "",
                        (_, Sign::Minus) => " - ",
                        (_, Sign::Plus) => " + ",
                    };
                    text +=
                        &self.at_least(part, if k == 0 { Binding::Sum } else { Binding::Product }, around);
                }
                (text, Binding::Sum)
            }
            Term::Product(parts) => {
                let mut text = String::new();
                for (k, (role, part)) in parts.iter().enumerate() {
                    text += match (k, role) {
                        (0, _) => "",
                        (_, Role::Divisor) => " / ",
                        (_, Role::Factor) => " * ",
                    };
                    text +=
                        &self.at_least(part, if k == 0 { Binding::Product } else { Binding::Power }, around);
                }
                (text, Binding::Product)
            }
            Term::Power(x, n) => {
                (format!("{} ^ {n}", self.at_least(x, Binding::Application, around)), Binding::Power)
            }
            Term::Call(f, args) => {
                let args: Vec<String> =
                    args.iter().map(|x| self.at_least(x, Binding::Atom, around)).collect();
                (format!("{} {}", self.definitions[*f], args.join(" ")), Binding::Application)
            }
            Term::Derivative { body, bound, at } => {
                let function = self.function(body, *bound, around);
                (
                    format!("Derive {function} {}", self.at_least(at, Binding::Atom, around)),
                    Binding::Application,
                )
            }
            Term::Integral { body, bound, low, high } => {
                let function = self.function(body, *bound, around);
                let [low, high] = [low, high].map(|end| self.at_least(end, Binding::Atom, around));
                (format!("RInt {function} {low} {high}"), Binding::Application)
            }
        }
    }

    /// A formula as data; `env` has the variables in the order in which their values are listed.
    pub(super) fn data(&self, term: &Term, env: &[usize]) -> String {
        match term {
            Term::Number(n) if n.is_integer() => format!("(Num ({n}))"),
            Term::Number(n) => format!("(Quot (Num ({})) (Num {}))", n.numer(), n.denom()),
            Term::Variable(v) => {
                let place = env.iter().position(|known| known == v);
                place.map_or_else(|| format!("missing'{v}"), |place| format!("(Var {place})"))
            }
            // What stands for these is rational.
            Term::Pi | Term::Circular(..) => String::from("missing'"),
            Term::Neg(x) => format!("(Opp {})", self.data(x, env)),
            Term::Sum(parts) => {
                self.folded(parts.iter().map(|(s, x)| (*s == Sign::Minus, x)), ["Sum", "Diff"], env)
            }
            Term::Product(parts) => {
                self.folded(parts.iter().map(|(r, x)| (*r == Role::Divisor, x)), ["Prod", "Quot"], env)
            }
            Term::Power(x, n) => format!("(Pow {} {n})", self.data(x, env)),
            Term::Call(f, args) => {
                let args: Vec<String> = args.iter().map(|x| self.data(x, env)).collect();
                format!("(App {}'fn [{}])", self.definitions[*f], args.join("; "))
            }
            Term::Derivative { body, bound, at } => {
                format!("(Der {} {})", self.body(body, *bound, env), self.data(at, env))
            }
            Term::Integral { body, bound, low, high } => {
                let body = self.body(body, *bound, env);
                format!("(Int {body} {} {})", self.data(low, env), self.data(high, env))
            }
        }
    }

    /// What is differentiated or integrated as data: its variable is the first.
    pub(super) fn body(&self, body: &Term, bound: usize, env: &[usize]) -> String {
        self.data(body, &[&[bound], env].concat())
    }

    fn folded<'t>(
        &self,
        parts: impl Iterator<Item = (bool, &'t Term)>,
        [plain, inverse]: [&str; 2],
        env: &[usize],
    ) -> String {
        let mut text = String::new();
        for (k, (inverted, part)) in parts.enumerate() {
            let part = self.data(part, env);
            text = match (k, inverted) {
                (0, _) => part,
                (_, true) => format!("({inverse} {text} {part})"),
                (_, false) => format!("({plain} {text} {part})"),
            };
        }
        text
    }
}

/// The variable of a derivative or integral, by how many are around each other.
fn inner(depth: usize) -> String {
    format!("x{}", "'".repeat(depth))
}

/// A number as a real number of Coq.
pub(super) fn number(n: &Rational) -> String {
    let signed = |n: &Rational| if n.is_negative() { format!("({n})") } else { n.to_string() };
    if n.is_integer() { signed(n) } else { format!("({} / {})", signed(&n.numer()), n.denom()) }
}

/// A number as a rational number of Coq.
pub(super) fn rational(n: &Rational) -> String {
    if n.is_integer() { format!("({n})") } else { format!("({} # {})", n.numer(), n.denom()) }
}

/// A polynomial as data, its variables in this order.
pub(super) fn polynomial_data(p: &Poly, variables: &[Var]) -> String {
    if let Some(c) = p.as_constant() {
        return format!("C {}", rational(&c));
    }
    let Some((first, rest)) = variables.split_first() else { return String::from("C 0") };
    let coefficients: Vec<String> =
        p.coefficients_in(*first).iter().map(|c| polynomial_data(c, rest)).collect();
    format!("P [{}]", coefficients.join("; "))
}
