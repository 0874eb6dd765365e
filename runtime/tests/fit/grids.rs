//! Grids of points to surfaces.

use basis_runtime::bspline::{BSplineSurface, FitError, KnotVector, Net, Spacing};
use basis_runtime::{BernsteinBasis, Fit, GridEnd, GridFit, Surface, TensorSurface};

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
        let corners = GridFit::new(&data)
            .ends([[GridEnd::Interpolated; 2]; 2])
            .spline_within([3, 3], tolerance)
            .unwrap();
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

/// Shape values of both families are found, from any place of their ranges, and are the best where there is noise.
#[test]
fn shape_values_are_found() {
    let mut random = Random::new(35);
    let (u, v) = (uniform(14), uniform(11));
    let range = [[-3.0, 1.0]];
    let families = || (|[l]: [f64; 1]| QuarticBernstein::new(l), |[l]: [f64; 1]| QuarticBernstein::new(l));
    for shapes in [[-0.75, 0.25], [0.9, -2.5], [-2.0, -2.0]] {
        let net = core::array::from_fn(|i| {
            core::array::from_fn(|j| [i as f64, j as f64, random.between::<f64>(-2.0, 2.0)])
        });
        let [first, second] = shapes.map(|l| QuarticBernstein::new(l).unwrap());
        let given = TensorSurface::new(first, second, net);
        let data = Net::from_fn(14, 11, |i, j| given.eval(u[i], v[j])).unwrap();
        let fit = GridFit::new(&data).parameters([&u, &v]);
        let found = fit.surface_over((range, range), families()).unwrap();
        assert!(found.largest < 1e-9 && found.rounds > 0, "{}", found.largest);
        let here = [found.surface.u_basis().lambda(), found.surface.rows()[0].basis().lambda()];
        assert!((0..2).all(|k| (here[k] - shapes[k]).abs() < 1e-6), "{here:?}");

        // One of the two alone.
        let fixed = |[]: [f64; 0]| QuarticBernstein::new(0.25);
        let found = fit.surface_over((range, []), (|[l]: [f64; 1]| QuarticBernstein::new(l), fixed)).unwrap();
        assert!(found.surface.rows()[0].basis().lambda() == 0.25);

        let noise = data.map(|p| p.map(|c| c + random.between::<f64>(-0.05, 0.05)));
        let fit = GridFit::new(&noise).parameters([&u, &v]);
        let found = fit.surface_over((range, range), families()).unwrap();
        let here = [found.surface.u_basis().lambda(), found.surface.rows()[0].basis().lambda()];
        for other in [[1e-3, 0.0], [-1e-3, 0.0], [0.0, 1e-3], [0.0, -1e-3]] {
            let [a, b] =
                [0, 1].map(|k| QuarticBernstein::new((here[k] + other[k]).clamp(-3.0, 1.0)).unwrap());
            assert!(fit.surface((a, b)).unwrap().root_mean_square >= found.root_mean_square - 1e-13);
        }
    }
    // In single precision too.
    let basis = QuarticBernstein::new(-0.5_f32).unwrap();
    let net = core::array::from_fn(|i| core::array::from_fn(|j| [i as f32, j as f32, ((i * j) % 3) as f32]));
    let given = TensorSurface::new(basis, basis, net);
    let t: Vec<f32> = (0..12).map(|i| i as f32 / 11.0).collect();
    let data = Net::from_fn(12, 12, |i, j| given.eval(t[i], t[j])).unwrap();
    let range = [[-3.0_f32, 1.0]];
    let families = (|[l]: [f32; 1]| QuarticBernstein::new(l), |[l]: [f32; 1]| QuarticBernstein::new(l));
    let found = GridFit::new(&data).parameters([&t, &t]).surface_over((range, range), families).unwrap();
    assert!(found.largest < 1e-4 && (found.surface.u_basis().lambda() + 0.5).abs() < 1e-2);

    // Mistakes.
    let data = grid(10, 10, &mut random, 0.1);
    let families = || (|[l]: [f64; 1]| QuarticBernstein::new(l), |[l]: [f64; 1]| QuarticBernstein::new(l));
    let error =
        GridFit::new(&data).surface_over((range64(-1.0, 0.0), range64(0.5, 0.5)), families()).unwrap_err();
    assert_eq!(error, FitError::Range { index: 1, range: [0.5, 0.5] });
    let error =
        GridFit::new(&data).surface_over((range64(2.0, 3.0), range64(0.0, 0.5)), families()).unwrap_err();
    assert_eq!(error, FitError::Shapes);
}

fn range64(lo: f64, hi: f64) -> [[f64; 2]; 1] {
    [[lo, hi]]
}

fn cross_part(a: [f64; 3], b: [f64; 3]) -> f64 {
    let c = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
    distance(c, [0.0; 3])
}

/// Along an edge with a direction the surface runs in it everywhere; with a direction for each point, where these are those of
/// a surface of the same functions, as well.
#[test]
fn edges_with_directions() {
    let mut random = Random::new(36);
    let cubic = BernsteinBasis::<f64, 4>::default();
    let data = grid(12, 9, &mut random, 0.02).map(|[x, y, z]| [x, y, 0.3 * z]);
    let wanted = [[[0.8, 0.0, 0.6], [0.8, 0.0, -0.6]], [[0.0, 1.0, 0.0], [0.0, 0.8, -0.6]]];
    let [[left, right], [front, back]] = wanted.map(|ends| ends.map(GridEnd::Tangent));
    let (free, fixed) = (GridEnd::Free, GridEnd::Interpolated);
    let places = uniform(17);
    for (ends, edges) in [
        ([[left, free], [free; 2]], vec![(0, 0)]),
        ([[fixed, right], [free; 2]], vec![(0, 1)]),
        ([[free; 2], [front, back]], vec![(1, 0), (1, 1)]),
        ([[left, right], [front, fixed]], vec![(0, 0), (0, 1), (1, 0)]),
        ([[left, right], [front, back]], vec![(0, 0), (0, 1), (1, 0), (1, 1)]),
    ] {
        let fit = GridFit::new(&data).ends(ends);
        let bezier = fit.surface((cubic, cubic)).unwrap();
        let spline = fit.spline_with([3, 3], [7, 6]).unwrap();
        let surfaces: [&dyn Surface<Point = [f64; 3]>; 2] = [&bezier.surface, &spline.surface];
        for surface in surfaces {
            for &(direction, e) in &edges {
                for &t in &places {
                    let (u, v) = if direction == 0 { (e as f64, t) } else { (t, e as f64) };
                    let mut orders = [0, 0];
                    orders[direction] = 1;
                    let (across, wanted) = (surface.partial(u, v, orders), wanted[direction][e]);
                    assert!(cross_part(across, wanted) < 1e-11, "{across:?}");
                    assert!(
                        (0..3).map(|d| across[d] * wanted[d]).sum::<f64>() > 0.0,
                        "{direction} {e} {t} {across:?}"
                    );
                }
            }
        }
        assert!(bezier.largest < 0.25 && spline.largest < 0.2, "{} {}", bezier.largest, spline.largest);
    }

    // The boundary curve is the one that is fitted to the boundary alone.
    let fit = GridFit::new(&data).ends([[left, free], [free; 2]]).spline_with([3, 3], [7, 6]).unwrap();
    let row: Vec<_> = (0..9).map(|j| data[[0, j]]).collect();
    let knots = fit.surface.knots(basis_runtime::Direction::V).clone();
    let boundary = Fit::new(&row).parameters(&fit.parameters[1]).spline(knots).unwrap();
    for &t in &places {
        assert!(distance(fit.surface.eval(0.0, t), boundary.curve.eval(t)) < 1e-11);
    }
    // A surface comes back with its own directions.
    let net = core::array::from_fn(|i| {
        core::array::from_fn(|j| [i as f64, j as f64 + 0.2 * i as f64, random.between::<f64>(-0.5, 0.5)])
    });
    let given = TensorSurface::new(cubic, cubic, net);
    let (u, v) = (uniform(9), uniform(8));
    let data = Net::from_fn(9, 8, |i, j| given.eval(u[i], v[j])).unwrap();
    let across_u: Vec<_> = v.iter().map(|&v| given.partial(0.0, v, [1, 0])).collect();
    let across_v: Vec<_> = u.iter().map(|&u| given.partial(u, 1.0, [0, 1])).collect();
    let ends = [[GridEnd::Tangents(&across_u), GridEnd::Free], [GridEnd::Free, GridEnd::Tangents(&across_v)]];
    let fit = GridFit::new(&data).parameters([&u, &v]).ends(ends);
    assert!(fit.surface((cubic, cubic)).unwrap().largest < 1e-11);
    assert!(fit.spline_within([3, 3], 1e-6).unwrap().largest < 1e-6);

    // Mistakes.
    let wrong = |end| GridFit::new(&data).ends([[end, free], [free; 2]]).surface((cubic, cubic)).unwrap_err();
    assert_eq!(wrong(GridEnd::Tangents(&across_u[1..])), FitError::Count { expected: 8, found: 7 });
    assert_eq!(wrong(GridEnd::Tangent([0.0; 3])), FitError::Tangent { end: 0 });
    let linear = BernsteinBasis::<f64, 2>::default();
    let crowded = GridFit::new(&data).ends([[left, right], [free; 2]]).surface((linear, cubic)).unwrap_err();
    assert_eq!(crowded, FitError::Ends);
    let back = GridEnd::Tangent([-1.0, 0.0, 0.0]);
    let turned = GridFit::new(&data).ends([[back, free], [free; 2]]).surface((cubic, cubic));
    assert!(turned.is_err() || turned.unwrap().surface.partial(0.0, 0.5, [1, 0])[0] < 0.0);
}
