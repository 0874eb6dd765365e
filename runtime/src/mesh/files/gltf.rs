//! glTF 2.0 in its binary form (GLB): indexed triangles with normals and texture coordinates, in single precision.

use std::borrow::ToOwned;
use std::io::{self, Write};

use alloc::borrow::Cow;
use alloc::collections::BTreeMap;
use alloc::vec::Vec;

use gltf::binary::{Glb, Header};
use gltf::json::accessor::{ComponentType, GenericComponentType, Type};
use gltf::json::buffer::{Target, View};
use gltf::json::mesh::{Mode, Primitive, Semantic};
use gltf::json::validation::{Checked, USize64};
use gltf::json::{Accessor, Index, Root};

use crate::Scalar;
use crate::mesh::Mesh;

impl<S: Scalar> Mesh<S> {
    /// Writes the mesh as a binary glTF 2.0 file (`.glb`), in single precision, with normals and texture coordinates.
    ///
    /// The material is plain and shows both sides, since surfaces may be open.
    ///
    /// # Errors
    /// When the writer fails, if an index does not exist, see [`check`](Self::check), and if a position is too large
    /// for single precision, with a [`MeshError`](crate::MeshError) inside.
    pub fn write_gltf(&self, writer: impl Write) -> io::Result<()> {
        let positions = self
            .check()
            .and_then(|()| self.single_positions())
            .map_err(|error| io::Error::new(io::ErrorKind::InvalidData, error))?;
        let mut file = File::default();
        if !self.triangles.is_empty() {
            file.add(self, &positions);
        }
        let json = file.root.to_vec().map_err(io::Error::other)?;
        let header = Header { magic: *b"glTF", version: 2, length: 0 }; // the length is found when it is written
        let glb = Glb { header, json: Cow::Owned(json), bin: Some(Cow::Owned(file.bytes)) };
        glb.to_writer(writer).map_err(io::Error::other)
    }
}

#[derive(Default)]
struct File {
    root: Root,
    bytes: Vec<u8>,
}

impl File {
    fn add<S: Scalar>(&mut self, mesh: &Mesh<S>, positions: &[[f32; 3]]) {
        use gltf::json;

        let single = |value: S| value.to_f64() as f32;
        let positions: Vec<[f32; 3]> = mesh.vertices.iter().map(|v| positions[v.position as usize]).collect();
        let normals: Vec<[f32; 3]> = mesh.vertices.iter().map(|v| unit(v.normal.map(single))).collect();
        let textures: Vec<[f32; 2]> = mesh.vertices.iter().map(|v| v.uv.map(single)).collect();
        let indices: Vec<[u32; 1]> = mesh.triangles.iter().flatten().map(|&index| [index]).collect();

        let attributes = BTreeMap::from([
            (Checked::Valid(Semantic::Positions), self.floats(&positions, Type::Vec3)),
            (Checked::Valid(Semantic::Normals), self.floats(&normals, Type::Vec3)),
            (Checked::Valid(Semantic::TexCoords(0)), self.floats(&textures, Type::Vec2)),
        ]);
        let bytes = indices.iter().flatten().flat_map(|index| index.to_le_bytes()).collect();
        let indices =
            self.accessor(bytes, indices.len(), ComponentType::U32, Type::Scalar, Target::ElementArrayBuffer);
        let material = self.root.push(json::Material { double_sided: true, ..json::Material::default() });
        let length = self.bytes.len();
        self.root.push(json::Buffer {
            byte_length: USize64::from(length),
            name: None,
            uri: None,
            extensions: None,
            extras: json::Extras::default(),
        });
        let mesh = self.root.push(json::Mesh {
            extensions: None,
            extras: json::Extras::default(),
            name: None,
            primitives: alloc::vec![Primitive {
                attributes,
                extensions: None,
                extras: json::Extras::default(),
                indices: Some(indices),
                material: Some(material),
                mode: Checked::Valid(Mode::Triangles),
                targets: None,
            }],
            weights: None,
        });
        let node = self.root.push(json::Node { mesh: Some(mesh), ..json::Node::default() });
        let scene = self.root.push(json::Scene {
            extensions: None,
            extras: json::Extras::default(),
            name: None,
            nodes: alloc::vec![node],
        });
        self.root.scene = Some(scene);
        self.root.asset.generator = Some("basis-runtime".to_owned());
    }

    /// One attribute of all vertices.
    fn floats<const N: usize>(&mut self, rows: &[[f32; N]], of: Type) -> Index<Accessor> {
        let bytes = rows.iter().flatten().flat_map(|c| c.to_le_bytes()).collect();
        let index = self.accessor(bytes, rows.len(), ComponentType::F32, of, Target::ArrayBuffer);
        let extreme = |of: fn(f32, f32) -> f32, start: f32| {
            let extreme: [f32; N] = core::array::from_fn(|k| rows.iter().fold(start, |a, row| of(a, row[k])));
            Some(gltf::json::Value::from(extreme.to_vec()))
        };
        if let Some(accessor) = self.root.accessors.get_mut(index.value()) {
            accessor.min = extreme(f32::min, f32::INFINITY);
            accessor.max = extreme(f32::max, f32::NEG_INFINITY);
        }
        index
    }

    fn accessor(
        &mut self,
        bytes: Vec<u8>,
        count: usize,
        component: ComponentType,
        of: Type,
        target: Target,
    ) -> Index<Accessor> {
        // All components have four bytes, so that every view begins where it must.
        let view = self.root.push(View {
            buffer: Index::new(0),
            byte_length: USize64::from(bytes.len()),
            byte_offset: Some(USize64::from(self.bytes.len())),
            byte_stride: None,
            name: None,
            target: Some(Checked::Valid(target)),
            extensions: None,
            extras: gltf::json::Extras::default(),
        });
        self.bytes.extend(bytes);
        self.root.push(Accessor {
            buffer_view: Some(view),
            byte_offset: Some(USize64(0)),
            count: USize64::from(count),
            component_type: Checked::Valid(GenericComponentType(component)),
            extensions: None,
            extras: gltf::json::Extras::default(),
            type_: Checked::Valid(of),
            min: None,
            max: None,
            name: None,
            normalized: false,
            sparse: None,
        })
    }
}

/// Of length one in single precision too; the format allows no zero normals.
fn unit(normal: [f32; 3]) -> [f32; 3] {
    crate::vector::direction(normal).unwrap_or([0.0, 0.0, 1.0])
}
