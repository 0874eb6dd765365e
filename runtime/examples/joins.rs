//! Curves that continue another one: by formulas that follow from the family, for any order of contact.
//!
//! `cargo run --example joins` prints how smooth each joint is, measured.

use basis_runtime::{Basis, BernsteinBasis, Contact, Curve, CurveError, basis};

basis!("quadratic.basis");

fn main() -> Result<(), CurveError> {
    let first = Curve::new(Quadratic::new(0.5)?, [[0.0, 0.0], [1.0, 2.0], [2.0, 0.0]]);
    println!("contact       gap  angle  difference of curvature");
    for (name, contact) in [
        ("C0", Contact::Parametric { order: 0 }),
        // Q' = P'/2: the same tangent at half the speed.
        ("G1", Contact::Tangent { f: 2.0 }),
        // The same curvature too; c moves the second derivative along the tangent.
        ("G2", Contact::Curvature { f: 2.0, c: 1.0 }),
    ] {
        // The first control points, one more than the order of the contact, are computed; the others are free.
        let free = [[0.0, 0.0], [2.5, -1.5], [4.0, -1.0], [5.0, 1.0]];
        let next = BernsteinBasis::<f64, 4>::new().curve_after(&first, contact, free)?;
        let joint = first.joint(&next);
        println!("{name}       {:8.1e}  {:5.3}  {:5.3}", joint.gap, joint.angle, joint.curvature);
        let order = joint.geometric_order(1e-12, 1e-12, 1e-12);
        assert!(order >= Some(contact.order()), "{name} gave {order:?}");
    }
    Ok(())
}

#[test]
fn runs() -> Result<(), CurveError> {
    main()
}
