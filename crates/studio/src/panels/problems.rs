//! What is wrong: what was found in the files that were opened, and what lint finds in the scene as it is.

use crate::beside::Beside;
use crate::{Action, Context};
use egui::{Color32, Id, RichText, ScrollArea, Ui};
use egui_material_icons::MaterialIcon;
use egui_material_icons::icons::{ICON_CHECK_CIRCLE, ICON_ERROR, ICON_INFO, ICON_WARNING};
use lancer_document::{Item, Selection};
use lancer_formats::{Describe, Severity};
use lancer_scene::{Finding, NameKind, Weight, lint};
use lancer_words::studio::panels as words;
use std::sync::{Arc, Mutex, PoisonError};

/// Shows the panel; gives what the user wants.
pub fn show(ui: &mut Ui, context: &Context<'_>) -> Vec<Action> {
    let mut actions = Vec::new();
    let (lang, palette) = (context.lang, context.palette);
    let (findings, current) = findings(ui, context);
    ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
        let mut nothing = true;
        for report in context.reports {
            for diagnostic in &report.diagnostics {
                nothing = false;
                let (icon, color) = match diagnostic.severity {
                    Severity::Error => (ICON_ERROR, palette.error),
                    Severity::Warning => (ICON_WARNING, palette.warning),
                };
                let place = match diagnostic.span {
                    Some(span) => {
                        let (line, column) = report.source.position(span.start);
                        format!("{}:{line}:{column}", report.source.name)
                    }
                    None => report.source.name.to_string(),
                };
                // what stands at the text that is underlined, such as the name that was probably meant
                let remark = diagnostic.span.map(|_| diagnostic.problem.label(lang));
                entry(ui, icon, color, &diagnostic.problem, remark, context, |ui| {
                    ui.label(RichText::new(place).monospace().weak());
                });
            }
        }
        if !findings.is_empty() {
            nothing = false;
            ui.label(RichText::new(words::in_scene(lang)).strong().color(palette.weak));
        }
        for finding in findings.iter() {
            let (icon, color) = match finding.weight() {
                Weight::Warning => (ICON_WARNING, palette.warning),
                Weight::Note => (ICON_INFO, palette.accent),
            };
            entry(ui, icon, color, finding, None, context, |ui| {
                for (kind, name) in finding.names() {
                    if let Some(item) = item(context, kind, name)
                        && ui.small_button(words::select(lang, name)).clicked()
                    {
                        actions.push(Action::Select(Selection::only(item)));
                    }
                }
            });
        }
        if nothing && !current {
            ui.label(RichText::new(words::looking(lang)).weak());
        } else if nothing {
            ui.horizontal(|ui| {
                ui.label(ICON_CHECK_CIRCLE.rich_text().color(palette.success));
                ui.label(words::no_problems(lang));
            });
        }
    });
    actions
}

/// What lint finds, found again beside the window when the document has changed; and whether that is of the document
/// as it is now.
fn findings(ui: &Ui, context: &Context<'_>) -> (Arc<Vec<Finding>>, bool) {
    let id = Id::unique("findings");
    let beside =
        ui.data_mut(|data| Arc::clone(data.get_temp_mut_or_default::<Arc<Mutex<Beside<u64, Arc<Vec<Finding>>>>>>(id)));
    let mut beside = beside.lock().unwrap_or_else(PoisonError::into_inner);
    let revision = context.document.revision();
    if !context.document.in_gesture() && !beside.is_of(&revision) {
        let stage = context.document.stage().clone();
        beside.follow(ui.ctx(), &revision, move || Arc::new(lint(&stage.scene, &stage.views)));
    }
    (beside.get().map(Arc::clone).unwrap_or_default(), beside.is_of(&revision))
}

/// One problem: its icon, its sentence, a remark about it, the way out, and what belongs to it.
fn entry(
    ui: &mut Ui,
    icon: MaterialIcon,
    color: Color32,
    problem: &impl Describe,
    remark: Option<String>,
    context: &Context<'_>,
    more: impl FnOnce(&mut Ui),
) {
    ui.horizontal_top(|ui| {
        ui.label(icon.rich_text().size(16.0).color(color));
        ui.vertical(|ui| {
            ui.horizontal_wrapped(|ui| {
                ui.label(problem.message(context.lang));
                more(ui);
            });
            let remark = remark.filter(|remark| !remark.is_empty());
            let below: Vec<String> = remark.into_iter().chain(problem.help(context.lang)).collect();
            if !below.is_empty() {
                ui.label(RichText::new(below.join(" · ")).weak());
            }
        });
    });
    ui.add_space(4.0);
}

/// The thing of that name.
fn item(context: &Context<'_>, kind: NameKind, name: &lancer_scene::Name) -> Option<Item> {
    let stage = context.document.stage();
    let candidates = match kind {
        NameKind::ObjectOrLight => vec![Item::Object(name.clone()), Item::Light(name.clone())],
        NameKind::Material => vec![Item::Material(name.clone())],
        NameKind::View => vec![Item::View(name.clone())],
    };
    candidates.into_iter().find(|item| item.exists(stage))
}
