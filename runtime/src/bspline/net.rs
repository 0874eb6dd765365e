//! Rectangular nets of control points.

use alloc::vec::Vec;

use super::SplineError;

/// A net of `rows × columns` points, stored row by row.
///
/// In a surface `S(u, v)` the row index belongs to `u` and the column index to `v`.
///
/// ```
/// use basis_runtime::bspline::Net;
///
/// let net = Net::from_rows([[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]])?;
/// assert_eq!((net.rows(), net.columns()), (2, 3));
/// assert_eq!(net[[1, 0]], 4.0);
/// assert_eq!(net.transposed().row(2), [3.0, 6.0]);
/// # Ok::<(), basis_runtime::bspline::SplineError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(try_from = "crate::serialize::bspline::Points<P>"))]
#[cfg_attr(
    feature = "serde",
    serde(bound(serialize = "P: serde::Serialize", deserialize = "P: Copy + serde::Deserialize<'de>"))
)]
pub struct Net<P> {
    points: Vec<P>,
    columns: usize,
}

impl<P: Copy> Net<P> {
    /// The net with these rows.
    ///
    /// # Errors
    /// [`SplineError::Ragged`] if the rows have different lengths, or if there is no point at all.
    pub fn from_rows<R: AsRef<[P]>>(rows: impl IntoIterator<Item = R>) -> Result<Self, SplineError> {
        let (mut points, mut columns) = (Vec::new(), 0);
        for (index, row) in rows.into_iter().enumerate() {
            let row = row.as_ref();
            if index == 0 {
                columns = row.len();
            }
            if row.is_empty() || row.len() != columns {
                return Err(SplineError::Ragged { row: index });
            }
            points.extend_from_slice(row);
        }
        if points.is_empty() { Err(SplineError::Ragged { row: 0 }) } else { Ok(Self { points, columns }) }
    }

    /// The net with that number of rows and columns whose points are `point(row, column)`.
    ///
    /// # Errors
    /// [`SplineError::Ragged`] if one of the numbers is 0, [`SplineError::Memory`] if there is no room for the points.
    pub fn from_fn(
        rows: usize,
        columns: usize,
        mut point: impl FnMut(usize, usize) -> P,
    ) -> Result<Self, SplineError> {
        if rows == 0 || columns == 0 {
            return Err(SplineError::Ragged { row: 0 });
        }
        let mut points = Vec::new();
        let room = rows.checked_mul(columns).map(|count| points.try_reserve_exact(count));
        if !matches!(room, Some(Ok(()))) {
            return Err(SplineError::Memory { rows, columns });
        }
        for i in 0..rows {
            points.extend((0..columns).map(|j| point(i, j)));
        }
        Ok(Self { points, columns })
    }

    /// Points that are known to fill the rows, with at least one column.
    pub(super) fn trusted(points: Vec<P>, columns: usize) -> Self {
        debug_assert!(columns > 0 && !points.is_empty() && points.len().is_multiple_of(columns));
        Self { points, columns }
    }

    pub(super) fn into_points(self) -> Vec<P> {
        self.points
    }

    /// The number of rows.
    #[inline]
    pub fn rows(&self) -> usize {
        self.points.len() / self.columns
    }

    /// The number of columns.
    #[inline]
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// One row.
    ///
    /// # Panics
    /// If there is no such row.
    #[inline]
    pub fn row(&self, row: usize) -> &[P] {
        &self.points[row * self.columns..][..self.columns]
    }

    /// One column.
    ///
    /// # Panics
    /// If there is no such column.
    pub fn column(&self, column: usize) -> impl Iterator<Item = P> + '_ {
        assert!(column < self.columns, "column {column} of a net with {} columns", self.columns);
        self.points[column..].iter().step_by(self.columns).copied()
    }

    /// All points, row by row.
    #[inline]
    pub fn as_slice(&self) -> &[P] {
        &self.points
    }

    /// All points, row by row, to be changed in place.
    #[inline]
    pub fn as_mut_slice(&mut self) -> &mut [P] {
        &mut self.points
    }

    /// The net with rows and columns exchanged.
    pub fn transposed(&self) -> Self {
        let points = (0..self.columns).flat_map(|column| self.column(column)).collect();
        Self { points, columns: self.rows() }
    }

    /// The net of the images of all points.
    pub fn map<Q: Copy>(&self, image: impl FnMut(P) -> Q) -> Net<Q> {
        Net { points: self.points.iter().copied().map(image).collect(), columns: self.columns }
    }
}

impl<P: Copy> core::ops::Index<[usize; 2]> for Net<P> {
    type Output = P;

    #[inline]
    fn index(&self, [row, column]: [usize; 2]) -> &P {
        &self.points[row * self.columns..][..self.columns][column]
    }
}

impl<P: Copy> core::ops::IndexMut<[usize; 2]> for Net<P> {
    #[inline]
    fn index_mut(&mut self, [row, column]: [usize; 2]) -> &mut P {
        &mut self.points[row * self.columns..][..self.columns][column]
    }
}
