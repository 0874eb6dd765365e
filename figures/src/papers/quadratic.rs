//! Figures of "Continuity conditions for a class of quadratic Bezier curve with parameters": curves over one triangle,
//! the hat and the vase.

#![allow(clippy::approx_constant)] // 3.14 is a coordinate of the hat

use std::error::Error;
use std::f64::consts::PI;

use basis_runtime::{Curve, Joint, SurfaceOfRevolution};

use super::families::QuadraticBezier;
use crate::draw::plot::{Axis, Plot};
use crate::draw::scene::{Scene, View};
use crate::figure::{Drawing, Facts, Figure, Picture, number};

type Plane = [f64; 2];
type Segment = Curve<QuadraticBezier, Plane>;

/// Segments of a generatrix: the shape value and the control points of each.
#[derive(Clone, Copy)]
struct Profile<const N: usize> {
    lambda: [f64; N],
    points: [[Plane; 3]; N],
}

const HAT: Profile<4> = Profile {
    lambda: [0.62, 0.73, 0.81, 0.60],
    points: [
        [[0.0, 0.04], [1.98, -0.23], [3.14, 0.51]],
        [[3.14, 0.51], [0.45, 1.29], [0.52, 1.33]],
        [[0.52, 1.33], [5.98, 1.26], [6.02, 1.68]],
        [[6.02, 1.68], [6.51, 1.32], [7.85, 1.29]],
    ],
};

const VASE: Profile<2> = Profile {
    lambda: [0.57, 0.52],
    points: [[[2.58, 6.27], [0.11, 4.45], [2.05, 2.81]], [[2.05, 2.81], [3.75, 2.13], [2.01, 0.02]]],
};

/// The hat with the first digits of two abscissae as they may have been meant, 4.45 and 5.52 instead of 0.45 and 0.52,
/// and all joins smooth as claimed: middle points turned onto the tangents, and λ = 1 where the curve changes the side
/// to which it turns.
const HAT_RESTORED: Profile<4> = Profile {
    lambda: [1.0, 1.0, 0.81, 0.60],
    points: [
        HAT.points[0],
        [[3.14, 0.51], [4.45, 1.29], [5.52, 1.33]],
        [[5.52, 1.33], [5.98, 1.26], [6.02, 1.68]],
        HAT.points[3],
    ],
};

/// All figures of the paper.
pub(crate) fn figures() -> Vec<Figure> {
    let hat_smooth = hat_smooth();
    let hat = Subject {
        id: "quad-ex1",
        name: "The hat",
        claimed: "published as G2, G1 and G0",
        view: View { azimuth: -60.0, elevation: 24.0 },
        up: -1.0,
    };
    let vase = Subject {
        id: "quad-ex2",
        name: "The vase",
        claimed: "published as G2",
        view: View { azimuth: -60.0, elevation: 14.0 },
        up: 1.0,
    };
    let mut figures = vec![Figure::new("quad-fig-family", "One control triangle, λ = −1, 0, 1", family)];
    figures.extend(hat.figures(
        "published",
        "as published",
        HAT,
        "The published points: no join is smooth, and the second curve runs back almost to the axis.",
    ));
    figures.extend(hat.figures(
        "repaired",
        "repaired",
        hat_smooth,
        "The outer control points of the first two segments are moved onto common tangents; with λ = 1 for both, the \
         curvature is zero on both sides of their join, which is then G2 although the curve changes the side to which it \
         turns.",
    ));
    figures.extend(hat.figures(
        "restored",
        "with two digits restored",
        hat_restored(),
        "With 4.45 and 5.52 in place of 0.45 and 0.52 the generatrix runs outwards all the way, from the crown to the brim, and \
         the surface is a hat. The middle points of the second and third segments are turned onto the tangents, and λ₁ = λ₂ = 1.",
    ));
    figures.extend(vase.figures("published", "as published", VASE, "The tangents at the join differ."));
    figures.extend(vase.figures(
        "repaired-g1",
        "repaired to G1",
        vase_smooth(VASE.lambda),
        "The middle point of the lower curve is turned onto the tangent. The neck and the belly bend to different sides, so \
         that with the published λ the join cannot be G2.",
    ));
    figures.extend(vase.figures(
        "repaired-g2",
        "repaired to G2",
        vase_smooth([1.0, 1.0]),
        "With λ = 1 both curvatures are zero at the join: G2.",
    ));
    figures
}

fn family() -> Result<Drawing, Box<dyn Error>> {
    let points = [[0.0, 0.0], [2.0, 3.0], [5.0, 0.0]];
    let mut plot = Plot::default();
    plot.polygon(&points);
    let mut heights = Vec::new();
    for lambda in [-1.0, 0.0, 1.0] {
        let curve = Curve::new(QuadraticBezier::new(lambda)?, points);
        plot.curve(&curve, &format!("λ = {}", number(lambda)));
        heights.push(curve.bounding_box()[1][1]);
    }
    Ok(Drawing {
        picture: Picture::Curves(plot),
        params: Facts::default().with("λ", vec![-1.0, 0.0, 1.0]).with("points", list(&points)),
        facts: Facts::default().with("greatest heights", heights),
        note: String::from("The larger λ, the nearer the curve runs to the two legs."),
    })
}

/// What several figures have in common.
#[derive(Clone, Copy)]
struct Subject {
    id: &'static str,
    name: &'static str,
    claimed: &'static str,
    view: View,
    /// Which way the paper's y axis points in the picture of the surface: 1 up, -1 down.
    up: f64,
}

impl Subject {
    /// The generatrix and the surface that it sweeps.
    fn figures<const N: usize>(
        self,
        suffix: &'static str,
        manner: &'static str,
        profile: Profile<N>,
        note: &'static str,
    ) -> [Figure; 2] {
        let Self { id, name, claimed, view, up } = self;
        [
            Figure::new(
                format!("{id}-{suffix}-generatrix"),
                format!("{name}, {manner}: the generatrix"),
                move || generatrix(profile, claimed, note),
            ),
            Figure::new(
                format!("{id}-{suffix}-surface"),
                format!("{name}, {manner}: the surface"),
                move || surface(profile, claimed, note, view, up),
            ),
        ]
    }
}

fn segments<const N: usize>(profile: &Profile<N>) -> Result<Vec<Segment>, Box<dyn Error>> {
    let pairs = profile.lambda.iter().zip(profile.points);
    Ok(pairs
        .map(|(&l, p)| Ok(Curve::new(QuadraticBezier::new(l)?, p)))
        .collect::<Result<_, basis_runtime::ShapeError>>()?)
}

fn generatrix<const N: usize>(
    profile: Profile<N>,
    claimed: &str,
    note: &str,
) -> Result<Drawing, Box<dyn Error>> {
    let segments = segments(&profile)?;
    let mut plot = Plot::default();
    plot.axis(Axis::Y);
    for (k, segment) in segments.iter().enumerate() {
        plot.polygon(segment.control_points());
        plot.curve(segment, &format!("P{} (λ = {})", k + 1, number(profile.lambda[k])));
    }
    Ok(Drawing {
        picture: Picture::Curves(plot),
        params: params(&profile),
        facts: joints(&segments, claimed),
        note: note.to_owned(),
    })
}

fn surface<const N: usize>(
    profile: Profile<N>,
    claimed: &str,
    note: &str,
    view: View,
    up: f64,
) -> Result<Drawing, Box<dyn Error>> {
    let segments = segments(&profile)?;
    let parts: Vec<SurfaceOfRevolution<QuadraticBezier, [f64; 3]>> = segments
        .iter()
        .map(|segment| {
            // The paper's y axis is the vertical.
            let points = core::array::from_fn(|i| {
                let [x, y] = segment.control_points()[i];
                [x, 0.0, up * y]
            });
            SurfaceOfRevolution::new(
                &Curve::new(segment.basis(), points),
                [0.0; 3],
                [0.0, 0.0, 1.0],
                2.0 * PI,
            )
        })
        .collect::<Result<_, _>>()?;
    let mut scene = Scene::default();
    let mesh = scene.surfaces(&parts)?;
    let facts = joints(&segments, claimed).with("area", mesh.area()).with("triangles", mesh.triangles.len());
    scene.colours(vec![0; N]);
    for segment in &segments {
        scene.polygon(&segment.control_points().iter().map(|&[x, y]| [x, 0.0, up * y]).collect::<Vec<_>>());
    }
    Ok(Drawing {
        picture: Picture::Surfaces(scene, view),
        params: params(&profile),
        facts,
        note: if up > 0.0 {
            note.to_owned()
        } else {
            format!("{note} The y axis of the generatrix points down here.")
        },
    })
}

/// Gap, angle and difference of curvature at each joint.
fn joints(segments: &[Segment], claimed: &str) -> Facts {
    let joints: Vec<Joint<f64>> = segments.windows(2).map(|pair| pair[0].joint(&pair[1])).collect();
    let orders: Vec<String> = joints
        .iter()
        .map(|joint| {
            joint.geometric_order(1e-9, 1e-7, 1e-6).map_or_else(|| String::from("gap"), |k| format!("G{k}"))
        })
        .collect();
    Facts::default()
        .with("claimed", claimed)
        .with("measured", orders)
        .with("gaps", joints.iter().map(|j| j.gap).collect::<Vec<f64>>())
        .with("angles in degrees", joints.iter().map(|j| j.angle.to_degrees()).collect::<Vec<f64>>())
        .with("curvature differences", joints.iter().map(|j| j.curvature).collect::<Vec<f64>>())
}

fn params<const N: usize>(profile: &Profile<N>) -> Facts {
    let facts = Facts::default().with("λ", profile.lambda.to_vec());
    (0..N).fold(facts, |facts, k| facts.with(&format!("P{}", k + 1), list(&profile.points[k])))
}

fn list(points: &[Plane]) -> serde_json::Value {
    points.iter().map(|p| p.to_vec()).collect()
}

/// The hat with smooth joins, its joints where they are published: the second curve ends in the direction of the third,
/// the first one in that of the second.
fn hat_smooth() -> Profile<4> {
    let Profile { mut lambda, mut points } = HAT;
    points[1][1] = continued_back(points[2][1], points[2][0], points[1][1]);
    points[0][1] = continued_back(points[1][1], points[1][0], points[0][1]);
    lambda[0] = 1.0;
    lambda[1] = 1.0;
    Profile { lambda, points }
}

fn hat_restored() -> Profile<4> {
    let Profile { lambda, mut points } = HAT_RESTORED;
    points[1][1] = continued_back(points[0][1], points[0][2], points[1][1]);
    points[2][1] = continued_back(points[1][1], points[1][2], points[2][1]);
    Profile { lambda, points }
}

fn vase_smooth(lambda: [f64; 2]) -> Profile<2> {
    let mut points = VASE.points;
    points[1][1] = continued_back(points[0][1], points[0][2], points[1][1]);
    Profile { lambda, points }
}

/// The point `point`, turned about `joint` so that it lies opposite to `other`.
fn continued_back(other: Plane, joint: Plane, point: Plane) -> Plane {
    let [dx, dy] = [joint[0] - other[0], joint[1] - other[1]];
    let length = (point[0] - joint[0]).hypot(point[1] - joint[1]) / dx.hypot(dy);
    [joint[0] + dx * length, joint[1] + dy * length]
}
