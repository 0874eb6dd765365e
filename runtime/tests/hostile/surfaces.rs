//! Tensor surfaces, rational surfaces, surfaces of revolution, and their meshes.

use basis_runtime::{
    BoundedSurface, Contact, Curve, Direction, Edge, EdgePair, Isocurve, Mesh, Orientation, ParametricCurve,
    RationalSurface, Surface, SurfaceDomain, SurfaceOfRevolution, SurfacePiece, TensorSurface, Tessellation,
    Vertex, basis, half_turn_parameter,
};

use crate::{Case, NETS, P, check, is_box, is_finite, is_length, is_nan, is_unit, pair};

basis!("../../../specs/quartic.basis");

type Q = QuarticBernstein;
type Tensor = TensorSurface<Q, Q, P>;
type Rational = RationalSurface<Q, Q, P>;
type Revolved = SurfaceOfRevolution<Q, P>;

fn quartic(shape: f64) -> Q {
    Q::new(shape).unwrap()
}

/// What is asked of every curve on a surface.
fn is_curve<S: BoundedSurface<Point = P>>(curve: &Isocurve<'_, S>, t: f64) -> bool {
    let _ = (curve.derivative(t, 2), curve.surface_parameters(t), curve.tangent(t));
    let [lo, hi] = curve.domain();
    curve.split(t).is_ok() == (t > lo && t < hi)
        && (t != 0.375 || is_box(curve.bounding_box()) || !is_finite(curve.start()))
        && (t != 0.5
            || curve.nearest([t, 0.5, 1.0], 1e300).is_none_or(|found| found.at_least <= found.distance))
}

/// What takes longer than to be asked for all parameters: areas as exact as can be, and the curves at the edges.
pub(crate) fn areas_and_edges<S: BoundedSurface<Point = P>>(make: impl Fn(fn(usize) -> P) -> Option<S>) {
    for (k, net) in NETS.into_iter().enumerate() {
        let Some(s) = make(net) else { continue };
        let found = s.area(f64::NAN);
        assert!(found.is_none_or(|area| area.value >= 0.0 && area.error >= 0.0), "net {k}: {found:?}");
        assert!(Edge::ALL.iter().all(|&edge| is_curve(&s.boundary(edge), 0.5)), "net {k}");
    }
}

/// What every surface answers.
pub(crate) fn any<S: Surface<Point = P> + BoundedSurface>(s: &S, a: f64, b: f64) -> bool {
    let mut grid = [[0.0; 3]; 5];
    assert!(s.eval_grid(&[a, b], &[b, a], &mut grid[..4]).is_ok());
    assert!(s.eval_grid(&[a], &[], &mut []).is_ok() && s.eval_grid(&[], &[a], &mut grid).is_err());
    assert!(s.eval_grid(&[a, b, 0.0, 1.0], &[a, b], &mut grid[..3]).is_err());
    let _ =
        (s.eval_with_partials::<0>(a, b), s.eval_with_partials::<1>(a, b), s.eval_with_partials::<4>(a, b));
    let _ = (s.partial(a, b, [0, 0]), s.partial(a, b, [1, 2]), s.partial(a, b, [9, 0]));
    let domain = s.domain();
    let [[lo, hi], [low, high]] = domain.ranges();
    let (u, v) = domain.clamped(a, b);
    lo < hi
        && low < high
        && s.eval_checked(a, b).is_ok() == domain.contains(a, b)
        && (domain.contains(u, v) || a.is_nan() || b.is_nan())
        && (is_nan(s.eval_clamped(a, b)) || !(a.is_nan() && b.is_nan()))
        && s.normal(a, b).is_none_or(is_unit)
        && s.curvature(a, b).is_none_or(|c| {
            is_finite(c.normal) && !c.gaussian().is_nan()
                || c.mean().is_nan()
                || !c.mean().is_finite()
                || !c.gaussian().is_finite()
        })
        && (is_nan(s.eval(a, b)) || !(a.is_nan() && b.is_nan()))
        && is_curve(&s.isocurve(Direction::U, a), b)
        && is_curve(&s.isocurve(Direction::V, b), a)
        && (a.to_bits() != b.to_bits() || whole(s, a))
}

/// What a surface answers as a whole: asked for each number with itself, because it takes longer.
fn whole<S: Surface<Point = P> + BoundedSurface>(s: &S, a: f64) -> bool {
    BoundedSurface::nearest(s, [a, 0.5, -a], 1e300)
        .is_none_or(|found| found.distance >= found.at_least && found.at_least >= 0.0)
        && s.area(f64::INFINITY).is_none_or(|area| area.value >= 0.0 && area.error >= 0.0)
        && is_box(BoundedSurface::bounding_box(s))
        && is_box(BoundedSurface::control_box(s))
}

/// Whether a surface over the unit square has two parts there.
fn inner(x: f64) -> bool {
    x > 0.0 && x < 1.0
}

const TENSOR: &[Case<Tensor>] = &[
    ("new", |s, a, b| any(s, a, b)),
    ("with_rows", |s, a, _| {
        let shapes = [-3.0, 1.0, 0.5, 0.5].map(quartic);
        let other = TensorSurface::with_rows(s.u_basis(), shapes, [[[a; 3]; 4]; 4]);
        !a.is_nan() || is_nan(other.eval(0.5, 0.5))
    }),
    ("from_slice", |s, a, _| {
        let surface = |points: &[P]| TensorSurface::from_slice(s.u_basis(), quartic(0.5), points);
        surface(&[[a; 3]; 15]).is_err() && surface(&[]).is_err() && surface(&[[a; 3]; 16]).is_ok()
    }),
    ("with_bases", |s, a, b| {
        let other = s.with_bases(quartic(1.0), quartic(-3.0));
        any(&other, a, b) && other.rows().iter().all(|row| row.basis() == quartic(-3.0))
    }),
    ("u_basis", |s, _, _| s.u_basis() == quartic(0.5)),
    ("rows", |s, _, _| s.rows().len() == 4),
    ("control_point", |s, _, _| {
        s.control_point(4, 0).is_none()
            && s.control_point(usize::MAX, usize::MAX).is_none()
            && s.control_point(3, 3).is_some()
    }),
    ("along_u", |s, a, b| !a.is_nan() || is_nan(s.along_u(a).eval(b))),
    ("along_v", |s, a, b| s.along_v(a).is_none_or(|c| !b.is_nan() || is_nan(c.eval(b)))),
    ("along_v_bezier", |s, a, b| !a.is_nan() || is_nan(s.along_v_bezier(a).eval(b))),
    ("boundary_along_u", |s, _, _| s.boundary_along_u().len() == 2),
    ("boundary_along_v", |s, _, _| s.boundary_along_v().iter().all(Option::is_some)),
    ("to_bezier", |s, a, b| any(&s.to_bezier(), a, b)),
    ("split", |s, a, b| {
        [Direction::U, Direction::V].iter().all(|&direction| match s.split(direction, a) {
            Ok(parts) => inner(a) && parts.iter().all(|part| !b.is_nan() || is_nan(part.eval(b, b))),
            Err(_) => !inner(a),
        })
    }),
    ("subpatch", |s, a, b| {
        let part = s.subpatch(a..b, b..a);
        let given = [a, b].iter().all(|x| (0.0..=1.0).contains(x)) && a != b;
        part.map_or(!given, |part| given && part.control_point(4, 4).is_some())
    }),
    ("reversed", |s, a, b| {
        [Direction::U, Direction::V].iter().all(|&along| {
            let turned = s.reversed(along);
            turned.normal(a, b).is_none_or(is_unit)
                && (is_nan(turned.eval(a, b)) || !(a.is_nan() && b.is_nan()))
        })
    }),
    ("control_box", |s, _, _| is_box(s.control_box())),
    ("bounding_box", |s, a, b| a != 0.0 || b != 0.0 || is_box(s.bounding_box())),
    ("nearest", |s, a, b| {
        // The point matters, and accuracies of every size.
        let few = [0.375, 1e300, f64::NAN].into_iter().any(|x| x.to_bits() == a.to_bits());
        !few || s.nearest([a, 0.25, a], b).is_none_or(|found| {
            let inside = found.at.iter().all(|x| (0.0..=1.0).contains(x));
            inside && found.at_least <= found.distance && is_length(found.distance)
        })
    }),
    ("continued", |s, a, b| {
        let contact = |order| {
            if order == 2 { Contact::Curvature { f: a, c: b } } else { Contact::Scaled { order, f: a } }
        };
        [0, 1, 2, 3, usize::MAX].into_iter().all(|order| {
            Edge::ALL.into_iter().all(|edge| {
                let pair = EdgePair::against(edge, Edge::VEnd);
                s.continued(pair, contact(order), s).map_or(true, |t| t.rows().len() == 4)
            })
        })
    }),
    ("joint", |s, a, b| {
        a != 0.0
            || [0, 1, 2, 5].into_iter().all(|samples| {
                let joint = s.joint(pair(Edge::UEnd, Edge::VStart, b > 0.0), s, samples);
                is_length(joint.gap) && is_length(joint.angle) && is_length(joint.curvature)
            })
    }),
    ("against", |s, _, _| {
        let pair = EdgePair::against(Edge::UEnd, Edge::VStart);
        pair.orientation == Orientation::Opposite && is_length(s.joint(pair, s, 3).gap)
    }),
    ("swapped", |_, a, b| {
        let joint = pair(Edge::UEnd, Edge::VStart, a > b);
        joint.swapped() == pair(Edge::VStart, Edge::UEnd, a > b)
    }),
    ("geometric_order", |s, a, b| {
        s.joint(EdgePair::along(Edge::UEnd, Edge::UStart), s, 2)
            .geometric_order(a, b, a)
            .is_none_or(|k| k <= 2)
    }),
    ("on_edge", |s, a, _| {
        Edge::ALL.iter().all(|&edge| {
            let (u, v) = s.domain().on_edge(edge, a);
            !a.is_nan() || u.is_nan() || v.is_nan()
        })
    }),
    ("contains", |s, a, b| s.domain().contains(a, b) == s.domain().check(a, b).is_ok()),
    ("clamped", |_, a, b| {
        let (u, v) = SurfaceDomain::Triangle.clamped(a, b);
        SurfaceDomain::Triangle.contains(u, v) || a.is_nan() || b.is_nan()
    }),
    ("ranges", |s, _, _| s.domain().ranges() == [[0.0, 1.0]; 2]),
    ("range", |_, a, _| {
        let [lo, hi] = SurfaceDomain::Triangle.range(Direction::V, a);
        lo <= hi || a.is_nan()
    }),
    ("at", |s, a, b| s.domain().at(a, b).0.to_bits() == a.to_bits() || a.is_nan()),
    ("along", |s, _, _| is_curve(&Isocurve::along(s, Edge::VEnd), 0.5)),
    ("runs_along_u", |_, _, _| Edge::VStart.runs_along_u() && !Edge::UEnd.runs_along_u()),
    ("across", |_, _, _| Edge::VStart.across() == Direction::V && Edge::UEnd.across() == Direction::U),
    ("is_end", |_, _, _| Edge::UEnd.is_end() && !Edge::VStart.is_end()),
    ("opposite", |_, _, _| Edge::ALL.iter().all(|edge| edge.opposite().opposite() == *edge)),
    ("gaussian", |s, a, b| {
        s.curvature(a, b).is_none_or(|c| c.gaussian().is_nan() || c.principal.iter().all(|k| !k.is_nan()))
    }),
    ("mean", |s, a, b| {
        s.curvature(a, b).is_none_or(|c| c.mean().is_nan() || c.principal.iter().all(|k| !k.is_nan()))
    }),
    ("along", |s, a, b| {
        s.curvature(0.3, 0.4)
            .is_none_or(|c| c.along([a, b, 0.0]).is_none_or(|k| !k.is_nan() || !c.mean().is_finite()))
    }),
];

const RATIONAL: &[Case<Rational>] = &[
    ("new", |s, a, b| any(s, a, b)),
    ("from_homogeneous", |s, _, _| {
        s.control_point(0, 0)
            == RationalSurface::from_homogeneous(*s.numerator(), *s.weight()).control_point(0, 0)
            || !is_finite(s.eval(0.5, 0.5))
    }),
    ("numerator", |s, _, _| s.numerator().rows().len() == 4),
    ("weight", |s, _, _| s.weight().rows().len() == 4),
    ("split", |s, a, _| {
        s.split(Direction::U, a).is_ok() == inner(a) && s.split(Direction::V, a).is_ok() == inner(a)
    }),
    ("subpatch", |s, a, b| {
        let given = [a, b].iter().all(|x| (0.0..=1.0).contains(x)) && a != b;
        let part = s.subpatch(a..b, b..a);
        part.map_or(!given, |part| given && part.numerator().control_point(4, 4).is_some())
    }),
    ("reversed", |s, _, _| s.reversed(Direction::U).numerator().control_point(4, 4).is_some()),
    ("control_point", |s, _, _| {
        s.control_point(4, 0).is_none() && s.control_point(usize::MAX, usize::MAX).is_none()
    }),
    ("continued", |s, a, b| {
        [0, 1, 2, 3, usize::MAX].into_iter().all(|order| {
            let contact =
                if order == 2 { Contact::Curvature { f: a, c: b } } else { Contact::Scaled { order, f: a } };
            let next = s.continued(pair(Edge::UEnd, Edge::VStart, b > 0.0), contact, s);
            next.map_or(true, |next| order <= 3 && next.control_point(9, 0).is_none())
        })
    }),
    ("control_box", |s, _, _| is_box(s.control_box())),
    ("bounding_box", |s, a, b| a != 0.0 || b != 0.0 || is_box(s.bounding_box())),
];

const REVOLVED: &[Case<Revolved>] = &[
    ("new", |s, a, b| {
        let other = SurfaceOfRevolution::new(s.generatrix(), [a, b, 0.0], [b, a, 1.0], a);
        any(s, a, b)
            && other.is_ok_and(|t| t.angle() == a)
                == (a > 0.0 && a <= 2.0 * core::f64::consts::PI && b.is_finite())
    }),
    ("map", |s, a, b| {
        let image = s.map(|[x, y, z]| [x * a, y * a, z * b + a]);
        image.map_or(true, |t| any(&t, a, b) && t.angle() == s.angle())
    }),
    ("transform", |s, a, b| {
        let image = s.transform(&[[a, 0.0, 0.0, b], [0.0, a, 0.0, 0.0], [0.0, 0.0, b, 0.0]]);
        image.map_or(true, |t| !a.is_nan() && !b.is_nan() && t.angle() == s.angle())
    }),
    ("continued", |s, a, b| {
        Edge::ALL.into_iter().all(|edge| {
            let contact = Contact::Curvature { f: a, c: b };
            let next = s.continued(EdgePair::against(edge, Edge::UEnd), contact, s);
            next.map_or(true, |next| !edge.runs_along_u() && next.angle() == s.angle())
        })
    }),
    ("angle", |s, _, _| s.angle() == 4.0),
    ("generatrix", |s, _, _| s.generatrix().control_points().len() == 4),
    ("axis", |s, _, _| is_unit(s.axis().1)),
    ("is_closed", |s, _, _| !s.is_closed()),
    ("meridian", |s, a, b| {
        !a.is_nan() || is_nan(s.meridian(a).eval(b)) || !b.is_nan() || !is_finite(s.eval(0.5, 1.0))
    }),
    ("about_x", |s, a, b| {
        let plane = Curve::new(s.generatrix().basis(), [[a, b], [b, a], [0.0, 0.0], [1.0, 1.0]]);
        SurfaceOfRevolution::about_x(&plane, b).map_or(true, |t| any(&t, a, b))
    }),
    ("control_box", |s, _, _| is_box(s.control_box())),
    ("bounding_box", |s, a, b| a != 0.0 || b != 0.0 || is_box(s.bounding_box())),
    ("half_turn_parameter", |_, a, _| {
        half_turn_parameter(a).is_nan()
            || (0.0..=1.0).contains(&half_turn_parameter(a))
            || !(0.0..=core::f64::consts::PI).contains(&a)
    }),
    ("split", |s, a, _| {
        s.split(Direction::U, a).is_ok() == inner(a)
            && s.split(Direction::V, a).is_ok() == (a > 0.0 && a < 4.0)
    }),
    ("subpatch", |s, a, b| {
        let given = [a, b].iter().all(|x| (0.0..=1.0).contains(x)) && a != b;
        s.subpatch(a..b, b..a).map_or(!given, |part| given && part.angle() > 0.0)
    }),
    ("reversed", |s, a, b| {
        [Direction::U, Direction::V].iter().all(|&along| {
            let turned = s.reversed(along);
            turned.normal(a, b).is_none_or(is_unit)
                && (is_nan(turned.eval(a, b)) || !(a.is_nan() && b.is_nan()))
        })
    }),
    ("to_rational_patches", |s, a, b| s.to_rational_patches().iter().all(|patch| any(patch, a, b))),
    ("half_turns", |s, a, b| s.half_turns().iter().all(|patch| any(patch, a, b))),
];

const MESH: &[Case<Mesh<f64>>] = &[
    ("check", |m, _, _| m.check().is_ok()),
    ("corners", |m, _, _| m.corners([u32::MAX; 3]).is_none()),
    ("area", |m, _, _| is_length(m.area())),
    ("volume", |m, _, _| m.volume().is_nan() || m.volume().abs() >= 0.0),
    ("boundary", |m, _, _| m.boundary().iter().flatten().all(|&p| (p as usize) < m.positions.len())),
    ("is_closed", |m, _, _| !m.is_closed() || m.boundary().is_empty()),
    ("is_oriented", |m, _, _| m.is_oriented() || !m.triangles.is_empty()),
];

/// Of a tessellation, whose functions answer with a mesh or an error, and of the features that write files.
const OTHERS: &[&str] = &[
    "with",
    "mesh",
    "longest_edge",
    "largest_angle",
    "largest_aspect",
    "write_obj",
    "write_stl",
    "write_gltf",
    "polynomial",
    "rational",
    "degrees",
    "surface_parameters",
];

pub(crate) const NAMES: &[&str] = &{
    let mut names = [""; TENSOR.len() + RATIONAL.len() + REVOLVED.len() + MESH.len() + OTHERS.len()];
    let mut k = 0;
    while k < TENSOR.len() {
        names[k] = TENSOR[k].0;
        k += 1;
    }
    let mut from = k;
    while k - from < RATIONAL.len() {
        names[k] = RATIONAL[k - from].0;
        k += 1;
    }
    from = k;
    while k - from < REVOLVED.len() {
        names[k] = REVOLVED[k - from].0;
        k += 1;
    }
    from = k;
    while k - from < MESH.len() {
        names[k] = MESH[k - from].0;
        k += 1;
    }
    from = k;
    while k - from < OTHERS.len() {
        names[k] = OTHERS[k - from];
        k += 1;
    }
    names
};

fn tensor(net: fn(usize) -> P) -> Tensor {
    let shapes = [-3.0, 1.0, 0.5, 0.5].map(quartic);
    TensorSurface::with_rows(
        quartic(0.5),
        shapes,
        core::array::from_fn(|i| core::array::from_fn(|j| net(4 * i + j))),
    )
}

#[test]
fn tensor_surfaces() {
    check(TENSOR, |net| Some(tensor(net)));
    areas_and_edges(|net| Some(tensor(net)));
    // Poles: each row is one point, or all rows are the same.
    let pole = |net: fn(usize) -> P, rows: bool| {
        let place = move |i: usize, j: usize| net(if rows { i } else { j });
        let net = core::array::from_fn(|i| core::array::from_fn(|j| place(i, j)));
        Some(TensorSurface::new(quartic(0.5), quartic(-1.0), net))
    };
    check(TENSOR, |net| pole(net, true));
    check(TENSOR, |net| pole(net, false));
}

#[test]
fn rational_surfaces() {
    let surface = |net: fn(usize) -> P, weight: f64| {
        let points = core::array::from_fn(|i| core::array::from_fn(|j| net(4 * i + j)));
        let weights =
            core::array::from_fn(|i| core::array::from_fn(|j| if (i + j) % 3 == 1 { weight } else { 1.0 }));
        Some(Rational::new(quartic(0.5), quartic(1.0), points, weights))
    };
    for weight in [1.0, 0.0, -1.0, 1e-300, f64::MAX, f64::NAN] {
        check(RATIONAL, |net| surface(net, weight));
    }
    areas_and_edges(|net| surface(net, 3.0));
}

#[test]
fn surfaces_of_revolution() {
    let surface = |net| {
        let curve = Curve::new(quartic(0.5), core::array::from_fn(net));
        SurfaceOfRevolution::new(&curve, [0.0; 3], [0.0, 0.6, 0.8], 4.0).ok()
    };
    check(REVOLVED, surface);
    areas_and_edges(surface);
}

#[test]
fn meshes() {
    for net in NETS {
        for tolerance in crate::NUMBERS {
            let Ok(tessellation) = Tessellation::new(tolerance) else {
                assert!(tolerance <= 0.0 || !tolerance.is_finite());
                continue;
            };
            let surface = tensor(net);
            let curve = Curve::new(quartic(0.5), core::array::from_fn(net));
            let size = surface.control_box().iter().flatten().fold(0.0_f64, |size, c| size.max(c.abs()));
            // Meshes finer than this take their time, and are cut off at millions of triangles.
            if size / tolerance > 1e4 && size.is_finite() {
                continue;
            }
            let revolved = SurfaceOfRevolution::new(&curve, [0.0; 3], [0.0, 0.6, 0.8], 4.0);
            let tessellation = tessellation.with(&surface).with(&surface);
            let found = revolved.as_ref().map_or_else(
                |_| tessellation.mesh(),
                |revolved| Tessellation::new(tolerance)?.with(revolved).with(&surface).mesh(),
            );
            let Ok(mesh) = found else { continue };
            assert!(mesh.positions.iter().all(|&p| is_finite(p)));
            for (name, call) in MESH {
                assert!(call(&mesh, 0.0, 0.0), "{name}: {net:?} {tolerance}");
            }
        }
    }
    assert_eq!(Tessellation::new(1.0).unwrap().mesh(), Ok(Mesh::default()));
}

#[test]
fn pieces_and_options() {
    for net in NETS {
        let points: [P; 6] = core::array::from_fn(net);
        for a in crate::NUMBERS {
            let domain = [[0.0, a], [a, 1.0]];
            assert!(
                SurfacePiece::polynomial(domain, 2, &points).is_ok_and(|piece| piece.degrees() == [1, 2])
            );
            assert!(SurfacePiece::polynomial(domain, 4, &points).is_err());
            let rational = SurfacePiece::rational(domain, 3, &points, &[1.0, a, 1.0, 1.0, 2.0, 3.0]);
            assert_eq!(rational.is_ok(), a > 0.0 && a.is_finite());
        }
    }
    for a in crate::NUMBERS {
        let tessellation = || Tessellation::new(1.0).unwrap();
        assert_eq!(tessellation().longest_edge(a).is_ok(), a > 0.0);
        assert_eq!(tessellation().largest_angle(a).is_ok(), a > 0.0);
    }
}

/// Put together by hand, with indices that do not exist and positions that are not numbers.
#[test]
fn broken_meshes() {
    let vertex =
        |position| Vertex { position, normal: [f64::NAN; 3], uv: [f64::INFINITY; 2], surface: u32::MAX };
    for position in [[f64::NAN; 3], [f64::MAX; 3], [0.0; 3]] {
        for index in [0, 1, u32::MAX] {
            let triangles = vec![[0, 1, index], [index; 3], [0, 1, 2], [0, 0, 1]];
            let mesh = Mesh {
                positions: vec![position; 2],
                vertices: vec![vertex(0), vertex(index), vertex(1)],
                triangles,
            };
            let _ = (
                mesh.check(),
                mesh.area(),
                mesh.volume(),
                mesh.boundary(),
                mesh.is_closed(),
                mesh.is_oriented(),
            );
            #[cfg(feature = "obj")]
            let _ = mesh.write_obj(std::io::sink());
            #[cfg(feature = "stl")]
            let _ = mesh.write_stl(std::io::sink());
            #[cfg(feature = "gltf")]
            let _ = mesh.write_gltf(std::io::sink());
        }
    }
}
