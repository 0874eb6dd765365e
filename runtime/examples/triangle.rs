//! A patch over a triangle, with a family that is written in place.
//!
//! `cargo run --example triangle` prints points, normals and the nearest point of a dome over three corners.

use basis_runtime::{TriangularPatch, basis};

basis! {
    /// The quadratic Bernstein basis of a triangle.
    family Dome {
        domain triangle (u, v, w);
        b[2,0,0] = u^2;
        b[0,2,0] = v^2;
        b[0,0,2] = w^2;
        b[1,1,0] = 2*u*v;
        b[1,0,1] = 2*u*w;
        b[0,1,1] = 2*v*w;
        prove partition_of_unity;
        prove nonnegative;
        prove independent;
    }
}

fn main() {
    // In lexicographic order of the indices: (0,0,2), (0,1,1), (0,2,0), (1,0,1), (1,1,0), (2,0,0).
    let points = [
        [0.0, 0.0, 0.0],
        [0.0, 0.5, 0.5],
        [0.0, 1.0, 0.0],
        [0.5, 0.0, 0.5],
        [0.5, 0.5, 0.5],
        [1.0, 0.0, 0.0],
    ];
    let dome = TriangularPatch::new(Dome::new(), points);
    for [u, v] in [[0.0_f64, 0.0], [0.5, 0.0], [0.25, 0.25], [1.0 / 3.0, 1.0 / 3.0]] {
        let [x, y, z] = dome.eval_at([u, v, 1.0 - u - v]);
        let normal = dome.normal(u, v).map(|n| n.map(|c| format!("{c:6.3}")).join(" "));
        println!("({x:.3}, {y:.3}, {z:.3})   normal {}", normal.as_deref().unwrap_or("none"));
        // The height of this dome is uv + uw + vw.
        assert!((z - (u * v + (u + v) * (1.0 - u - v))).abs() < 1e-15);
    }
    if let Some(found) = dome.nearest([0.3, 0.3, 2.0], 1e-9) {
        println!(
            "the nearest point to (0.3, 0.3, 2) is {:.6} away, at least {:.6}",
            found.distance, found.at_least
        );
        assert!(found.distance - found.at_least <= 1e-9);
    }
}

#[test]
fn runs() {
    main();
}
