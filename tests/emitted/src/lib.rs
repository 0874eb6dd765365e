//! Families as files, without the macro. They are written again by the commands at their top, from the folder of the
//! workspace; `cargo test -p basis-cli --test command emit` says when that is due, and does it with `INSTA_UPDATE=always`.

/// A curve with its join, a triangle and a box.
pub mod shapes;

/// Angles and exponentials, a denominator, values that are cut off at 0, and several spans.
pub mod quotients;

#[cfg(test)]
mod tests {
    use basis_runtime::{
        Basis, BoxPatch, Contact, Curve, Rounding, SimplexBasis, SimplexPatch, SpannedBasis,
    };

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
        assert_eq!(sheet.eval_at([1.0, 0.0]), 1.0);
        assert_eq!(sheet.partial_at([1.0, 0.0], [1, 1]), 1.0);
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
    /// Points in `f32` beside those in `f64`, whose errors are far smaller.
    #[test]
    fn points_are_within_their_bounds() {
        let mut largest = [0.0_f64; 2];
        let mut note = |place: usize, single: f32, double: f64, bound: Option<f64>| {
            // The largest control points are 1 and -1.
            let error = (f64::from(single) - double).abs() / f64::from(f32::EPSILON);
            let bound = bound.expect("it is proved");
            assert!(error <= bound, "{single} in place of {double}: {error} of {bound}");
            largest[place] = largest[place].max(error / bound);
        };
        for signs in 0..8_u8 {
            let sign = |k: usize| if signs >> k & 1 == 1 { -1.0_f32 } else { 1.0 };
            let points: [f32; 3] = core::array::from_fn(sign);
            let net: [f32; 6] = core::array::from_fn(|k| sign(k % 3));
            let mu = 0.3_f32;
            let bell = Curve::new(Bell::new(mu).expect("inside"), points);
            let exact = Curve::new(Bell::new(f64::from(mu)).expect("inside"), points.map(f64::from));
            let tent = SimplexPatch::new(Tent::new(mu).expect("inside"), net);
            let exact_tent = SimplexPatch::new(Tent::new(f64::from(mu)).expect("inside"), net.map(f64::from));
            for k in 0..=1000_u16 {
                let t = f32::from(k) / 500.0;
                note(0, bell.eval(t), exact.eval(f64::from(t)), Bell::<f32>::ROUNDING_POINT);
                // Barycentric coordinates that add up to 1.
                let [u, v] = [k % 65, (k / 8) % 65].map(|n| f32::from(n) / 128.0);
                let double = exact_tent.eval(f64::from(u), f64::from(v));
                note(1, tent.eval(u, v), double, Tent::<f32>::ROUNDING_POINT);
            }
        }
        assert!(largest.iter().all(|found| *found > 0.1), "{largest:?}");
    }
}
