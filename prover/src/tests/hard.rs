//! Statements that need more than the usual methods, and long numbers; work is counted, never time.

use super::*;
use basis_kernel::{Products, Witness};

fn decided(statement: Statement) -> Result<Shown, Failure> {
    decide(statement, &Vec::new(), 1)
}

/// The claim as `proved`, or the witness as text.
fn verdict_of(p: &str, ranges: &str) -> String {
    let (p, relation) = match p.split_once(">=") {
        Some((p, _)) => (p, Relation::NonNegative),
        None => (p.split_once('>').expect("a relation").0, Relation::Positive),
    };
    let domain = Rc::new(Domain::of(region(ranges)));
    match decided(Statement::Sign { value: Quotient::from(poly(p)), relation, domain }) {
        Ok(_) => String::from("proved"),
        Err(Failure::Refuted(found)) => basis_kernel::text::witness_text(found.refutation.witness()),
        Err(Failure::Undecided(left)) => left,
    }
}

#[test]
fn zeros_on_diagonals() {
    let found = verdict_of("(t^5 - t - 1)^2 + (λ^5 - λ - 1)^2 + (t - λ)^2 > 0", "");
    assert!(
        found.starts_with("(at (root (-1 -1 0 0 0 1) ") && found.ends_with("(x0 (0 1)) (x1 (0 1)))"),
        "{found}"
    );
    // Of three variables two may be exchanged.
    let found = verdict_of(
        "(t^3 - 2)^2 + (λ^3 - 2)^2 + (t*λ*μ - 1)^2*(t + λ)^2 + (t - λ)^4 > 0",
        "0<t<3, 0<λ<3, 0<μ<3",
    );
    assert!(found.starts_with("(at (root "), "{found}");
    assert_eq!(verdict_of("(t^2 - 2)^2 + (λ^2 - 2)^2 + 1/100 > 0", ""), "proved");
}

/// A square is nonnegative whatever it is the square of.
#[test]
fn even_powers() {
    let on = "0<=t<=1, 0<=λ<=1, 0<=μ<=1";
    assert_eq!(verdict_of("((t-λ)^2 + (λ-μ)^2 + (t*λ*μ - 1/7)^2)^6 >= 0", on), "proved");
    assert_eq!(verdict_of("-((t-λ)^2 + (λ-μ)^2 + t)^6 >= 0", on), "(at (x0 0) (x1 0) (x2 1))");
}

/// Negative only within 10⁻⁸ of an irrational point, and nowhere.
#[test]
fn minima_of_three_variables() {
    let sum = "(t^2 - λ)^4 + (λ^2 - μ)^4 + (μ*t - 1/2)^4";
    let tiny = "1/1000000000000000000000000000000";
    let unit = "0<=t<=1, 0<=λ<=1, 0<=μ<=1";
    for relation in [">=", ">"] {
        let found = verdict_of(&format!("{sum} - {tiny} {relation} 0"), unit);
        assert!(found.starts_with("(at (x0 "), "{found}");
    }
    let far = verdict_of("(t - 1/3)^2*(λ - 7)^2 + (t*μ - 2)^2 + (λ - t)^2 - 1/100000000 >= 0", "");
    assert!(far.starts_with("(at (x0 "), "{far}");
}

/// Sums of dot products that are negative somewhere, by points on a line.
#[test]
fn dot_products_are_refuted_on_a_line() {
    let products: Products = vec![(Var(0), (0, 0)), (Var(1), (0, 1)), (Var(2), (1, 1))];
    let statement = |text: &str, domain: Domain| Statement::Products {
        value: poly(text),
        relation: Relation::NonNegative,
        products: products.clone(),
        domain: Rc::new(domain),
    };
    let refuted = |text: &str, domain: Domain| match decided(statement(text, domain)) {
        Err(Failure::Refuted(found)) => match found.refutation.witness() {
            Witness::OnLine(..) => basis_kernel::text::witness_text(found.refutation.witness()),
            other => panic!("{other:?}"),
        },
        other => panic!("{text}: {other:?}"),
    };
    let on = |text: &str| Domain::of(region(text));
    assert_eq!(refuted("t - 3*λ + μ", on("")), "(line (at) 0 3/2 1 1)");
    assert_eq!(refuted("t - 2*λ + μ - f", on("0<=f<=1")), "(line (at (x3 1)))");
    // Negative only for long vectors.
    let found = refuted("t - 2*f*λ + μ + 1000", on("0<=f<=2"));
    assert!(found.starts_with("(line (at (x3 2)) 0 "), "{found}");
    let simplex = basis_kernel::Simplex { variables: vec![Var(3), Var(4)], sum: Rational::ONE };
    let triangle = Domain { simplices: vec![simplex], ..Domain::default() };
    let found = refuted("f*t - 2*w*λ + f*μ", triangle.clone());
    assert!(found.starts_with("(line (at (x3 "), "{found}");
    assert!(decided(statement("f*t + 2*f*w*λ + w*μ", triangle)).is_ok());
}

/// Long numbers cost what they say: the budget of a search is enough for them, or it ends.
#[test]
fn long_numbers_are_charged() {
    let tiny = |k: u32| Rational::new(1, 10).pow(k);
    for k in [20, 80, 160, 320] {
        let p = -&(&Poly::constant(tiny(k)) + &Poly::var(Var(0)));
        for relation in [Relation::NonNegative, Relation::Positive] {
            let mut budget = Budget::default();
            let before = budget.left();
            let found = accepted(&p, relation, &region("t<0"), &mut budget);
            assert!(matches!(found, Err(Some(_))), "10^-{k}");
            assert!(before - budget.left() < 1_000_000, "10^-{k}: {}", before - budget.left());
        }
        // (10ᵏ t − 1)(t² − 2)²: a double root that has to be separated from a rational one.
        let p = &(&Poly::var(Var(0)) - &Poly::constant(tiny(k))) * &poly("(t^2 - 2)^2");
        let mut budget = Budget::default();
        let before = budget.left();
        assert!(matches!(accepted(&p, Relation::Positive, &region("0<t"), &mut budget), Err(Some(_))));
        assert!(before - budget.left() < 1_000_000, "10^-{k}: {}", before - budget.left());
    }
}

/// The n-th Jacobi polynomials up to a degree, as rows of coefficients of powers of x, in α and β.
fn jacobi(degree: u32) -> Vec<Vec<Poly>> {
    let binomial = crate::algebra::number::binomial;
    let (alpha, beta) = (Poly::var(Var(0)), Poly::var(Var(1)));
    let rising = |start: &Poly, count: u32| {
        (0..count).fold(Poly::one(), |p, k| &p * &(start + &Poly::integer(i64::from(k))))
    };
    let factorial = |n: u32| (1..=n).fold(Rational::ONE, |f, k| &f * &Rational::from(i64::from(k)));
    (0..=degree)
        .map(|n| {
            let mut row = vec![Poly::zero(); degree as usize + 1];
            for k in 0..=n {
                let sum = &(&alpha + &beta) + &Poly::integer(i64::from(n) + 1);
                let next = &alpha + &Poly::integer(i64::from(k) + 1);
                let number = &binomial(n, k) / &(&factorial(n) * &Rational::from(2).pow(k));
                let c = (&rising(&sum, k) * &rising(&next, n - k)).scale(&number);
                for j in 0..=k {
                    let sign = if (k - j) % 2 == 0 { Rational::ONE } else { Rational::from(-1) };
                    row[j as usize] = &row[j as usize] + &c.scale(&(&binomial(k, j) * &sign));
                }
            }
            row
        })
        .collect()
}

#[test]
fn jacobi_polynomials_are_independent() {
    for (degree, range, expected) in
        [(3, "-1<t, -1<λ", true), (9, "-1<t, -1<λ", true), (4, "-1<=t, -1<=λ", false)]
    {
        let statement =
            Statement::Independent { rows: jacobi(degree), except: Vec::new(), region: region(range) };
        let decision = decided(statement);
        assert_eq!(decision.is_ok(), expected, "{degree}: {decision:?}");
        assert!(!matches!(decision, Err(Failure::Undecided(_))), "{degree}");
    }
}
