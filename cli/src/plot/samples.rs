//! Functions on an interval, sampled at every setting.

use basis_engine::Diagnostic;

use super::Scene;
use super::settings::Setting;
use super::values::{Functions, pieces};
use crate::output::error;

/// How many parts of the domain have a line each.
const PARTS: i64 = 160;

/// The functions at one setting: a list of values for each point.
pub(super) struct Sampled {
    pub(super) at: Vec<f64>,
    /// By point, then by function.
    pub(super) values: Vec<Vec<Option<f64>>>,
}

/// The values of all functions at every setting.
pub(super) fn sampled(scene: &Scene) -> Result<Vec<Sampled>, Diagnostic> {
    let sample = |setting: &Setting| {
        let mut all = Sampled { at: Vec::new(), values: Vec::new() };
        for piece in pieces(&scene.family) {
            let range = piece.domain.first().and_then(|p| p.range.finite());
            let Some((low, high)) = range else {
                return Err(error("the domain is not an interval with two ends"));
            };
            let functions = Functions::new(piece, &setting.values);
            // Between two spans the pen is lifted: functions may jump.
            if let Some(last) = all.at.last().copied() {
                all.at.push(last);
                all.values.push(vec![None; piece.functions.len()]);
            }
            for t in functions.along(low, high, PARTS) {
                all.at.push(functions.axis(&t));
                all.values.push(functions.values(core::slice::from_ref(&t)));
            }
        }
        Ok(all)
    };
    scene.settings.iter().map(sample).collect()
}

/// How strong the colour of a setting is: the last one has the full colour.
pub(super) fn strength(setting: usize, of: usize) -> f64 {
    if of == 1 { 0.0 } else { 0.72 * (1.0 - setting as f64 / (of - 1) as f64) }
}
