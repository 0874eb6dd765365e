//! Gauss–Legendre quadrature on `[-1, 1]`.

use crate::Scalar;

/// A rule with an even number of nodes, `±node` for each pair `[node, weight]`; exact for polynomials of degree
/// `4 pairs - 1`.
pub(crate) struct Rule {
    pairs: &'static [[f64; 2]],
}

impl Rule {
    /// The number of nodes.
    pub(crate) fn len(&self) -> u32 {
        2 * self.pairs.len() as u32
    }

    /// The integral over `[-1, 1]`.
    #[inline]
    pub(crate) fn integrate<S: Scalar>(&self, f: impl Fn(S) -> S) -> S {
        self.pairs.iter().fold(S::ZERO, |sum, &[node, weight]| {
            let node = S::of(node);
            sum + (f(-node) + f(node)) * S::of(weight)
        })
    }
}

/// The rules with 4, 8, 12, 16 and 24 nodes: the zeros of Legendre's polynomials, computed with 50 digits.
#[allow(clippy::excessive_precision, clippy::unreadable_literal)] // the shortest decimals of the nearest floats
pub(crate) static RULES: [Rule; 5] = [
    Rule { pairs: &[[0.33998104358485626, 0.6521451548625461], [0.8611363115940526, 0.34785484513745385]] },
    Rule {
        pairs: &[
            [0.1834346424956498, 0.362683783378362],
            [0.525532409916329, 0.31370664587788727],
            [0.7966664774136267, 0.22238103445337448],
            [0.9602898564975363, 0.10122853629037626],
        ],
    },
    Rule {
        pairs: &[
            [0.1252334085114689, 0.24914704581340277],
            [0.3678314989981802, 0.2334925365383548],
            [0.5873179542866175, 0.20316742672306592],
            [0.7699026741943047, 0.16007832854334622],
            [0.9041172563704749, 0.10693932599531843],
            [0.9815606342467192, 0.04717533638651183],
        ],
    },
    Rule {
        pairs: &[
            [0.09501250983763744, 0.1894506104550685],
            [0.2816035507792589, 0.18260341504492358],
            [0.45801677765722737, 0.16915651939500254],
            [0.6178762444026438, 0.14959598881657674],
            [0.755404408355003, 0.12462897125553388],
            [0.8656312023878318, 0.09515851168249279],
            [0.9445750230732326, 0.062253523938647894],
            [0.9894009349916499, 0.027152459411754096],
        ],
    },
    Rule {
        pairs: &[
            [0.06405689286260563, 0.12793819534675216],
            [0.1911188674736163, 0.1258374563468283],
            [0.3150426796961634, 0.12167047292780339],
            [0.4337935076260451, 0.1155056680537256],
            [0.5454214713888396, 0.10744427011596563],
            [0.6480936519369755, 0.09761865210411388],
            [0.7401241915785544, 0.08619016153195327],
            [0.820001985973903, 0.0733464814110803],
            [0.8864155270044011, 0.05929858491543678],
            [0.9382745520027328, 0.04427743881741981],
            [0.9747285559713095, 0.028531388628933663],
            [0.9951872199970213, 0.0123412297999872],
        ],
    },
];

#[cfg(test)]
mod tests {
    use super::RULES;

    #[test]
    fn polynomials_up_to_the_degree_are_integrated_exactly() {
        for rule in &RULES {
            let degree = 2 * rule.len() as i32 - 2;
            let integral: f64 = rule.integrate(|x: f64| x.powi(degree) + x.powi(degree + 1));
            assert!((integral * f64::from(degree + 1) / 2.0 - 1.0).abs() < 1e-13);
            let beyond: f64 = rule.integrate(|x: f64| x.powi(degree + 2));
            assert!((beyond * f64::from(degree + 3) / 2.0 - 1.0).abs() > 1e-13);
        }
    }
}
