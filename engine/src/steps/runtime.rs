//! The functions of the runtime, written out: each does what the function of that name does there, operation by
//! operation. A change of association on either side fails the test of faithfulness.

use super::Builder;
use crate::algebra::number::binomial;
use crate::algebra::rational::Rational;
use crate::plan::patch::form::multi_indices;
use basis_prover::collections::list::Listed;

impl Builder {
    /// `Point::add_weighted`: a + b·factor.
    fn add_scaled(&mut self, a: usize, b: usize, factor: usize) -> usize {
        let product = self.mul(b, factor);
        self.add(a, product)
    }

    fn zero(&mut self) -> usize {
        self.constant(Rational::ZERO)
    }

    fn one(&mut self) -> usize {
        self.constant(Rational::ONE)
    }

    /// `domain::unit`: `[s, x]` of a parameter.
    pub(super) fn unit(&mut self, [low, high]: [usize; 2], t: usize) -> [usize; 2] {
        let width = self.sub(high, low);
        let (to_high, from_low) = (self.sub(high, t), self.sub(t, low));
        [self.div(to_high, width), self.div(from_low, width)]
    }

    /// `domain::inverse_width`: 1/(high − low).
    pub(super) fn inverse_width(&mut self, [low, high]: [usize; 2]) -> usize {
        let (one, width) = (self.one(), self.sub(high, low));
        self.div(one, width)
    }

    /// `basis::combination`: Σ weight·point, from the first to the last.
    pub(super) fn combination(&mut self, points: &[usize], weights: &[usize]) -> usize {
        let mut sum = None;
        for (point, weight) in points.iter().zip(weights) {
            sum = Some(match sum {
                None => self.mul(*point, *weight),
                Some(sum) => self.add_scaled(sum, *point, *weight),
            });
        }
        sum.unwrap_or_else(|| self.zero())
    }

    /// `macro_support::bernstein`.
    pub(crate) fn bernstein(&mut self, coefficients: &[usize], s: usize, x: usize) -> usize {
        let degree = coefficients.len().saturating_sub(1) as u32;
        let binomials: Vec<Rational> = (0..=degree).map(|k| binomial(degree, k)).collect();
        self.nested(coefficients, &binomials, s, x)
    }

    /// `form::nested`: Σ binomial·s^(n−k)·x^k·point, nested in s.
    pub(super) fn nested(&mut self, points: &[usize], binomials: &[Rational], s: usize, x: usize) -> usize {
        let Some((first, rest)) = points.split_first() else { return self.zero() };
        let (mut sum, mut power) = (*first, self.one());
        for (point, binomial) in rest.iter().zip(&binomials[1..]) {
            power = self.mul(power, x);
            let binomial = self.constant(binomial.clone());
            let factor = self.mul(power, binomial);
            let scaled = self.mul(sum, s);
            sum = self.add_scaled(scaled, *point, factor);
        }
        sum
    }

    /// What `RationalCurve::new` makes of Bernstein coefficients: each times its binomial coefficient.
    pub(super) fn with_binomials(&mut self, coefficients: &[usize]) -> Vec<usize> {
        let degree = coefficients.len().saturating_sub(1) as u32;
        let mut scaled = Vec::new();
        for (c, k) in coefficients.iter().zip(0..) {
            let binomial = self.constant(binomial(degree, k));
            scaled.push(self.mul(*c, binomial));
        }
        scaled
    }

    /// `rational::curve::nested`: Σ c·s^(n−k)·x^k, nested in s.
    pub(super) fn nested_in_powers(&mut self, coefficients: &[usize], s: usize, x: usize) -> usize {
        let Some((first, rest)) = coefficients.split_first() else { return self.zero() };
        let (mut sum, mut power) = (*first, self.one());
        for c in rest {
            power = self.mul(power, x);
            let scaled = self.mul(sum, s);
            sum = self.add_scaled(scaled, *c, power);
        }
        sum
    }

    /// `macro_support::affine_bernstein`: as [`bernstein`](Self::bernstein) for s + x = 1, in the smaller of both.
    pub(super) fn affine_bernstein(&mut self, points: &[usize], s: usize, x: usize) -> usize {
        let degree = points.len().saturating_sub(1);
        if degree < 2 {
            return self.bernstein(points, s, x);
        }
        // One of two numbers, which is that times 1 and the other one times 0.
        let (is_first, one) = (self.less(x, s), self.one());
        let is_last = self.sub(one, is_first);
        let mut either = |a: usize, b: usize| {
            let (a, b) = (self.mul(a, is_first), self.mul(b, is_last));
            self.add(a, b)
        };
        let smaller = either(x, s);
        let from_its_end: Vec<usize> =
            (0..points.len()).map(|k| either(points[k], points[degree - k])).collect();
        self.in_smaller(&from_its_end, smaller)
    }

    /// [`affine_bernstein`](Self::affine_bernstein) where the k-th of both is the smaller one.
    pub(crate) fn bernstein_in(&mut self, k: usize, points: &[usize], s: usize, x: usize) -> usize {
        match (points.len(), k) {
            (..3, _) => self.bernstein(points, s, x),
            (_, 0) => self.in_smaller(&points.iter().rev().copied().listed(), s),
            _ => self.in_smaller(points, x),
        }
    }

    /// The sum in Bernstein form in the smaller of two coordinates with the sum 1.
    fn in_smaller(&mut self, points: &[usize], smaller: usize) -> usize {
        let degree = points.len().saturating_sub(1) as u32;
        let Some((first, rest)) = points.split_first() else { return self.zero() };
        let (mut sum, mut lost, mut power) = (*first, self.zero(), self.one());
        for (point, k) in rest.iter().zip(1..) {
            power = self.mul(power, smaller);
            let binomial = self.constant(binomial(degree, k));
            let (factor, product) = (self.mul(power, binomial), self.mul(sum, smaller));
            let term = self.mul(*point, factor);
            let step = self.sub(term, product);
            let next = self.add(sum, step);
            let rounded = self.sub(sum, next);
            let rounded = self.add(rounded, step);
            let left = self.mul(lost, smaller);
            let left = self.sub(lost, left);
            (sum, lost) = (next, self.add(left, rounded));
        }
        self.add(sum, lost)
    }

    /// `form::difference`: all but the last replaced by the difference to the next.
    fn difference(&mut self, points: &mut [usize]) {
        for i in 1..points.len() {
            points[i - 1] = self.sub(points[i], points[i - 1]);
        }
    }

    /// `form::bernstein_derivative`: differences, then de Casteljau's algorithm.
    pub(super) fn bernstein_derivative(
        &mut self,
        coefficients: &[usize],
        order: usize,
        s: usize,
        x: usize,
    ) -> usize {
        let mut coefficients = coefficients.to_vec();
        let len = coefficients.len();
        if order >= len {
            return self.zero();
        }
        let mut factor = self.one();
        for k in 0..order {
            let next = self.integer(len - 1 - k);
            factor = self.mul(factor, next);
            self.difference(&mut coefficients[..len - k]);
        }
        let value = self.casteljau(&mut coefficients[..len - order], s, x);
        self.mul(value, factor)
    }

    /// De Casteljau's algorithm: `boxes::net::finish`.
    fn casteljau(&mut self, coefficients: &mut [usize], s: usize, x: usize) -> usize {
        for end in (1..coefficients.len()).rev() {
            for i in 0..end {
                let scaled = self.mul(coefficients[i], s);
                coefficients[i] = self.add_scaled(scaled, coefficients[i + 1], x);
            }
        }
        coefficients[0]
    }

    /// `EndpointForm::eval_with_derivs`: the point and its derivatives in x, `count` values in all; for one it is `eval`.
    pub(super) fn endpoint(
        &mut self,
        ends: [usize; 2],
        inner: &[usize],
        x: usize,
        count: usize,
    ) -> Vec<usize> {
        let one = self.one();
        let s = self.sub(one, x);
        let y = self.sub(x, s);
        let product = self.mul(s, x);
        self.name(s, "s");
        self.name(y, "y");
        let mut results = vec![self.endpoint_point(ends, inner, [s, x, y, product])];
        let mut taylor = vec![self.zero(); count];
        for (step, coefficient) in inner.iter().rev().enumerate() {
            for j in (1..count.min(step + 1)).rev() {
                taylor[j] =
                    if j < step { self.add_scaled(taylor[j - 1], taylor[j], y) } else { taylor[j - 1] };
            }
            taylor[0] = if step > 0 { self.add_scaled(*coefficient, taylor[0], y) } else { *coefficient };
        }
        let chord = self.sub(ends[1], ends[0]);
        // 2^(k−2) k!
        let mut factor = Rational::new(1, 4);
        for k in 1..count {
            if k >= inner.len() + 2 {
                results.push(self.zero());
                continue;
            }
            factor = &factor * &Rational::from(2 * k as i64);
            let [negative, twice, fourfold] =
                [-1, -2, 4].map(|n| self.constant(&factor * &Rational::from(n)));
            let mut sum = if k == 1 { chord } else { self.mul(taylor[k - 2], negative) };
            if k - 1 < inner.len() {
                let weight = self.mul(twice, y);
                sum = self.add_scaled(sum, taylor[k - 1], weight);
            }
            if k < inner.len() {
                let weight = self.mul(fourfold, product);
                sum = self.add_scaled(sum, taylor[k], weight);
            }
            results.push(sum);
        }
        results
    }

    /// `EndpointForm::eval`.
    fn endpoint_point(&mut self, ends: [usize; 2], inner: &[usize], [s, x, y, product]: [usize; 4]) -> usize {
        let start = self.mul(ends[0], s);
        let chord = self.add_scaled(start, ends[1], x);
        let Some((last, rest)) = inner.split_last() else { return chord };
        let mut sum = *last;
        for coefficient in rest.iter().rev() {
            sum = self.add_scaled(*coefficient, sum, y);
        }
        self.add_scaled(chord, sum, product)
    }

    /// `BernsteinForm::eval_with_derivs`: the point and its derivatives in x, `count` values in all; for one it is `eval`.
    pub(super) fn bernstein_form(&mut self, points: &[usize], x: usize, count: usize) -> Vec<usize> {
        let one = self.one();
        let s = self.sub(one, x);
        self.name(s, "s");
        let mut differences = points.to_vec();
        let mut factor = self.one();
        let mut results = Vec::new();
        for k in 0..count {
            let Some(len) = points.len().checked_sub(k).filter(|len| *len > 0) else {
                results.push(self.zero());
                continue;
            };
            if k > 0 {
                let next = self.integer(len);
                factor = self.mul(factor, next);
                self.difference(&mut differences[..=len]);
            }
            let value = self.bernstein(&differences[..len], s, x);
            results.push(self.mul(value, factor));
        }
        results
    }

    /// `simplex::simplex_sum`.
    pub(super) fn simplex_sum(&mut self, coefficients: &[usize], at: &[usize], n: usize) -> usize {
        match *at {
            [u, v, w] => self.triangle_sum(coefficients, [u, v, w], n),
            [u, v, w, x] => {
                let mut end = coefficients.len();
                let mut sum = self.zero();
                for m in 0..=n {
                    let start = end - (m + 1) * (m + 2) / 2;
                    let layer = self.triangle_sum(&coefficients[start..end], [v, w, x], m);
                    sum = self.mul(sum, u);
                    sum = self.add(sum, layer);
                    end = start;
                }
                sum
            }
            _ => self.zero(),
        }
    }

    fn triangle_sum(&mut self, coefficients: &[usize], [u, v, w]: [usize; 3], n: usize) -> usize {
        let mut end = coefficients.len();
        let mut sum = self.zero();
        for m in 0..=n {
            let row = &coefficients[end - m - 1..end];
            end -= m + 1;
            let row = self.nested_row(row, w, v);
            sum = self.mul(sum, u);
            sum = self.add(sum, row);
        }
        sum
    }

    /// Σ `terms[k]` s^(n−k) x^k, nested in s, without binomial coefficients.
    fn nested_row(&mut self, terms: &[usize], s: usize, x: usize) -> usize {
        let (mut sum, mut power) = (terms[0], self.one());
        for term in &terms[1..] {
            power = self.mul(power, x);
            let (scaled, next) = (self.mul(sum, s), self.mul(*term, power));
            sum = self.add(scaled, next);
        }
        sum
    }

    /// `boxes::box_sum`.
    pub(super) fn box_sum(
        &mut self,
        coefficients: &[usize],
        degrees: &[usize],
        units: &[[usize; 2]],
    ) -> usize {
        let mut coefficients = coefficients.to_vec();
        for (degree, [s, x]) in degrees.iter().zip(units).rev() {
            let fibres: Vec<Vec<usize>> = coefficients.chunks(degree + 1).map(<[usize]>::to_vec).collect();
            coefficients = fibres.iter().map(|fibre| self.nested_row(fibre, *s, *x)).collect();
        }
        coefficients[0]
    }

    /// `simplex::net::contract`: a step down in a net of order `n`, c[β] = Σ_j a[j] c[β + e_j], from the last j to the
    /// first.
    fn contract(&mut self, net: &[usize], n: usize, a: &[usize]) -> Vec<usize> {
        let above = multi_indices(a.len(), n as u32);
        let mut contracted = Vec::new();
        for mut index in multi_indices(a.len(), n as u32 - 1) {
            let mut sum = None;
            for j in (0..a.len()).rev() {
                index[j] += 1;
                let element = net[above.binary_search(&index).unwrap_or(0)];
                index[j] -= 1;
                sum = Some(match sum {
                    None => self.mul(element, a[j]),
                    Some(sum) => self.add_scaled(sum, element, a[j]),
                });
            }
            contracted.extend(sum);
        }
        contracted
    }

    /// `simplex::differentiate` along the directions of the coordinates but the last, which is 1 minus their sum, in
    /// turn; `None` above the degree. With the degree that is left.
    pub(super) fn simplex_partial(
        &mut self,
        net: &[usize],
        degree: usize,
        orders: &[usize],
    ) -> Option<(Vec<usize>, usize)> {
        let (mut net, mut degree) = (net.to_vec(), degree);
        for (place, order) in orders.iter().enumerate() {
            if *order > degree {
                return None;
            }
            let along = |j: usize| match j {
                _ if j == place => 1,
                _ if j == orders.len() => -1,
                _ => 0,
            };
            let along: Vec<usize> =
                (0..=orders.len()).map(|j| self.constant(Rational::from(along(j)))).collect();
            for m in (degree - order + 1..=degree).rev() {
                let factor = self.integer(m);
                net = self.contract(&net, m, &along);
                net = net.iter().map(|element| self.mul(*element, factor)).collect();
            }
            degree -= order;
        }
        Some((net, degree))
    }

    /// `simplex::finish`: de Casteljau's algorithm to the end.
    pub(super) fn simplex_finish(&mut self, net: &[usize], degree: usize, at: &[usize]) -> usize {
        let mut net = net.to_vec();
        for m in (1..=degree).rev() {
            net = self.contract(&net, m, at);
        }
        net[0]
    }

    /// `simplex::net::triangle_point`: Σ multinomial·x^α·c[α], nested.
    pub(super) fn triangle_point(&mut self, net: &[usize], [u, v, w]: [usize; 3], n: usize) -> usize {
        let factors: Vec<Rational> = multi_indices(3, n as u32)
            .iter()
            .map(|index| &binomial(n as u32, index[0]) * &binomial(n as u32 - index[0], index[1]))
            .collect();
        let mut end = net.len();
        let mut sum = self.zero();
        for m in 0..=n {
            let start = end - m - 1;
            let mut power = self.one();
            let factor = self.constant(factors[start].clone());
            let mut row = self.mul(net[start], factor);
            for place in start + 1..end {
                power = self.mul(power, v);
                let factor = self.constant(factors[place].clone());
                let (scaled, weight) = (self.mul(row, w), self.mul(power, factor));
                row = self.add_scaled(scaled, net[place], weight);
            }
            sum = self.add_scaled(row, sum, u);
            end = start;
        }
        sum
    }

    /// `simplex::raise::raise_weights`, one step: from the table of the functions of an order, with their Bernstein
    /// coefficients of a degree, to that of the next order.
    pub(super) fn raised(
        &mut self,
        table: &[Vec<usize>],
        corners: usize,
        order: u32,
        degree: u32,
    ) -> Vec<Vec<usize>> {
        let [rows, columns] = [degree + 1, order + 1].map(|n| multi_indices(corners, n));
        let zero = self.zero();
        let mut result = vec![vec![zero; columns.len()]; rows.len()];
        for (mut alpha, row) in multi_indices(corners, degree).into_iter().zip(table) {
            for place in 0..corners {
                let [above, below] = [alpha[place] + 1, degree + 1].map(|n| self.integer(n as usize));
                let factor = self.div(above, below);
                alpha[place] += 1;
                let to = rows.binary_search(&alpha).unwrap_or(0);
                alpha[place] -= 1;
                for (mut index, weight) in multi_indices(corners, order).into_iter().zip(row) {
                    index[place] += 1;
                    let column = columns.binary_search(&index).unwrap_or(0);
                    let product = self.mul(factor, *weight);
                    result[to][column] = self.add(result[to][column], product);
                }
            }
        }
        result
    }

    /// `boxes::partial` and `product::partial`: the derivative of these orders of a net. For each factor of the domain
    /// its degree, and the ends of an interval, or of a simplex the number of its corners.
    pub(super) fn net_partial(
        &mut self,
        net: &[usize],
        factors: &[(usize, NetFactor)],
        at: &[usize],
        orders: &[usize],
    ) -> usize {
        let mut net = net.to_vec();
        let mut scale = self.one();
        let (mut at, mut orders) = (at, orders);
        for (degree, factor) in factors.iter().rev() {
            let (all, free) = match factor {
                NetFactor::Interval(_) => (1, 1),
                NetFactor::Simplex(corners) => (*corners, corners - 1),
            };
            let (rest, own) = at.split_at(at.len() - all);
            let (rest_of_orders, own_orders) = orders.split_at(orders.len() - free);
            (at, orders) = (rest, rest_of_orders);
            let mut next = Vec::new();
            match factor {
                NetFactor::Interval(range) => {
                    let order = own_orders[0];
                    if order > *degree {
                        return self.zero();
                    }
                    let inverse = self.inverse_width(*range);
                    let [s, x] = self.unit(*range, own[0]);
                    for fibre in net.chunks(degree + 1) {
                        let mut coefficients = fibre.to_vec();
                        for m in (degree + 1 - order..=*degree).rev() {
                            let factor = self.integer(m);
                            self.difference(&mut coefficients[..=m]);
                            coefficients.truncate(m);
                            coefficients = coefficients.iter().map(|c| self.mul(*c, factor)).collect();
                        }
                        next.push(self.casteljau(&mut coefficients, s, x));
                    }
                    for _ in 0..order {
                        scale = self.mul(scale, inverse);
                    }
                }
                NetFactor::Simplex(corners) => {
                    for block in net.chunks(multi_indices(*corners, *degree as u32).len()) {
                        let Some((block, left)) = self.simplex_partial(block, *degree, own_orders) else {
                            return self.zero();
                        };
                        next.push(self.simplex_finish(&block, left, own));
                    }
                }
            }
            net = next;
        }
        self.mul(net[0], scale)
    }
}

/// A factor of a domain.
pub(super) enum NetFactor {
    /// An interval with these ends.
    Interval([usize; 2]),
    /// A simplex with this number of corners.
    Simplex(usize),
}
