//! Places of an angle as texts of proofs: from its range to that of its tangent, and back.

use basis_engine::algebra::range::{End, Range};

use super::super::theorem::Missing;
use super::{Angular, OTHER};

impl Angular<'_> {
    /// Steps that bound the tangent at an angle by its range, from the hypothesis about the angle and `X'`.
    pub(super) fn tangent_bounds(&self, range: &Range, t: &str, hypothesis: &str) -> Result<String, Missing> {
        let tangent = self.turn.tangent_text(t);
        let mut text = String::new();
        for (k, (quarter, side)) in sides(range)?.into_iter().enumerate() {
            let (said, lemma) = match side {
                Side::From => (format!("({quarter}) <= {tangent}"), "tangent_from"),
                Side::Above => (format!("({quarter}) < {tangent}"), "tangent_above"),
                Side::To => (format!("{tangent} <= ({quarter})"), "tangent_to"),
                Side::Below => (format!("{tangent} < ({quarter})"), "tangent_below"),
            };
            text += &format!("  assert (Y'{k} : {said}) by (clear - {hypothesis} X'; tangent {lemma}).\n");
        }
        Ok(text)
    }

    /// The step that gives an angle `t'` with a tangent: `Q'` says that it is less than a half turn, `T'` what its tangent is.
    pub(super) fn arrival(&self, tangent: &str) -> String {
        let (slope, shift) = self.turn.factors();
        format!(
            "destruct (angle_of {slope} {shift} {tangent} ltac:(pose proof PI_RGT_0; lra)) as [t' [Q' T']]."
        )
    }

    /// Steps that bound an angle by its tangent, which `lra` compares with the ends of its range.
    pub(super) fn angle_bounds(&self, range: &Range, t: &str, tangent: &str) -> Result<Vec<String>, Missing> {
        let angle = self.turn.text(t);
        let step = |(k, (quarter, side)): (usize, (i64, Side))| {
            let (said, lemma) = match side {
                Side::From => (format!("({quarter}) * (PI / 2) <= {angle}"), "angle_from"),
                Side::Above => (format!("({quarter}) * (PI / 2) < {angle}"), "angle_above"),
                Side::To => (format!("{angle} <= ({quarter}) * (PI / 2)"), "angle_to"),
                Side::Below => (format!("{angle} < ({quarter}) * (PI / 2)"), "angle_below"),
            };
            let by = format!("apply ({lemma} ({quarter}) _ {tangent}); [lia | exact Q' | exact T' | lra]");
            format!("assert (R'{k} : {said}) by ({by}).")
        };
        Ok(sides(range)?.into_iter().enumerate().map(step).collect())
    }
}

/// How a quarter turn bounds an angle.
enum Side {
    From,
    Above,
    To,
    Below,
}

/// The ends of a range of tangents, each as a number of quarter turns.
fn sides(range: &Range) -> Result<Vec<(i64, Side)>, Missing> {
    let side = |end: &End, included: Side, excluded: Side| -> Result<Option<(i64, Side)>, Missing> {
        let Some(x) = end.value() else { return Ok(None) };
        let quarter = x.to_i64().filter(|k| (-1..=1).contains(k)).ok_or(OTHER)?;
        Ok(Some((quarter, if end.is_included() { included } else { excluded })))
    };
    let low = side(&range.low, Side::From, Side::Above)?;
    let high = side(&range.high, Side::To, Side::Below)?;
    Ok(low.into_iter().chain(high).collect())
}
