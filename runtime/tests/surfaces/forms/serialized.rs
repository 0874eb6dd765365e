//! Surfaces that are written and read back are the same. JSON is read up to the last digit, so the numbers are short.

use basis_runtime::{
    Curvature, Curve, Mesh, RevolutionPatch, Surface, SurfaceOfRevolution, TensorSurface, Tessellation,
};
use serde::Serialize;
use serde::de::DeserializeOwned;

use crate::families::{Cubic, FiveParameters, QuarticBernstein, graph};

type Swept = SurfaceOfRevolution<Cubic, [f64; 3]>;

fn again<T: Serialize + DeserializeOwned>(value: &T) -> T {
    serde_json::from_str(&serde_json::to_string(value).unwrap()).unwrap()
}

#[test]
fn tensor_surfaces() {
    let quartic = |shape| QuarticBernstein::new(shape).unwrap();
    let net = core::array::from_fn(|i| core::array::from_fn(|j| [i as f64, j as f64, (i * j) as f64]));
    let surface: FiveParameters<[f64; 3]> =
        TensorSurface::with_rows(quartic(0.5), [0.25, -1.0, -2.5, 1.0].map(quartic), net);
    assert_eq!(again(&surface), surface);
    let text = serde_json::to_string(&surface).unwrap();
    // A row too few, and a shape value out of range.
    let mut value: serde_json::Value = serde_json::from_str(&text).unwrap();
    value["rows"].as_array_mut().unwrap().pop();
    assert!(serde_json::from_value::<FiveParameters<[f64; 3]>>(value).is_err());
    assert!(serde_json::from_str::<FiveParameters<[f64; 3]>>(&text.replace("-2.5", "-3.5")).is_err());
}

#[test]
fn surfaces_of_revolution_and_what_follows_from_surfaces() {
    let curve = Curve::new(Cubic::new(), [[0.0, 1.0], [1.0, 2.0], [2.0, 2.0], [3.0, 1.0]]);
    let surface: Swept = SurfaceOfRevolution::about_x(&curve, 4.0).unwrap();
    assert_eq!(again(&surface), surface);
    let patch: RevolutionPatch<Cubic, [f64; 3]> = surface.to_rational_patches()[1];
    let (read, point) = (again(&patch).eval(0.25, 0.75), patch.eval(0.25, 0.75));
    assert!(read.iter().zip(point).all(|(a, b)| (a - b).abs() < 1e-15));
    let saddle = graph(|u, v| u * v);
    let curvature: Curvature<[f64; 3]> = graph(|u, v| u * u - v * v).curvature(0.0, 0.0).unwrap();
    assert_eq!(again(&curvature), curvature);
    let mesh: Mesh<f64> = Tessellation::new(0.5).unwrap().with(&saddle).mesh().unwrap();
    assert_eq!(again(&mesh).triangles, mesh.triangles);
}
