//! Generated evaluators beside kurbo's cubic Bézier curve, point by point over 4096 parameters; and both forms of bound
//! curves beside each other.

use basis_benches::parameters;
use basis_runtime::{BernsteinForm, Curve, EndpointForm, Form, basis};
use divan::{Bencher, black_box};
use kurbo::{CubicBez, ParamCurve};

basis!("../../specs/quartic.basis");
basis!("../../specs/bernstein.basis", Bernstein(3));

fn main() {
    divan::main();
}

const COUNT: u32 = 4096;
const POINTS: [[f64; 2]; 4] = [[0.0, 0.0], [1.0, 2.0], [3.0, 2.0], [4.0, 0.0]];

/// The peer: kurbo's cubic, two dimensions.
#[divan::bench]
fn kurbo_cubic(bencher: Bencher<'_, '_>) {
    let [a, b, c, d] = POINTS.map(|[x, y]| kurbo::Point::new(x, y));
    let curve = black_box(CubicBez::new(a, b, c, d));
    let parameters = parameters(COUNT);
    let mut out = vec![kurbo::Point::ZERO; COUNT as usize];
    bencher.counter(COUNT).bench_local(|| {
        for (point, t) in out.iter_mut().zip(&parameters) {
            *point = curve.eval(*t);
        }
        black_box(out.as_ptr())
    });
}

/// The cubic Bernstein family, bound to the same points.
#[divan::bench]
fn bernstein_cubic(bencher: Bencher<'_, '_>) {
    let curve = black_box(Curve::new(Bernstein::new(), POINTS));
    let parameters = parameters(COUNT);
    let mut out = vec![[0.0; 2]; COUNT as usize];
    bencher.counter(COUNT).bench_local(|| {
        for (point, t) in out.iter_mut().zip(&parameters) {
            *point = curve.eval(*t);
        }
        black_box(out.as_ptr())
    });
}

/// The quartic family, bound: one degree more than the peer.
#[divan::bench]
fn quartic_bound(bencher: Bencher<'_, '_>) {
    let family = QuarticBernstein::new(0.5).expect("0.5 is in the declared range");
    let curve = black_box(Curve::new(family, POINTS));
    let parameters = parameters(COUNT);
    let mut out = vec![[0.0; 2]; COUNT as usize];
    bencher.counter(COUNT).bench_local(|| {
        for (point, t) in out.iter_mut().zip(&parameters) {
            *point = curve.eval(*t);
        }
        black_box(out.as_ptr())
    });
}

/// The values of the four quartic functions.
#[divan::bench]
fn quartic_values(bencher: Bencher<'_, '_>) {
    let family = black_box(QuarticBernstein::new(0.5).expect("0.5 is in the declared range"));
    let parameters = parameters(COUNT);
    let mut out = vec![[0.0; 4]; COUNT as usize];
    bencher.counter(COUNT).bench_local(|| {
        for (values, t) in out.iter_mut().zip(&parameters) {
            *values = family.values(*t);
        }
        black_box(out.as_ptr())
    });
}

/// Points in space, one after the other or as a slice, of both forms that a bound curve can have.
macro_rules! forms {
    ($($degree:ident: $points:literal, $inner:literal;)*) => { $(
        mod $degree {
            use super::{BernsteinForm, Bencher, EndpointForm, many, one_by_one, spread};

            #[divan::bench]
            fn endpoint_points(bencher: Bencher<'_, '_>) {
                one_by_one(bencher, EndpointForm::<_, $inner>::new(spread(), spread()));
            }

            #[divan::bench]
            fn bernstein_points(bencher: Bencher<'_, '_>) {
                one_by_one(bencher, BernsteinForm::<_, $points>::new(spread()));
            }

            #[divan::bench]
            fn endpoint_slice(bencher: Bencher<'_, '_>) {
                many(bencher, EndpointForm::<_, $inner>::new(spread(), spread()));
            }

            #[divan::bench]
            fn bernstein_slice(bencher: Bencher<'_, '_>) {
                many(bencher, BernsteinForm::<_, $points>::new(spread()));
            }
        }
    )* };
}

forms! {
    degree_02: 3, 1;
    degree_03: 4, 2;
    degree_04: 5, 3;
    degree_05: 6, 4;
    degree_06: 7, 5;
    degree_08: 9, 7;
    degree_10: 11, 9;
    degree_12: 13, 11;
}

fn spread<const N: usize>() -> [[f64; 3]; N] {
    std::array::from_fn(|i| [0, 3, 5].map(|shift| ((i * 7 + shift) % 11) as f64 / 8.0))
}

fn one_by_one<F: Form<[f64; 3]>>(bencher: Bencher<'_, '_>, form: F) {
    let form = black_box(form);
    let parameters = parameters(COUNT);
    let mut out = vec![[0.0; 3]; COUNT as usize];
    bencher.counter(COUNT).bench_local(|| {
        for (point, t) in out.iter_mut().zip(&parameters) {
            *point = form.eval(*t);
        }
        black_box(out.as_ptr())
    });
}

fn many<F: Form<[f64; 3]>>(bencher: Bencher<'_, '_>, form: F) {
    let form = black_box(form);
    let parameters = parameters(COUNT);
    let mut out = vec![[0.0; 3]; COUNT as usize];
    bencher.counter(COUNT).bench_local(|| {
        form.eval_into(&parameters, &mut out);
        black_box(out.as_ptr())
    });
}
