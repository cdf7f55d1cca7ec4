//! The names of a tree's rays, as in figure 3 of the subject: `R1` is mirrored at the first surface, `T1` refracted;
//! `T1·R2` is the ray that is mirrored where `T1` ends. A ray that carries one or two channels says which: `T1[r]`.

use lancer_trace::{Channels, RayKind, RayTree};

/// The name of every ray of a tree; the primary ray's is empty.
pub(super) fn ray_names(tree: &RayTree) -> Vec<String> {
    let mut names = vec![String::new(); tree.nodes.len()];
    // a ray stands before the rays that it gives rise to
    for number in 0..tree.nodes.len() {
        for &child in &tree.nodes[number].children {
            let node = &tree.nodes[child];
            let letter = match node.kind {
                RayKind::Primary => "",
                RayKind::Reflected => "R",
                RayKind::Refracted => "T",
            };
            let start = if number == 0 { String::new() } else { format!("{}·", names[number]) };
            names[child] = format!("{start}{letter}{}{}", node.level, carried(node.channels));
        }
    }
    names
}

/// `[r]` or the like for a ray that does not carry every channel.
fn carried(channels: Channels) -> String {
    if channels == Channels::ALL {
        return String::new();
    }
    let letters: String = channels.iter().map(|channel| ["r", "g", "b"][channel]).collect();
    format!("[{letters}]")
}
