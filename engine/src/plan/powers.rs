//! Powers of coordinates: each one is computed once.

use super::{Builder, Let, Node, Ref};

impl Builder {
    /// The power of the coordinate at a position; `None` for the exponent 0.
    pub(super) fn power(&mut self, base: usize, exponent: u32) -> Option<Ref> {
        let (name, coordinate) = &self.coordinates[base];
        match exponent {
            0 => return None,
            1 => return Some(*coordinate),
            _ => {}
        }
        if let Some((_, _, power)) = self.powers.iter().find(|(b, e, _)| *b == base && *e == exponent) {
            return Some(*power);
        }
        let joint = if name.ends_with(|c: char| c.is_ascii_digit()) { "_" } else { "" };
        let name = format!("{name}{joint}{exponent}");
        let (a, b) = (self.power(base, exponent / 2)?, self.power(base, exponent - exponent / 2)?);
        let power = self.push(Node::Product(a, b));
        self.power_lets.push(Let { names: vec![name], value: power });
        self.powers.push((base, exponent, power));
        Some(power)
    }

    /// The product of powers of all coordinates; `None` for 1.
    pub(super) fn monomial(&mut self, exponents: &[u32]) -> Option<Ref> {
        let mut factors = Vec::new();
        for (base, exponent) in exponents.iter().enumerate() {
            factors.extend(self.power(base, *exponent));
        }
        if factors.is_empty() { None } else { Some(self.product(&factors)) }
    }
}
