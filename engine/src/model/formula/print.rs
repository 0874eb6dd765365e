//! Expressions as text for messages: index variables replaced by their values, lists by one component.

use crate::syntax::{Condition, Expr, ExprKind, Generator, Loops, Role, Sign, TheoremRelation};
use basis_prover::collections::list::Mapped;

/// How to print.
pub(crate) struct Printer<'a> {
    /// Index parameters and index variables with their values.
    pub(crate) constants: &'a [(String, i64)],
    /// The component of lists to print instead of the list.
    pub(crate) component: Option<Component<'a>>,
}

/// One component of lists.
pub(crate) struct Component<'a> {
    /// The name that stands for the list of all functions.
    pub(crate) function_name: &'a str,
    /// Whether a name is a family, whose call is a list too.
    pub(crate) is_family: &'a dyn Fn(&str) -> bool,
    /// The place in the list.
    pub(crate) position: usize,
    /// The index of the function at that place.
    pub(crate) index: &'a [i64],
}

/// How tight an expression binds: a looser part inside a tighter one needs brackets.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Binding {
    Sum,
    Product,
    Power,
    Atom,
}

impl Printer<'_> {
    /// The expression as text.
    pub(crate) fn print(&self, expr: &Expr) -> String {
        self.at_least(expr, Binding::Sum)
    }

    /// `left`, `right` and `left - right` as text, without what need not be said.
    pub(crate) fn difference(&self, left: &Expr, right: &Expr) -> (String, String, String) {
        let left = self.print(left);
        let (right, binding) = self.parts(right);
        let difference = match (right.as_str(), binding) {
            ("0", _) => left.clone(),
            (_, Binding::Sum) => format!("{left} - ({right})"),
            _ => format!("{left} - {right}"),
        };
        (left, right, difference)
    }

    fn at_least(&self, expr: &Expr, wanted: Binding) -> String {
        let (text, binding) = self.parts(expr);
        if binding < wanted { format!("({text})") } else { text }
    }

    fn parts(&self, expr: &Expr) -> (String, Binding) {
        match &expr.kind {
            ExprKind::Number(n) => {
                (n.to_string(), if n.is_integer() { Binding::Atom } else { Binding::Product })
            }
            ExprKind::Name(name) => (self.name(name), Binding::Atom),
            ExprKind::Neg(inner) => (format!("-{}", self.at_least(inner, Binding::Product)), Binding::Sum),
            ExprKind::Sum(parts) => {
                let mut text = String::new();
                for (k, (sign, part)) in parts.iter().enumerate() {
                    text += match (k, sign) {
                        (0, _) => "",
                        (_, Sign::Minus) => " - ",
                        (_, Sign::Plus) => " + ",
                    };
                    // A sign inside stands in brackets, except at the beginning.
                    text += &self.at_least(part, if k == 0 { Binding::Sum } else { Binding::Product });
                }
                (text, Binding::Sum)
            }
            ExprKind::Product(parts) => {
                let mut text = String::new();
                for (k, (role, part)) in parts.iter().enumerate() {
                    text += match (k, role) {
                        (0, _) => "",
                        (_, Role::Divisor) => "/",
                        (_, Role::Factor) => "*",
                    };
                    let sign_in_front = k == 0 && matches!(part.kind, ExprKind::Neg(_));
                    text += &match (sign_in_front, role) {
                        (true, _) => self.parts(part).0,
                        (false, Role::Divisor) => self.at_least(part, Binding::Power),
                        (false, Role::Factor) => self.at_least(part, Binding::Product),
                    };
                }
                (text.clone(), if text.starts_with('-') { Binding::Sum } else { Binding::Product })
            }
            ExprKind::Power(base, exponent) => (
                format!("{}^{}", self.at_least(base, Binding::Atom), self.at_least(exponent, Binding::Atom)),
                Binding::Power,
            ),
            ExprKind::Index(base, indices) => {
                // b[i] is one function already: its name is not to be replaced by a component.
                let base = self.plain().at_least(base, Binding::Atom);
                let indices: Vec<String> =
                    indices.mapped(|i| self.whole(i).map_or_else(|| self.print(i), |n| n.to_string()));
                (format!("{base}[{}]", indices.join(",")), Binding::Atom)
            }
            ExprKind::Call(callee, arguments) => {
                let plain = self.plain();
                let inner_family = self.family_call(callee);
                // A sum is one function, whatever list it is of.
                let is_sum =
                    matches!(&callee.kind, ExprKind::Name(name) if name == "sum" || name == "product");
                let printer = if inner_family || is_sum { &plain } else { self };
                let inner = match arguments.as_slice() {
                    [Expr { kind: ExprKind::Each(body, loops), .. }] if is_sum => printer.each(body, loops),
                    _ => printer.list(arguments, ", "),
                };
                let text = format!("{}({inner})", printer.at_least(callee, Binding::Atom));
                match &self.component {
                    Some(c) if inner_family => (format!("{text}[{}]", indices(c.index)), Binding::Atom),
                    _ => (text, Binding::Atom),
                }
            }
            ExprKind::List(parts) => match &self.component {
                Some(c) => match parts.get(c.position) {
                    Some(part) => self.parts(part),
                    None => (String::from("0"), Binding::Atom),
                },
                None => (format!("[{}]", self.list(parts, ", ")), Binding::Atom),
            },
            ExprKind::Tuple(parts) => (format!("({})", self.list(parts, ", ")), Binding::Atom),
            ExprKind::Each(body, loops) => {
                let list = || format!("[{}]", self.plain().each(body, loops));
                match &self.component {
                    None => (list(), Binding::Atom),
                    Some(c) => match self.values_at(loops, c.position) {
                        Some(values) => {
                            let constants = [self.constants, &values].concat();
                            Printer { constants: &constants, component: None }.parts(body)
                        }
                        None => (format!("{}[{}]", list(), c.position), Binding::Atom),
                    },
                }
            }
        }
    }

    /// The same for whole lists.
    const fn plain(&self) -> Printer<'_> {
        Printer { constants: self.constants, component: None }
    }

    /// An expression for all values of index variables, without the brackets around it.
    fn each(&self, body: &Expr, loops: &Loops) -> String {
        let range = |g: &Generator| match g {
            Generator::Range(g) => {
                let dots = if g.inclusive { "..=" } else { ".." };
                format!("{} in {}{dots}{}", g.name.text, self.print(&g.low), self.print(&g.high))
            }
            Generator::Simplex(names, sum) => {
                let names: Vec<&str> = names.mapped(|n| n.text.as_str());
                format!("{} in simplex({})", names.join(", "), self.print(sum))
            }
        };
        let ranges: Vec<String> = loops.generators.mapped(range);
        let mut text = format!("{} for {}", self.print(body), ranges.join(", "));
        if let Some(condition) = &loops.condition {
            text += &format!(" if {}", self.condition(condition, false));
        }
        text
    }

    /// The value that the index variable of a loop has at a place of its list; of several, or with a condition, they are not
    /// looked for.
    fn values_at(&self, loops: &Loops, position: usize) -> Option<Vec<(String, i64)>> {
        let ([Generator::Range(range)], None) = (loops.generators.as_slice(), &loops.condition) else {
            return None;
        };
        let value = self.whole(&range.low)?.checked_add(i64::try_from(position).ok()?)?;
        Some(vec![(range.name.text.clone(), value)])
    }

    /// A condition; inside of another one with brackets if it is made of several.
    fn condition(&self, condition: &Condition, inner: bool) -> String {
        let joined = |parts: &[Condition], word: &str| {
            let text = parts.mapped(|part| self.condition(part, true)).join(word);
            if inner { format!("({text})") } else { text }
        };
        match condition {
            Condition::Compare(a, sign, b) => {
                let sign = TheoremRelation::Compare(*sign).symbol();
                format!("{} {sign} {}", self.print(a), self.print(b))
            }
            Condition::All(parts) => joined(parts, " && "),
            Condition::Any(parts) => joined(parts, " || "),
            Condition::Not(part) => match &**part {
                Condition::Compare(..) => format!("!({})", self.condition(part, false)),
                _ => format!("!{}", self.condition(part, true)),
            },
        }
    }

    /// Whether the callee of a call is a family, or a family with its order.
    fn family_call(&self, callee: &Expr) -> bool {
        let Some(c) = &self.component else { return false };
        match &callee.kind {
            ExprKind::Name(name) => (c.is_family)(name),
            ExprKind::Call(inner, _) => matches!(&inner.kind, ExprKind::Name(name) if (c.is_family)(name)),
            _ => false,
        }
    }

    /// The whole number that an index such as `n - 1` is.
    fn whole(&self, expr: &Expr) -> Option<i64> {
        match &expr.kind {
            ExprKind::Number(n) => n.to_i64(),
            ExprKind::Name(name) => self.constants.iter().rev().find(|(n, _)| n == name).map(|(_, v)| *v),
            ExprKind::Neg(inner) => self.whole(inner)?.checked_neg(),
            ExprKind::Sum(parts) => parts.iter().try_fold(0_i64, |sum, (sign, part)| {
                let value = self.whole(part)?;
                if *sign == Sign::Minus { sum.checked_sub(value) } else { sum.checked_add(value) }
            }),
            ExprKind::Product(parts) => parts.iter().try_fold(1_i64, |product, (role, part)| {
                let value = self.whole(part)?;
                if *role == Role::Divisor { None } else { product.checked_mul(value) }
            }),
            _ => None,
        }
    }

    fn name(&self, name: &str) -> String {
        if let Some((_, value)) = self.constants.iter().rev().find(|(n, _)| n == name) {
            return value.to_string();
        }
        match &self.component {
            Some(c) if name == c.function_name || (c.is_family)(name) => {
                format!("{name}[{}]", indices(c.index))
            }
            _ => name.to_string(),
        }
    }

    fn list(&self, parts: &[Expr], separator: &str) -> String {
        parts.mapped(|e| self.print(e)).join(separator)
    }
}

fn indices(index: &[i64]) -> String {
    index.mapped(i64::to_string).join(",")
}
