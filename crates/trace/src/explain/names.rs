//! The names of a tree's rays, as in figure 3 of the subject: `R1` is mirrored at the first surface, `T1` refracted;
//! `T1·R2` is the ray that is mirrored where `T1` ends. A ray that carries one or two channels says which: `T1[r]`.

use crate::{Channels, RayKind, RayTree};

/// Gives the rays of a tree their names. A name is put together when it is asked for: a tree may have a million rays.
#[derive(Clone, Debug)]
pub struct RayNames<'a> {
    tree: &'a RayTree,
    /// The ray that each ray stems from; the primary ray's is its own number.
    parents: Vec<usize>,
}

impl<'a> RayNames<'a> {
    /// The names of a tree's rays.
    pub fn new(tree: &'a RayTree) -> RayNames<'a> {
        let mut parents = vec![0; tree.nodes.len()];
        for (number, node) in tree.nodes.iter().enumerate() {
            for &child in &node.children {
                if let Some(parent) = parents.get_mut(child) {
                    *parent = number;
                }
            }
        }
        RayNames { tree, parents }
    }

    /// The name of a ray by its number in the tree; the primary ray's is empty.
    pub fn of(&self, ray: usize) -> String {
        let mut steps = Vec::new();
        let mut ray = ray;
        while ray != 0 {
            let Some(node) = self.tree.nodes.get(ray) else { break };
            let letter = match node.kind {
                RayKind::Primary => "",
                RayKind::Reflected => "R",
                RayKind::Refracted => "T",
            };
            steps.push(format!("{letter}{}{}", node.level, carried(node.channels)));
            ray = self.parents[ray];
        }
        steps.reverse();
        steps.join("·")
    }
}

/// `[r]` or the like for a ray that does not carry every channel.
fn carried(channels: Channels) -> String {
    if channels == Channels::ALL {
        return String::new();
    }
    let letters: String = channels.iter().map(|channel| ["r", "g", "b"][channel]).collect();
    format!("[{letters}]")
}
