//! Where a statement holds: the variables of a theorem with their hypotheses, and how its proof goes from there to
//! independent variables with ranges.

use basis_engine::Family;
use basis_engine::algebra::range::{End, Range};
use basis_engine::algebra::rational::Rational;
use basis_engine::formulas::{Sign, Term};
use basis_engine::model::Factor;
use basis_kernel::{Chart, Domain};

use super::formula::{Writer, number, rational};

/// The variables of charts have numbers from here on, so that they are none of the family, of which the last barycentric
/// coordinate occurs in no statement of the kernel.
const CHART: usize = 1 << 16;

/// The variables of a family with the values that an `at` block fixes.
pub(super) struct Frame {
    /// What is known, as formulas: ranges, fixed values, and that barycentric coordinates sum to 1.
    pub(super) hypotheses: Vec<String>,
    /// Steps that put independent variables in place of all others.
    pub(super) steps: Vec<String>,
    /// What stands for each variable that is not independent.
    by: Vec<(usize, Term)>,
    /// The numbers of the independent variables with their names and ranges.
    pub(super) independent: Vec<(usize, String, Range)>,
}

impl Frame {
    /// Of a simplex the independent variables are those of the box of `chart`, if there is one, or else all but one of
    /// the coordinates, about which nothing is said.
    pub(super) fn new(
        family: &Family,
        names: &[String],
        fixed: &[(usize, Term)],
        chart: Option<(&Domain, &Chart)>,
    ) -> Option<Self> {
        let mut frame =
            Self { hypotheses: Vec::new(), steps: Vec::new(), by: Vec::new(), independent: Vec::new() };
        let name = |v: usize| names.get(v).cloned();
        let writer = Writer { definitions: &[], variables: &name };
        let (mut intervals, mut simplices) = (Vec::new(), Vec::new());
        for factor in family.factors() {
            match factor {
                Factor::Interval(p) => intervals.push(p),
                Factor::Simplex(..) => {
                    simplices.push(factor.variables().map(|p| p.var.0).collect::<Vec<usize>>());
                }
            }
        }
        for parameter in family.shapes.iter().chain(intervals) {
            let v = parameter.var.0;
            frame.hypotheses.extend(between(&names[v], &parameter.range));
            if fixed.iter().all(|(f, _)| *f != v) {
                frame.independent.push((v, names[v].clone(), parameter.range.clone()));
            }
        }
        for coordinates in &simplices {
            frame.hypotheses.extend(coordinates.iter().map(|v| format!("0 <= {}", names[*v])));
            let sum: Vec<&str> = coordinates.iter().map(|v| names[*v].as_str()).collect();
            frame.hypotheses.push(format!("{} = 1", sum.join(" + ")));
        }
        for (v, value) in fixed {
            frame.hypotheses.push(format!("{} = {}", names[*v], writer.text(value)));
            frame.steps.push(format!("subst {}.", names[*v]));
            frame.by.push((*v, value.clone()));
        }
        for coordinates in &simplices {
            frame.simplex(coordinates, names, chart)?;
        }
        Some(frame)
    }

    fn simplex(
        &mut self,
        coordinates: &[usize],
        names: &[String],
        chart: Option<(&Domain, &Chart)>,
    ) -> Option<()> {
        let mut open: Vec<usize> =
            coordinates.iter().copied().filter(|v| self.by.iter().all(|(known, _)| known != v)).collect();
        let name = |v: usize| names.get(v).cloned();
        let given = coordinates.iter().filter_map(|v| self.by.iter().find(|(known, _)| known == v));
        let given = given.map(|(_, value)| match value {
            Term::Number(n) => Some(n.clone()),
            _ => None,
        });
        let given: Vec<Rational> = given.collect::<Option<_>>()?;
        let left = given.iter().fold(Rational::ONE, |left, x| &left - x);
        if let Some((domain, chart)) = chart {
            // x1 = c (1 - s1), x2 = c s1 (1 - s2), ... on each simplex
            let all = domain.simplices.iter();
            let all = all.flat_map(|s| s.variables.iter().enumerate().map(move |(k, v)| (v.0, k, &s.sum)));
            let fresh = chart.region().ranges.iter().skip(domain.region.ranges.len());
            let mut rest: Option<Term> = None;
            for ((v, k, sum), (s, range)) in all.zip(fresh).filter(|((v, ..), _)| coordinates.contains(v)) {
                let s_name = format!("s'{}", self.independent.len() + 1);
                let whole = rest.filter(|_| k > 0).unwrap_or_else(|| Term::Number(sum.clone()));
                let known = |w: usize| {
                    name(w)
                        .or_else(|| Some(self.independent.iter().find(|(other, ..)| *other == w)?.1.clone()))
                };
                let text = Writer { definitions: &[], variables: &known }.argument(&whole);
                let own = CHART + s.0;
                let (x, s_term) = (names.get(v)?, Term::Variable(own));
                self.steps.push(format!(
                    "destruct (split_off {text} {x}) as ({s_name} & ? & ?); [lra | lra | subst {x}]."
                ));
                self.by.push((v, whole.clone().by(Term::integer(1).minus(s_term.clone()))));
                self.independent.push((own, s_name, range.clone()));
                rest = Some(whole.by(s_term));
                open.retain(|other| *other != v);
            }
        } else if !left.is_zero() {
            for v in open.drain(..open.len().saturating_sub(1)) {
                self.independent.push((v, names[v].clone(), Range::all()));
            }
        }
        // What is left: 0 at a corner, or else 1 minus all others.
        let others = open.len() > 1;
        for v in open {
            let value = if others || left.is_zero() {
                Term::integer(0)
            } else {
                let all = coordinates.iter().filter(|w| **w != v).map(|w| (Sign::Minus, self.term(*w)));
                Term::Sum(std::iter::once((Sign::Plus, Term::integer(1))).chain(all).collect())
            };
            let known = |w: usize| {
                let own = self.independent.iter().find(|(other, ..)| *other == w).map(|(_, n, _)| n.clone());
                own.or_else(|| name(w))
            };
            let text = Writer { definitions: &[], variables: &known }.text(&value);
            self.steps.push(format!("assert ({} = {text}) by lra; subst {}.", names[v], names[v]));
            self.by.push((v, value));
        }
        Some(())
    }

    /// What stands for a variable.
    fn term(&self, v: usize) -> Term {
        self.by.iter().find(|(known, _)| *known == v).map_or(Term::Variable(v), |(_, value)| value.clone())
    }

    /// A formula in the independent variables.
    pub(super) fn put(&self, term: &Term) -> Term {
        term.put(&|v| self.by.iter().find(|(known, _)| *known == v).map(|(_, value)| value.clone()))
    }

    /// The numbers of the independent variables.
    pub(super) fn env(&self) -> Vec<usize> {
        self.independent.iter().map(|(v, ..)| *v).collect()
    }

    /// Their names as a list.
    pub(super) fn values(&self) -> String {
        let names: Vec<&str> = self.independent.iter().map(|(_, name, _)| name.as_str()).collect();
        format!("[{}]", names.join("; "))
    }

    /// Their ranges as a list.
    pub(super) fn ranges(&self) -> String {
        let ranges: Vec<String> = self.independent.iter().map(|(.., range)| range_data(range)).collect();
        format!("[{}]", ranges.join("; "))
    }
}

/// A range as a formula; nothing for all real numbers.
pub(super) fn between(name: &str, range: &Range) -> Option<String> {
    let sign = |end: &End| if end.is_included() { "<=" } else { "<" };
    let low = range.low.value().map(|x| format!("{} {} ", number(x), sign(&range.low)));
    let high = range.high.value().map(|x| format!(" {} {}", sign(&range.high), number(x)));
    (low.is_some() || high.is_some())
        .then(|| format!("{}{name}{}", low.unwrap_or_default(), high.unwrap_or_default()))
}

/// A range as data.
pub(super) fn range_data(range: &Range) -> String {
    let end = |end: &End| match end {
        End::Infinite => String::from("Inf"),
        End::Included(x) => format!("Incl {}", rational(x)),
        End::Excluded(x) => format!("Excl {}", rational(x)),
    };
    format!("({}, {})", end(&range.low), end(&range.high))
}
