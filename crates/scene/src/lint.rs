//! placeholder
use crate::{Scene, View};
/// A finding.
#[derive(Clone, Debug, PartialEq)]
pub enum Finding {}
/// Lint.
pub fn lint(_scene: &Scene, _views: &[std::sync::Arc<View>]) -> Vec<Finding> {
    Vec::new()
}
