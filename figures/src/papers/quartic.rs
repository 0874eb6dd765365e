//! Figures of "Quartic generalized Bézier surfaces with multiple shape parameters": special patches, joins, a
//! tablecloth and a tent. The paper prints no control points, so those of the figures are our own.

use std::error::Error;
use std::f64::consts::PI;

use basis_runtime::{Contact, Edge, EdgeJoint, EdgePair, ShapeError, Surface, TensorSurface};

use super::families::QuarticBernstein;
use crate::draw::scene::{Point3d, Scene, View};
use crate::figure::{Drawing, Facts, Figure, Picture, number};

type Net = [[Point3d; 4]; 4];
type Patch = TensorSurface<QuarticBernstein, QuarticBernstein, Point3d>;

const SAMPLES: usize = 129;

/// All figures of the paper.
pub(crate) fn figures() -> Vec<Figure> {
    let mut figures = Vec::new();
    for (lambda, gamma) in [(-2.0, -3.0), (-1.0, -3.0), (0.0, -3.0)] {
        let id = format!("quart-fig-three-sided-{}", file(lambda));
        figures.push(Figure::new(
            id,
            format!("A three-sided patch, λ = {}, γᵢ = {}", number(lambda), number(gamma)),
            move || {
                special(
                    &three_sided(),
                    lambda,
                    gamma,
                    &[Edge::UStart],
                    View { azimuth: -50.0, elevation: 32.0 },
                )
            },
        ));
    }
    for gamma in [-2.0, -1.0, 0.0, 1.0] {
        let id = format!("quart-fig-two-sided-{}", file(gamma));
        figures.push(Figure::new(
            id,
            format!("A two-sided patch, λ = −1, γᵢ = {}", number(gamma)),
            move || {
                special(
                    &two_sided(),
                    -1.0,
                    gamma,
                    &[Edge::UStart, Edge::UEnd],
                    View { azimuth: -62.0, elevation: 28.0 },
                )
            },
        ));
    }
    figures
        .push(Figure::new("quart-fig-join-before", "Two patches before the join", || joined(&Join::Before)));
    figures.push(Figure::new("quart-fig-join-after", "The second patch moved into a G1 join", || {
        joined(&Join::After)
    }));
    figures.push(Figure::new(
        "quart-fig-join-lambda",
        "The G1 join with another common λ: still smooth",
        || joined(&Join::OtherLambda),
    ));
    figures.push(Figure::new(
        "quart-fig-join-gamma-published",
        "The G1 join with other γ, as published: no longer smooth",
        || joined(&Join::OtherGamma),
    ));
    figures.push(Figure::new(
        "quart-fig-join-gamma-repaired",
        "The G1 join with other γ, and the second patch moved again: smooth",
        || joined(&Join::OtherGammaMoved),
    ));
    figures.push(Figure::new("quart-fig-join-g2", "The second patch moved into a G2 join", || {
        joined(&Join::SecondOrder)
    }));
    figures.push(Figure::new("quart-fig-tablecloth", "A tablecloth of four patches", tablecloth));
    figures.push(Figure::new("quart-fig-tent", "A tent of six patches", tent));
    figures
}

/// A number as a part of a file name.
fn file(x: f64) -> String {
    if x < 0.0 { format!("m{}", -x) } else { format!("{x}") }
}

fn quartic(shape: f64) -> Result<QuarticBernstein, ShapeError> {
    QuarticBernstein::new(shape)
}

fn net_of(patch: &Patch) -> Net {
    core::array::from_fn(|i| core::array::from_fn(|j| patch.rows()[i].control_points()[j]))
}

fn show_net(scene: &mut Scene, net: &Net) {
    scene.net(&net.iter().map(|row| row.to_vec()).collect::<Vec<_>>());
}

/// The first row is one point.
fn three_sided() -> Net {
    core::array::from_fn(|i| {
        core::array::from_fn(|j| {
            let (r, a) = (i as f64, (j as f64 - 1.5) / 3.0);
            let height = [1.0, 2.9, 2.6, 0.0][i] + if j == 1 || j == 2 { 0.7 * r } else { 0.0 };
            [1.5 * r, 3.0 * r * a, height]
        })
    })
}

/// The first and the last row are one point each: a sail.
fn two_sided() -> Net {
    core::array::from_fn(|i| {
        core::array::from_fn(|j| {
            let x = 2.0 * i as f64;
            if i == 0 || i == 3 {
                return [x, 0.0, 0.0];
            }
            let (y, z) = [(-2.6, 0.0), (-1.2, 2.6), (1.2, 2.6), (2.6, 0.0)][j];
            [x, y, z]
        })
    })
}

fn special(
    net: &Net,
    lambda: f64,
    gamma: f64,
    poles: &[Edge],
    view: View,
) -> Result<Drawing, Box<dyn Error>> {
    let patch = TensorSurface::new(quartic(lambda)?, quartic(gamma)?, *net);
    let mut scene = Scene::default();
    let mesh = scene.surfaces(&[patch])?;
    let facts = Facts::default().with("area", mesh.area()).with("triangles", mesh.triangles.len());
    show_net(&mut scene, net);
    // How far the limit normals at the poles are from those close by.
    let (mut with_normal, mut turn) = (0, 0.0_f64);
    for &pole in poles {
        for k in 0..=16 {
            let (u, v) = patch.domain().on_edge(pole, f64::from(k) / 16.0);
            let beside = if u == 0.0 { 1e-6 } else { 1.0 - 1e-6 };
            if let (Some(a), Some(b)) = (patch.normal(u, v), patch.normal(beside, v)) {
                with_normal += 1;
                turn = turn.max((0..3).map(|c| (a[c] - b[c]).powi(2)).sum::<f64>().sqrt());
            }
        }
    }
    let facts = facts
        .with("poles", poles.len())
        .with("limit normals found", format!("{with_normal} of {}", 17 * poles.len()))
        .with("largest difference of a limit normal from the normal 1e-6 beside it", turn);
    Ok(Drawing {
        picture: Picture::Surfaces(scene, view),
        params: Facts::default().with("λ", lambda).with("γᵢ", gamma).with("net", list(net)),
        facts,
        note: String::from(
            "Where a row of the net is one point, the normal is a limit; it is shaded with it.",
        ),
    })
}

fn list(net: &Net) -> serde_json::Value {
    net.iter().map(|row| row.iter().map(|p| p.to_vec()).collect::<serde_json::Value>()).collect()
}

/// The two patches of the paper's figure of a join, and what happens to them.
enum Join {
    Before,
    After,
    OtherLambda,
    OtherGamma,
    OtherGammaMoved,
    SecondOrder,
}

fn first_net() -> Net {
    const Z: [[f64; 4]; 4] =
        [[0.0, 1.2, 1.6, 0.6], [0.4, 1.9, 2.4, 1.2], [0.2, 1.6, 2.2, 1.5], [-0.4, 0.6, 1.4, 0.9]];
    core::array::from_fn(|i| core::array::from_fn(|j| [i as f64, j as f64, Z[i][j]]))
}

fn second_net() -> Net {
    const Z: [[f64; 4]; 4] =
        [[1.0, 1.4, 0.2, 0.8], [1.6, 0.4, -0.4, 0.5], [1.2, 1.0, -0.6, 0.1], [0.6, 0.9, 0.3, 0.6]];
    core::array::from_fn(|i| core::array::from_fn(|j| [i as f64, 3.6 + j as f64, Z[i][j]]))
}

/// The edges that are joined.
const EDGES: EdgePair = EdgePair::along(Edge::VEnd, Edge::VStart);

fn joined(join: &Join) -> Result<Drawing, Box<dyn Error>> {
    let (first_gammas, second_gammas) = ([0.5, 0.0, 0.3, -0.5], [-0.5, 0.3, 0.8, 0.0]);
    let (other_first, other_second) = ([1.0, -2.0, -1.0, 0.5], [0.9, -0.5, 0.0, 0.6]);
    let factor = 0.9;
    let patch = |lambda: f64, gammas: [f64; 4], net: Net| -> Result<Patch, ShapeError> {
        let [a, b, c, d] = gammas.map(quartic);
        Ok(TensorSurface::with_rows(quartic(lambda)?, [a?, b?, c?, d?], net))
    };
    let first = patch(0.5, first_gammas, first_net())?;
    let draft = patch(0.5, second_gammas, second_net())?;
    let next = first.continued(EDGES, Contact::Scaled { order: 1, f: factor }, &draft)?;
    let (lambda, gammas, [first, second], note) = match join {
        Join::Before => (
            0.5,
            [first_gammas, second_gammas],
            [first, draft],
            "Two patches that do not meet; the edge v = 1 of the first belongs to the edge v = 0 of the second.",
        ),
        Join::After => (
            0.5,
            [first_gammas, second_gammas],
            [first, next],
            "The first two columns of the second net are replaced (the paper's steps, Theorem 1).",
        ),
        Join::OtherLambda => (
            -2.0,
            [first_gammas, second_gammas],
            [patch(-2.0, first_gammas, net_of(&first))?, patch(-2.0, second_gammas, net_of(&next))?],
            "The same nets with another λ for both: the condition of the join does not contain λ.",
        ),
        Join::OtherGamma => (
            0.5,
            [other_first, other_second],
            [patch(0.5, other_first, net_of(&first))?, patch(0.5, other_second, net_of(&next))?],
            "The same nets with other γ. The paper says that parameters may be changed after the join; the condition \
             contains γ, and the join has a crease.",
        ),
        Join::OtherGammaMoved => {
            let first = patch(0.5, other_first, net_of(&first))?;
            let next = first.continued(
                EDGES,
                Contact::Scaled { order: 1, f: factor },
                &patch(0.5, other_second, net_of(&next))?,
            )?;
            (
                0.5,
                [other_first, other_second],
                [first, next],
                "With other γ the second column of the second net has to be computed again; then the join is smooth.",
            )
        }
        Join::SecondOrder => (
            0.5,
            [first_gammas, second_gammas],
            [first, first.continued(EDGES, Contact::Scaled { order: 2, f: factor }, &draft)?],
            "Three columns are replaced (Theorem 4): the curvatures agree as well.",
        ),
    };
    let mut scene = Scene::default();
    let parts = [first, second];
    scene.surfaces(&parts)?;
    for part in &parts {
        show_net(&mut scene, &net_of(part));
    }
    let measured = first.joint(EdgePair::along(Edge::VEnd, Edge::VStart), &second, SAMPLES);
    Ok(Drawing {
        picture: Picture::Surfaces(scene, View { azimuth: -28.0, elevation: 30.0 }),
        params: Facts::default()
            .with("λ", lambda)
            .with("γ of the first", gammas[0].to_vec())
            .with("γ of the second", gammas[1].to_vec())
            .with("f", factor)
            .with("first net", list(&net_of(&first)))
            .with("second net", list(&net_of(&second))),
        facts: continuity(&[measured]),
        note: note.to_owned(),
    })
}

/// The worst of the measured edges.
fn continuity(edges: &[EdgeJoint<f64>]) -> Facts {
    let most = |of: fn(&EdgeJoint<f64>) -> f64| edges.iter().map(of).fold(0.0, f64::max);
    let orders: Vec<String> = edges
        .iter()
        .map(|edge| {
            edge.geometric_order(1e-9, 1e-7, 1e-6).map_or_else(|| String::from("gap"), |k| format!("G{k}"))
        })
        .collect();
    Facts::default()
        .with("edges", edges.len())
        .with("measured", orders)
        .with("largest gap", most(|e| e.gap))
        .with("largest angle in degrees", most(|e| e.angle.to_degrees()))
        .with("largest curvature difference", most(|e| e.curvature))
}

/// Four patches over the quarters of a square table: flat on it, hanging down over its edges, with pleats at the
/// corners.
fn tablecloth() -> Result<Drawing, Box<dyn Error>> {
    let (lambda, gamma) = (0.6, 0.6);
    // One net of 7 × 7 points for the whole cloth; the quarters share its middle lines. The points next to these lie
    // straight across, so that the joins are G1 with f = 1.
    let quarter = |x: f64, y: f64| -> Result<Patch, ShapeError> {
        let net = core::array::from_fn(|i| {
            core::array::from_fn(|j| {
                // Patches run in the direction of x and y; those on the negative side end in the middle.
                let (a, b) = (if x > 0.0 { i } else { 3 - i }, if y > 0.0 { j } else { 3 - j });
                let [px, py, pz] = cloth(a, b);
                [x * px, y * py, pz]
            })
        });
        Ok(TensorSurface::new(quartic(lambda)?, quartic(gamma)?, net))
    };
    let parts = [quarter(1.0, 1.0)?, quarter(-1.0, 1.0)?, quarter(-1.0, -1.0)?, quarter(1.0, -1.0)?];
    let edges = [
        parts[1].joint(EdgePair::along(Edge::UEnd, Edge::UStart), &parts[0], SAMPLES),
        parts[2].joint(EdgePair::along(Edge::UEnd, Edge::UStart), &parts[3], SAMPLES),
        parts[3].joint(EdgePair::along(Edge::VEnd, Edge::VStart), &parts[0], SAMPLES),
        parts[2].joint(EdgePair::along(Edge::VEnd, Edge::VStart), &parts[1], SAMPLES),
    ];
    let drawing = assembled(&parts, &edges, [lambda, gamma], View { azimuth: -62.0, elevation: 30.0 })?;
    let note = String::from("Four patches that meet in the middle of the table: two u–u and two v–v joins.");
    Ok(Drawing { note, ..drawing })
}

/// Patches with the same shape values beside each other, and their nets; the note is left empty.
fn assembled(
    parts: &[Patch],
    edges: &[EdgeJoint<f64>],
    [lambda, gamma]: [f64; 2],
    view: View,
) -> Result<Drawing, Box<dyn Error>> {
    let mut scene = Scene::default();
    let mesh = scene.surfaces(parts)?;
    let facts = continuity(edges).with("area", mesh.area()).with("triangles", mesh.triangles.len());
    let mut nets = Vec::with_capacity(parts.len());
    for part in parts {
        let net = net_of(part);
        show_net(&mut scene, &net);
        nets.push(list(&net));
    }
    Ok(Drawing {
        picture: Picture::Surfaces(scene, view),
        params: Facts::default().with("λ", lambda).with("γᵢ", gamma).with("nets", nets),
        facts,
        note: String::new(),
    })
}

/// A point of a quarter of the cloth, counted from the middle.
fn cloth(a: usize, b: usize) -> Point3d {
    const ACROSS: [f64; 4] = [0.0, 1.5, 2.9, 3.0];
    const HEM: f64 = -2.4;
    match (a, b) {
        // The pleat at the corner: the tip hangs out and low, its neighbours are drawn in.
        (3, 3) => [3.7, 3.7, HEM - 0.4],
        (3, 2) => [2.6, 3.2, HEM],
        (2, 3) => [3.2, 2.6, HEM],
        (2, 2) => [3.2, 3.2, 0.2],
        (3, _) => [ACROSS[3] + 0.3, ACROSS[b], HEM],
        (_, 3) => [ACROSS[a], ACROSS[3] + 0.3, HEM],
        _ => [ACROSS[a], ACROSS[b], 0.0],
    }
}

/// Six patches from the top of a tent to the ground.
fn tent() -> Result<Drawing, Box<dyn Error>> {
    let (lambda, gamma) = (0.0, -1.5);
    let sector = 2.0 * PI / 6.0;
    let net = |k: usize| -> Net {
        core::array::from_fn(|i| {
            core::array::from_fn(|j| {
                let (radius, height) = [(0.0, 5.2), (0.7, 3.0), (1.9, 1.5), (4.4, 0.0)][i];
                let angle = sector * (k as f64 + j as f64 / 3.0);
                // Between the poles, which stand at the seams, the cloth sags inwards.
                let sag = if j == 1 || j == 2 { 0.94 - 0.05 * i as f64 } else { 1.06 };
                let sag = if i == 3 && (j == 1 || j == 2) { 0.90 } else { sag };
                [radius * sag * angle.cos(), radius * sag * angle.sin(), height]
            })
        })
    };
    let parts = tent_ring(lambda, gamma, net)?;
    let edges: Vec<EdgeJoint<f64>> = (0..6)
        .map(|k| parts[k].joint(EdgePair::along(Edge::VEnd, Edge::VStart), &parts[(k + 1) % 6], SAMPLES))
        .collect();
    let drawing = assembled(&parts, &edges, [lambda, gamma], View { azimuth: -52.0, elevation: 22.0 })?;
    Ok(Drawing { note: String::from("Six three-sided patches joined G1 around the top."), ..drawing })
}

/// The patches with their seams smoothed: at each seam the neighbouring columns are moved to both sides of it equally.
fn tent_ring(lambda: f64, gamma: f64, net: impl Fn(usize) -> Net) -> Result<Vec<Patch>, Box<dyn Error>> {
    let mut nets: Vec<Net> = (0..6).map(net).collect();
    for k in 0..6 {
        let next = (k + 1) % 6;
        let (mut before, mut after) = (nets[k], nets[next]);
        for (row, next_row) in before.iter_mut().zip(&mut after) {
            let seam = row[3];
            next_row[0] = seam;
            let half = [0, 1, 2].map(|c| 0.5 * (next_row[1][c] - row[2][c]));
            row[2] = [0, 1, 2].map(|c| seam[c] - half[c]);
            next_row[1] = [0, 1, 2].map(|c| seam[c] + half[c]);
        }
        (nets[k], nets[next]) = (before, after);
    }
    Ok(nets
        .into_iter()
        .map(|net| Ok(TensorSurface::new(quartic(lambda)?, quartic(gamma)?, net)))
        .collect::<Result<_, ShapeError>>()?)
}
