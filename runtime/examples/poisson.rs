//! Finite elements: Poisson's equation on the square, with linear, quadratic and cubic triangles.
//!
//! `cargo run --example poisson` solves `-Δu = f` on the unit square, `u = 0` on its sides, on finer and finer meshes, and
//! prints the errors against `u = sin(πx) sin(πy)` with the rates at which they fall: `p + 1` for the values and `p` for
//! the gradients with elements of degree `p`.

use std::collections::HashMap;
use std::error::Error;
use std::f64::consts::PI;

use basis_runtime::{Quadrature, TriangularBasis, basis};

basis!(library "lagrange",
    TriangularLagrange(1) as Linear, TriangularLagrange(2) as Quadratic, TriangularLagrange(3) as Cubic);

fn solution([x, y]: [f64; 2]) -> f64 {
    (PI * x).sin() * (PI * y).sin()
}

fn gradient([x, y]: [f64; 2]) -> [f64; 2] {
    [PI * (PI * x).cos() * (PI * y).sin(), PI * (PI * x).sin() * (PI * y).cos()]
}

/// The right-hand side `-Δu`.
fn load(at: [f64; 2]) -> f64 {
    2.0 * PI * PI * solution(at)
}

/// The corners of the two triangles of each of `n × n` squares.
fn triangles(n: usize) -> impl Iterator<Item = [[f64; 2]; 3]> {
    let corner = move |i: usize, j: usize| [i as f64 / n as f64, j as f64 / n as f64];
    (0..n * n).flat_map(move |square| {
        let (i, j) = (square / n, square % n);
        let (a, b, c, d) = (corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1));
        [[a, b, c], [a, c, d]]
    })
}

/// The point of a triangle with these barycentric coordinates.
fn point(corners: [[f64; 2]; 3], at: [f64; 3]) -> [f64; 2] {
    [0, 1].map(|d| (0..3).map(|j| at[j] * corners[j][d]).sum())
}

/// The errors of the values and of the gradients, in the mean over the square.
fn errors<B: TriangularBasis<Scalar = f64>>(family: B, n: usize) -> Result<[f64; 2], Box<dyn Error>> {
    // What does not depend on the triangle, computed once.
    let rule = Quadrature::<[f64; 3]>::on_simplex(2 * B::DEGREE + 2)?;
    let table = family.tabulate(rule.points(), 1);
    let nodes = family.nodes().ok_or("the family is not nodal")?;

    // One unknown for each node, whichever triangles it is part of.
    let key = |at: [f64; 2]| at.map(|x| (x * 1e9).round() as i64);
    let mut numbers = HashMap::new();
    let mut fixed = Vec::new();
    let cells: Vec<([[f64; 2]; 3], Vec<usize>)> = triangles(n)
        .map(|corners| {
            let unknowns = nodes.as_ref().iter().map(|&node| {
                let at = point(corners, node);
                let next = numbers.len();
                let number = *numbers.entry(key(at)).or_insert(next);
                if number == next {
                    fixed.push(at.iter().any(|&x| x.min(1.0 - x) < 1e-9));
                }
                number
            });
            (corners, unknowns.collect())
        })
        .collect();

    // ∫ ∇b[i]·∇b[j] and ∫ f b[i], triangle by triangle.
    let mut rows: Vec<HashMap<usize, f64>> = vec![HashMap::new(); fixed.len()];
    let mut right = vec![0.0; fixed.len()];
    for (corners, unknowns) in &cells {
        let (area, gradients) = physical(*corners);
        for (q, (at, weight)) in rule.iter().enumerate() {
            let weight = weight * 2.0 * area;
            let slopes: Vec<[f64; 2]> =
                (0..unknowns.len()).map(|i| apply(gradients, table.gradient(q, i))).collect();
            let load = load(point(*corners, at));
            for (i, &row) in unknowns.iter().enumerate() {
                right[row] += weight * load * table.values(q)[i];
                for (j, &column) in unknowns.iter().enumerate() {
                    let product = slopes[i][0] * slopes[j][0] + slopes[i][1] * slopes[j][1];
                    *rows[row].entry(column).or_insert(0.0) += weight * product;
                }
            }
        }
    }
    let values = conjugate_gradients(&rows, &right, &fixed);

    // The errors, by the same rule.
    let mut squares = [0.0, 0.0];
    for (corners, unknowns) in &cells {
        let (area, gradients) = physical(*corners);
        for (q, (at, weight)) in rule.iter().enumerate() {
            let at = point(*corners, at);
            let (mut value, mut slope) = (0.0, [0.0, 0.0]);
            for (i, &unknown) in unknowns.iter().enumerate() {
                value += values[unknown] * table.values(q)[i];
                let [x, y] = apply(gradients, table.gradient(q, i));
                slope = [slope[0] + values[unknown] * x, slope[1] + values[unknown] * y];
            }
            let exact = gradient(at);
            squares[0] += weight * 2.0 * area * (value - solution(at)).powi(2);
            squares[1] +=
                weight * 2.0 * area * ((slope[0] - exact[0]).powi(2) + (slope[1] - exact[1]).powi(2));
        }
    }
    Ok(squares.map(f64::sqrt))
}

/// The area of a triangle, and the gradients in the plane of the coordinates `u` and `v`.
fn physical([a, b, c]: [[f64; 2]; 3]) -> (f64, [[f64; 2]; 2]) {
    // The map from (u, v) to the plane has these columns.
    let (along_u, along_v) = ([a[0] - c[0], a[1] - c[1]], [b[0] - c[0], b[1] - c[1]]);
    let determinant = along_u[0] * along_v[1] - along_u[1] * along_v[0];
    let of_u = [along_v[1] / determinant, -along_v[0] / determinant];
    let of_v = [-along_u[1] / determinant, along_u[0] / determinant];
    (determinant.abs() / 2.0, [of_u, of_v])
}

fn apply([of_u, of_v]: [[f64; 2]; 2], [u, v]: [f64; 2]) -> [f64; 2] {
    [u * of_u[0] + v * of_v[0], u * of_u[1] + v * of_v[1]]
}

/// The solution of the symmetric system, with zeros for the unknowns that are fixed.
fn conjugate_gradients(rows: &[HashMap<usize, f64>], right: &[f64], fixed: &[bool]) -> Vec<f64> {
    let free = |i: usize, x: f64| if fixed[i] { 0.0 } else { x };
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let mut solution = vec![0.0; right.len()];
    let mut residual: Vec<f64> = right.iter().enumerate().map(|(i, &x)| free(i, x)).collect();
    let mut direction = residual.clone();
    let mut square = dot(&residual, &residual);
    let goal = square * 1e-26;
    for _ in 0..10 * right.len() {
        if square <= goal {
            break;
        }
        let image: Vec<f64> = rows
            .iter()
            .enumerate()
            .map(|(i, row)| free(i, row.iter().map(|(&j, entry)| entry * direction[j]).sum()))
            .collect();
        let step = square / dot(&direction, &image);
        for i in 0..right.len() {
            solution[i] += step * direction[i];
            residual[i] -= step * image[i];
        }
        let next = dot(&residual, &residual);
        for i in 0..right.len() {
            direction[i] = residual[i] + next / square * direction[i];
        }
        square = next;
    }
    solution
}

/// Prints the errors on meshes of `2`, `4`, … squares on a side, and checks the rates.
fn study<B: TriangularBasis<Scalar = f64>>(family: B) -> Result<(), Box<dyn Error>> {
    println!("{}, degree {}\n   n     values  rate  gradients  rate", B::NAME, B::DEGREE);
    let mut before: Option<[f64; 2]> = None;
    for n in [2, 4, 8, 16] {
        let errors = errors(family, n)?;
        let rates = before.map(|before| [0, 1].map(|k| (before[k] / errors[k]).log2()));
        match rates {
            None => println!("{n:4} {:10.2e}       {:10.2e}", errors[0], errors[1]),
            Some([a, b]) => println!("{n:4} {:10.2e} {a:5.2} {:10.2e} {b:5.2}", errors[0], errors[1]),
        }
        if n == 16 {
            let degree = B::DEGREE as f64;
            let [values, gradients] = rates.ok_or("there are two meshes")?;
            assert!((values - degree - 1.0).abs() < 0.1 && (gradients - degree).abs() < 0.1);
        }
        before = Some(errors);
    }
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    study(Linear::new())?;
    study(Quadratic::new())?;
    study(Cubic::new())
}

#[test]
fn runs() {
    main().unwrap();
}
