//! Patches on simplices and boxes, their indices, and bound forms.

use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::{Coefficients, Components, Elements, read_shape, write_shape};
use crate::{
    BernsteinForm, BoxBasis, BoxPatch, EndpointForm, Point, ProductBasis, ProductPatch, Scalar, SimplexBasis,
    SimplexIndex, SimplexPatch, TriangularBernsteinBasis,
};

/// A patch as it is written: its basis and its control points.
macro_rules! patch {
    ($patch:ident, $basis:ident, $name:literal, $expecting:literal) => {
        const _: () = {
            #[derive(Serialize)]
            #[serde(rename = $name)]
            struct Written<'a, B, P> {
                basis: &'a B,
                points: &'a [P],
            }

            #[derive(Deserialize)]
            #[serde(rename = $name, expecting = $expecting)]
            #[serde(bound(deserialize = "B: Deserialize<'de>, P: Copy + Deserialize<'de>"))]
            struct Read<B: $basis, P: Copy> {
                basis: B,
                points: Elements<B::Points<P>, P>,
            }

            impl<B: $basis + Serialize, P: Point<Scalar = B::Scalar> + Serialize> Serialize for $patch<B, P> {
                fn serialize<Z: Serializer>(&self, serializer: Z) -> Result<Z::Ok, Z::Error> {
                    Written { basis: &self.basis(), points: self.control_points() }.serialize(serializer)
                }
            }

            impl<'de, B, P> Deserialize<'de> for $patch<B, P>
            where
                B: $basis + Deserialize<'de>,
                P: Point<Scalar = B::Scalar> + Deserialize<'de>,
            {
                fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                    let Read { basis, points } = Read::deserialize(deserializer)?;
                    Ok(Self::new(basis, points.0))
                }
            }
        };
    };
}
patch!(SimplexPatch, SimplexBasis, "SimplexPatch", "struct SimplexPatch");
patch!(BoxPatch, BoxBasis, "BoxPatch", "struct BoxPatch");
patch!(ProductPatch, ProductBasis, "ProductPatch", "struct ProductPatch");

impl<S: Scalar, const N: usize, const T: usize> Serialize for TriangularBernsteinBasis<S, N, T> {
    fn serialize<Z: Serializer>(&self, serializer: Z) -> Result<Z::Ok, Z::Error> {
        write_shape::<f64, Z>(serializer, "TriangularBernsteinBasis", &[])
    }
}

impl<'de, S: Scalar, const N: usize, const T: usize> Deserialize<'de> for TriangularBernsteinBasis<S, N, T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let []: [f64; 0] = read_shape(deserializer, "TriangularBernsteinBasis", &[])?;
        Ok(Self::new())
    }
}

impl<const K: usize> Serialize for SimplexIndex<K> {
    fn serialize<Z: Serializer>(&self, serializer: Z) -> Result<Z::Ok, Z::Error> {
        self.components().as_slice().serialize(serializer)
    }
}

impl<'de, const K: usize> Deserialize<'de> for SimplexIndex<K> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let components = Elements::<[usize; K], usize, Components>::deserialize(deserializer)?.0;
        // The order is a sum, and the number of all indices of that order has to be a number too.
        let order = components.iter().try_fold(0_usize, |sum, &part| sum.checked_add(part));
        match order {
            Some(order) if order <= 1 << 12 => Ok(Self::new(components)),
            _ => Err(D::Error::custom("the order of an index is at most 4096")),
        }
    }
}

#[derive(Serialize)]
#[serde(rename = "EndpointForm")]
struct WrittenEndpoint<'a, P> {
    ends: [&'a P; 2],
    inner: &'a [P],
}

#[derive(Deserialize)]
#[serde(
    rename = "EndpointForm",
    expecting = "struct EndpointForm",
    bound(deserialize = "P: Copy + Deserialize<'de>")
)]
struct ReadEndpoint<P: Copy, const R: usize> {
    ends: [P; 2],
    inner: Elements<[P; R], P, Coefficients>,
}

impl<P: Point + Serialize, const R: usize> Serialize for EndpointForm<P, R> {
    fn serialize<Z: Serializer>(&self, serializer: Z) -> Result<Z::Ok, Z::Error> {
        let [start, end] = self.ends();
        WrittenEndpoint { ends: [start, end], inner: self.inner() }.serialize(serializer)
    }
}

impl<'de, P: Point + Deserialize<'de>, const R: usize> Deserialize<'de> for EndpointForm<P, R> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let ReadEndpoint { ends, inner } = ReadEndpoint::deserialize(deserializer)?;
        Ok(Self::new(ends, inner.0))
    }
}

#[derive(Serialize)]
#[serde(rename = "BernsteinForm")]
struct WrittenBernstein<'a, P> {
    points: &'a [P],
}

#[derive(Deserialize)]
#[serde(
    rename = "BernsteinForm",
    expecting = "struct BernsteinForm",
    bound(deserialize = "P: Copy + Deserialize<'de>")
)]
struct ReadBernstein<P: Copy, const N: usize> {
    points: Elements<[P; N], P>,
}

impl<P: Point + Serialize, const N: usize> Serialize for BernsteinForm<P, N> {
    fn serialize<Z: Serializer>(&self, serializer: Z) -> Result<Z::Ok, Z::Error> {
        WrittenBernstein { points: self.points() }.serialize(serializer)
    }
}

impl<'de, P: Point + Deserialize<'de>, const N: usize> Deserialize<'de> for BernsteinForm<P, N> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        Ok(Self::new(ReadBernstein::deserialize(deserializer)?.points.0))
    }
}
