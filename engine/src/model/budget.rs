//! How large formulas may become, counted in work and never in time, so that one spec gives one result on
//! every machine.

use core::cell::{Cell, RefCell};
use std::rc::Rc;

use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::rational::Rational;
use crate::algebra::work::{Spent, Work};
use crate::diagnostic::grouped;
use crate::model::angle::Analytic;
use crate::model::roots::{self, Root};

/// The highest total degree of a polynomial.
pub(crate) const MAX_DEGREE: u32 = 100;
/// The most terms of a polynomial.
const MAX_TERMS: usize = 20_000;
/// The most bits of a coefficient.
const MAX_BITS: u64 = 20_000;
/// The most term products in the expansion of the functions of one family, and of each of its claims.
const MAX_WORK: u64 = 400_000;
/// The most work to bring quotients into lowest terms, for the functions of a family and for each of its claims.
const MAX_REDUCTION: u64 = 4_000_000;

/// The most term products in all expansions of a run: all families in all their orders, and all claims.
const RUN_WORK: u64 = 15_000_000;
/// The most work of a run to bring quotients into lowest terms.
const RUN_REDUCTION: u64 = 120_000_000;
/// The most parts of formulas that are evaluated in a run, the passes of loops included.
const RUN_STEPS: u64 = 8_000_000;
/// The most families of a run, each order counted.
const RUN_FAMILIES: u64 = 5_000;
/// The most claims of a run, each value of an index variable counted.
const RUN_CLAIMS: u64 = 20_000;
/// The most work of the provers in a run for what is needed for formulas to have a meaning.
const RUN_DECISIONS: u64 = 60_000_000;
/// The most memory that the functions and claims of a run take, in words of eight bytes, roughly.
const RUN_WORDS: u64 = 20_000_000;

/// What to do about a run that takes too much.
pub(crate) const SPLIT: &str = "split the spec into several files, narrow the ranges of its index parameters and variables, or lower the degrees";

/// What a run may still take: all families in all their orders, with all claims.
///
/// Each of them has a budget of its own, but a spec may have any number of them.
#[derive(Debug)]
pub(crate) struct Run {
    work: Cell<u64>,
    reduction: Cell<u64>,
    steps: Cell<u64>,
    families: Cell<u64>,
    claims: Cell<u64>,
    words: Cell<u64>,
    decisions: Cell<u64>,
    stopped: Cell<bool>,
}

impl Run {
    pub(crate) const fn new() -> Self {
        Self {
            work: Cell::new(RUN_WORK),
            reduction: Cell::new(RUN_REDUCTION),
            steps: Cell::new(RUN_STEPS),
            families: Cell::new(RUN_FAMILIES),
            claims: Cell::new(RUN_CLAIMS),
            words: Cell::new(RUN_WORDS),
            decisions: Cell::new(RUN_DECISIONS),
            stopped: Cell::new(false),
        }
    }

    /// Whether something was used up: nothing more is expanded.
    pub(crate) const fn is_stopped(&self) -> bool {
        self.stopped.get()
    }

    /// Takes an amount of something; an error when less is left, which is said once.
    fn take(&self, of: &Cell<u64>, amount: u64, limit: u64, what: &str) -> Result<(), TooLarge> {
        if self.stopped.get() {
            return Err(TooLarge::Said);
        }
        if let Some(left) = of.get().checked_sub(amount) {
            of.set(left);
            return Ok(());
        }
        self.stopped.set(true);
        Err(TooLarge::Run(format!("the spec takes more than {} {what}", grouped(limit as usize))))
    }

    /// Counts a family of one order.
    pub(crate) fn family(&self) -> Result<(), TooLarge> {
        self.take(&self.families, 1, RUN_FAMILIES, "families, each order counted")
    }

    /// Counts the work of the provers for what is needed for formulas to have a meaning, with 1 for the decision
    /// itself.
    pub(crate) fn decision(&self, units: u64) -> Result<(), TooLarge> {
        let what = "units of work to prove that its denominators vanish nowhere and its shape values stay in their ranges";
        self.take(&self.decisions, 1 + units, RUN_DECISIONS, what)
    }

    /// What is left of that work.
    pub(crate) const fn decisions_left(&self) -> u64 {
        self.decisions.get()
    }

    /// Counts a claim, whose text takes a number of bytes.
    pub(crate) fn claim(&self, text: usize) -> Result<(), TooLarge> {
        self.take(
            &self.claims,
            1,
            RUN_CLAIMS,
            "claims, each value of an index variable and each order counted",
        )?;
        self.words(32)?;
        self.text(text)
    }

    /// Counts the bytes of a text that is kept.
    pub(crate) fn text(&self, bytes: usize) -> Result<(), TooLarge> {
        self.words(bytes as u64 / 8)
    }

    /// Counts a function that is kept.
    pub(crate) fn keep(&self, value: &Fraction) -> Result<(), TooLarge> {
        self.words(words(value))
    }

    fn words(&self, amount: u64) -> Result<(), TooLarge> {
        self.take(&self.words, amount, RUN_WORDS, "words of memory for its functions and claims")
    }
}

/// The memory of a function, in words.
fn words(value: &Fraction) -> u64 {
    let part = |p: &Poly| p.len() as u64 * (8 + p.max_bits() / 64);
    16 + part(value.numer()) + part(value.denom())
}

/// The work that is left for the expansion of the functions of a family, or of a claim.
#[derive(Debug)]
pub(crate) struct Budget {
    run: Rc<Run>,
    work: Cell<u64>,
    reduction: RefCell<Work>,
    roots: RefCell<Vec<Root>>,
}

fn formula(reason: impl Into<String>) -> TooLarge {
    TooLarge::Formula(reason.into())
}

/// The cost of an operation on coefficients by their bits, compared with one on machine words: mostly of common
/// divisors.
const fn weight(bits: u64) -> u64 {
    if bits <= 128 { 1 } else { 6 + bits / 64 + (bits / 512) * (bits / 512) }
}

/// Why an expansion was stopped.
#[derive(Debug)]
pub(crate) enum TooLarge {
    /// This formula is too large, in words that follow "the formula …".
    Formula(String),
    /// The formulas of the whole run are, in a sentence.
    Run(String),
    /// As before, and it is said already.
    Said,
}

impl Budget {
    pub(crate) fn new(run: &Rc<Run>) -> Self {
        Self {
            run: Rc::clone(run),
            work: Cell::new(MAX_WORK),
            reduction: RefCell::new(Work::new(MAX_REDUCTION)),
            roots: RefCell::new(Vec::new()),
        }
    }

    /// From now on powers of these numbers are replaced by lower ones.
    pub(crate) fn set_roots(&self, roots: &[Root]) {
        *self.roots.borrow_mut() = roots.to_vec();
    }

    /// Starts to count again.
    pub(crate) fn refill(&self) {
        self.work.set(MAX_WORK);
        *self.reduction.borrow_mut() = Work::new(MAX_REDUCTION);
    }

    /// Starts to count again, with a small part of the work for common divisors: for what may be left undone.
    #[cfg(feature = "angles")]
    pub(crate) fn shorten(&self) {
        self.refill();
        *self.reduction.borrow_mut() = Work::new(MAX_REDUCTION / 16);
    }

    /// What the whole run may take.
    pub(crate) fn run(&self) -> &Run {
        &self.run
    }

    /// The result of an operation on quotients, which may need too much work for common divisors.
    fn reduce<T>(&self, operation: impl FnOnce(&mut Work) -> Result<T, Spent>) -> Result<T, TooLarge> {
        let too_large = |Spent| formula("has denominators that take too much work to combine");
        let mut work = self.reduction.borrow_mut();
        let before = work.left();
        let result = operation(&mut work).map_err(too_large);
        // A formula that is refused counts for what it took until then.
        let spent = before - work.left();
        let what = "units of work to bring its quotients into lowest terms";
        self.run.take(&self.run.reduction, spent, RUN_REDUCTION, what)?;
        result
    }

    /// Counts work; an error when none is left.
    pub(crate) fn spend(&self, amount: u64) -> Result<(), TooLarge> {
        match self.work.get().checked_sub(amount) {
            Some(left) => {
                self.work.set(left);
                self.run.take(&self.run.work, amount, RUN_WORK, "products of terms to expand")
            }
            None => {
                self.work.set(0);
                let limit = grouped(MAX_WORK as usize);
                Err(formula(format!("takes more than {limit} products of terms to expand")))
            }
        }
    }

    /// Counts parts of formulas that are evaluated, or passes of a loop.
    pub(crate) fn step(&self, parts: u64) -> Result<(), TooLarge> {
        self.run.take(
            &self.run.steps,
            parts,
            RUN_STEPS,
            "parts of formulas to evaluate, in all passes of its loops",
        )
    }

    /// Counts the work of a copy.
    pub(crate) fn copy(&self, value: &Fraction) -> Result<(), TooLarge> {
        // A copy of a term costs a tenth of a product or so.
        self.step(1 + words(value) / 32)
    }

    /// Counts a product before it is computed.
    fn before_product(&self, a: &Poly, b: &Poly) -> Result<(), TooLarge> {
        if a.is_one() && b.is_one() {
            return self.spend(1);
        }
        let degree = a.total_degree() + b.total_degree();
        if degree > MAX_DEGREE {
            return Err(formula(format!("has degree {degree}; the highest degree is {MAX_DEGREE}")));
        }
        let bits = a.max_bits() + b.max_bits();
        if bits > MAX_BITS {
            return Err(formula(format!("has coefficients of {bits} bits; the most is {MAX_BITS}")));
        }
        self.spend(a.len() as u64 * b.len() as u64 * weight(bits))
    }

    fn checked(&self, value: Fraction) -> Result<Fraction, TooLarge> {
        let value = roots::lowered(&self.roots.borrow(), value);
        let terms = value.numer().len() + value.denom().len();
        if terms > MAX_TERMS {
            return Err(formula(format!("has {terms} terms; the most is {MAX_TERMS}")));
        }
        Ok(value)
    }

    pub(crate) fn add(&self, a: &Fraction, b: &Fraction) -> Result<Fraction, TooLarge> {
        self.before_sum(a, b)?;
        self.checked(self.reduce(|work| a.add_within(b, work).ok_or(Spent))?)
    }

    pub(crate) fn sub(&self, a: &Fraction, b: &Fraction) -> Result<Fraction, TooLarge> {
        self.before_sum(a, b)?;
        self.checked(self.reduce(|work| a.sub_within(b, work).ok_or(Spent))?)
    }

    fn before_sum(&self, a: &Fraction, b: &Fraction) -> Result<(), TooLarge> {
        let bits = a.numer().max_bits().max(b.numer().max_bits());
        self.spend((a.numer().len() + b.numer().len()) as u64 * weight(bits))?;
        if a.denom() != b.denom() {
            self.before_product(a.numer(), b.denom())?;
            self.before_product(b.numer(), a.denom())?;
            self.before_product(a.denom(), b.denom())?;
        }
        Ok(())
    }

    pub(crate) fn mul(&self, a: &Fraction, b: &Fraction) -> Result<Fraction, TooLarge> {
        self.before_product(a.numer(), b.numer())?;
        self.before_product(a.denom(), b.denom())?;
        self.checked(self.reduce(|work| a.mul_within(b, work).ok_or(Spent))?)
    }

    /// a / b, where b is not zero.
    pub(crate) fn div(&self, a: &Fraction, b: &Fraction) -> Result<Fraction, TooLarge> {
        self.before_product(a.numer(), b.denom())?;
        self.before_product(a.denom(), b.numer())?;
        let quotient = self.reduce(|work| a.div_within(b, work))?;
        quotient.ok_or_else(|| formula("divides by zero")).and_then(|value| self.checked(value))
    }

    pub(crate) fn pow(&self, base: &Fraction, exponent: u32) -> Result<Fraction, TooLarge> {
        let degree =
            u64::from(base.numer().total_degree().max(base.denom().total_degree())) * u64::from(exponent);
        if degree > u64::from(MAX_DEGREE) {
            return Err(formula(format!("has degree {degree}; the highest degree is {MAX_DEGREE}")));
        }
        let bits = base.numer().max_bits().max(base.denom().max_bits()) * u64::from(exponent);
        let trivial = base.as_constant().is_some_and(|c| c.abs().is_one() || c.is_zero());
        if bits > MAX_BITS && !trivial {
            return Err(formula(format!("has coefficients of {bits} bits; the most is {MAX_BITS}")));
        }
        if base.as_constant().is_some() {
            let small = if exponent == 0 { 0 } else { 2 - exponent % 2 };
            return Ok(base.pow(if trivial { small } else { exponent }));
        }
        // Repeated products with the base, so that every step is counted.
        let mut result = Fraction::constant(Rational::ONE);
        if base.numer().len() <= 2 && base.as_poly().is_some() {
            // High powers are shifts, with as many sums as the square of the exponent.
            let exponent = u64::from(exponent);
            self.spend((exponent + 1) * (1 + exponent / 64) * weight(bits))?;
            return Ok(base.pow(exponent as u32));
        }
        for _ in 0..exponent {
            result = self.mul(&result, base)?;
        }
        Ok(result)
    }

    /// The partial derivative of an order in a variable.
    pub(crate) fn derivative(
        &self,
        value: &Fraction,
        (var, order): (Var, u32),
        analytic: &Analytic,
    ) -> Result<Fraction, TooLarge> {
        let spend = |value: &Fraction| self.spend((value.numer().len() + value.denom().len()) as u64);
        if analytic.angles.is_empty() {
            spend(value)?;
            let derivative = self.reduce(|work| value.derivative_of_order(var, order, work).ok_or(Spent));
            return derivative.and_then(|value| self.checked(value));
        }
        let mut value = value.clone();
        for _ in 0..order {
            if value.is_zero() {
                break;
            }
            spend(&value)?;
            let derivative = self.reduce(|work| analytic.derivative_within(&value, var, work).ok_or(Spent));
            value = derivative.and_then(|value| self.checked(value))?;
        }
        Ok(value)
    }

    /// The function with another put in place of a variable; `None` when its denominator becomes zero.
    pub(crate) fn substitute(
        &self,
        value: &Fraction,
        var: Var,
        by: &Fraction,
    ) -> Result<Option<Fraction>, TooLarge> {
        let degree = value.numer().degree(var).max(value.denom().degree(var));
        let inner = by.numer().total_degree().max(by.denom().total_degree());
        let total = degree * inner + value.numer().total_degree();
        if total > 2 * MAX_DEGREE {
            return Err(formula(format!(
                "has degree {total} after the substitution; the highest degree is {MAX_DEGREE}"
            )));
        }
        let terms = (by.numer().len() + by.denom().len()) as u64;
        let growth = if by.as_constant().is_some() { 1 } else { terms * u64::from(degree + 1) };
        let bits = value.numer().max_bits() + by.numer().max_bits();
        self.spend(growth * (value.numer().len() + value.denom().len()) as u64 * weight(bits))?;
        self.reduce(|work| value.substitute_within(var, by, work))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{Library, Selected};
    use crate::source::{self, Disk};

    /// A spec of the library takes a small part of what a run may: large ones need not fear the limits.
    #[test]
    fn shipped_specs_are_far_from_the_limits() {
        let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../specs");
        let mut found = 0;
        for folder in [root.clone(), root.join("papers")] {
            for entry in folder.read_dir().unwrap() {
                let path = entry.unwrap().path();
                if path.extension().is_none_or(|e| e != "basis") {
                    continue;
                }
                found += 1;
                let source = source::read(&Disk, path.to_str().unwrap(), &[]).unwrap();
                let library = Library::from_source(&Disk, &crate::Prover, source);
                library.items(Selected::EveryOrder);
                crate::theorem::theorems(&library);
                let run = library.run();
                let spent = [
                    ("work", RUN_WORK, &run.work),
                    ("reduction", RUN_REDUCTION, &run.reduction),
                    ("steps", RUN_STEPS, &run.steps),
                    ("families", RUN_FAMILIES, &run.families),
                    ("claims", RUN_CLAIMS, &run.claims),
                    ("words", RUN_WORDS, &run.words),
                    ("decisions", RUN_DECISIONS, &run.decisions),
                ];
                for (what, limit, left) in spent {
                    let used = limit - left.get();
                    assert!(used < limit / 8, "{}: {used} of {limit} {what}", path.display());
                }
            }
        }
        assert!(found > 15, "the specs are missing");
    }

    /// What is done once for every pair of things is counted, conditions on shape values and the variables in them, claims with
    /// different arguments of sines, denominators; and so is the work of claims that are refused for it.
    #[test]
    fn work_that_grows_with_the_text_is_counted() {
        let chain = "family F { domain 0 <= t <= 1; shape 0 <= x[i] <= x[i + 1] for i in 1..=50; b[0] = t; }";
        let repeat = |claim: fn(usize) -> String| (1..=200).map(claim).collect::<String>();
        let sines = repeat(|k| format!("prove sin(θ)^2 + {k}*sin({k}*θ) <= {k} + 1;"));
        let sines = format!("family G {{ domain 0 <= θ <= pi/2; b[0] = sin(θ); {sines} }}");
        let quotients = repeat(|k| format!("prove 1/(t + {k}) > 0;"));
        let quotients = format!("family H {{ domain 0 <= t <= 1; b[0] = t; {quotients} }}");
        let refused = "prove b[0]^6 >= b[1]^5;".repeat(5);
        let refused = format!(
            "family K {{ domain 0 <= t <= 1; shape 0 < x <= 3; let w = (1 - t)^2 + x*t*(1 - t) + t^2;
            b[0] = (1 - t)^2/w; b[1] = x*t*(1 - t)/w; b[2] = t^2/w; {refused} }}"
        );
        let parts: [(&str, Part, u64, u64); 4] = [
            (chain, |run| &run.decisions, RUN_DECISIONS, 50_000),
            (&sines, |run| &run.steps, RUN_STEPS, 200 * 200 / 2),
            (&quotients, |run| &run.decisions, RUN_DECISIONS, 200 * 1_500),
            (&refused, |run| &run.reduction, RUN_REDUCTION, 5 * MAX_REDUCTION),
        ];
        for (spec, part, limit, least) in parts {
            let library =
                Library::from_source(&Disk, &crate::Prover, crate::Source::text("square.basis", spec));
            library.items(Selected::EveryOrder);
            let used = limit - part(library.run()).get();
            assert!(used >= least, "{used} for {spec:.60}");
        }
    }

    type Part = fn(&Run) -> &Cell<u64>;

    /// With little left of something, a spec is refused once, in its own words, and nothing more is expanded.
    #[test]
    fn what_is_used_up_is_said_once() {
        let orders = "family F(n in 1..=60) { domain 0 <= t <= 1; b[i] = t^i for i in 0..=n; }\n";
        let claims = "family G { domain 0 <= t <= 1; b[0] = t; prove b[0] + i >= 0 for i in 0..=99; }\n";
        let shapes = "family H { domain 0 <= t <= 1; shape 0 < x; let a = 1/(x + 1); let c = 1/(x^2 + x + 1); b[0] = a*c*t; }\n";
        let spec = [orders, claims, shapes].concat();
        let parts: [(Part, u64, &str); 6] = [
            (|run| &run.work, 200, "products of terms"),
            (|run| &run.steps, 200, "parts of formulas"),
            (|run| &run.families, 20, "families"),
            (|run| &run.claims, 20, "claims"),
            (|run| &run.words, 9000, "words of memory"),
            (|run| &run.decisions, 1, "units of work to prove"),
        ];
        for (part, left, words) in parts {
            let library =
                Library::from_source(&Disk, &crate::Prover, crate::Source::text("much.basis", &spec));
            part(library.run()).set(left);
            let items = library.items(Selected::EveryOrder);
            let messages: Vec<String> =
                library.diagnostics().into_iter().map(|d| d.message.clone()).collect();
            assert!(messages.len() == 1 && messages[0].contains(words), "{words}: {messages:?}");
            assert!(library.run().is_stopped() && items.len() < 62, "{words}");
        }
    }
}
