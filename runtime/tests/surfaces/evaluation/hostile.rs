//! No input makes a surface panic or run without end.

use std::cell::Cell;

use basis_runtime::{
    BernsteinBasis, BoundedSurface, Contact, Curve, Edge, EdgePair, MeshError, ScalarOf, Surface,
    SurfaceDomain, SurfaceOfRevolution, SurfacePiece, TensorSurface, Tessellation,
};

use crate::families::{QuarticBernstein, random_quartic};
use crate::random::Random;

/// Components that coincide, vanish, overflow and are not numbers.
const COMPONENTS: [f64; 12] =
    [0.0, 0.0, 1.0, 1.0, -1.0, 0.5, 1e-300, 1e300, -1e300, f64::MIN_POSITIVE, f64::INFINITY, f64::NAN];

#[test]
fn nets_of_extreme_numbers() {
    let random = &mut Random::new(101);
    for round in 0..48 {
        // Most nets are finite, and many of moderate size.
        let kinds = [6.0, 8.0, 10.0, 12.0][round % 4];
        let mut component = || COMPONENTS[random.between::<f64>(0.0, kinds) as usize % COMPONENTS.len()];
        let net = core::array::from_fn(|_| core::array::from_fn(|_| core::array::from_fn(|_| component())));
        let shape = |value| QuarticBernstein::new(value).unwrap();
        let lambda = [-3.0, 1.0, 0.0, -1.0][round / 4 % 4];
        let surface: TensorSurface<_, _, [f64; 3]> =
            TensorSurface::with_rows(shape(lambda), [-3.0, 1.0, 0.0, 0.5].map(shape), net);
        for (u, v) in [(0.0, 0.0), (0.5, 0.25), (1.0, 1.0), (0.0, 0.7), (f64::NAN, 0.5), (1e300, -1e300)] {
            if let Some(normal) = surface.normal(u, v) {
                let square: f64 = normal.iter().map(|c| c * c).sum();
                assert!((square - 1.0).abs() < 1e-9, "{net:?} at {u}, {v}: {normal:?}");
            }
            surface.curvature(u, v);
        }
        surface.bounding_box();
        for edge in Edge::ALL {
            for pair in [EdgePair::along(edge, Edge::UStart), EdgePair::against(edge, Edge::UStart)] {
                surface.joint(pair, &surface, 5);
            }
        }
        let _ = surface.continued(
            EdgePair::along(Edge::VEnd, Edge::VStart),
            Contact::Parametric { order: round % 5 },
            &surface,
        );
        let _ = surface.continued(
            EdgePair::along(Edge::UEnd, Edge::UStart),
            Contact::Scaled { order: round % 5, f: 1e300 },
            &surface,
        );
        if let Ok(mesh) = Tessellation::new(0.05).unwrap().with(&surface).with(&surface).mesh() {
            assert!(mesh.positions.iter().flatten().all(|c| c.is_finite()));
        }
    }
}

#[test]
fn generatrices_of_extreme_numbers() {
    let random = &mut Random::new(102);
    for round in 0..24 {
        let kinds = [6.0, 8.0, 10.0, 12.0][round % 4];
        let points = core::array::from_fn(|_| {
            core::array::from_fn(|_| {
                COMPONENTS[random.between::<f64>(0.0, kinds) as usize % COMPONENTS.len()]
            })
        });
        let curve: Curve<QuarticBernstein, [f64; 3]> = Curve::new(random_quartic(random), points);
        let Ok(surface) = SurfaceOfRevolution::new(&curve, [0.0; 3], points[0], 4.0) else { continue };
        surface.normal(0.0, 0.0);
        for patch in surface.to_rational_patches().into_iter().chain(surface.half_turns()) {
            patch.normal(0.0, 1.0);
            patch.curvature(0.5, 0.5);
            let _ = Tessellation::new(0.05).unwrap().with(&patch).mesh();
        }
        let _ = Tessellation::new(0.05).unwrap().with(&surface).mesh();
    }
}

/// A surface that counts how often it is asked for a point.
struct Counted<'a, S> {
    surface: &'a S,
    questions: Cell<usize>,
}

impl<S: Surface> Surface for Counted<'_, S> {
    type Point = S::Point;

    fn domain(&self) -> SurfaceDomain<ScalarOf<Self>> {
        self.surface.domain()
    }

    fn eval(&self, u: ScalarOf<Self>, v: ScalarOf<Self>) -> Self::Point {
        self.questions.set(self.questions.get() + 1);
        self.surface.eval(u, v)
    }

    fn partial(
        &self,
        u: ScalarOf<Self>,
        v: ScalarOf<Self>,
        orders: [usize; 2],
    ) -> basis_runtime::VectorOf<Self> {
        self.surface.partial(u, v, orders)
    }
}

impl<S: BoundedSurface> BoundedSurface for Counted<'_, S> {
    fn pieces(&self) -> Vec<SurfacePiece> {
        self.surface.pieces()
    }
}

/// Millions of rectangles are refused when some ten thousand have shown that they are needed.
#[test]
fn tolerances_out_of_reach_are_refused_soon() {
    let quadratic = BernsteinBasis::<f64, 3>::new();
    let wavy = |size: f64| -> [[[f64; 3]; 3]; 3] {
        core::array::from_fn(|i| {
            core::array::from_fn(|j| {
                let (i, j): (f64, f64) = (i as f64, j as f64);
                [i * size, j * size, ((3.0 * i).sin() + (2.0 * j).cos()) * size]
            })
        })
    };
    for (net, tolerance) in [(wavy(1.0), 1e-12), (wavy(1e105), 1e96), (wavy(1e300), 1e292)] {
        let surface = TensorSurface::new(quadratic, quadratic, net);
        let counted = Counted { surface: &surface, questions: Cell::new(0) };
        let error = Tessellation::new(tolerance).unwrap().with(&counted).mesh().unwrap_err();
        assert!(matches!(error, MeshError::TooFine { surface: 0, .. }), "{error}");
        assert!(counted.questions.get() < 150_000, "{tolerance}: {}", counted.questions.get());
    }
    // A point with one corner far away, which is a line.
    let mut peak = wavy(0.0);
    peak[2][2] = [1e308, -1e308, 1e308];
    let surface = TensorSurface::new(quadratic, quadratic, peak);
    let counted = Counted { surface: &surface, questions: Cell::new(0) };
    let error = Tessellation::new(1e300).unwrap().with(&counted).mesh().unwrap_err();
    assert!(matches!(error, MeshError::Collapsed { surface: 0 }), "{error}");
    assert!(counted.questions.get() < 150_000, "{}", counted.questions.get());
}
