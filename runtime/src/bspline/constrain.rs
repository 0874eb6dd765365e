//! Point constraints: the least change of a net with which the surface passes through given points.

use alloc::vec;
use alloc::vec::Vec;
use core::error::Error;
use core::fmt::{self, Display, Formatter};

use super::{BSplineSurface, Direction, KnotError, Net};
#[cfg(feature = "serde")]
use crate::serialize::{Read, Written};
use crate::vector::largest_component;
use crate::{Point, Scalar};

/// A row that the earlier ones determine up to this part of its length says nothing new.
const DEPENDENT: f64 = 1e-12;

/// How much nearer a point may be than the nearest one that is found, as a part of the extent of the net.
const NEAREST: f64 = 1e-10;

/// Rounding errors, in ε of the scalar type, up to which constraints do not count as contradicting each other.
const ROUNDING: f64 = 32.0;

/// A point through which a surface is to pass.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(bound(serialize = "P: Written", deserialize = "P: Read<'de>")))]
#[non_exhaustive]
pub enum PointConstraint<P: Point> {
    /// `S(u, v) = point` at these parameters `[u, v]`.
    At([P::Scalar; 2], P),
    /// `S(u, v) = point` at the parameters of the point of the original surface that is nearest to it.
    Nearest(P),
}

/// A surface that was deformed, and how.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(bound(serialize = "P: Written", deserialize = "P: Read<'de>")))]
#[non_exhaustive]
pub struct Constrained<P: Point> {
    /// The surface, over the same knots.
    pub surface: BSplineSurface<P>,
    /// The parameters `[u, v]` of each constraint.
    pub parameters: Vec<[P::Scalar; 2]>,
    /// The length of the change of the net: `√(Σ |ΔP[i, j]|²)`, the least possible.
    pub change: f64,
    /// The largest distance between a constraint and the surface: rounding errors.
    pub miss: f64,
}

/// Constraints that no change of the net satisfies, or that cannot be read.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum ConstraintError {
    /// The parameters of a constraint are outside of the domain.
    Outside {
        /// The index of the constraint.
        constraint: usize,
        /// The parameter.
        error: KnotError,
    },
    /// The point of a constraint is not finite.
    NotFinite {
        /// The index of the constraint.
        constraint: usize,
    },
    /// A control point of the surface is not finite.
    Surface,
    /// The points are so far away that a control point would become infinite.
    Overflow,
    /// A constraint contradicts others: their parameters determine the point of the surface at its own.
    Infeasible {
        /// The index of the constraint.
        constraint: usize,
        /// The constraints before it that determine the point; none if all control points that could move are held.
        against: Vec<usize>,
        /// How far its point is from the one that they determine.
        distance: f64,
    },
}

impl Display for ConstraintError {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Outside { constraint, error } => write!(f, "constraint {constraint}: {error}"),
            Self::NotFinite { constraint } => {
                write!(f, "the point of constraint {constraint} is not finite")
            }
            Self::Surface => f.write_str("a control point of the surface is not finite"),
            Self::Overflow => f.write_str(
                "the points are so far from the surface that a control point would become infinite; use \
                 a larger unit",
            ),
            Self::Infeasible { constraint, against, distance } if against.is_empty() => write!(
                f,
                "constraint {constraint} cannot be met: every control point that could move the surface \
                 there is held; it misses by {distance}"
            ),
            Self::Infeasible { constraint, against, distance } => {
                write!(f, "constraint {constraint} contradicts")?;
                for (i, other) in against.iter().enumerate() {
                    write!(f, "{} {other}", if i == 0 { "" } else { "," })?;
                }
                write!(
                    f,
                    ": these determine the surface at its parameters, {distance} away from its point; \
                     drop one of them or insert knots between them"
                )
            }
        }
    }
}

impl Error for ConstraintError {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        match self {
            Self::Outside { error, .. } => Some(error),
            _ => None,
        }
    }
}

impl<P: Point> BSplineSurface<P> {
    /// The surface over the same knots that passes through the points and whose net differs least from this one.
    ///
    /// It minimises `Σ |ΔP[i, j]|²` subject to `Σ N[i](u) N[j](v) ΔP[i, j] = point - S(u, v)` for each constraint.
    ///
    /// ```
    /// use basis_runtime::bspline::{BSplineSurface, KnotVector, Net, PointConstraint};
    ///
    /// let knots = KnotVector::uniform(3, 4)?;
    /// let net = Net::from_fn(7, 7, |i, j| [i as f64, j as f64, 0.0])?;
    /// let plane = BSplineSurface::new(knots.clone(), knots, net)?;
    /// let pulled = plane.pass_through(&[PointConstraint::At([0.5, 0.5], [3.0, 3.0, 1.0])])?;
    /// let [_, _, z] = pulled.surface.eval(0.5, 0.5);
    /// assert!((z - 1.0).abs() < 1e-15);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`ConstraintError::Infeasible`] says which constraint contradicts which; the other errors say which one cannot
    /// be read.
    pub fn pass_through(
        &self,
        constraints: &[PointConstraint<P>],
    ) -> Result<Constrained<P>, ConstraintError> {
        self.pass_through_holding(constraints, |_, _| false)
    }

    /// As [`pass_through`](Self::pass_through), with control points that must not move: those for which
    /// `held(row, column)` is true stay bit by bit the same.
    ///
    /// # Errors
    /// As [`pass_through`](Self::pass_through).
    pub fn pass_through_holding(
        &self,
        constraints: &[PointConstraint<P>],
        held: impl Fn(usize, usize) -> bool,
    ) -> Result<Constrained<P>, ConstraintError> {
        let finite = |point: &P| (0..P::DIM).all(|i| point.component(i).is_finite());
        if !self.net().as_slice().iter().all(finite) {
            return Err(ConstraintError::Surface);
        }
        let [low, high] = crate::vector::box_of(self.net().as_slice());
        let accuracy = P::Scalar::of(NEAREST) * largest_component(high.minus(low));
        let mut parameters = Vec::with_capacity(constraints.len());
        for (constraint, wanted) in constraints.iter().enumerate() {
            let (PointConstraint::At(_, point) | PointConstraint::Nearest(point)) = wanted;
            if !finite(point) {
                return Err(ConstraintError::NotFinite { constraint });
            }
            let at = match wanted {
                PointConstraint::At(at, _) => *at,
                PointConstraint::Nearest(point) => {
                    self.nearest(*point, accuracy).ok_or(ConstraintError::NotFinite { constraint })?.at
                }
            };
            for (direction, t) in [(Direction::U, at[0]), (Direction::V, at[1])] {
                let outside = |error| ConstraintError::Outside { constraint, error };
                self.knots(direction).check(t).map_err(outside)?;
            }
            parameters.push(at);
        }
        let rows = parameters.iter().map(|at| self.constraint_row(*at, &held));
        let system = Orthogonal::new(rows.collect());

        let mut surface = self.clone();
        let mut total = vec![0.0; system.touched.len() * P::DIM];
        // The second round removes what the rounding of the first one left.
        for round in 0..2 {
            let misses = misses(&surface, constraints, &parameters);
            let change = system.least_change(&misses, P::DIM);
            if round == 0 {
                let noise = ROUNDING * P::Scalar::EPSILON.to_f64() * self.size(constraints);
                if let Some((constraint, distance)) = system.contradiction(&misses, &change, P::DIM, noise) {
                    let against = system.determining(constraint);
                    return Err(ConstraintError::Infeasible { constraint, against, distance });
                }
            }
            for (sum, step) in total.iter_mut().zip(&change) {
                *sum += step;
            }
            for (place, &index) in system.touched.iter().enumerate() {
                let old = self.net().as_slice()[index];
                let change = &total[place * P::DIM..];
                surface.control_points_mut()[index] =
                    P::from_components(|i| P::Scalar::of(old.component(i).to_f64() + change[i]));
            }
        }
        if !surface.net().as_slice().iter().all(finite) {
            return Err(ConstraintError::Overflow);
        }
        let miss = misses(&surface, constraints, &parameters);
        let miss = miss.chunks(P::DIM.max(1)).map(norm).fold(0.0, f64::max);
        Ok(Constrained { surface, parameters, change: norm(&total), miss })
    }

    /// The largest component of a control point or of the point of a constraint.
    fn size(&self, constraints: &[PointConstraint<P>]) -> f64 {
        let wanted = constraints.iter().map(|constraint| match constraint {
            PointConstraint::At(_, point) | PointConstraint::Nearest(point) => point,
        });
        let points = self.net().as_slice().iter().chain(wanted);
        let components = points.flat_map(|point| (0..P::DIM).map(|i| point.component(i).to_f64().abs()));
        components.fold(0.0, f64::max)
    }

    /// `N[i](u) N[j](v)` for the control points that may move, by their index in the net.
    fn constraint_row(&self, at: [P::Scalar; 2], held: &impl Fn(usize, usize) -> bool) -> Vec<(usize, f64)> {
        let [u, v] = [(Direction::U, at[0]), (Direction::V, at[1])].map(|(direction, t)| {
            let knots = self.knots(direction).to_f64();
            let t = t.to_f64();
            let span = knots.span(t);
            (span - knots.degree(), knots.values_on(span, t))
        });
        let mut row = Vec::new();
        for (i, &a) in u.1.iter().enumerate() {
            for (j, &b) in v.1.iter().enumerate() {
                let (i, j) = (u.0 + i, v.0 + j);
                if a * b != 0.0 && !held(i, j) {
                    row.push((i * self.net().columns() + j, a * b));
                }
            }
        }
        row
    }
}

/// `point - S(u, v)` for each constraint, component by component, in double precision.
fn misses<P: Point>(
    surface: &BSplineSurface<P>,
    constraints: &[PointConstraint<P>],
    parameters: &[[P::Scalar; 2]],
) -> Vec<f64> {
    let net: &Net<P> = surface.net();
    let mut all = Vec::with_capacity(constraints.len() * P::DIM);
    for (constraint, &at) in constraints.iter().zip(parameters) {
        let (PointConstraint::At(_, point) | PointConstraint::Nearest(point)) = constraint;
        let row = surface.constraint_row(at, &|_, _| false);
        all.extend((0..P::DIM).map(|i| {
            let value =
                |&(index, factor): &(usize, f64)| net.as_slice()[index].component(i).to_f64() * factor;
            point.component(i).to_f64() - row.iter().map(value).sum::<f64>()
        }));
    }
    all
}

/// The Euclidean length, also of components whose squares overflow or vanish.
fn norm(components: &[f64]) -> f64 {
    let size = largest(components);
    if size == 0.0 || !size.is_finite() {
        return size;
    }
    size * Scalar::sqrt(components.iter().map(|x| (x / size) * (x / size)).sum::<f64>())
}

fn largest(components: &[f64]) -> f64 {
    components.iter().fold(0.0, |size: f64, x| size.max(x.abs()))
}

/// The rows of the constraints, orthogonalised one after the other: `row[i] = Σ lower[i][j] unit[j]`.
///
/// Modified Gram–Schmidt, twice, in the order in which the constraints were given, so that a conflict can be told.
struct Orthogonal {
    /// The control points that some row moves.
    touched: Vec<usize>,
    /// Orthonormal rows.
    units: Vec<Vec<f64>>,
    rows: Vec<Row>,
}

/// The row of one constraint.
struct Row {
    /// Its factors of the unit rows; the last one is that of the row it added, if it added one.
    factors: Vec<f64>,
    /// The unit row that it added, if it is not determined by the ones before.
    added: Option<usize>,
    /// The length of what the unit rows before it leave.
    left: f64,
}

impl Orthogonal {
    fn new(sparse: Vec<Vec<(usize, f64)>>) -> Self {
        let mut touched: Vec<usize> = sparse.iter().flatten().map(|(index, _)| *index).collect();
        touched.sort_unstable();
        touched.dedup();
        let mut units: Vec<Vec<f64>> = Vec::new();
        let mut rows = Vec::with_capacity(sparse.len());
        for row in sparse {
            let mut rest = vec![0.0; touched.len()];
            for (index, factor) in row {
                rest[touched.partition_point(|&other| other < index)] = factor;
            }
            let length = norm(&rest);
            let mut factors = vec![0.0; units.len()];
            for _ in 0..2 {
                for (unit, factor) in units.iter().zip(&mut factors) {
                    let part: f64 = unit.iter().zip(&rest).map(|(a, b)| a * b).sum();
                    *factor += part;
                    for (x, u) in rest.iter_mut().zip(unit) {
                        *x -= part * u;
                    }
                }
            }
            let left = norm(&rest);
            let added = left > DEPENDENT * length;
            if added {
                factors.push(left);
                for x in &mut rest {
                    *x /= left;
                }
                units.push(rest);
            }
            rows.push(Row { factors, added: added.then(|| units.len() - 1), left });
        }
        Self { touched, units, rows }
    }

    /// The shortest change with the given products with all rows that are not determined by earlier ones, `lanes`
    /// numbers for each.
    fn least_change(&self, wanted: &[f64], lanes: usize) -> Vec<f64> {
        let mut along: Vec<Vec<f64>> = Vec::new();
        for (constraint, row) in self.rows.iter().enumerate() {
            if row.added.is_none() {
                continue;
            }
            let mut rest = wanted[constraint * lanes..(constraint + 1) * lanes].to_vec();
            for (part, factor) in along.iter().zip(&row.factors) {
                for (x, y) in rest.iter_mut().zip(part) {
                    *x -= y * factor;
                }
            }
            along.push(rest.iter().map(|x| x / row.left).collect());
        }
        let mut change = vec![0.0; self.touched.len() * lanes];
        for (unit, part) in self.units.iter().zip(&along) {
            for (place, factor) in unit.iter().enumerate() {
                for (lane, x) in part.iter().enumerate() {
                    change[place * lanes + lane] += factor * x;
                }
            }
        }
        change
    }

    /// The constraint that is furthest from what the ones before it determine, and how far; none if all distances are
    /// rounding errors, `noise` being those of one point.
    fn contradiction(
        &self,
        wanted: &[f64],
        change: &[f64],
        lanes: usize,
        noise: f64,
    ) -> Option<(usize, f64)> {
        let mut worst: Option<(usize, f64)> = None;
        for (constraint, row) in self.rows.iter().enumerate() {
            if row.added.is_some() {
                continue;
            }
            let mut rest = wanted[constraint * lanes..(constraint + 1) * lanes].to_vec();
            let combination = self.combination(constraint);
            for &(other, share) in &combination {
                for (x, y) in rest.iter_mut().zip(&wanted[other * lanes..]) {
                    *x -= share * y;
                }
            }
            let distance = norm(&rest);
            let shares: f64 = combination.iter().map(|(_, share)| share.abs()).sum();
            // What is left of a row, though too little to be solved for, still sees the change.
            let allowed = noise * (1.0 + shares) + ROUNDING * row.left * norm(change);
            if distance > allowed && worst.is_none_or(|(_, other)| distance > other) {
                worst = Some((constraint, distance));
            }
        }
        worst
    }

    /// The constraints that determine this one.
    fn determining(&self, constraint: usize) -> Vec<usize> {
        let combination = self.combination(constraint);
        let largest = combination.iter().fold(0.0, |size: f64, (_, share)| size.max(share.abs()));
        let matters = |&(other, share): &(usize, f64)| (share.abs() > 1e-9 * largest).then_some(other);
        combination.iter().filter_map(matters).collect()
    }

    /// The factors with which this row is a combination of those before it, the ones of which no other is.
    fn combination(&self, constraint: usize) -> Vec<(usize, f64)> {
        // Solve from the last unit row to the first: each was added by one constraint.
        let mut rest = self.rows[constraint].factors.clone();
        let mut combination = Vec::new();
        for (other, row) in self.rows[..constraint].iter().enumerate().rev() {
            let Some(unit) = row.added else { continue };
            let share = rest[unit] / row.left;
            combination.push((other, share));
            for (x, y) in rest.iter_mut().zip(&row.factors) {
                *x -= share * y;
            }
        }
        combination.reverse();
        combination
    }
}
