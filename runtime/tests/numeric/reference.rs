//! Polynomials by their monomial coefficients, in `f64`: what the families are, independently of how they are
//! evaluated.

/// The coefficients of `1, t, t², …` of the product of two polynomials.
pub fn product(a: &[f64], b: &[f64]) -> Vec<f64> {
    let mut product = vec![0.0; a.len() + b.len() - 1];
    for (i, a) in a.iter().enumerate() {
        for (j, b) in b.iter().enumerate() {
            product[i + j] += a * b;
        }
    }
    product
}

/// The derivative of that order.
pub fn derivative(polynomial: &[f64], order: usize) -> Vec<f64> {
    (0..order)
        .fold(polynomial.to_vec(), |p, _| p.iter().enumerate().skip(1).map(|(k, c)| k as f64 * c).collect())
}

pub fn evaluate(polynomial: &[f64], t: f64) -> f64 {
    polynomial.iter().rev().fold(0.0, |sum, c| sum * t + c)
}

/// The functions of `QuarticBernstein`, as the paper writes them.
pub fn quartic(lambda: f64) -> [Vec<f64>; 4] {
    let (t, s) = (&[0.0, 1.0][..], &[1.0, -1.0][..]);
    let all = |factors: &[&[f64]]| factors.iter().fold(vec![1.0], |p, factor| product(&p, factor));
    [
        all(&[&[1.0, -lambda], s, s, s]),
        all(&[&[3.0 + lambda, -lambda], t, s, s]),
        all(&[&[3.0, lambda], t, t, s]),
        all(&[&[1.0 - lambda, lambda], t, t, t]),
    ]
}

/// The functions of `UniformCubic`.
pub fn uniform_cubic() -> [Vec<f64>; 4] {
    [[1.0, -3.0, 3.0, -1.0], [4.0, 0.0, -6.0, 3.0], [1.0, 3.0, 3.0, -3.0], [0.0, 0.0, 0.0, 1.0]]
        .map(|coefficients| coefficients.iter().map(|c| c / 6.0).collect())
}

/// The functions of `QuadraticLagrange`.
pub fn quadratic_lagrange() -> [Vec<f64>; 3] {
    [vec![0.0, -0.5, 0.5], vec![1.0, 0.0, -1.0], vec![0.0, 0.5, 0.5]]
}

/// De Casteljau's algorithm: the point at `x` of the Bézier curve over these control points.
pub fn de_casteljau(points: &[f64], x: f64) -> f64 {
    let mut points = points.to_vec();
    for end in (1..points.len()).rev() {
        for i in 0..end {
            points[i] = (1.0 - x) * points[i] + x * points[i + 1];
        }
    }
    points[0]
}
