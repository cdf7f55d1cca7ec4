//! Brings a list of elements from one state of the model to another: what stays, what moves, what is new.

use super::super::Element;
use super::splices::Splices;
use lancer_scene::Name;
use std::collections::HashMap;
use std::sync::Arc;

/// Where the items of a new list stand in the old one.
pub(super) struct Matching {
    /// For each new item the old one that it comes from.
    pub(super) from: Vec<Option<usize>>,
}

impl Matching {
    /// Items are the same if they have the same name, or if they are what stands between two that are: then it was
    /// renamed.
    pub(super) fn of<T>(old: &[Arc<T>], new: &[Arc<T>], name: impl Fn(&T) -> &Name) -> Matching {
        let by_name: HashMap<&Name, usize> = old.iter().enumerate().map(|(at, item)| (name(item), at)).collect();
        let mut from: Vec<Option<usize>> = new.iter().map(|item| by_name.get(name(item)).copied()).collect();
        let mut taken = vec![false; old.len()];
        for at in from.iter().flatten() {
            taken[*at] = true;
        }
        let mut expected = 0;
        for place in &mut from {
            if place.is_none() && taken.get(expected) == Some(&false) {
                taken[expected] = true;
                *place = Some(expected);
            }
            expected = place.map_or(expected, |at| at + 1);
        }
        Matching { from }
    }

    /// Which new items stay where they are: a longest run of items whose order has not changed.
    fn stay(&self) -> Vec<bool> {
        // Patience sorting: `ends[n]` is the new item that ends a rising run of n + 1 items with the least old place.
        let mut ends: Vec<usize> = Vec::new();
        let mut before: Vec<Option<usize>> = vec![None; self.from.len()];
        for (item, place) in self.from.iter().enumerate().filter(|(_, place)| place.is_some()) {
            let length = ends.partition_point(|end| self.from[*end] < *place);
            before[item] = length.checked_sub(1).map(|last| ends[last]);
            match ends.get_mut(length) {
                Some(end) => *end = item,
                None => ends.push(item),
            }
        }
        let mut stay = vec![false; self.from.len()];
        let mut item = ends.last().copied();
        while let Some(at) = item {
            stay[at] = true;
            item = before[at];
        }
        stay
    }
}

/// Where the items of a list go if none of them stands in the document yet.
#[derive(Clone, Copy)]
pub(super) enum Place<'d> {
    After(Element<'d>),
    Before(Element<'d>),
    Within(Element<'d>),
}

/// Brings a list's elements to the new state.
///
/// `patch` changes the element of an old item into the new item's, given both places; `write` writes a new item at an
/// indentation, ended by a line end.
pub(super) fn patch_list<'d>(
    splices: &mut Splices<'d>,
    elements: &[Element<'d>],
    matching: &Matching,
    empty: Place<'d>,
    mut patch: impl FnMut(&mut Splices<'d>, Element<'d>, usize, usize),
    write: impl Fn(&mut String, &str, usize),
) {
    let stay = matching.stay();
    let mut gone = vec![true; elements.len()];
    let mut last: Option<Element<'d>> = None;
    let first_staying = matching.from.iter().zip(&stay).find(|(_, stays)| **stays).and_then(|(from, _)| *from);
    for (item, from) in matching.from.iter().enumerate() {
        if let Some(old) = from
            && stay[item]
        {
            gone[*old] = false;
            patch(splices, elements[*old], *old, item);
            last = Some(elements[*old]);
            continue;
        }
        let place = match (last, first_staying) {
            (Some(last), _) => Place::After(last),
            (None, Some(first)) => Place::Before(elements[first]),
            (None, None) => empty,
        };
        let indent = match place {
            Place::After(element) | Place::Before(element) => splices.indent(element),
            Place::Within(element) => splices.inner_indent(element),
        };
        let lines = match from {
            // An item that moves takes its own text along.
            Some(old) => {
                let mut own = splices.another();
                patch(&mut own, elements[*old], *old, item);
                let text = own.apply(elements[*old].span());
                format!("{indent}{text}{}", splices.line_end())
            }
            None => splices.written(|out| write(out, &indent, item)),
        };
        match place {
            Place::After(element) => splices.insert_after(element, &lines),
            Place::Before(element) => splices.insert_before(element, &lines),
            Place::Within(element) => splices.insert_within(element, &lines),
        }
    }
    for (element, gone) in elements.iter().zip(gone) {
        if gone {
            splices.remove(*element);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_keeps_its_order_stays() {
        let stay = |from: &[usize]| Matching { from: from.iter().copied().map(Some).collect() }.stay();
        assert_eq!(stay(&[0, 1, 2]), [true; 3]);
        assert_eq!(stay(&[3, 0, 1, 2]), [false, true, true, true]);
        assert_eq!(stay(&[1, 2, 3, 0]), [true, true, true, false]);
        assert_eq!(stay(&[2, 1, 0]).iter().filter(|stays| **stays).count(), 1);
        assert!(stay(&[]).is_empty());
    }
}
