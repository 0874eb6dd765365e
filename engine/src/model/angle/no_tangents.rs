//! Stands for shape parameters in terms of their own tangents where the feature `angles` is off: there are none.

use std::borrow::Cow;

use crate::model::Family;

/// The family as it is.
#[allow(clippy::unnecessary_wraps)]
pub(crate) fn in_tangents(family: &Family) -> Option<Cow<'_, Family>> {
    Some(Cow::Borrowed(family))
}
