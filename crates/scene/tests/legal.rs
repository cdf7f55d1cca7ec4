//! The strategy of arbitrary scenes gives legal ones, with names of their own.

mod arbitrary;

use arbitrary::{Extent, scene, stage};
use proptest::prelude::*;

proptest! {
    #[test]
    fn arbitrary_scenes_are_legal(stage in stage(), contained in scene(Extent::SelfContained)) {
        prop_assert_eq!(stage.scene.check(), Ok(()));
        prop_assert_eq!(contained.check(), Ok(()));
        for view in &stage.views {
            prop_assert_eq!(view.check(), Ok(()));
        }
    }
}
