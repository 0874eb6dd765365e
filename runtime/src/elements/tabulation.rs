//! All functions of a family and their derivatives at many points.

use alloc::vec;
use alloc::vec::Vec;

use crate::domain::{inverse_width, unit};
use crate::simplex::raised;
use crate::{Array, Basis, BoxBasis, Point, ProductBasis, Scalar, SimplexBasis};

/// The values and the partial derivatives of all functions of a family at a list of points: what assembly loops read.
///
/// It is made by [`Basis::tabulate`](crate::Basis::tabulate), [`SimplexBasis::tabulate`](crate::SimplexBasis::tabulate),
/// [`BoxBasis::tabulate`](crate::BoxBasis::tabulate) and [`ProductBasis::tabulate`](crate::ProductBasis::tabulate). `O` holds
/// an order of differentiation for each variable: the parameter of an interval, the coordinates of a box, the barycentric
/// coordinates of a simplex but the last.
///
/// ```
/// use basis_runtime::{Quadrature, SimplexBasis, basis};
///
/// basis!(library "lagrange", TriangularLagrange(2));
/// # fn main() -> Result<(), basis_runtime::QuadratureError> {
/// let rule = Quadrature::<[f64; 3]>::on_simplex(2)?;
/// let table = TriangularLagrange::<f64>::new().tabulate(rule.points(), 1);
/// // ∫ ∇b[3] · ∇b[5] over the reference triangle, exactly.
/// let entry = |q: usize, w: f64| {
///     let [a, b] = [table.gradient(q, 3), table.gradient(q, 5)];
///     w * (a[0] * b[0] + a[1] * b[1])
/// };
/// let stiffness: f64 = rule.weights().iter().enumerate().map(|(q, &w)| entry(q, w)).sum();
/// assert!((stiffness - -2.0 / 3.0).abs() < 1e-15);
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Tabulation<S, O> {
    points: usize,
    functions: usize,
    order: usize,
    /// The orders that are stored, those with a smaller sum first, each sum in decreasing lexicographic order.
    orders: Vec<O>,
    /// For each point, for each of the orders, one number for each function.
    numbers: Vec<S>,
    /// For orders above the degree.
    zeros: Vec<S>,
}

impl<S: Scalar, O: Array<usize>> Tabulation<S, O> {
    /// The number of points.
    pub fn points(&self) -> usize {
        self.points
    }

    /// The number of functions.
    pub fn functions(&self) -> usize {
        self.functions
    }

    /// The highest order of the derivatives, all variables together.
    pub fn order(&self) -> usize {
        self.order
    }

    /// The values of all functions at the point `q`.
    ///
    /// # Panics
    /// If there is no point `q`.
    pub fn values(&self, q: usize) -> &[S] {
        self.row(q, 0)
    }

    /// The partial derivatives of these orders of all functions at the point `q`; `None` if the orders have a larger sum
    /// than was asked for.
    ///
    /// # Panics
    /// If there is no point `q`.
    pub fn derivatives(&self, q: usize, orders: O) -> Option<&[S]> {
        assert!(q < self.points, "there is no point {q}: the table has {}", self.points);
        let sum = orders.as_ref().iter().fold(0, |sum: usize, &order| sum.saturating_add(order));
        if sum > self.order {
            return None;
        }
        let place = self.orders.iter().position(|stored| stored.as_ref() == orders.as_ref());
        Some(place.map_or(&self.zeros, |place| self.row(q, place)))
    }

    fn row(&self, q: usize, place: usize) -> &[S] {
        assert!(q < self.points, "there is no point {q}: the table has {}", self.points);
        &self.numbers[(q * self.orders.len() + place) * self.functions..][..self.functions]
    }
}

impl<S: Scalar, const K: usize> Tabulation<S, [usize; K]> {
    /// The derivatives of the function `i` at the point `q` in each variable.
    ///
    /// # Panics
    /// If there is no such point or function, or the table has no derivatives of order 1.
    pub fn gradient(&self, q: usize, i: usize) -> [S; K] {
        assert!(self.order >= 1, "gradients need a table of order 1 or more");
        core::array::from_fn(|d| self.row(q, 1 + d)[i])
    }

    /// The second derivatives of the function `i` at the point `q`: the symmetric matrix of Hesse.
    ///
    /// # Panics
    /// If there is no such point or function, or the table has no derivatives of order 2.
    pub fn hessian(&self, q: usize, i: usize) -> [[S; K]; K] {
        assert!(self.order >= 2, "second derivatives need a table of order 2 or more");
        core::array::from_fn(|a| {
            core::array::from_fn(|b| {
                let (low, high) = if a < b { (a, b) } else { (b, a) };
                // After the value and K first derivatives; K - a of them begin with the variable a.
                self.row(q, 1 + K + low * (2 * K - low + 1) / 2 + high - low)[i]
            })
        })
    }
}

/// The orders with a sum up to `most`, those with a smaller sum first.
fn orders<O: Array<usize>>(most: usize) -> Vec<O> {
    let stored = |sum| {
        let indices = lattice(O::LEN, sum);
        let count = indices.len() / O::LEN;
        (0..count).rev().map(move |i| O::from_fn(|d| indices[i * O::LEN + d])).collect::<Vec<O>>()
    };
    (0..=most).flat_map(stored).collect()
}

/// The indices with that many components and that sum, in lexicographic order, one after the other.
pub(super) fn lattice(components: usize, sum: usize) -> Vec<usize> {
    let mut index = vec![0; components];
    let mut all = Vec::new();
    let Some(last) = components.checked_sub(1) else { return all };
    index[last] = sum;
    loop {
        all.extend_from_slice(&index);
        // One unit moves left from the last place that has any, the rest goes to the end.
        let Some(from) = (1..components).rev().find(|&place| index[place] > 0) else { return all };
        let rest = core::mem::take(&mut index[from]) - 1;
        index[from - 1] += 1;
        index[last] = rest;
    }
}

/// `row += weight * values`.
fn add<V: Point>(row: &mut [V::Scalar], values: &V, weight: V::Scalar) {
    for (i, sum) in row.iter_mut().enumerate() {
        *sum = values.component(i).fma::<{ crate::FUSED_HERE }>(weight, *sum);
    }
}

/// Derivatives of order up to `order`, but no higher than needed: above the degree, where all is zero, only gradients and
/// second derivatives are stored.
fn kept(order: usize, degree: usize) -> usize {
    order.min(degree.max(2))
}

pub(crate) fn tabulate_interval<B: Basis>(
    basis: &B,
    at: &[B::Scalar],
    order: usize,
) -> Tabulation<B::Scalar, [usize; 1]> {
    let orders = orders(kept(order, B::DEGREE));
    let grid = Grid::new(basis.bernstein_weights().as_ref(), &[B::DEGREE], &orders, &[B::domain()]);
    let mut table = empty(at.len(), B::LEN, order, orders);
    for &t in at {
        table.numbers.extend_from_slice(basis.values(t).as_ref());
        grid.derivatives(&[t], &mut table.numbers);
    }
    table
}

pub(crate) fn tabulate_box<B: BoxBasis>(
    basis: &B,
    at: &[B::Coordinates],
    order: usize,
) -> Tabulation<B::Scalar, B::Orders> {
    let orders = orders(kept(order, B::DEGREES.iter().sum()));
    let [low, high] = B::domain();
    let domain: Vec<[B::Scalar; 2]> =
        low.as_ref().iter().zip(high.as_ref()).map(|(&low, &high)| [low, high]).collect();
    let grid = Grid::new(basis.bernstein_weights().as_ref(), B::DEGREES, &orders, &domain);
    let mut table = empty(at.len(), B::LEN, order, orders);
    for &at in at {
        table.numbers.extend_from_slice(basis.values(at).as_ref());
        grid.derivatives(at.as_ref(), &mut table.numbers);
    }
    table
}

pub(crate) fn tabulate_simplex<B: SimplexBasis>(
    basis: &B,
    at: &[B::Coordinates],
    order: usize,
) -> Tabulation<B::Scalar, B::Orders> {
    let orders: Vec<B::Orders> = orders(kept(order, B::DEGREE));
    // The Bernstein nets of the derivatives of all functions, once for all points.
    let weights = basis.bernstein_weights();
    let nets: Vec<(usize, B::Bernstein<B::Values>)> = orders[1..]
        .iter()
        .map(|orders| {
            let mut net = weights;
            let degree = crate::simplex::partial::<B::Values, B::Coordinates>(
                net.as_mut(),
                B::DEGREE,
                orders.as_ref(),
            );
            (degree, net)
        })
        .collect();
    let mut table = empty(at.len(), B::LEN, order, orders);
    for &at in at {
        table.numbers.extend_from_slice(basis.values(at).as_ref());
        // Bernstein's functions of each degree that a derivative has.
        let mut functions: Vec<Vec<B::Scalar>> = vec![vec![B::Scalar::ONE]];
        for degree in 1..B::DEGREE {
            functions.push(raised(&functions[degree - 1], degree - 1, at.as_ref()));
        }
        for ((degree, net), orders) in nets.iter().zip(&table.orders[1..]) {
            let start = table.numbers.len();
            table.numbers.resize(start + B::LEN, B::Scalar::ZERO);
            if orders.as_ref().iter().sum::<usize>() <= B::DEGREE {
                let row = &mut table.numbers[start..];
                functions[*degree]
                    .iter()
                    .zip(net.as_ref())
                    .for_each(|(&weight, values)| add(row, values, weight));
            }
        }
    }
    table
}

pub(crate) fn tabulate_product<B: ProductBasis>(
    basis: &B,
    at: &[B::Coordinates],
    order: usize,
) -> Tabulation<B::Scalar, B::Orders> {
    let degree = B::FACTORS.iter().map(|factor| factor.degree()).sum();
    let orders: Vec<B::Orders> = orders(kept(order, degree));
    let weights = basis.bernstein_weights();
    let mut table = empty(at.len(), B::LEN, order, orders);
    for &at in at {
        table.numbers.extend_from_slice(basis.values(at).as_ref());
        for &orders in &table.orders[1..] {
            let mut net = weights;
            let row = crate::product::partial::<B, B::Values>(net.as_mut(), at, orders);
            table.numbers.extend_from_slice(row.as_ref());
        }
    }
    table
}

fn empty<S: Scalar, O>(points: usize, functions: usize, order: usize, orders: Vec<O>) -> Tabulation<S, O> {
    let numbers = Vec::with_capacity(points * orders.len() * functions);
    Tabulation { points, functions, order, orders, numbers, zeros: vec![S::ZERO; functions] }
}

/// The Bernstein nets of the derivatives of all functions on a box.
struct Grid<S> {
    /// For each order but the first, the degree in each coordinate and the net, a row of numbers for each element;
    /// nothing where the derivative is zero.
    nets: Vec<Option<(Vec<usize>, Vec<S>)>>,
    degrees: Vec<usize>,
    domain: Vec<[S; 2]>,
    functions: usize,
}

impl<S: Scalar> Grid<S> {
    fn new<V: Point<Scalar = S>, O: Array<usize>>(
        weights: &[V],
        degrees: &[usize],
        orders: &[O],
        domain: &[[S; 2]],
    ) -> Self {
        let values: Vec<S> = weights.iter().flat_map(|row| (0..V::DIM).map(|i| row.component(i))).collect();
        let net = |orders: &O| {
            let (mut degrees, mut net) = (degrees.to_vec(), values.clone());
            for (axis, &order) in orders.as_ref().iter().enumerate() {
                if order > degrees[axis] {
                    return None;
                }
                let scale = inverse_width(domain[axis]);
                for _ in 0..order {
                    let inner =
                        degrees[axis + 1..].iter().map(|degree| degree + 1).product::<usize>() * V::DIM;
                    let factor = S::from_usize(degrees[axis]) * scale;
                    let fibres = net.chunks_exact((degrees[axis] + 1) * inner);
                    net = fibres
                        .flat_map(|fibre| fibre[inner..].iter().zip(fibre).map(|(&b, &a)| (b - a) * factor))
                        .collect();
                    degrees[axis] -= 1;
                }
            }
            Some((degrees, net))
        };
        let nets = orders[1..].iter().map(net).collect();
        Self { nets, degrees: degrees.to_vec(), domain: domain.to_vec(), functions: V::DIM }
    }

    /// Adds the derivatives at a point to a list.
    fn derivatives(&self, at: &[S], numbers: &mut Vec<S>) {
        // Bernstein's functions of each degree in each coordinate.
        let functions: Vec<Vec<Vec<S>>> = (0..at.len())
            .map(|axis| {
                let [s, x] = unit(self.domain[axis], at[axis]);
                let mut functions = vec![vec![S::ONE]];
                for degree in 0..self.degrees[axis] {
                    let below = &functions[degree];
                    let next = (0..degree + 2).map(|j| match j {
                        0 => below[0] * s,
                        j if j <= degree => below[j] * s + below[j - 1] * x,
                        _ => below[degree] * x,
                    });
                    functions.push(next.collect());
                }
                functions
            })
            .collect();
        for net in &self.nets {
            let start = numbers.len();
            numbers.resize(start + self.functions, S::ZERO);
            let Some((degrees, net)) = net else { continue };
            let row = &mut numbers[start..];
            for (element, values) in net.chunks_exact(self.functions).enumerate() {
                let (mut weight, mut rest) = (S::ONE, element);
                for axis in (0..at.len()).rev() {
                    let degree = degrees[axis];
                    weight = weight * functions[axis][degree][rest % (degree + 1)];
                    rest /= degree + 1;
                }
                for (sum, &value) in row.iter_mut().zip(values) {
                    *sum = value.fma::<{ crate::FUSED_HERE }>(weight, *sum);
                }
            }
        }
    }
}
