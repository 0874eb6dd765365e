//! Grids are the points, whatever the sizes.

use basis_runtime::{Bezier, CurveError, Surface, SurfaceOfRevolution, TensorSurface};

use crate::families::{Cubic, Linear, UniformBSpline, graph, random_surface};
use crate::random::Random;

fn parameters(count: usize, lo: f64, hi: f64) -> Vec<f64> {
    (0..count).map(|k| lo + (hi - lo) * k as f64 / (count.max(2) - 1) as f64).collect()
}

fn is_the_grid<T: Surface<Point = [f64; 3]>>(surface: &T, rows: usize, columns: usize) {
    let [[u0, u1], [v0, v1]] = surface.domain().ranges();
    let (us, vs) = (parameters(rows, u0, u1), parameters(columns, v0, v1));
    let mut out = vec![[f64::NAN; 3]; rows * columns];
    surface.eval_grid(&us, &vs, &mut out).unwrap();
    for (i, &u) in us.iter().enumerate() {
        for (j, &v) in vs.iter().enumerate() {
            let (grid, point) = (out[i * columns + j], surface.eval(u, v));
            assert!(grid.iter().zip(point).all(|(a, b)| (a - b).abs() < 4e-15), "{grid:?} {point:?}");
        }
    }
}

#[test]
fn are_the_points() {
    let random = &mut Random::new(91);
    let surface = random_surface::<[f64; 3]>(random);
    for (rows, columns) in [(1, 1), (0, 5), (5, 0), (3, 15), (2, 16), (4, 17), (2, 511), (2, 513), (3, 1100)]
    {
        is_the_grid(&surface, rows, columns);
    }
    is_the_grid(&graph(|u, v| u * v * v), 7, 30);
    let net = core::array::from_fn(|i| core::array::from_fn(|j| [i as f64, j as f64, (i * j) as f64]));
    is_the_grid(&TensorSurface::new(UniformBSpline::new(), Linear::new(), net), 5, 40);
    is_the_grid(&surface.to_bezier(), 5, 40);
}

#[test]
fn corners_are_exact() {
    let surface = random_surface::<[f64; 3]>(&mut Random::new(92));
    let ts = parameters(20, 0.0, 1.0);
    let mut out = vec![[0.0; 3]; 400];
    surface.eval_grid(&ts, &ts, &mut out).unwrap();
    for (index, (i, j)) in [(0, (0, 0)), (19, (0, 3)), (380, (3, 0)), (399, (3, 3))] {
        assert_eq!(out[index], surface.control_point(i, j).unwrap());
    }
}

#[test]
fn slices_of_other_lengths_are_refused() {
    let surface = TensorSurface::new(
        Cubic::new(),
        Cubic::new(),
        core::array::from_fn(|i| core::array::from_fn(|j| [i as f64, j as f64, 0.0])),
    );
    let generatrix = Bezier::from_points([[0.0, 1.0], [1.0, 2.0]]);
    let revolved = SurfaceOfRevolution::about_x(&generatrix, 1.0).unwrap();
    let others: [&dyn Surface<Point = [f64; 3]>; 2] = [&surface, &revolved];
    let ts = parameters(4, 0.0, 1.0);
    for surface in others {
        let mut out = [[7.0; 3]; 18];
        for found in [0, 10, 15, 17, 18] {
            let error = surface.eval_grid(&ts, &ts, &mut out[..found]);
            assert_eq!(error, Err(CurveError::Length { expected: 16, found }));
            let error = surface.partials_into(0.5, 0.5, 4, &mut out[..found]);
            assert_eq!(error, Err(CurveError::Length { expected: 16, found }));
        }
        assert_eq!(out, [[7.0; 3]; 18]);
        assert_eq!(surface.eval_grid(&ts, &ts, &mut out[..16]), Ok(()));
        assert_eq!(surface.eval_grid(&ts, &[], &mut []), Ok(()));
        assert!(surface.eval_grid(&ts, &[], &mut out).is_err());
        assert_eq!(surface.partials_into(0.5, 0.5, 2, &mut out[..4]), Ok(()));
        assert_eq!(out[1], surface.partial(0.5, 0.5, [0, 1]));
    }
}
