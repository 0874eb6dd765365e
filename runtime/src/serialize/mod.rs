//! serde for bases, curves and surfaces: shape values and control points. Nothing that follows from them is written,
//! and what is read goes through the constructors.
//!
//! ```json
//! {"basis": {"lambda": 0.5}, "points": [[0.0, 0.0], [1.0, 2.0], [3.0, 2.0], [4.0, 0.0]]}
//! ```

#[cfg(feature = "bspline")]
pub(crate) mod bspline;
#[cfg(feature = "mesh")]
pub(crate) mod mesh;
mod patches;
#[cfg(feature = "geometry")]
pub(crate) mod path;
pub(crate) mod rational;
pub(crate) mod revolution;

use core::fmt::{self, Formatter};
use core::marker::PhantomData;

use serde::de::{DeserializeSeed, Error, IgnoredAny, MapAccess, SeqAccess, Visitor};
use serde::ser::SerializeStruct;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use crate::{Array, Basis, BernsteinBasis, Curve, Point, Scalar, TensorSurface};

/// A point that can be written with its components: the bound of derived implementations.
pub trait Written: Point<Scalar: Serialize> + Serialize {}

impl<P: Point<Scalar: Serialize> + Serialize> Written for P {}

/// A point that can be read with its components: the bound of derived implementations.
pub trait Read<'de>: Point<Scalar: Deserialize<'de>> + Deserialize<'de> {}

impl<'de, P: Point<Scalar: Deserialize<'de>> + Deserialize<'de>> Read<'de> for P {}

/// Implements serde's traits for a generated type: a struct of its shape values, which are checked when they are read.
#[doc(hidden)]
#[macro_export]
macro_rules! __serialize_shape {
    ($name:ident, $title:literal, []) => {
        $crate::__serialize_shape!(@impl $name, $title, [], {
            let []: [S; 0] = $crate::__private::read_shape(deserializer, $title, &[])?;
            $crate::__private::core::result::Result::Ok(Self::new())
        }, deserializer);
    };
    ($name:ident, $title:literal, [$($field:ident $label:literal),+]) => {
        $crate::__serialize_shape!(@impl $name, $title, [$($field $label),+], {
            let [$($field),+] = $crate::__private::read_shape(deserializer, $title, &[$($label),+])?;
            Self::new($($field),+).map_err($crate::__private::shape_error)
        }, deserializer);
    };
    ($name:ident, $title:literal, [$($field:ident $label:literal),+], ($($argument:expr),+)) => {
        $crate::__serialize_shape!(@impl $name, $title, [$($field $label),+], {
            let [$($field),+] = $crate::__private::read_shape(deserializer, $title, &[$($label),+])?;
            Self::new($($argument),+).map_err($crate::__private::shape_error)
        }, deserializer);
    };
    (@impl $name:ident, $title:literal, [$($field:ident $label:literal),*], $read:block, $deserializer:ident) => {
        impl<S: $crate::Scalar + $crate::__private::serde::Serialize> $crate::__private::serde::Serialize for $name<S> {
            fn serialize<Z: $crate::__private::serde::Serializer>(
                &self,
                serializer: Z,
            ) -> $crate::__private::core::result::Result<Z::Ok, Z::Error> {
                let values: &[(&'static str, S)] = &[$(($label, self.$field)),*];
                $crate::__private::write_shape(serializer, $title, values)
            }
        }

        impl<'de, S: $crate::Scalar + $crate::__private::serde::Deserialize<'de>>
            $crate::__private::serde::Deserialize<'de> for $name<S>
        {
            fn deserialize<D: $crate::__private::serde::Deserializer<'de>>(
                $deserializer: D,
            ) -> $crate::__private::core::result::Result<Self, D::Error> $read
        }
    };
}

/// Writes the shape values of a generated type.
#[doc(hidden)]
pub fn write_shape<S: Serialize, Z: Serializer>(
    serializer: Z,
    name: &'static str,
    values: &[(&'static str, S)],
) -> Result<Z::Ok, Z::Error> {
    let mut shape = serializer.serialize_struct(name, values.len())?;
    for (label, value) in values {
        shape.serialize_field(label, value)?;
    }
    shape.end()
}

/// Reads the shape values of a generated type, from a map or a sequence.
#[doc(hidden)]
pub fn read_shape<'de, S, D, const N: usize>(
    deserializer: D,
    name: &'static str,
    labels: &'static [&'static str; N],
) -> Result<[S; N], D::Error>
where
    S: Deserialize<'de> + Copy,
    D: Deserializer<'de>,
{
    deserializer.deserialize_struct(name, labels, ShapeVisitor { labels, scalar: PhantomData })
}

/// The refusal of a shape value.
#[doc(hidden)]
pub fn shape_error<E: Error>(error: crate::ShapeError) -> E {
    E::custom(error)
}

struct ShapeVisitor<S, const N: usize> {
    labels: &'static [&'static str; N],
    scalar: PhantomData<S>,
}

impl<'de, S: Deserialize<'de> + Copy, const N: usize> Visitor<'de> for ShapeVisitor<S, N> {
    type Value = [S; N];

    fn expecting(&self, f: &mut Formatter<'_>) -> fmt::Result {
        write!(f, "{N} shape values")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<[S; N], A::Error> {
        let mut values = [None; N];
        for (index, value) in values.iter_mut().enumerate() {
            *value = Some(seq.next_element()?.ok_or_else(|| A::Error::invalid_length(index, &self))?);
        }
        all(values).ok_or_else(|| A::Error::invalid_length(0, &self))
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<[S; N], A::Error> {
        let mut values = [None; N];
        while let Some(index) = map.next_key_seed(Label(self.labels))? {
            match index {
                Some(index) if values[index].is_some() => {
                    return Err(A::Error::duplicate_field(self.labels[index]));
                }
                Some(index) => values[index] = Some(map.next_value()?),
                None => drop(map.next_value::<IgnoredAny>()?),
            }
        }
        if let Some(index) = values.iter().position(Option::is_none) {
            return Err(A::Error::missing_field(self.labels[index]));
        }
        all(values).ok_or_else(|| A::Error::invalid_length(0, &self))
    }
}

fn all<S: Copy, const N: usize>(values: [Option<S>; N]) -> Option<[S; N]> {
    // Checked by both callers; an array of options has no transpose yet.
    values.iter().all(Option::is_some).then(|| values.map(|value| value.unwrap_or_else(|| unreachable!())))
}

/// The index of a label; `None` for others.
struct Label<const N: usize>(&'static [&'static str; N]);

impl<'de, const N: usize> DeserializeSeed<'de> for Label<N> {
    type Value = Option<usize>;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Option<usize>, D::Error> {
        deserializer.deserialize_identifier(self)
    }
}

impl<const N: usize> Visitor<'_> for Label<N> {
    type Value = Option<usize>;

    fn expecting(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str("the name of a shape parameter")
    }

    fn visit_str<E>(self, name: &str) -> Result<Option<usize>, E> {
        Ok(self.0.iter().position(|&label| label == name))
    }

    fn visit_bytes<E>(self, name: &[u8]) -> Result<Option<usize>, E> {
        Ok(self.0.iter().position(|label| label.as_bytes() == name))
    }

    fn visit_u64<E>(self, index: u64) -> Result<Option<usize>, E> {
        Ok(usize::try_from(index).ok().filter(|&index| index < N))
    }
}

impl<S: Scalar, const N: usize> Serialize for BernsteinBasis<S, N> {
    fn serialize<Z: Serializer>(&self, serializer: Z) -> Result<Z::Ok, Z::Error> {
        write_shape::<f64, Z>(serializer, "BernsteinBasis", &[])
    }
}

impl<'de, S: Scalar, const N: usize> Deserialize<'de> for BernsteinBasis<S, N> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let []: [f64; 0] = read_shape(deserializer, "BernsteinBasis", &[])?;
        Ok(Self::new())
    }
}

#[derive(Serialize)]
#[serde(rename = "Curve")]
struct WrittenCurve<'a, B, P> {
    basis: &'a B,
    points: &'a [P],
}

#[derive(Deserialize)]
#[serde(rename = "Curve", expecting = "struct Curve")]
struct ReadCurve<B, E> {
    basis: B,
    points: E,
}

impl<B: Basis + Serialize, P: Point<Scalar = B::Scalar> + Serialize> Serialize for Curve<B, P> {
    fn serialize<Z: Serializer>(&self, serializer: Z) -> Result<Z::Ok, Z::Error> {
        WrittenCurve { basis: &self.basis(), points: self.control_points() }.serialize(serializer)
    }
}

impl<'de, B, P> Deserialize<'de> for Curve<B, P>
where
    B: Basis + Deserialize<'de>,
    P: Point<Scalar = B::Scalar> + Deserialize<'de>,
{
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let ReadCurve { basis, points } =
            ReadCurve::<B, Elements<B::Points<P>, P>>::deserialize(deserializer)?;
        Ok(Self::new(basis, points.0))
    }
}

#[derive(Serialize)]
#[serde(rename = "TensorSurface")]
struct WrittenSurface<'a, U, R> {
    u_basis: &'a U,
    rows: &'a [R],
}

#[derive(Deserialize)]
#[serde(
    rename = "TensorSurface",
    expecting = "struct TensorSurface",
    bound(deserialize = "U: Basis + Deserialize<'de>, R: Copy + Deserialize<'de>")
)]
struct ReadSurface<U: Basis, R: Copy> {
    u_basis: U,
    rows: Elements<U::Points<R>, R, Rows>,
}

impl<U, V, P> Serialize for TensorSurface<U, V, P>
where
    U: Basis + Serialize,
    V: Basis<Scalar = U::Scalar> + Serialize,
    P: Point<Scalar = U::Scalar> + Serialize,
{
    fn serialize<Z: Serializer>(&self, serializer: Z) -> Result<Z::Ok, Z::Error> {
        WrittenSurface { u_basis: &self.u_basis(), rows: self.rows() }.serialize(serializer)
    }
}

impl<'de, U, V, P> Deserialize<'de> for TensorSurface<U, V, P>
where
    U: Basis + Deserialize<'de>,
    V: Basis<Scalar = U::Scalar> + Deserialize<'de>,
    P: Point<Scalar = U::Scalar> + Deserialize<'de>,
{
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let ReadSurface { u_basis, rows } = ReadSurface::deserialize(deserializer)?;
        Ok(Self::from_rows(u_basis, rows.0))
    }
}

/// What the elements of an array are, for messages.
trait Kind {
    const NAME: &'static str;
}

struct ControlPoints;
impl Kind for ControlPoints {
    const NAME: &'static str = "control points";
}

struct Rows;
impl Kind for Rows {
    const NAME: &'static str = "rows of the net";
}

struct Coefficients;
impl Kind for Coefficients {
    const NAME: &'static str = "coefficients";
}

struct Components;
impl Kind for Components {
    const NAME: &'static str = "components";
}

/// As many elements as the array has.
struct Elements<A, T, K = ControlPoints>(A, PhantomData<(T, K)>);

impl<'de, A: Array<T>, T: Copy + Deserialize<'de>, K: Kind> Deserialize<'de> for Elements<A, T, K> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_seq(ElementsVisitor(PhantomData))
    }
}

struct ElementsVisitor<A, T, K>(PhantomData<(A, T, K)>);

impl<'de, A: Array<T>, T: Copy + Deserialize<'de>, K: Kind> Visitor<'de> for ElementsVisitor<A, T, K> {
    type Value = Elements<A, T, K>;

    fn expecting(&self, f: &mut Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}", A::LEN, K::NAME)
    }

    fn visit_seq<S: SeqAccess<'de>>(self, mut seq: S) -> Result<Self::Value, S::Error> {
        // Read in order; after an error the rest is filled with what is there, and not used.
        let mut error = None;
        let mut last = None;
        let mut next = |index: usize| {
            if error.is_none() {
                match seq.next_element() {
                    Ok(Some(element)) => last = Some(element),
                    Ok(None) => error = Some(S::Error::invalid_length(index, &self)),
                    Err(other) => error = Some(other),
                }
            }
            last
        };
        let Some(first) = (if A::LEN == 0 { None } else { next(0) }) else {
            return match error {
                Some(error) => Err(error),
                None => Ok(Elements(A::from_fn(|_| unreachable!("an empty array")), PhantomData)),
            };
        };
        let array = A::from_fn(|index| if index == 0 { first } else { next(index).unwrap_or(first) });
        if let Some(error) = error {
            return Err(error);
        }
        if seq.next_element::<IgnoredAny>()?.is_some() {
            return Err(S::Error::invalid_length(A::LEN + 1, &self));
        }
        Ok(Elements(array, PhantomData))
    }
}

#[cfg(feature = "geometry")]
mod piecewise {
    use alloc::vec::Vec;

    use serde::de::Error;
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    use crate::{ParametricCurve, PiecewiseCurve};

    impl<C: ParametricCurve + Serialize> Serialize for PiecewiseCurve<C> {
        fn serialize<Z: Serializer>(&self, serializer: Z) -> Result<Z::Ok, Z::Error> {
            self.segments().serialize(serializer)
        }
    }

    impl<'de, C: ParametricCurve + Deserialize<'de>> Deserialize<'de> for PiecewiseCurve<C> {
        fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
            Self::new(Vec::deserialize(deserializer)?).map_err(D::Error::custom)
        }
    }
}
