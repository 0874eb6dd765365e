//! Meshes written to files are the meshes, as other programs read them.

#[cfg(any(feature = "gltf", feature = "stl"))]
use basis_runtime::MeshError;
use basis_runtime::{Curve, Mesh, SurfaceOfRevolution, Tessellation};

use crate::families::QuarticBernstein;

fn egg() -> Mesh<f64> {
    let points = [[-1.0, 0.0], [-1.0, 1.0], [1.0, 1.0], [1.0, 0.0]];
    let curve = Curve::new(QuarticBernstein::new(0.5).unwrap(), points);
    let surface = SurfaceOfRevolution::about_x(&curve, 2.0 * core::f64::consts::PI).unwrap();
    Tessellation::new(0.05).unwrap().with(&surface).mesh().unwrap()
}

#[test]
#[cfg(feature = "obj")]
fn obj() {
    let mesh = egg();
    let mut text = Vec::new();
    mesh.write_obj(&mut text).unwrap();
    let text = String::from_utf8(text).unwrap();
    let of = |key: &str| -> Vec<Vec<f64>> {
        let lines = text.lines().filter_map(|line| line.strip_prefix(key)?.strip_prefix(' '));
        lines.map(|line| line.split(' ').map(|number| number.parse().unwrap()).collect()).collect()
    };
    assert_eq!(of("v"), mesh.positions.iter().map(|p| p.to_vec()).collect::<Vec<_>>());
    assert_eq!(of("vn"), mesh.vertices.iter().map(|v| v.normal.to_vec()).collect::<Vec<_>>());
    assert_eq!(of("vt"), mesh.vertices.iter().map(|v| v.uv.to_vec()).collect::<Vec<_>>());
    let faces: Vec<[u32; 3]> = text
        .lines()
        .filter_map(|line| line.strip_prefix("f "))
        .map(|line| {
            let corners: Vec<[u32; 3]> = line
                .split(' ')
                .map(|corner| {
                    let indices: Vec<u32> = corner.split('/').map(|index| index.parse().unwrap()).collect();
                    [indices[0], indices[1], indices[2]]
                })
                .collect();
            assert!(
                corners.iter().all(|[p, t, n]| t == n && mesh.vertices[*t as usize - 1].position + 1 == *p)
            );
            [corners[0][1] - 1, corners[1][1] - 1, corners[2][1] - 1]
        })
        .collect();
    assert_eq!(faces, mesh.triangles);
}

#[test]
#[cfg(feature = "stl")]
fn stl() {
    let mesh = egg();
    let mut bytes = Vec::new();
    mesh.write_stl(&mut bytes).unwrap();
    assert_eq!(bytes.len(), 84 + 50 * mesh.triangles.len());
    let read = stl_io::read_stl(&mut std::io::Cursor::new(bytes)).unwrap();
    assert_eq!((read.faces.len(), read.vertices.len()), (mesh.triangles.len(), mesh.positions.len()));
    read.validate().unwrap(); // without cracks
    let mut empty = Vec::new();
    Mesh::<f32>::default().write_stl(&mut empty).unwrap();
    assert_eq!(empty.len(), 84);
}

#[test]
#[cfg(feature = "gltf")]
fn gltf() {
    let mesh = egg();
    let mut bytes = Vec::new();
    mesh.write_gltf(&mut bytes).unwrap();
    let file = gltf::Gltf::from_slice(&bytes).unwrap(); // validates
    let blob = file.blob.as_deref().unwrap();
    let primitive = file.meshes().next().unwrap().primitives().next().unwrap();
    let indices = primitive.indices().unwrap();
    assert_eq!(indices.count(), 3 * mesh.triangles.len());
    let view = indices.view().unwrap();
    let read: Vec<u32> = blob[view.offset()..view.offset() + view.length()]
        .chunks(4)
        .map(|four| u32::from_le_bytes(four.try_into().unwrap()))
        .collect();
    assert_eq!(read, mesh.triangles.iter().flatten().copied().collect::<Vec<_>>());
    let positions = primitive.get(&gltf::Semantic::Positions).unwrap();
    assert_eq!(positions.count(), mesh.vertices.len());
    let view = positions.view().unwrap();
    for (vertex, bytes) in mesh.vertices.iter().zip(blob[view.offset()..].chunks(12)) {
        for (component, four) in mesh.positions[vertex.position as usize].iter().zip(bytes.chunks(4)) {
            assert_eq!(f32::from_le_bytes(four.try_into().unwrap()), *component as f32);
        }
    }
    assert_eq!(file.scenes().next().unwrap().nodes().count(), 1);

    let mut empty = Vec::new();
    Mesh::<f64>::default().write_gltf(&mut empty).unwrap();
    assert!(gltf::Gltf::from_slice(&empty).is_ok());
}

#[test]
#[cfg(any(feature = "gltf", feature = "stl"))]
fn too_large_for_single_precision() {
    let mut mesh = egg();
    mesh.positions[3][1] = 1e40;
    let refused = |result: std::io::Result<()>| {
        let error = result.unwrap_err().into_inner().unwrap();
        assert_eq!(error.downcast_ref(), Some(&MeshError::Single { position: 3 }));
    };
    #[cfg(feature = "gltf")]
    refused(mesh.write_gltf(Vec::new()));
    #[cfg(feature = "stl")]
    refused(mesh.write_stl(std::io::Cursor::new(Vec::new())));
}
