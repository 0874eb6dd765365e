//! The bonnet of "A smooth splicing method for B-spline surfaces": the right patch is deformed through four points, the
//! left one follows.

use std::error::Error;

use super::bonnet::{Bonnet, bonnet};
use crate::draw::scene::{Point3d, Scene, View};
use crate::figure::{Drawing, Facts, Figure, Picture};

/// All figures of the paper, and the state between them.
pub(crate) fn figures() -> Vec<Figure> {
    vec![
        Figure::new("spl-ex-before", "The bonnet before, with the four constraint points", || {
            draw(Stage::Before)
        }),
        Figure::new("spl-ex-apart", "The right patch deformed, the left one not yet following", || {
            draw(Stage::Apart)
        }),
        Figure::new("spl-ex-after", "The bonnet after: the left patch follows", || draw(Stage::After)),
    ]
}

#[derive(Clone, Copy)]
enum Stage {
    Before,
    Apart,
    After,
}

fn draw(stage: Stage) -> Result<Drawing, Box<dyn Error>> {
    let Bonnet { before, constraints, apart, after, facts } = bonnet()?;
    let of = |name: &str| facts.iter().find(|(fact, _)| *fact == name).map(|(_, value)| *value);
    let (patches, names, note) = match stage {
        Stage::Before => (
            before,
            ["gap before", "angle before"],
            "Two cubic patches with different knots along the centre line, spliced; the dots are the points through which the \
             right patch is to pass.",
        ),
        Stage::Apart => (
            apart,
            ["gap without splicing", "angle without splicing"],
            "The right patch passes through the points and leaves the left one behind.",
        ),
        Stage::After => (
            after,
            ["gap", "angle"],
            "The edge row of the left patch, and the one beside it, are recomputed from the right patch.",
        ),
    };
    let mut scene = Scene::default();
    let mesh = scene.surfaces(&patches)?;
    let mut measured = Facts::default()
        .with("gap", of(names[0]))
        .with("angle", of(names[1])) // in radians
        .with("area", mesh.area())
        .with("triangles", mesh.triangles.len());
    if matches!(stage, Stage::Apart | Stage::After) {
        measured = measured.with("distance from the constraints", of("distance from the constraints"));
    }
    scene.inside_out();
    scene.points(&constraints);
    Ok(Drawing {
        picture: Picture::Surfaces(scene, View { azimuth: -40.0, elevation: 30.0 }),
        params: Facts::default().with(
            "constraints",
            constraints.iter().map(|p: &Point3d| p.to_vec()).collect::<serde_json::Value>(),
        ),
        facts: measured,
        note: note.to_owned(),
    })
}
