//! The stacks of media that rays carry, as lists that share their beginnings: a stack is the number of its last entry.

use super::packet::NOTHING;
use crate::World;
use crate::world::Media;
use lancer_scene::Rgb;

/// All stacks of a block of rays.
#[derive(Clone, Debug)]
pub(crate) struct Stacks {
    entries: Vec<Entry>,
    /// The stack of a primary ray.
    primary: u32,
}

#[derive(Clone, Copy, Debug)]
struct Entry {
    /// The stack below; the first entry, free space, has itself.
    below: u32,
    body: u32,
    /// The index of the medium.
    index: Rgb,
}

impl Stacks {
    /// The stacks of rays from an eye that is inside of these media.
    pub(crate) fn new(world: &World, of_eye: &Media) -> Stacks {
        let free = Entry { below: 0, body: NOTHING, index: world.environment().index };
        let mut stacks = Stacks { entries: vec![free], primary: 0 };
        for (body, index) in of_eye.entries() {
            stacks.primary = stacks.entered(stacks.primary, body, index);
        }
        stacks
    }

    /// The stack of every primary ray.
    pub(crate) fn primary(&self) -> u32 {
        self.primary
    }

    /// The index of the medium that a ray with this stack travels in.
    pub(crate) fn index(&self, stack: u32) -> Rgb {
        self.entries[stack as usize].index
    }

    /// Entering pushes, again if the body is there already.
    pub(crate) fn entered(&mut self, stack: u32, body: u32, index: Rgb) -> u32 {
        self.entries.push(Entry { below: stack, body, index });
        (self.entries.len() - 1) as u32
    }

    /// Leaving removes the body's last entry; leaving what is not there changes nothing.
    pub(crate) fn left(&mut self, stack: u32, body: u32) -> u32 {
        let mut above = Vec::new();
        let mut place = stack;
        while place != 0 {
            let entry = self.entries[place as usize];
            if entry.body == body {
                return above
                    .iter()
                    .rev()
                    .fold(entry.below, |stack, kept: &Entry| self.entered(stack, kept.body, kept.index));
            }
            above.push(entry);
            place = entry.below;
        }
        stack
    }

    /// A mark to go back to when the rays of a level are done.
    pub(crate) fn mark(&self) -> usize {
        self.entries.len()
    }

    /// Forgets every stack that was made since the mark.
    pub(crate) fn forget(&mut self, mark: usize) {
        self.entries.truncate(mark);
    }
}
