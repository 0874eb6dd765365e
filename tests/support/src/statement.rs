//! Statements as text, for a checker in another language; certificates and witnesses have theirs in
//! [`basis_kernel::text`], with whose variables, numbers and polynomials these are written.
//!
//! ```text
//! statement  (zero NUMERATOR DENOMINATOR DOMAIN)                  the quotient is 0
//!            (sign RELATION NUMERATOR DENOMINATOR DOMAIN)         the quotient is ≥ 0 (> 0)
//!            (products RELATION POLYNOMIAL ((x0 p q) …) DOMAIN)   the same of a sum of dot products, of points p and q
//!            (independent ((POLYNOMIAL …) …) (EXCEPTION …) (RANGE …))    the rows, on a box but for the exceptions
//! RELATION   >= or >
//! DOMAIN     ((RANGE …) (SIMPLEX …) (PREMISE …))
//! RANGE      (x0 END END)        END: _ for none, 1/2 for one that does not belong to the range, =1/2 for one that does
//! SIMPLEX    (c x0 x1 …)         xᵢ ≥ 0, x₀ + x₁ + … ≤ c
//! PREMISE    (RELATION POLYNOMIAL)
//! EXCEPTION  ((x0 1/2) …)
//! ```
//!
//! Where a domain has simplices, a proof is about the box of [`basis_kernel::Chart`], whose variables follow all others.

use basis_kernel::algebra::poly::{Poly, Var};
use basis_kernel::algebra::range::{End, Range};
use basis_kernel::{Domain, Quotient, Relation, Simplex, Statement};

/// The text of a statement.
pub fn statement_text(statement: &Statement) -> String {
    match statement {
        Statement::Zero { value, domain } => format!("(zero {} {})", quotient(value), self::domain(domain)),
        Statement::Sign { value, relation, domain } => {
            format!("(sign {} {} {})", self::relation(*relation), quotient(value), self::domain(domain))
        }
        Statement::Products { value, relation, products, domain } => {
            let products = list(products.iter().map(|(v, (p, q))| format!("({} {p} {q})", var(*v))));
            let relation = self::relation(*relation);
            format!("(products {relation} {} {products} {})", poly(value), self::domain(domain))
        }
        Statement::Independent { rows, except, region } => {
            let rows = list(rows.iter().map(|row| list(row.iter().map(poly))));
            let values =
                except.iter().map(|values| list(values.iter().map(|(v, x)| format!("({} {x})", var(*v)))));
            format!("(independent {rows} {} {})", list(values), list(region.ranges.iter().map(range)))
        }
    }
}

fn list(parts: impl Iterator<Item = String>) -> String {
    format!("({})", parts.collect::<Vec<_>>().join(" "))
}

fn var(var: Var) -> String {
    format!("x{}", var.0)
}

fn poly(p: &Poly) -> String {
    p.display(&[]).to_string().replace(' ', "")
}

fn quotient(value: &Quotient) -> String {
    format!("{} {}", poly(&value.numerator), poly(&value.denominator))
}

const fn relation(relation: Relation) -> &'static str {
    match relation {
        Relation::NonNegative => ">=",
        Relation::Positive => ">",
    }
}

fn range((v, range): &(Var, Range)) -> String {
    let end = |end: &End| match end {
        End::Infinite => String::from("_"),
        End::Included(x) => format!("={x}"),
        End::Excluded(x) => x.to_string(),
    };
    format!("({} {} {})", var(*v), end(&range.low), end(&range.high))
}

fn domain(domain: &Domain) -> String {
    let simplex = |simplex: &Simplex| {
        list([simplex.sum.to_string()].into_iter().chain(simplex.variables.iter().copied().map(var)))
    };
    let premise = |(p, r): &(Poly, Relation)| format!("({} {})", relation(*r), poly(p));
    format!(
        "({} {} {})",
        list(domain.region.ranges.iter().map(range)),
        list(domain.simplices.iter().map(simplex)),
        list(domain.premises.iter().map(premise))
    )
}
