//! A vase: a curve that turns about an axis, as triangles in a glTF file.
//!
//! `cargo run --example vase --features gltf -- vase.glb` writes the file, which any viewer of 3D models opens; without
//! a name it writes nothing.

use std::error::Error;
use std::f64::consts::PI;
use std::fs::File;

use basis_runtime::{Bezier, SurfaceOfRevolution, Tessellation};

fn main() -> Result<(), Box<dyn Error>> {
    vase(std::env::args().nth(1).as_deref())
}

fn vase(file: Option<&str>) -> Result<(), Box<dyn Error>> {
    // The wall from the foot to the lip, (height, radius); the foot is a disk.
    let wall = Bezier::from_points([[0.0, 0.5], [0.5, 1.4], [1.2, 0.1], [2.0, 0.6]]);
    let foot = Bezier::from_points([[0.0, 0.0], [0.0, 0.5]]);
    let wall = SurfaceOfRevolution::about_x(&wall, 2.0 * PI)?;
    let foot = SurfaceOfRevolution::about_x(&foot, 2.0 * PI)?;

    // Nowhere farther from the surface than 1/500, and without a crack where wall and foot meet.
    let mesh = Tessellation::new(0.002)?.with(&wall).with(&foot).mesh()?;
    println!("{} triangles, area {:.4}", mesh.triangles.len(), mesh.area());
    println!("the lip is open: {} edges without a neighbour", mesh.boundary().len());
    assert!(mesh.is_oriented() && !mesh.is_closed());
    // Every edge that has one triangle only lies on the lip.
    let on_lip = |&position: &u32| (mesh.positions[position as usize][0] - 2.0).abs() < 1e-12;
    assert!(mesh.boundary().iter().flatten().all(on_lip));

    if let Some(name) = file {
        mesh.write_gltf(File::create(name)?)?;
        println!("written to {name}");
    }
    let mut bytes = Vec::new();
    mesh.write_gltf(&mut bytes)?;
    assert!(bytes.starts_with(b"glTF"));
    Ok(())
}

#[test]
fn runs() -> Result<(), Box<dyn Error>> {
    vase(None)
}
