//! Families as files, without the macro. The files are written again by the commands at their tops, from the folder of
//! the workspace; `cargo test -p basis-cli --test emit` says when that is due.

/// A curve and its joins.
pub mod quadratic;
/// A box.
pub mod serendipity;
/// A triangle.
pub mod triangular;

#[cfg(test)]
mod tests {
    use basis_runtime::{Contact, Curve, SimplexPatch};

    use crate::quadratic::{QuadraticBezier, g1};
    use crate::serendipity::Serendipity;
    use crate::triangular::Cubic;

    /// With λ = 0 it is the quadratic Bernstein basis; with other shape values it joins with itself.
    #[test]
    fn a_curve_is_evaluated_and_continued() {
        let bezier = QuadraticBezier::new(0.0).expect("inside the range");
        assert_eq!(bezier.values(0.25), [0.5625, 0.375, 0.0625]);
        assert!(QuadraticBezier::new(1.5).is_err());
        let first = Curve::new(
            QuadraticBezier::new(0.5).expect("inside the range"),
            [[0.0, 0.0], [1.0, 2.0], [3.0, 2.0]],
        );
        let points = g1(&[[0.0, 0.0], [1.0, 2.0], [3.0, 2.0]], 0.5, 0.5, 2.0).expect("finite");
        assert_eq!(points, [[3.0, 2.0], [4.0, 2.0]]);
        let free = [[0.0, 0.0], [0.0, 0.0], [7.0, 1.0]];
        let next = first.basis().curve_after(&first, Contact::Tangent { f: 2.0 }, free).expect("finite");
        assert_eq!(next.control_points(), [[3.0, 2.0], [4.0, 2.0], [7.0, 1.0]]);
    }

    #[test]
    fn patches_are_evaluated() {
        let cubic = Cubic::new(1.5, 1.0).expect("inside the range");
        let sum: f64 = cubic.values([0.5, 0.25, 0.25]).iter().sum();
        assert_eq!(sum, 1.0);
        let flat = SimplexPatch::new(cubic, [1.0; 10]);
        assert_eq!(flat.eval(0.5, 0.25), 1.0);
        assert_eq!(Serendipity::new().values([-1.0, -1.0]), [1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
    }
}
