//! Takes the Rust out of the README and of a page of the guide, and makes a function of each block: what the text around
//! the block takes for granted, the block as it stands, and what has to be true after it.

use std::fmt::Write as _;
use std::path::PathBuf;
use std::{env, fs};

/// A block of a page.
struct Block {
    /// The function.
    name: &'static str,
    /// Something that only this block says.
    says: &'static str,
    /// What the text takes for granted.
    before: &'static str,
    /// What has to be true afterwards.
    after: &'static str,
}

const BLOCKS: [Block; 4] = [
    Block {
        name: "curves",
        says: "curve_after(",
        before: "",
        after: "
            assert!(values.iter().all(|value| *value >= 0.0));
            assert!(point.iter().chain(&velocity).chain(&acceleration).all(|x| x.is_finite()));
            assert_eq!(next.start(), curve.end());",
    },
    Block {
        name: "triangles",
        says: "TriangularPatch::new(",
        before: "
            let lattice = (0..=5_u8).flat_map(|i| (0..=5 - i).map(move |j| [f64::from(i), f64::from(j)]));
            let all: Vec<[f64; 3]> = lattice.map(|[x, y]| [x, y, 0.1 * x * y]).collect();
            let points: [[f64; 3]; 21] = all.try_into().expect(\"21 points\");
            let draft = TriangularPatch::new(TriangularII::new(1.0, 1.0)?, points);",
        after: "
            assert!(point.iter().all(|x| x.is_finite()) && normal.is_some());
            assert_eq!(edge.control_points().len(), 6);
            assert!(next.edge_curve(TriangleEdge::U).start().iter().all(|x| x.is_finite()));",
    },
    Block {
        name: "surfaces",
        says: "TensorSurface::with_rows(",
        before: "
            use basis_runtime::{
                BoundedSurface as _, Curve, Surface, SurfaceOfRevolution, TensorSurface, Tessellation, basis,
            };
            use std::f64::consts::PI;
            use std::fs::File;
            basis!(library \"quartic\");
            let family = QuarticBernstein::new(0.5)?;
            let gammas = [family, QuarticBernstein::new(-1.0)?, family, family];
            let net = [0.0, 1.0, 2.0, 3.0].map(|x: f64| [0.0, 1.0, 2.0, 3.0].map(|y: f64| [x, y, x * y / 4.0]));
            let curve = Curve::new(family, [[0.0, 1.0], [1.0, 2.0], [2.0, 0.5], [3.0, 1.0]]);",
        after: "
            assert!(normal.is_some() && nearest.distance.is_finite() && !mesh.triangles.is_empty());
            assert_eq!(hits.map(|hits| hits.len()), Some(2));
            assert!(std::fs::read(\"vase.glb\")?.starts_with(b\"glTF\"));",
    },
    Block {
        name: "splices",
        says: "right.continued_within",
        before: "
            use basis_runtime::bspline::{BSplineSurface, KnotVector, Net};
            let patch = |knots: KnotVector<f64>, from: f64| -> Result<_, Box<dyn std::error::Error>> {
                let v = KnotVector::uniform(3, 3)?;
                let (at_u, at_v) = (knots.greville(), v.greville());
                let grid = Net::from_fn(at_u.len(), at_v.len(), |i, j| {
                    let [x, y] = [from + at_u[i], at_v[j]];
                    [x, y, 0.3 * (x * x + y)]
                })?;
                Ok(BSplineSurface::fit([knots, v], [&at_u, &at_v], &grid)?)
            };
            let left = patch(KnotVector::uniform(3, 4)?, -1.0)?;
            let right = patch(KnotVector::uniform(3, 2)?, 0.0)?;",
        after: "
            use basis_runtime::Surface;
            assert_eq!(right.joint(edges, &curved, 17).geometric_order(1e-12, 1e-12, 1e-9), Some(2));
            assert!(joined.joint.gap <= 1e-5 && joined.joint.angle <= 1e-4);",
    },
];

/// The page of the guide on sines and cosines.
const ANGLES: [Block; 1] = [Block {
    name: "angles",
    says: "to_rational_bezier()",
    before: "
        use basis_runtime::ParametricCurve as _;",
    after: "
        assert!((point[0] - 0.7_f64.sin()).abs() < 1e-15 && (point[1] - 0.7_f64.cos()).abs() < 1e-15);
        assert!((velocity[0] - 0.7_f64.cos()).abs() < 1e-15);
        assert!((length - core::f64::consts::FRAC_PI_2).abs() < 1e-9);
        assert_eq!([bezier.start(), bezier.end()], [[0.0, 1.0], [1.0, 0.0]]);",
}];

/// The blocks of a page in a language.
fn listings<'a>(text: &'a str, language: &str) -> Vec<&'a str> {
    let start = format!("\n```{language}");
    let code = |rest: &'a str| rest.split_once('\n')?.1.split("\n```").next();
    text.split(start.as_str()).skip(1).filter_map(code).collect()
}

/// The functions of the blocks of a page, after what all of them build on.
fn functions(page: &str, blocks: &[Block], given: &dyn Fn(&str) -> String) -> String {
    println!("cargo::rerun-if-changed={page}");
    let text = fs::read_to_string(page).expect("the page can be read");
    let found = listings(&text, "rust");
    assert!(!text.contains("```rust,"), "a block of {page} is marked so that nothing compiles it");
    assert_eq!(
        found.len(),
        blocks.len(),
        "tests/readme/build.rs has to say what the blocks of {page} build on"
    );
    let mut code = String::new();
    for (block, shown) in blocks.iter().zip(found) {
        assert!(shown.contains(block.says), "`{}` is not in this block:\n{shown}", block.says);
        let (Block { name, before, after, .. }, given) = (block, given(&text));
        write!(
            code,
            "pub(crate) fn {name}() -> Result<(), Box<dyn std::error::Error>> {{{given}{before}\n{shown}\n{after}\n Ok(())\n}}\n"
        )
        .expect("a string takes everything");
    }
    code
}

fn main() {
    let out = PathBuf::from(env::var_os("OUT_DIR").expect("Cargo sets it"));
    println!("cargo::rerun-if-changed=build.rs");
    // The first family of the page is the one that its Rust is about.
    let family = |text: &str| format!("\nbasis_runtime::basis! {{\n{}\n}}\n", listings(text, "basis")[0]);
    let code = functions("README.md", &BLOCKS, &|_| String::new())
        + &functions("../../guide/src/angles.md", &ANGLES, &family);
    fs::write(out.join("readme.rs"), code).expect("the folder can be written");

    // Beside the code, as the README names them.
    fs::create_dir_all(out.join("specs")).expect("a folder can be made");
    for (name, text) in basis_specs::SPECS.iter().filter(|(name, _)| !name.contains('/')) {
        fs::write(out.join("specs").join(format!("{name}.basis")), text).expect("the folder can be written");
    }
}
