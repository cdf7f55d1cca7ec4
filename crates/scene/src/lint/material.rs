//! Rules about coefficients.

use super::scenery::Scenery;
use super::{Finding, Owner};
use crate::{MaterialRef, Rgb, Surface};
use std::collections::HashSet;

/// Every surface of a visible object with what it belongs to.
fn surfaces<'a>(scenery: &Scenery<'a>) -> Vec<(Owner, &'a Surface)> {
    let objects = scenery.visible.iter().map(|visible| visible.object);
    let used: HashSet<&str> = objects
        .clone()
        .flat_map(|object| object.material_refs().filter_map(MaterialRef::name))
        .map(|name| &**name)
        .collect();
    let named = scenery
        .scene
        .materials
        .iter()
        .filter(|material| used.contains(&*material.name))
        .map(|material| (Owner::Material(material.name.clone()), &material.surface));
    let inline = objects.flat_map(|object| {
        object.material_refs().filter_map(|material| match material {
            MaterialRef::Inline(surface) => Some((Owner::Object(object.name.clone()), &**surface)),
            MaterialRef::Default | MaterialRef::Named(_) => None,
        })
    });
    named.chain(inline).collect()
}

/// Appends a finding, once where a mesh has many parts of one surface.
fn push(findings: &mut Vec<Finding>, finding: Finding) {
    if findings.last() != Some(&finding) {
        findings.push(finding);
    }
}

/// Light is nowhere faster than in empty space.
pub(super) fn index_below_one(scenery: &Scenery<'_>, findings: &mut Vec<Finding>) {
    let least = |index: Rgb| index.r.min(index.g).min(index.b);
    let world = least(scenery.scene.world.index);
    if world < 1.0 && scenery.visible.iter().any(|visible| visible.is_transparent()) {
        findings.push(Finding::WorldIndexBelowOne { index: world });
    }
    for (owner, surface) in surfaces(scenery) {
        let index = least(surface.index);
        if surface.is_transparent() && index < 1.0 {
            push(findings, Finding::IndexBelowOne { owner, index });
        }
    }
}

/// 1 absorbs in `⊕` and is the clamp of a plain sum.
pub(super) fn always_white(scenery: &Scenery<'_>, findings: &mut Vec<Finding>) {
    for (owner, surface) in surfaces(scenery) {
        if surface.ka * scenery.scene.world.ambient == Rgb::WHITE {
            push(findings, Finding::AlwaysWhite { owner });
        }
    }
}

/// A material that no object names, hidden objects included.
pub(super) fn unused_material(scenery: &Scenery<'_>, findings: &mut Vec<Finding>) {
    let used: HashSet<&str> = scenery
        .scene
        .objects
        .iter()
        .flat_map(|object| object.material_refs().filter_map(MaterialRef::name))
        .map(|name| &**name)
        .collect();
    for material in &scenery.scene.materials {
        if !used.contains(&*material.name) {
            findings.push(Finding::UnusedMaterial { material: material.name.clone() });
        }
    }
}
