//! What to render next: a pure decision over the state of all views, so that it can be tested without a thread.
//!
//! Every view first gets its coarsest pass, the active view before the others. After that the views share the time by
//! weight: each has a virtual clock that its pixels advance, the active view's more slowly, and the view whose clock is
//! furthest behind is next (stride scheduling, Waldspurger 1995). So the active view is fast and none starves, however
//! often another one restarts.

use crate::{Pass, Region};

/// What the decision needs to know of a view.
#[derive(Clone, Debug)]
pub struct ViewState {
    width: u32,
    height: u32,
    /// Its tiles are wanted before those of other views.
    pub active: bool,
    /// Nothing of it is handed out.
    pub paused: bool,
    /// This rectangle is refined before the rest.
    priority: Option<Region>,
    next: Option<Cursor>,
    clock: u64,
}

/// The place in a view's work that is next.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Cursor {
    stage: Stage,
    pass: Pass,
    unit: u64,
}

/// A view's work in its order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Stage {
    /// The coarsest pass of everything.
    Coarse,
    /// The other passes within the priority rectangle.
    Priority,
    /// The other passes of what is left.
    Rest,
}

/// A piece of work.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Unit {
    /// The pass whose pixels are computed.
    pub pass: Pass,
    /// Where.
    pub within: Region,
    /// Pixels in or not in this rectangle are left out: they belong to another stage.
    filter: Filter,
}

/// Which pixels of a unit belong to its stage.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Filter {
    All,
    Within(Region),
    Outside(Region),
}

impl Unit {
    /// The pixels to compute, neighbours together.
    pub fn pixels(&self) -> impl Iterator<Item = (u32, u32)> + use<> {
        let filter = self.filter;
        self.pass.pixels(self.within).filter(move |&(x, y)| match filter {
            Filter::All => true,
            Filter::Within(region) => region.contains(x, y),
            Filter::Outside(region) => !region.contains(x, y),
        })
    }

    /// How many they are.
    fn count(&self) -> u64 {
        let inside = |region: &Region| region.overlap(&self.within).map_or(0, |both| self.pass.count(both));
        match &self.filter {
            Filter::All => self.pass.count(self.within),
            Filter::Within(region) => inside(region),
            Filter::Outside(region) => self.pass.count(self.within) - inside(region),
        }
    }
}

/// How much slower the active view's clock goes.
const ACTIVE_WEIGHT: u64 = 4;

impl ViewState {
    /// A view with nothing to do.
    pub fn idle() -> ViewState {
        ViewState { width: 0, height: 0, active: false, paused: false, priority: None, next: None, clock: 0 }
    }

    /// Begins a picture of that size from its coarsest pass.
    pub fn restart(&mut self, width: u32, height: u32) {
        (self.width, self.height) = (width, height);
        self.next = Some(Cursor { stage: Stage::Coarse, pass: Pass::COARSEST, unit: 0 });
    }

    /// Sets the rectangle that is refined first. What is handed out already is not computed again, so the order changes
    /// from the next restart on, or at once if the coarse pass is not through.
    pub fn prioritise(&mut self, region: Option<Region>) {
        if self.next.is_none_or(|cursor| cursor.stage == Stage::Coarse) {
            self.priority = region;
        }
    }

    /// Whether everything is handed out.
    pub fn is_exhausted(&self) -> bool {
        self.next.is_none()
    }

    fn is_ready(&self) -> bool {
        !self.paused && self.next.is_some()
    }

    /// Takes the next unit and advances the clock.
    fn take(&mut self) -> Option<Unit> {
        loop {
            let cursor = self.next?;
            let within = cursor.pass.unit(self.width, self.height, cursor.unit)?;
            let following = Cursor { unit: cursor.unit + 1, ..cursor };
            let more = following.unit < cursor.pass.units(self.width, self.height);
            self.next = if more { Some(following) } else { self.after_pass(cursor) };
            let filter = match (cursor.stage, self.priority) {
                (Stage::Coarse, _) | (Stage::Priority | Stage::Rest, None) => Filter::All,
                (Stage::Priority, Some(region)) => Filter::Within(region),
                (Stage::Rest, Some(region)) => Filter::Outside(region),
            };
            let unit = Unit { pass: cursor.pass, within, filter };
            let pixels = unit.count();
            if pixels == 0 {
                continue;
            }
            self.clock += if self.active { pixels } else { pixels * ACTIVE_WEIGHT };
            return Some(unit);
        }
    }

    /// Where the work goes on after a pass.
    fn after_pass(&self, cursor: Cursor) -> Option<Cursor> {
        let begin = |stage, pass| Some(Cursor { stage, pass, unit: 0 });
        match (cursor.stage, cursor.pass.next()) {
            (Stage::Coarse, Some(finer)) if self.priority.is_some() => begin(Stage::Priority, finer),
            (Stage::Coarse, Some(finer)) => begin(Stage::Rest, finer),
            (stage @ (Stage::Priority | Stage::Rest), Some(finer)) => begin(stage, finer),
            (Stage::Priority, None) => Pass::COARSEST.next().and_then(|finer| begin(Stage::Rest, finer)),
            (Stage::Coarse | Stage::Rest, None) => None,
        }
    }
}

/// Decides which view gets the next unit and takes it. Gives the view's place and the unit.
pub fn next_unit(views: &mut [ViewState]) -> Option<(usize, Unit)> {
    loop {
        let ready = views.iter().enumerate().filter(|(_, view)| view.is_ready());
        let coarse = |view: &ViewState| view.next.is_some_and(|cursor| cursor.stage == Stage::Coarse);
        let (place, _) =
            ready.min_by_key(|(place, view)| (!coarse(view), coarse(view) && !view.active, view.clock, *place))?;
        if let Some(unit) = views[place].take() {
            return Some((place, unit));
        }
    }
}

/// Brings a view that begins again after a rest up to the others' clocks, so that it does not take all their time.
pub fn wake(views: &mut [ViewState], place: usize) {
    let others =
        views.iter().enumerate().filter(|(other, view)| *other != place && view.is_ready()).map(|(_, view)| view.clock);
    if let Some(behind) = others.min() {
        views[place].clock = views[place].clock.max(behind);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashSet;

    fn views(count: usize) -> Vec<ViewState> {
        (0..count)
            .map(|place| {
                let mut view = ViewState::idle();
                view.restart(640, 480);
                view.active = place == 0;
                view
            })
            .collect()
    }

    fn pixels_until(views: &mut [ViewState], units: usize) -> Vec<u64> {
        let mut pixels = vec![0; views.len()];
        for _ in 0..units {
            let Some((place, unit)) = next_unit(views) else { break };
            pixels[place] += unit.pixels().count() as u64;
        }
        pixels
    }

    #[test]
    fn every_view_is_complete_in_the_end() {
        for count in [1, 2, 8] {
            let mut views = views(count);
            views[count - 1].prioritise(Some(Region { x: 101, y: 33, width: 77, height: 200 }));
            let mut seen = HashSet::new();
            while let Some((place, unit)) = next_unit(&mut views) {
                let mut pixels = 0;
                for (x, y) in unit.pixels() {
                    assert!(seen.insert((place, x, y)), "{place} {x} {y} twice");
                    pixels += 1;
                }
                assert_eq!(unit.count(), pixels);
            }
            assert_eq!(seen.len(), count * 640 * 480);
            assert!(views.iter().all(ViewState::is_exhausted));
        }
    }

    #[test]
    fn the_coarse_pass_of_every_view_comes_first_and_the_active_view_before_all() {
        let mut views = views(8);
        views[0].active = false;
        views[5].active = true;
        let coarse = Pass::COARSEST.units(640, 480) as usize;
        let order: Vec<(usize, Pass)> =
            (0..8 * coarse + 1).filter_map(|_| next_unit(&mut views)).map(|(place, unit)| (place, unit.pass)).collect();
        assert!(order[..coarse].iter().all(|(place, _)| *place == 5));
        assert!(order[..8 * coarse].iter().all(|(_, pass)| *pass == Pass::COARSEST));
        assert_ne!(order[8 * coarse].1, Pass::COARSEST);
    }

    #[test]
    fn the_active_view_gets_four_times_as_much_and_none_starves() {
        for count in [2, 8] {
            let mut views = views(count);
            let pixels = pixels_until(&mut views, 1500);
            for other in &pixels[1..] {
                let ratio = pixels[0] as f64 / *other as f64;
                assert!((3.0..5.0).contains(&ratio), "{pixels:?}");
            }
        }
    }

    /// A view that restarts after every few units, as under a moving mouse, leaves time for the others.
    #[test]
    fn a_view_that_restarts_for_ever_starves_nobody() {
        let mut views = views(3);
        let mut pixels = [0; 3];
        for _ in 0..200 {
            views[0].restart(640, 480);
            wake(&mut views, 0);
            for _ in 0..60 {
                if let Some((place, unit)) = next_unit(&mut views) {
                    pixels[place] += unit.pixels().count();
                }
            }
        }
        assert!(views[1].is_exhausted() && views[2].is_exhausted(), "{pixels:?}");
    }

    #[test]
    fn a_priority_rectangle_is_refined_before_the_rest() {
        let mut views = views(1);
        let wanted = Region { x: 300, y: 200, width: 64, height: 64 };
        views[0].prioritise(Some(wanted));
        let mut left = HashSet::new();
        let mut outside = 0;
        left.extend((wanted.y..264).flat_map(|y| (wanted.x..364).map(move |x| (x, y))));
        while !left.is_empty() {
            let (_, unit) = next_unit(&mut views).unwrap();
            for pixel in unit.pixels() {
                if !left.remove(&pixel) && unit.pass != Pass::COARSEST {
                    outside += 1;
                }
            }
        }
        assert_eq!(outside, 0);
    }

    #[test]
    fn a_paused_view_waits() {
        let mut views = views(2);
        views[1].paused = true;
        while let Some((place, _)) = next_unit(&mut views) {
            assert_eq!(place, 0);
        }
        views[1].paused = false;
        assert!(next_unit(&mut views).is_some());
    }
}
