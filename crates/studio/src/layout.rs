//! Where the panes are: the tree of tiles in the main window, and the views in windows of their own.

use egui::Rect;
use egui_tiles::{Container, Linear, LinearDir, SimplificationOptions, Tile, TileId, Tiles, Tree};
use lancer_scene::{Name, Stage};

/// A pane shows one view.
#[derive(Clone, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub struct Pane {
    /// The view's name.
    pub view: String,
}

/// Where the panes are. A view has at most one pane.
#[derive(Clone, Debug, serde::Serialize, serde::Deserialize)]
pub struct Layout {
    /// The main window.
    pub tree: Tree<Pane>,
    /// The views in windows of their own.
    pub detached: Vec<String>,
}

impl Default for Layout {
    fn default() -> Layout {
        Layout { tree: Tree::empty(id()), detached: Vec::new() }
    }
}

/// The tree's identity in the window.
fn id() -> egui::Id {
    egui::Id::unique("views")
}

/// Every pane has its bar, and nothing else is kept around it.
pub const SIMPLIFICATION: SimplificationOptions = SimplificationOptions {
    prune_empty_tabs: true,
    prune_empty_containers: true,
    prune_single_child_tabs: true,
    prune_single_child_containers: true,
    all_panes_must_have_tabs: true,
    join_nested_linear_containers: true,
    flatten_tabs_in_tabs: true,
};

impl Layout {
    /// The first two views side by side.
    pub fn of(stage: &Stage) -> Layout {
        let panes = stage.views.iter().take(2).map(|view| Pane { view: view.name.to_string() });
        Layout { tree: Tree::new_horizontal(id(), panes.collect()), detached: Vec::new() }
    }

    /// The layout if it is one of this document: every view that it shows exists. Else the first two views are shown.
    pub fn fitted(self, stage: &Stage) -> Layout {
        let exists = |name: &String| stage.views.iter().any(|view| *view.name == **name);
        if !self.is_empty() && self.views().iter().all(exists) { self } else { Layout::of(stage) }
    }

    /// Takes out the panes of views that do not exist.
    pub fn prune(&mut self, stage: &Stage) {
        let exists = |name: &str| stage.views.iter().any(|view| &*view.name == name);
        let gone: Vec<TileId> = self.panes().filter(|(_, view)| !exists(view)).map(|(tile, _)| tile).collect();
        for tile in gone {
            self.tree.remove_recursively(tile);
        }
        self.tree.simplify(&SIMPLIFICATION);
        self.detached.retain(|name| exists(name));
    }

    /// Whether no view is shown anywhere.
    pub fn is_empty(&self) -> bool {
        self.panes().next().is_none() && self.detached.is_empty()
    }

    /// The tiles that are panes, with their views.
    fn panes(&self) -> impl Iterator<Item = (TileId, &str)> {
        self.tree.tiles.iter().filter_map(|(tile, content)| match content {
            Tile::Pane(pane) => Some((*tile, pane.view.as_str())),
            Tile::Container(_) => None,
        })
    }

    /// The tile that shows a view.
    fn tile(&self, view: &str) -> Option<TileId> {
        self.panes().find(|(_, shown)| *shown == view).map(|(tile, _)| tile)
    }

    /// Whether a view has a pane.
    pub fn shows(&self, view: &str) -> bool {
        self.is_detached(view) || self.tile(view).is_some()
    }

    /// Whether a view is in a window of its own.
    pub fn is_detached(&self, view: &str) -> bool {
        self.detached.iter().any(|name| name == view)
    }

    /// Brings the pane of a view to the front; makes one beside `neighbour` where there is none.
    pub fn show(&mut self, view: &str, neighbour: Option<&str>, dir: LinearDir) {
        if self.is_detached(view) {
            return;
        }
        let tile = match self.tile(view) {
            Some(tile) => tile,
            None => {
                let tile = self.tree.tiles.insert_pane(Pane { view: view.to_owned() });
                let beside = neighbour.and_then(|name| self.tile(name)).or_else(|| self.panes().next().map(|p| p.0));
                let beside = beside.filter(|beside| *beside != tile);
                self.insert(tile, beside, dir);
                tile
            }
        };
        self.tree.make_active(|id, _| id == tile);
    }

    /// The view whose pane is the largest that is seen, and the way in which it is cut best; `None` before a first frame.
    pub fn roomiest(&self) -> Option<(String, LinearDir)> {
        let mut seen: Vec<(&str, Rect)> =
            self.panes().filter_map(|(tile, pane)| Some((pane, self.tree.tiles.rect(tile)?))).collect();
        // of several that are equal but for the last pixel, the first as one reads; the tiles themselves have no order
        seen.sort_by(|(_, a), (_, b)| a.min.y.total_cmp(&b.min.y).then(a.min.x.total_cmp(&b.min.x)));
        let is_larger = |other: &Rect, most: &Rect| other.area() > 1.02 * most.area();
        let largest = seen.into_iter().reduce(|most, other| if is_larger(&other.1, &most.1) { other } else { most });
        largest.map(|(pane, rect)| {
            let size = rect.size();
            let dir = if size.y > size.x { LinearDir::Vertical } else { LinearDir::Horizontal };
            (pane.to_owned(), dir)
        })
    }

    /// Puts a new tile beside another one, in half of its place.
    fn insert(&mut self, tile: TileId, beside: Option<TileId>, dir: LinearDir) {
        let root = self.tree.root();
        let tiles = &mut self.tree.tiles;
        let Some(mut beside) = beside.or(root) else {
            self.tree = Tree::new(id(), tile, std::mem::take(tiles));
            return;
        };
        // the bar of tabs around a pane belongs to it
        if let Some(parent) = tiles.parent_of(beside)
            && matches!(tiles.get(parent), Some(Tile::Container(Container::Tabs(_))))
        {
            beside = parent;
        }
        let parent = tiles.parent_of(beside);
        if let Some(Tile::Container(Container::Linear(linear))) = parent.and_then(|parent| tiles.get_mut(parent))
            && linear.dir == dir
            && let Some(place) = linear.children.iter().position(|child| *child == beside)
        {
            let half = linear.shares[beside] / 2.0;
            linear.children.insert(place + 1, tile);
            linear.shares.set_share(beside, half);
            linear.shares.set_share(tile, half);
            return;
        }
        let both = tiles.insert_container(Linear::new(dir, vec![beside, tile]));
        match parent.and_then(|parent| tiles.get_mut(parent)) {
            Some(Tile::Container(container)) => replace(container, beside, both),
            Some(Tile::Pane(_)) | None => self.tree = Tree::new(id(), both, std::mem::take(tiles)),
        }
    }

    /// Closes the pane or the window of a view.
    pub fn close(&mut self, view: &str) {
        self.detached.retain(|name| name != view);
        if let Some(tile) = self.tile(view) {
            self.tree.remove_recursively(tile);
            self.tree.simplify(&SIMPLIFICATION);
        }
    }

    /// Takes a view out of the main window.
    pub fn detach(&mut self, view: &str) {
        self.close(view);
        self.detached.push(view.to_owned());
    }

    /// Lets the panes follow views that got new names: the lists have the same length, and the old name is gone.
    pub fn follow(&mut self, before: &[std::sync::Arc<lancer_scene::View>], after: &Stage) {
        if before.len() != after.views.len() {
            return;
        }
        for (old, new) in before.iter().zip(after.views.iter()) {
            if old.name != new.name && !after.views.iter().any(|view| view.name == old.name) {
                self.rename(&old.name, &new.name);
            }
        }
    }

    fn rename(&mut self, from: &Name, to: &Name) {
        for tile in self.tree.tiles.tiles_mut() {
            if let Tile::Pane(pane) = tile
                && *pane.view == **from
            {
                pane.view = to.to_string();
            }
        }
        self.detached.iter_mut().filter(|name| ***name == **from).for_each(|name| *name = to.to_string());
    }

    /// The views in the order of their panes.
    pub fn views(&self) -> Vec<String> {
        let mut views = Vec::new();
        if let Some(root) = self.tree.root() {
            collect(&self.tree.tiles, root, &mut views);
        }
        views.extend(self.detached.iter().cloned());
        views
    }
}

fn collect(tiles: &Tiles<Pane>, tile: TileId, views: &mut Vec<String>) {
    match tiles.get(tile) {
        Some(Tile::Pane(pane)) => views.push(pane.view.clone()),
        Some(Tile::Container(container)) => container.children().for_each(|child| collect(tiles, *child, views)),
        None => {}
    }
}

/// Puts another child in the place of one.
fn replace(container: &mut Container, old: TileId, new: TileId) {
    match container {
        Container::Tabs(tabs) => {
            tabs.children.iter_mut().filter(|child| **child == old).for_each(|child| *child = new);
            tabs.set_active(new);
        }
        Container::Linear(linear) => {
            let share = linear.shares[old];
            linear.children.iter_mut().filter(|child| **child == old).for_each(|child| *child = new);
            linear.shares.set_share(new, share);
        }
        Container::Grid(grid) => {
            let place = grid.children().position(|child| *child == old);
            if let Some(place) = place {
                let _old = grid.replace_at(place, new);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use lancer_scene::{DVec3, ScreenSpec, Steps, View};

    fn stage(names: &[&str]) -> Stage {
        let view = |name: &&str| View {
            name: (*name).into(),
            width: 8,
            height: 6,
            eye: DVec3::Z,
            screen: ScreenSpec::LookAt { look_at: DVec3::ZERO, up: DVec3::Y, fov: 45.0 },
            samples: 1,
            depth: None,
            steps: Steps::default(),
        };
        Stage { views: names.iter().map(view).collect(), ..Stage::default() }
    }

    #[test]
    fn the_first_two_views_are_shown() {
        assert_eq!(Layout::of(&stage(&["a", "b", "c"])).views(), ["a", "b"]);
        assert!(Layout::of(&stage(&[])).is_empty());
    }

    #[test]
    fn panes_are_made_beside_each_other_and_closed() {
        let mut layout = Layout::of(&stage(&["a", "b"]));
        layout.show("c", Some("a"), LinearDir::Vertical);
        layout.show("d", Some("b"), LinearDir::Horizontal);
        assert_eq!(layout.views(), ["a", "c", "b", "d"]);
        layout.show("c", Some("b"), LinearDir::Vertical);
        assert_eq!(layout.views(), ["a", "c", "b", "d"], "it has a pane");
        layout.close("a");
        layout.detach("b");
        assert_eq!(layout.views(), ["c", "d", "b"]);
        assert!(layout.is_detached("b") && layout.shows("b"));
        for view in ["b", "c", "d"] {
            layout.close(view);
        }
        assert!(layout.is_empty());
        layout.show("a", None, LinearDir::Horizontal);
        assert_eq!(layout.views(), ["a"]);
    }

    #[test]
    fn panes_follow_the_views() {
        let before = stage(&["a", "b"]);
        let mut layout = Layout::of(&before);
        layout.detach("b");
        layout.follow(&before.views, &stage(&["front", "b"]));
        assert_eq!(layout.views(), ["front", "b"]);
        layout.prune(&stage(&["front"]));
        assert_eq!(layout.views(), ["front"]);
        assert_eq!(layout.clone().fitted(&stage(&["front", "x"])).views(), ["front"]);
        assert_eq!(layout.fitted(&stage(&["x", "y", "z"])).views(), ["x", "y"]);
    }
}
