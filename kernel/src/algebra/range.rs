//! Ranges of real numbers with rational, infinite, included or excluded ends, and boxes of them.

use core::cmp::Ordering;

use super::poly::Var;
use super::rational::Rational;

/// One end of a range.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum End {
    /// The range goes on without end.
    Infinite,
    /// The range ends here and contains the end.
    Included(Rational),
    /// The range ends here and does not contain the end.
    Excluded(Rational),
}

impl End {
    /// The number at which the range ends.
    pub fn value(&self) -> Option<&Rational> {
        match self {
            Self::Infinite => None,
            Self::Included(v) | Self::Excluded(v) => Some(v),
        }
    }

    /// Whether the end belongs to the range.
    pub fn is_included(&self) -> bool {
        matches!(self, Self::Included(_))
    }
}

/// A range of real numbers.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Range {
    /// The lower end.
    pub low: End,
    /// The upper end.
    pub high: End,
}

impl Range {
    /// The range low ≤ x ≤ high.
    pub fn closed(low: Rational, high: Rational) -> Self {
        Self { low: End::Included(low), high: End::Included(high) }
    }

    /// The range 0 ≤ x ≤ 1.
    pub fn unit() -> Self {
        Self::closed(Rational::ZERO, Rational::ONE)
    }

    /// All real numbers.
    pub const fn all() -> Self {
        Self { low: End::Infinite, high: End::Infinite }
    }

    /// Whether a number lies in the range.
    pub fn contains(&self, x: &Rational) -> bool {
        let inside = |end: &End, beyond: Ordering| {
            let holds = |order: Ordering| order == beyond || order.is_eq() && end.is_included();
            end.value().is_none_or(|v| holds(x.cmp(v)))
        };
        inside(&self.low, Ordering::Greater) && inside(&self.high, Ordering::Less)
    }

    /// Whether no number lies in the range.
    pub fn is_empty(&self) -> bool {
        match (self.low.value(), self.high.value()) {
            (Some(a), Some(b)) if a == b => !(self.low.is_included() && self.high.is_included()),
            (Some(a), Some(b)) => a > b,
            _ => false,
        }
    }

    /// The two ends, if both are finite.
    pub fn finite(&self) -> Option<(&Rational, &Rational)> {
        Some((self.low.value()?, self.high.value()?))
    }
}

/// A box: a range for each of some variables.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct Region {
    /// The variables in increasing order, each once.
    pub ranges: Vec<(Var, Range)>,
}

impl Region {
    /// The range of a variable; all real numbers if the box says nothing of it.
    pub fn range(&self, var: Var) -> Range {
        self.ranges.iter().find(|(v, _)| *v == var).map_or(Range::all(), |(_, r)| r.clone())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ends_count_as_declared() {
        let n = Rational::from;
        let all = |x: i64| [End::Included(n(x)), End::Excluded(n(x)), End::Infinite];
        for low in all(1) {
            for (high_at, high) in [1, 2, 0].into_iter().flat_map(|at| all(at).map(|end| (at, end))) {
                let range = Range { low: low.clone(), high: high.clone() };
                let below = |x: i64| match &low {
                    End::Included(_) => x >= 1,
                    End::Excluded(_) => x > 1,
                    End::Infinite => true,
                };
                let above = |x: i64| match &high {
                    End::Included(_) => x <= high_at,
                    End::Excluded(_) => x < high_at,
                    End::Infinite => true,
                };
                for x in -1..=3 {
                    assert_eq!(range.contains(&n(x)), below(x) && above(x), "{x} in {range:?}");
                }
                // Between 1 and 2 there are others.
                let any = (-1..=3).any(|x| below(x) && above(x));
                let between = below(2) && (high_at == 2 || high == End::Infinite) || low == End::Infinite;
                assert_eq!(range.is_empty(), !any && !between, "{range:?}");
            }
        }
    }
}
