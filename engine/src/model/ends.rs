//! Derivatives at an end of an interval, and the domain reversed; of angles by `angle_ends`.

use super::Family;
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::Var;
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;

impl Family {
    /// The value of a function and its derivatives up to an order at the lower or the upper end of an interval. `None` when
    /// there is no interval or no value, or the work is spent.
    pub fn derivatives_at_end(
        &self,
        f: &Fraction,
        order: u32,
        upper: bool,
        work: &mut Work,
    ) -> Option<Vec<Fraction>> {
        let (var, low, high) = self.interval()?;
        let Some(angle) = self.analytic.angle(var) else {
            let (mut derivative, mut all) = (f.clone(), vec![self.at_end(f, upper, work)?]);
            for _ in 0..order {
                derivative = self.derivative_within(&derivative, var, work)?;
                all.push(self.at_end(&derivative, upper, work)?);
            }
            return Some(all);
        };
        let end = if upper { high } else { low };
        super::angle::ends::derivatives(self, angle, f, (end, upper), order, work)
    }
}

/// What takes the place of s and of y of a span in that one which takes its place when the domain is reversed, in s and y
/// of the latter; both hold the same angle. `None` when the work is spent.
pub(crate) fn reversed(piece: &Family, mirrored: &Family, work: &mut Work) -> Option<Vec<(Var, Fraction)>> {
    let ((var, low, high), (other, other_low, other_high)) = (piece.interval()?, mirrored.interval()?);
    let one = Fraction::constant(Rational::ONE);
    let u = &(&Fraction::var(var) - &Fraction::constant(low.clone()))
        * &Fraction::constant((high - low).recip()?);
    let span = Fraction::constant(other_high - other_low);
    let start = Fraction::constant(other_low.clone());
    let (Some(own), Some(angle)) = (piece.analytic.angle(var), mirrored.analytic.angle(other)) else {
        return Some(vec![(other, &start + &(&span * &(&one - &u)))]);
    };
    super::angle::ends::reversed((own, angle), [low, high], [other_low, other_high], &u, work)
}
