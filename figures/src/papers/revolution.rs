//! Figures of "Surfaces of revolution with shape parameters from quartic λ-Bézier generatrices".

use std::error::Error;
use std::f64::consts::PI;

use basis_runtime::{
    Curve, RationalSurface, RevolutionPatch, SurfaceOfRevolution, TensorSurface, half_turn_parameter,
};

use super::families::QuarticBernstein;
use crate::draw::plot::{Axis, Plot};
use crate::draw::scene::{Point3d, Scene, View};
use crate::figure::{Drawing, Facts, Figure, Picture, number};

type Plane = [f64; 2];
type Segment = Curve<QuarticBernstein, Plane>;
type Swept = SurfaceOfRevolution<QuarticBernstein, Point3d>;

const ONE: [Plane; 4] = [[0.0, 0.0], [0.5, 0.4], [0.2, 1.8], [1.0, 2.0]];
const TWO: [[Plane; 4]; 2] =
    [[[0.0, 0.5], [0.5, 1.0], [0.5, 1.6], [1.0, 2.0]], [[1.0, 2.0], [2.0, 1.5], [3.0, 0.5], [4.0, 1.0]]];

/// As the second example, with the first inner point of the second segment on the common tangent: at equal λ, rev-T1
/// holds with α = |Q1 - P3| / |P3 - P2|.
const TWO_SMOOTH: [[Plane; 4]; 2] =
    [[[0.0, 0.5], [0.5, 1.0], [0.5, 1.6], [1.0, 2.0]], [[1.0, 2.0], [1.9, 2.72], [3.0, 0.5], [4.0, 1.0]]];

const VIEW: View = View { azimuth: 48.0, elevation: 28.0 };

/// All figures of the paper.
pub(crate) fn figures() -> Vec<Figure> {
    let mut figures = Vec::new();
    figures.push(Figure::new("rev-eq18-generatrix", "Equation (18): the generatrix", || {
        generatrix_of_one(&[1.0, 0.0, -0.75, -1.5])
    }));
    for (lambda, name) in [(1.0, "1"), (0.0, "0"), (-0.75, "m0.75"), (-1.5, "m1.5")] {
        figures.push(Figure::new(
            format!("rev-eq18-{name}"),
            format!("Equation (18), a full turn, λ = {}", number(lambda)),
            move || whole(&[ONE], &[lambda], 2.0 * PI),
        ));
    }
    for (angle, name, shown) in [(PI / 2.0, "quarter", "π/2"), (1.5 * PI, "three-quarters", "3π/2")] {
        figures.push(Figure::new(
            format!("rev-eq18-angle-{name}-published"),
            format!("Equation (18) revolved by θ = {shown}, with the published parameters"),
            move || partial(angle, shown, false),
        ));
        figures.push(Figure::new(
            format!("rev-eq18-angle-{name}-exact"),
            format!("Equation (18) revolved by θ = {shown}, exactly"),
            move || partial(angle, shown, true),
        ));
    }
    figures.push(Figure::new(
        "rev-eq18-angle-third-published",
        "Equation (18) revolved by θ = π/3, with the published parameters",
        || partial(PI / 3.0, "π/3", false),
    ));
    figures.push(Figure::new(
        "rev-eq18-angle-third-exact",
        "Equation (18) revolved by θ = π/3, exactly",
        || partial(PI / 3.0, "π/3", true),
    ));
    for [a, b] in [[1.0, 1.0], [0.0, 0.0], [-1.0, -1.0], [-2.0, -2.0], [1.0, -3.0], [-3.0, 1.0]] {
        figures.push(Figure::new(
            format!("rev-eq22-{}-{}", file(a), file(b)),
            format!("Equation (22), λ₁ = {}, λ₂ = {}", number(a), number(b)),
            move || whole(&TWO, &[a, b], 2.0 * PI),
        ));
    }
    for lambda in [1.0, -1.0] {
        figures.push(Figure::new(
            format!("rev-eq22-smooth-{}", file(lambda)),
            format!("A second pair of nets with a G1 join, λ₁ = λ₂ = {}", number(lambda)),
            move || whole(&TWO_SMOOTH, &[lambda, lambda], 2.0 * PI),
        ));
    }
    figures
}

/// A number as a part of a file name.
fn file(x: f64) -> String {
    if x < 0.0 { format!("m{}", -x) } else { format!("{x}") }
}

fn generatrix_of_one(lambdas: &[f64]) -> Result<Drawing, Box<dyn Error>> {
    let mut plot = Plot::default();
    plot.axis(Axis::X);
    plot.polygon(&ONE);
    let mut off = 0.0_f64;
    for &lambda in lambdas {
        let curve = Curve::new(QuarticBernstein::new(lambda)?, ONE);
        plot.curve(&curve, &format!("λ = {}", number(lambda)));
        for k in 0..=100 {
            let s = f64::from(k) / 100.0;
            let [x, y] = curve.eval(s);
            let published = [
                (1.5 + 0.5 * lambda) * s - (2.4 + 1.5 * lambda) * s.powi(2)
                    + (1.9 + 0.7 * lambda) * s.powi(3)
                    + 0.3 * lambda * s.powi(4),
                (1.2 + 0.4 * lambda) * s + (3.0 - 1.2 * lambda) * s.powi(2)
                    - (2.2 - lambda) * s.powi(3)
                    - 0.2 * lambda * s.powi(4),
            ];
            off = off.max((x - published[0]).hypot(y - published[1]));
        }
    }
    Ok(Drawing {
        picture: Picture::Curves(plot),
        params: Facts::default().with("λ", lambdas.to_vec()).with("P", list(&ONE)),
        facts: Facts::default().with("largest distance from the published polynomials", off),
        note: String::from("It starts on the axis, so that the surface has a pole there."),
    })
}

fn segments(nets: &[[Plane; 4]], lambdas: &[f64]) -> Result<Vec<Segment>, Box<dyn Error>> {
    let mut segments = Vec::new();
    for (&net, &lambda) in nets.iter().zip(lambdas) {
        segments.push(Curve::new(QuarticBernstein::new(lambda)?, net));
    }
    Ok(segments)
}

fn whole(nets: &[[Plane; 4]], lambdas: &[f64], angle: f64) -> Result<Drawing, Box<dyn Error>> {
    let segments = segments(nets, lambdas)?;
    let parts: Vec<Swept> =
        segments.iter().map(|s| SurfaceOfRevolution::about_x(s, angle)).collect::<Result<_, _>>()?;
    let mut scene = Scene::default();
    let mesh = scene.surfaces(&parts)?;
    let mut facts = Facts::default().with("area", mesh.area()).with("triangles", mesh.triangles.len());
    for pair in segments.windows(2) {
        let joint = pair[0].joint(&pair[1]);
        let order = joint.geometric_order(1e-9, 1e-7, 1e-6);
        facts = facts
            .with("join", order.map_or_else(|| String::from("gap"), |k| format!("G{k}")))
            .with("angle at the join in degrees", joint.angle.to_degrees());
    }
    scene.inside_out();
    if nets == TWO {
        facts = facts.with(
            "largest distance from the published polynomials",
            distance_from_published(&segments, lambdas),
        );
    }
    for net in nets {
        scene.polygon(&net.map(|[x, y]| [x, y, 0.0]));
    }
    let mut params = Facts::default().with("λ", lambdas.to_vec());
    for (k, net) in nets.iter().enumerate() {
        params = params.with(&format!("P{}", k + 1), list(net));
    }
    Ok(Drawing {
        picture: Picture::Surfaces(scene, VIEW),
        params,
        facts,
        note: String::from(
            "About the x axis; the control polygon of the generatrix stands on the meridian of angle 0.",
        ),
    })
}

/// How far the generatrix is from the polynomials printed with equation (22).
fn distance_from_published(segments: &[Segment], lambdas: &[f64]) -> f64 {
    let (a, b) = (lambdas[0], lambdas[1]);
    let published = |k: usize, s: f64| -> Plane {
        let power = |coefficients: [f64; 5]| coefficients.iter().rev().fold(0.0, |sum, c| sum * s + c);
        if k == 0 {
            [
                power([0.0, 1.5 + 0.5 * a, -(1.5 + 1.5 * a), 1.0 + a, 0.0]),
                power([0.5, 1.5 + 0.5 * a, 0.3 - 1.5 * a, -(0.3 - 1.1 * a), -0.1 * a]),
            ]
        } else {
            [
                power([1.0, 3.0 + b, -3.0 * b, 2.0 * b, 0.0]),
                power([2.0, -(1.5 + 0.5 * b), -(1.5 - 1.5 * b), 2.0 - 2.0 * b, b]),
            ]
        }
    };
    let steps = (0..2).flat_map(|k| (0..=100).map(move |step| (k, f64::from(step) / 100.0)));
    steps.fold(0.0, |most, (k, s)| {
        let ([x, y], [p, q]) = (segments[k].eval(s), published(k, s));
        most.max((x - p).hypot(y - q))
    })
}

/// The surface as rational half-turns, up to the published parameter or up to the one that belongs to the angle.
fn partial(angle: f64, shown: &str, exact: bool) -> Result<Drawing, Box<dyn Error>> {
    let lambda = 0.0;
    let generatrix = Curve::new(QuarticBernstein::new(lambda)?, ONE);
    let surface = SurfaceOfRevolution::about_x(&generatrix, angle)?;
    let first = angle.min(PI);
    let rest = angle - first;
    let (parts, ends, parameters) = if exact {
        let parts = surface.half_turns();
        let parameters = parts_parameters(first, rest, half_turn_parameter);
        (parts, [0.0, angle], parameters)
    } else {
        // The whole half-turns of the paper, cut where it says.
        let half = SurfaceOfRevolution::about_x(&generatrix, PI)?.half_turns();
        let parameters = parts_parameters(first, rest, |angle| angle / PI);
        let turned = |t: f64| (2.0 * t * (1.0 - t)).atan2(1.0 - 2.0 * t);
        let cut = |t: f64| half[0].subpatch(0.0..1.0, 0.0..t);
        let mut parts: Vec<RevolutionPatch<QuarticBernstein, Point3d>> = vec![cut(parameters[0])?];
        let mut ends = [0.0, turned(parameters[0])];
        if rest > 0.0 {
            // R~ = (r1, r2, -r3) runs backwards from angle 0.
            parts.push(mirrored(&cut(parameters[1])?));
            ends[0] = -turned(parameters[1]);
        }
        (parts, ends, parameters)
    };
    let mut scene = Scene::default();
    let mesh = scene.surfaces(&parts)?;
    let covered = (ends[1] - ends[0]).to_degrees();
    let facts = Facts::default()
        .with("angle asked for in degrees", angle.to_degrees())
        .with("angle covered in degrees", covered)
        .with("from angle in degrees", ends[0].to_degrees())
        .with("to angle in degrees", ends[1].to_degrees())
        .with("error of the angle in degrees", covered - angle.to_degrees())
        .with("parameters t", parameters)
        .with("area", mesh.area())
        .with("triangles", mesh.triangles.len());
    scene.polygon(&ONE.map(|[x, y]| [x, y, 0.0]));
    scene.inside_out();
    scene.colours(vec![0; parts.len()]);
    Ok(Drawing {
        picture: Picture::Surfaces(scene, VIEW),
        params: Facts::default().with("λ", lambda).with("θ", shown).with("P", list(&ONE)),
        facts,
        note: String::from(if exact {
            "t = sin(α/2) / (sin(α/2) + cos(α/2)) for each half-turn; the second is the first one turned by π."
        } else {
            "t = θ/π is the right parameter at π/2 and π only; beyond π the published second half runs backwards from angle 0, \
             so that the surface does not begin at the generatrix."
        }),
    })
}

fn parts_parameters(first: f64, rest: f64, of: impl Fn(f64) -> f64) -> Vec<f64> {
    if rest > 0.0 { vec![of(first), of(rest)] } else { vec![of(first)] }
}

/// The other half of the paper, `(r1, r2, -r3)`.
fn mirrored(part: &RevolutionPatch<QuarticBernstein, Point3d>) -> RevolutionPatch<QuarticBernstein, Point3d> {
    let numerator = part.numerator();
    let net = core::array::from_fn(|i| {
        core::array::from_fn(|j| {
            let [x, y, z] = numerator.rows()[i].control_points()[j];
            [x, y, -z]
        })
    });
    let basis = numerator.rows()[0].basis();
    RationalSurface::from_homogeneous(TensorSurface::new(numerator.u_basis(), basis, net), *part.weight())
}

fn list(points: &[Plane]) -> serde_json::Value {
    points.iter().map(|p| p.to_vec()).collect()
}
