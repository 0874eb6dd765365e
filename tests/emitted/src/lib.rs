//! Families as files, without the macro. They are written again by the commands at their top, from the folder of the
//! workspace; `cargo test -p basis-cli --test command emit` says when that is due, and does it with `INSTA_UPDATE=always`.

/// A curve with its join, a triangle and a box.
pub mod shapes;

/// Angles and exponentials, a denominator, values that are cut off at 0, and several spans.
pub mod quotients;

#[cfg(test)]
mod tests {
    use basis_runtime::{BoxPatch, Contact, Curve, Rounding, SimplexPatch, SpannedBasis};

    use crate::quotients::{Fall, Hump, Peak, Swing};
    use crate::shapes::{Bell, Sheet, SmoothScalars, Tent, smooth};

    #[test]
    fn a_curve_is_evaluated_and_continued() {
        let bezier = Bell::new(0.0).expect("inside the range");
        assert_eq!(bezier.values(0.5), [0.5625, 0.375, 0.0625]);
        assert!(Bell::new(1.5).is_err());
        let bell = Bell::new(0.5).expect("inside the range");
        let first = Curve::new(bell, [[0.0, 0.0], [1.0, 2.0], [3.0, 2.0]]);
        let scalars = SmoothScalars { mu1: 0.5, mu2: 0.5, delta: 2.0 };
        let points = smooth(&[[0.0, 0.0], [1.0, 2.0], [3.0, 2.0]], scalars).expect("finite");
        assert_eq!(points, [[3.0, 2.0], [4.0, 2.0]]);
        let free = [[0.0, 0.0], [0.0, 0.0], [7.0, 1.0]];
        let next = bell.curve_after(&first, Contact::Tangent { f: 2.0 }, free).expect("finite");
        assert_eq!(next.control_points(), [[3.0, 2.0], [4.0, 2.0], [7.0, 1.0]]);
    }

    #[test]
    fn patches_are_evaluated() {
        let tent = Tent::new(1.0).expect("inside the range");
        // b[0,0,2], b[0,1,1], b[0,2,0], b[1,0,1], b[1,1,0], b[2,0,0].
        assert_eq!(tent.values([0.5, 0.25, 0.25]), [0.15625, 0.0625, 0.15625, 0.125, 0.125, 0.375]);
        assert_eq!(SimplexPatch::new(tent, [3.0; 6]).eval(0.5, 0.25), 3.0);
        let sheet = BoxPatch::new(Sheet::new(), [4.0, 0.0]);
        assert_eq!(sheet.eval([1.0, 0.0]), 1.0);
        assert_eq!(sheet.partial([1.0, 0.0], [1, 1]), 1.0);
    }
    /// All that such a file calls is there without features.
    #[test]
    fn quotients_are_evaluated() {
        let swing = Swing::new(3.140_625_f64).expect("inside the range");
        // The square of cos(t/2), next to its zero.
        let [first, ..] = swing.values(3.140_625);
        let exact = (3.140_625_f64 / 2.0).cos().powi(2);
        assert!((first / exact - 1.0).abs() < 1e-14, "{first} {exact}");
        assert!(Swing::new(3.25).is_err());
        let fall = Fall::new(2.0).expect("inside the range");
        assert_eq!(fall.values(0.0), [1.0, 0.0]);
        let peak = Peak::new(0.25, 0.5).expect("inside the ranges");
        assert_eq!(peak.values(0.75), [0.5, 0.5, 0.25]);
        // Both parts of the denominator underflow: no value of the wrong sign.
        let narrow = Peak::new(0.25_f32, 1e-30).expect("inside the ranges");
        assert!(narrow.values(0.25)[0].is_nan());
        let hump = Hump::new(1.0).expect("inside the range");
        assert_eq!(hump.values(1.0), [2.0, 0.0]);
        assert!(matches!(Hump::<f32>::ROUNDING, [Rounding::Relative(_), Rounding::Absolute(_)]));
    }
}
