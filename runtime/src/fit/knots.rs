//! Knots for points: as many as are asked for, or as many as a tolerance needs.

use alloc::vec::Vec;

use crate::Scalar;
use crate::bspline::{FitError, KnotVector};

/// Breakpoints for `count` functions of that degree, so that each span holds parameters: those of interpolation for as many
/// functions as parameters, otherwise by the rule of L. Piegl, W. Tiller, *The NURBS Book* (1997), equation 9.69.
pub(super) fn averaged(degree: usize, count: usize, t: &[f64]) -> Result<Vec<f64>, FitError> {
    let mut sorted = t.to_vec();
    sorted.sort_by(f64::total_cmp);
    let (Some(&lo), Some(&hi)) = (sorted.first(), sorted.last()) else {
        return Err(FitError::TooFew { needed: count, found: 0 });
    };
    if count <= degree {
        return Err(FitError::TooFewFunctions { needed: degree.saturating_add(1), found: count });
    }
    if sorted.len() < count {
        return Err(FitError::TooFew { needed: count, found: sorted.len() });
    }
    let mut breakpoints = alloc::vec![lo];
    if count == sorted.len() {
        for j in 1..count - degree {
            let window = if degree == 0 { &sorted[j - 1..=j] } else { &sorted[j..j + degree] };
            breakpoints.push(window.iter().sum::<f64>() / window.len() as f64);
        }
    } else {
        let step = sorted.len() as f64 / (count - degree) as f64;
        for j in 1..count - degree {
            let place = j as f64 * step;
            let i = (place as usize).clamp(1, sorted.len() - 1);
            let part = (place - i as f64).clamp(0.0, 1.0);
            breakpoints.push((1.0 - part) * sorted[i - 1] + part * sorted[i]);
        }
    }
    breakpoints.push(hi);
    Ok(breakpoints)
}

/// A fit over given knots.
pub(super) struct Over {
    pub(super) knots: KnotVector<f64>,
    pub(super) control: Vec<f64>,
    pub(super) t: Vec<f64>,
    /// The distance of each point.
    pub(super) errors: Vec<f64>,
    pub(super) rounds: usize,
}

impl Over {
    pub(super) fn largest(&self) -> f64 {
        self.errors.iter().fold(0.0, |a, &b| if b > a || b.is_nan() { b } else { a })
    }
}

/// What fits the points with these parameters over a knot vector.
pub(super) type FitOver<'a> = &'a mut dyn FnMut(KnotVector<f64>, &[f64]) -> Result<Over, FitError>;

/// The work that is spent on taking knots away again, in products.
const MOST_REMOVALS: usize = 1 << 23;

/// A fit over as few knots as bring all points within the tolerance: new knots stand where half of the squared error of a span
/// is on each side, then those are taken away that are not needed. `rounds` says how often a fit moves the parameters.
pub(super) fn within(
    degree: usize,
    t: &[f64],
    tolerance: f64,
    rounds: usize,
    fit: FitOver<'_>,
) -> Result<Over, FitError> {
    let mut sorted = t.to_vec();
    sorted.sort_by(f64::total_cmp);
    sorted.dedup();
    let most = sorted.len();
    if most <= degree {
        return Err(FitError::TooFew { needed: degree.saturating_add(1), found: most });
    }
    let mut over = |breakpoints: &[f64]| fit(KnotVector::clamped(degree, breakpoints)?, t);
    let mut breakpoints = alloc::vec![sorted[0], sorted[most - 1]];
    let mut best = over(&breakpoints)?;
    let mut fewest = None;
    // The number of functions that were last tried with knots all over the curve.
    let mut tried = 0;
    while best.largest() > tolerance {
        let functions = breakpoints.len() - 1 + degree;
        let local = refined(degree, &breakpoints, &best, tolerance, most).and_then(|finer| {
            let next = over(&finer).ok()?;
            // Nearly as many functions as points in a part of the curve can determine them badly.
            (next.largest() <= 4.0 * best.largest()).then_some((finer, next))
        });
        let next = local.or_else(|| {
            let count = (2 * functions).min(most);
            if count <= tried {
                return None;
            }
            tried = count;
            let finer = averaged(degree, count, &sorted).ok()?;
            let next = over(&finer).ok()?;
            Some((finer, next))
        });
        let Some(next) = next else {
            return Err(FitError::NotReached { tolerance, reached: best.largest() });
        };
        (breakpoints, best) = next;
    }
    // As few as are enough where the error is the same everywhere.
    let (density, spans) = (density(degree, &best), breakpoints.len() - 1);
    let (mut enough, mut few) = (spans, 0);
    while enough > few + 1 {
        let middle = usize::midpoint(enough, few);
        let spread = spread(&breakpoints, &density, middle);
        match over(&spread) {
            Ok(next) if next.largest() <= tolerance => {
                enough = middle;
                fewest = Some((spread, next));
            }
            _ => few = middle,
        }
    }
    if let Some(found) = fewest {
        (breakpoints, best) = found;
    }
    let (mut k, mut work) = (1, 0);
    while k + 1 < breakpoints.len() && work < MOST_REMOVALS {
        work += t.len() * (degree + 1) * (degree + 1) * (1 + 30 * rounds);
        let mut fewer = breakpoints.clone();
        fewer.remove(k);
        match over(&fewer) {
            Ok(next) if next.largest() <= tolerance => (breakpoints, best) = (fewer, next),
            _ => k += 1,
        }
    }
    Ok(best)
}

/// For each span the density that knots should have there: the root of the next derivative above the degree, of the order by one
/// higher, estimated from the jumps of the highest one (C. de Boor, *A Practical Guide to Splines*, 1978, chapter XII).
fn density(degree: usize, over: &Over) -> Vec<f64> {
    let breakpoints = over.knots.breakpoints();
    let dim = over.control.len() / over.knots.functions();
    let highest = |span: &[f64]| {
        let middle = f64::midpoint(span[0], span[1]);
        let (first, row) = over.knots.derivatives(middle, degree).unwrap_or((0, Vec::new()));
        super::linear::sum(&(first, row), &over.control, dim)
    };
    let values: Vec<Vec<f64>> = breakpoints.windows(2).map(highest).collect();
    let lengths: Vec<f64> = breakpoints.windows(2).map(|span| span[1] - span[0]).collect();
    let slope = |i: usize| {
        let jump = super::linear::minus(&values[i], &values[i - 1]);
        2.0 * Scalar::sqrt(super::linear::dot(&jump, &jump)) / (lengths[i] + lengths[i - 1])
    };
    let count = values.len();
    let root = |i: usize| {
        let [before, after] = [(i > 0).then(|| slope(i)), (i + 1 < count).then(|| slope(i + 1))];
        let slope = before.unwrap_or(0.0).max(after.unwrap_or(0.0));
        if slope > 0.0 { Scalar::exp_m1(Scalar::ln_1p(slope - 1.0) / (degree + 1) as f64) + 1.0 } else { 0.0 }
    };
    let mut density: Vec<f64> = (0..count).map(root).collect();
    let total: f64 = density.iter().zip(&lengths).map(|(d, h)| d * h).sum();
    let least = 0.05 * total / lengths.iter().sum::<f64>();
    for d in &mut density {
        *d = if *d > least { *d } else { least };
    }
    if total > 0.0 && total.is_finite() { density } else { alloc::vec![1.0; count] }
}

/// Breakpoints for that number of spans, between which the integral of the density is the same.
fn spread(breakpoints: &[f64], density: &[f64], spans: usize) -> Vec<f64> {
    let mut sums = alloc::vec![0.0];
    let mut sum = 0.0;
    for (span, d) in breakpoints.windows(2).zip(density) {
        sum += (span[1] - span[0]) * d;
        sums.push(sum);
    }
    let last = breakpoints.len() - 1;
    let place = |k: usize| {
        let wanted = sum * k as f64 / spans as f64;
        let i = sums.partition_point(|&s| s <= wanted).clamp(1, last);
        let part = ((wanted - sums[i - 1]) / (sums[i] - sums[i - 1])).clamp(0.0, 1.0);
        breakpoints[i - 1] + (breakpoints[i] - breakpoints[i - 1]) * part
    };
    let inner = (1..spans).map(place);
    core::iter::once(breakpoints[0]).chain(inner).chain([breakpoints[last]]).collect()
}

/// The breakpoints with one more in each span that holds a point outside of the tolerance; `None` if there is none more.
fn refined(degree: usize, breakpoints: &[f64], over: &Over, tolerance: f64, most: usize) -> Option<Vec<f64>> {
    let mut points: Vec<(f64, f64)> = over.t.iter().copied().zip(over.errors.iter().copied()).collect();
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut finer = alloc::vec![breakpoints[0]];
    let mut room = most.saturating_sub(breakpoints.len() - 1 + degree);
    for span in breakpoints.windows(2) {
        let from = points.partition_point(|p| p.0 < span[0]);
        let to = points.partition_point(|p| p.0 <= span[1]);
        let inside = &points[from..to];
        if room > 0 && inside.iter().any(|p| p.1 > tolerance) {
            let total: f64 = inside.iter().map(|p| p.1 * p.1).sum();
            let mut before = 0.0;
            let mut best: Option<(f64, f64)> = None;
            for pair in inside.windows(2) {
                before += pair[0].1 * pair[0].1;
                let middle = f64::midpoint(pair[0].0, pair[1].0);
                let uneven = (before - 0.5 * total).abs();
                let inner = middle > span[0] && middle < span[1] && pair[0].0 < pair[1].0;
                if inner && best.is_none_or(|(least, _)| uneven < least) {
                    best = Some((uneven, middle));
                }
            }
            if let Some((_, knot)) = best {
                finer.push(knot);
                room -= 1;
            }
        }
        finer.push(span[1]);
    }
    (finer.len() > breakpoints.len()).then_some(finer)
}

#[cfg(test)]
mod tests {
    use super::averaged;

    #[test]
    fn every_span_holds_parameters() {
        let t: Vec<f64> = (0..40).map(|i| f64::from(i * i) / 1521.0).collect();
        for degree in 0..5 {
            for count in degree + 1..=40 {
                let breakpoints = averaged(degree, count, &t).unwrap();
                assert_eq!(breakpoints.len(), count - degree + 1);
                for span in breakpoints.windows(2) {
                    assert!(span[0] < span[1]);
                    let held = t.iter().any(|&t| t >= span[0] && t <= span[1]);
                    assert!(held || count == 40, "{degree} {count} {span:?}");
                }
            }
        }
        assert!(averaged(3, 3, &t).is_err() && averaged(3, 41, &t).is_err() && averaged(3, 4, &[]).is_err());
    }

    extern crate alloc;
    use alloc::vec::Vec;
}
