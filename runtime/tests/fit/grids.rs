//! Grids of points to surfaces.

use basis_runtime::bspline::{BSplineSurface, FitError, KnotVector, Net, Spacing};
use basis_runtime::{BernsteinBasis, GridCorners, GridFit, Surface, TensorSurface};

use crate::random::Random;
use crate::{QuarticBernstein, distance};

fn grid(rows: usize, columns: usize, random: &mut Random, noise: f64) -> Net<[f64; 3]> {
    Net::from_fn(rows, columns, |i, j| {
        let (x, y) = (i as f64 / (rows - 1) as f64, j as f64 / (columns - 1) as f64);
        [x, y, (3.0 * x).sin() * (2.0 * y).cos() + random.between::<f64>(-noise, noise)]
    })
    .unwrap()
}

fn uniform(count: usize) -> Vec<f64> {
    (0..count).map(|i| i as f64 / (count - 1) as f64).collect()
}

/// Points of a surface give the surface back, and the sum is least: that of the normal equations over both directions at once.
#[test]
fn surfaces_come_back() {
    let mut random = Random::new(31);
    let bases = (QuarticBernstein::new(-0.5).unwrap(), BernsteinBasis::<f64, 4>::default());
    let net = core::array::from_fn(|_| {
        core::array::from_fn(|_| [(); 3].map(|()| random.between::<f64>(-1.0, 2.0)))
    });
    let given = TensorSurface::new(bases.0, bases.1, net);
    let (u, v) = (uniform(9), uniform(7));
    let data = Net::from_fn(9, 7, |i, j| given.eval(u[i], v[j])).unwrap();
    let fit = GridFit::new(&data).parameters([&u, &v]).surface(bases).unwrap();
    assert!(fit.largest < 1e-12 && fit.parameters == [u.clone(), v.clone()]);

    // Noise: no change of a control point makes the sum smaller.
    let data = grid(9, 7, &mut random, 0.2);
    let fit = GridFit::new(&data).parameters([&u, &v]).surface(bases).unwrap();
    let sum = |s: &TensorSurface<_, _, [f64; 3]>| -> f64 {
        let all = (0..9).flat_map(|i| (0..7).map(move |j| (i, j)));
        all.map(|(i, j)| distance(s.eval(u[i], v[j]), data[[i, j]]).powi(2)).sum()
    };
    let best = sum(&fit.surface);
    assert!((fit.root_mean_square - (best / 63.0).sqrt()).abs() < 1e-13);
    for (i, j) in (0..4).flat_map(|i| (0..4).map(move |j| (i, j))) {
        let changed = |by: f64| {
            let mut k = 0;
            let moved = fit.surface.map(|p| {
                k += 1;
                if k == 4 * i + j + 1 { [p[0], p[1], p[2] + by] } else { p }
            });
            sum(&moved)
        };
        let [up, down] = [changed(1e-3), changed(-1e-3)];
        assert!(up >= best && down >= best && (up - down).abs() < 1e-9 * best);
    }
}

/// The same as the least squares over given knots, with the parameters that these would have.
#[test]
fn over_given_knots() {
    let mut random = Random::new(32);
    let data = grid(12, 15, &mut random, 0.05);
    let knots = || [KnotVector::uniform(3, 3).unwrap(), KnotVector::uniform(2, 4).unwrap()];
    let fit = GridFit::new(&data).spacing(Spacing::Centripetal).spline(knots()).unwrap();
    let [u, v] = &fit.parameters;
    let expected = BSplineSurface::fit(knots(), [u, v], &data).unwrap();
    for (a, b) in fit.surface.net().as_slice().iter().zip(expected.net().as_slice()) {
        assert!(distance(*a, *b) < 1e-11);
    }
}

#[test]
fn counts_tolerances_corners() {
    let mut random = Random::new(33);
    for round in 0..6 {
        let data = grid(40, 25, &mut random, [0.0, 0.01][round % 2]);
        let fit = GridFit::new(&data).spline_with([3, 2], [9, 8]).unwrap();
        assert_eq!((fit.surface.net().rows(), fit.surface.net().columns()), (9, 8));
        let tolerance = [1e-1, 1e-2, 3e-3][round / 2];
        let free = GridFit::new(&data).spline_within([3, 3], tolerance).unwrap();
        assert!(free.largest <= tolerance);
        let corners =
            GridFit::new(&data).corners(GridCorners::Interpolated).spline_within([3, 3], tolerance).unwrap();
        assert!(corners.largest <= tolerance);
        for (i, j) in [(0, 0), (0, 24), (39, 0), (39, 24)] {
            let [u, v] = [f64::from(i == 39), f64::from(j == 24)];
            assert!(distance(corners.surface.eval(u, v), data[[i as usize, j as usize]]) < 1e-12);
        }
        if round % 2 == 0 {
            assert!(free.surface.net().as_slice().len() < 120, "{}", free.surface.net().as_slice().len());
        }
    }
    // A surface that bends in one direction alone has knots in that one alone.
    let data = Net::from_fn(50, 50, |i, j| [i as f64, j as f64, 10.0 * (i as f64 / 5.0).sin()]).unwrap();
    let fit =
        GridFit::new(&data).parameters([&uniform(50), &uniform(50)]).spline_within([3, 3], 1e-2).unwrap();
    assert_eq!(fit.surface.net().columns(), 4);
    assert!(fit.surface.net().rows() > 10);
}

#[test]
fn smoothing_and_mistakes() {
    let mut random = Random::new(34);
    let data = grid(10, 10, &mut random, 0.3);
    let rough = GridFit::new(&data).spline_with([3, 3], [8, 8]).unwrap();
    let smooth = GridFit::new(&data).smoothing(1e-2).spline_with([3, 3], [8, 8]).unwrap();
    let bend = |s: &BSplineSurface<[f64; 3]>| distance(s.partial(0.4, 0.6, [2, 0]), [0.0; 3]);
    assert!(bend(&smooth.surface) < bend(&rough.surface) && smooth.root_mean_square > rough.root_mean_square);
    let bases = (BernsteinBasis::<f64, 11>::default(), BernsteinBasis::<f64, 3>::default());
    let few = GridFit::new(&data).surface(bases).unwrap_err();
    assert_eq!(few, FitError::TooFew { needed: 11, found: 10 });
    assert!(GridFit::new(&data).parameters([&[0.0], &[1.0]]).spline_with([3, 3], [8, 8]).is_err());
    let broken = Net::from_fn(5, 5, |i, j| [f64::NAN, 1.0][usize::from(i + j != 3)]).unwrap();
    assert_eq!(
        GridFit::new(&broken).spline_within([1, 1], 0.1).unwrap_err(),
        FitError::NotFinite { index: 3 }
    );
    assert!(GridFit::new(&data).smoothing(f64::NAN).spline_with([3, 3], [8, 8]).is_err());
}
