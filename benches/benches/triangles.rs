//! The two ways of evaluating a recursive family on a triangle: its lowest order, raised, beside expanded polynomials;
//! and a bound patch beside de Casteljau steps on the control points followed by the lowest order.

use basis_benches::barycentric;
use basis_runtime::{SimplexBasis, TriangularPatch, basis};
use divan::{Bencher, black_box};

basis!(
    "../../specs/triangular.basis",
    TriangularI(2) as I2,
    TriangularI(4) as I4,
    TriangularI(5) as I5,
    TriangularI(8) as I8
);
basis!(
    "../../specs/triangular.basis",
    TriangularII(3) as II3,
    TriangularII(5) as II5,
    TriangularII(6) as II6,
    TriangularII(8) as II8
);
basis!("../specs/expanded.basis", ExpandedI(4) as ExpandedI4, ExpandedI(5) as ExpandedI5);
basis!("../specs/expanded.basis", ExpandedII(5) as ExpandedII5, ExpandedII(6) as ExpandedII6);

fn main() {
    divan::main();
}

const COUNT: usize = 1024;

fn values<B: SimplexBasis<Scalar = f64, Coordinates = [f64; 3]>>(bencher: Bencher<'_, '_>, basis: B) {
    let (basis, points) = (black_box(basis), barycentric(COUNT));
    let mut out: Vec<_> = points.iter().map(|_| basis.values([1.0, 0.0, 0.0])).collect();
    bencher.counter(COUNT).bench_local(|| {
        for (values, at) in out.iter_mut().zip(&points) {
            *values = basis.values(*at);
        }
        black_box(out.as_ptr());
    });
}

#[divan::bench_group]
mod values {
    use super::{Bencher, ExpandedI4, ExpandedI5, ExpandedII5, ExpandedII6, I4, I5, II5, II6};

    #[divan::bench]
    fn i_4_raised(bencher: Bencher<'_, '_>) {
        super::values(bencher, I4::new(1.0, 3.0).unwrap());
    }

    #[divan::bench]
    fn i_4_expanded(bencher: Bencher<'_, '_>) {
        super::values(bencher, ExpandedI4::new(1.0, 3.0).unwrap());
    }

    #[divan::bench]
    fn i_5_raised(bencher: Bencher<'_, '_>) {
        super::values(bencher, I5::new(1.0, 3.0).unwrap());
    }

    #[divan::bench]
    fn i_5_expanded(bencher: Bencher<'_, '_>) {
        super::values(bencher, ExpandedI5::new(1.0, 3.0).unwrap());
    }

    #[divan::bench]
    fn ii_5_raised(bencher: Bencher<'_, '_>) {
        super::values(bencher, II5::new(1.0, 1.0).unwrap());
    }

    #[divan::bench]
    fn ii_5_expanded(bencher: Bencher<'_, '_>) {
        super::values(bencher, ExpandedII5::new(1.0, 1.0).unwrap());
    }

    #[divan::bench]
    fn ii_6_raised(bencher: Bencher<'_, '_>) {
        super::values(bencher, II6::new(1.0, 1.0).unwrap());
    }

    #[divan::bench]
    fn ii_6_expanded(bencher: Bencher<'_, '_>) {
        super::values(bencher, ExpandedII6::new(1.0, 1.0).unwrap());
    }
}

fn net<const N: usize>() -> [[f64; 3]; N] {
    core::array::from_fn(|i| [i as f64, (i * i % 7) as f64, (i * 5 % 11) as f64])
}

fn bound<B, const N: usize>(bencher: Bencher<'_, '_>, basis: B)
where
    B: basis_runtime::TriangularBasis<Scalar = f64, Points<[f64; 3]> = [[f64; 3]; N]>,
{
    let (patch, points) = (black_box(TriangularPatch::new(basis, net())), barycentric(COUNT));
    let mut out = vec![[0.0; 3]; COUNT];
    bencher.counter(COUNT).bench_local(|| {
        for (point, at) in out.iter_mut().zip(&points) {
            *point = patch.eval_at(*at);
        }
        black_box(out.as_ptr());
    });
}

/// Steps on the points down to the lowest order, then its formula.
fn stepwise<B, const N: usize, const M: usize>(
    bencher: Bencher<'_, '_>,
    lowest: B,
    order: usize,
    steps: usize,
) where
    B: SimplexBasis<Scalar = f64, Coordinates = [f64; 3], Values = [f64; M]>,
{
    let (lowest, net, points) = (black_box(lowest), black_box(net::<N>()), barycentric(COUNT));
    let mut out = vec![[0.0; 3]; COUNT];
    bencher.counter(COUNT).bench_local(|| {
        for (point, at) in out.iter_mut().zip(&points) {
            let mut net = net;
            for step in 0..steps {
                let n = order - step;
                let (mut to, mut row) = (0, 0);
                for i in 0..n {
                    let next = row + n - i + 1;
                    for j in 0..n - i {
                        let (a, b, c) = (net[next + j], net[row + j + 1], net[row + j]);
                        net[to] = [0, 1, 2].map(|k| at[0] * a[k] + at[1] * b[k] + at[2] * c[k]);
                        to += 1;
                    }
                    row = next;
                }
            }
            let weights = lowest.values(*at);
            *point = [0.0; 3];
            for (weight, p) in weights.iter().zip(&net) {
                for (sum, x) in point.iter_mut().zip(p) {
                    *sum += weight * x;
                }
            }
        }
        black_box(out.as_ptr());
    });
}

#[divan::bench_group]
mod points {
    use super::{Bencher, I2, I4, I8, II3, II5, II8};

    #[divan::bench]
    fn i_2_bound(bencher: Bencher<'_, '_>) {
        super::bound::<_, 6>(bencher, I2::new(1.0, 3.0).unwrap());
    }

    #[divan::bench]
    fn i_2_stepwise(bencher: Bencher<'_, '_>) {
        super::stepwise::<_, 6, 6>(bencher, I2::new(1.0, 3.0).unwrap(), 2, 0);
    }

    #[divan::bench]
    fn i_4_bound(bencher: Bencher<'_, '_>) {
        super::bound::<_, 15>(bencher, I4::new(1.0, 3.0).unwrap());
    }

    #[divan::bench]
    fn i_4_stepwise(bencher: Bencher<'_, '_>) {
        super::stepwise::<_, 15, 6>(bencher, I2::new(1.0, 3.0).unwrap(), 4, 2);
    }

    #[divan::bench]
    fn i_8_bound(bencher: Bencher<'_, '_>) {
        super::bound::<_, 45>(bencher, I8::new(1.0, 3.0).unwrap());
    }

    #[divan::bench]
    fn i_8_stepwise(bencher: Bencher<'_, '_>) {
        super::stepwise::<_, 45, 6>(bencher, I2::new(1.0, 3.0).unwrap(), 8, 6);
    }

    #[divan::bench]
    fn ii_3_bound(bencher: Bencher<'_, '_>) {
        super::bound::<_, 10>(bencher, II3::new(1.0, 1.0).unwrap());
    }

    #[divan::bench]
    fn ii_3_stepwise(bencher: Bencher<'_, '_>) {
        super::stepwise::<_, 10, 10>(bencher, II3::new(1.0, 1.0).unwrap(), 3, 0);
    }

    #[divan::bench]
    fn ii_5_bound(bencher: Bencher<'_, '_>) {
        super::bound::<_, 21>(bencher, II5::new(1.0, 1.0).unwrap());
    }

    #[divan::bench]
    fn ii_5_stepwise(bencher: Bencher<'_, '_>) {
        super::stepwise::<_, 21, 10>(bencher, II3::new(1.0, 1.0).unwrap(), 5, 2);
    }

    #[divan::bench]
    fn ii_8_bound(bencher: Bencher<'_, '_>) {
        super::bound::<_, 45>(bencher, II8::new(1.0, 1.0).unwrap());
    }

    #[divan::bench]
    fn ii_8_stepwise(bencher: Bencher<'_, '_>) {
        super::stepwise::<_, 45, 10>(bencher, II3::new(1.0, 1.0).unwrap(), 8, 5);
    }
}
