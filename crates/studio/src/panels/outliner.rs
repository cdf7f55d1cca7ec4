//! The scene as a list: world, lamps, objects, materials, views; to select, add, rename, copy, delete, reorder, hide and
//! filter. Only the rows that are seen are made, so a scene of ten thousand objects scrolls as lightly as one of ten.

use crate::chrome::{SMALL, icon_menu, small_icon_button as icon_button};
use crate::kind::Kind;
use crate::toasts::Toast;
use crate::widgets::{line, preset_list, swatch};
use crate::{Action, Context, FileAction, ViewAction};
use egui::{Id, Key, Response, RichText, ScrollArea, TextEdit, Ui, WidgetInfo};
use egui_material_icons::MaterialIcon;
use egui_material_icons::icons::{
    ICON_ADD, ICON_CLOSE, ICON_PUBLIC, ICON_SEARCH, ICON_VISIBILITY, ICON_VISIBILITY_OFF,
};
use lancer_document::insert::{NewItem, Standpoint, added};
use lancer_document::{Command, Item, Selection, arrange};
use lancer_scene::{Name, Shape, Stage, Surface};
use lancer_words::studio::panels as words;
use lancer_words::{Lang, number};

/// The height of a row.
const ROW: f32 = 24.0;

/// A line of the list.
enum Row {
    /// A section's head with what it can add.
    Head(Section),
    /// The world.
    World,
    /// A thing in its section.
    Item(Item),
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Section {
    Lamps,
    Objects,
    Materials,
    Views,
}

/// Shows the panel; gives what the user wants.
pub fn show(ui: &mut Ui, context: &Context<'_>) -> Vec<Action> {
    let mut actions = Vec::new();
    let filter = filter(ui, context.lang);
    let stage = context.document.stage();
    let rows = rows(stage, &filter.to_lowercase());
    if rows.is_empty() {
        ui.label(RichText::new(words::nothing_matches(context.lang, filter)).weak());
        return actions;
    }
    ui.spacing_mut().item_spacing.y = 0.0;
    ScrollArea::vertical().auto_shrink(false).show_rows(ui, ROW, rows.len(), |ui, seen| {
        for row in rows.get(seen).unwrap_or_default() {
            match row {
                Row::Head(section) => head(ui, context, *section, &mut actions),
                Row::World => item_row(ui, context, &Item::World, &mut actions),
                Row::Item(item) if context.renaming == Some(item) => rename_row(ui, context, item, &mut actions),
                Row::Item(item) => item_row(ui, context, item, &mut actions),
            }
        }
    });
    actions
}

/// The field that filters by name; gives the text.
fn filter(ui: &mut Ui, lang: Lang) -> String {
    let id = Id::unique("outliner filter");
    let mut text = ui.data(|data| data.get_temp::<String>(id)).unwrap_or_default();
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        ui.label(ICON_SEARCH.rich_text().weak());
        let room = if text.is_empty() { 0.0 } else { 30.0 };
        let width = (ui.available_width() - room).max(40.0);
        let response = ui.add(TextEdit::singleline(&mut text).hint_text(words::filter(lang)).desired_width(width));
        let (enabled, name) = (response.enabled(), words::filter(lang));
        response.widget_info(|| WidgetInfo {
            label: Some(name.clone()),
            ..WidgetInfo::text_edit(enabled, &text, &text, &name)
        });
        if !text.is_empty() && icon_button(ui, ICON_CLOSE, &words::clear_filter(lang)).clicked() {
            text.clear();
        }
    });
    ui.add_space(4.0);
    ui.data_mut(|data| data.insert_temp(id, text.clone()));
    text
}

/// The lines that match a filter, which is in lower case.
fn rows(stage: &Stage, filter: &str) -> Vec<Row> {
    let mut rows = Vec::new();
    let matches = |name: &Name| filter.is_empty() || name.to_lowercase().contains(filter);
    if filter.is_empty() {
        rows.push(Row::World);
    }
    for section in [Section::Lamps, Section::Objects, Section::Materials, Section::Views] {
        let items: Vec<Item> = items(stage, section).filter(|item| item.name().is_some_and(&matches)).collect();
        if filter.is_empty() || !items.is_empty() {
            rows.push(Row::Head(section));
        }
        rows.extend(items.into_iter().map(Row::Item));
    }
    rows
}

/// The things of a section in their order.
fn items(stage: &Stage, section: Section) -> Box<dyn Iterator<Item = Item> + '_> {
    let scene = &stage.scene;
    match section {
        Section::Lamps => Box::new(scene.lights.iter().map(|light| Item::Light(light.name.clone()))),
        Section::Objects => Box::new(scene.objects.iter().map(|object| Item::Object(object.name.clone()))),
        Section::Materials => Box::new(scene.materials.iter().map(|material| Item::Material(material.name.clone()))),
        Section::Views => Box::new(stage.views.iter().map(|view| Item::View(view.name.clone()))),
    }
}

fn head(ui: &mut Ui, context: &Context<'_>, section: Section, actions: &mut Vec<Action>) {
    let (lang, stage) = (context.lang, context.document.stage());
    let scene = &stage.scene;
    let (title, count, add) = match section {
        Section::Lamps => (words::lamps(lang), scene.lights.len(), words::add_lamp(lang)),
        Section::Objects => (words::objects(lang), scene.objects.len(), words::add_object(lang)),
        Section::Materials => (words::materials(lang), scene.materials.len(), words::add_material(lang)),
        Section::Views => (words::views(lang), stage.views.len(), words::add_view(lang)),
    };
    ui.horizontal(|ui| {
        ui.set_height(ROW);
        ui.label(RichText::new(title).strong().color(context.palette.weak));
        ui.label(RichText::new(count.to_string()).weak().small());
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| match section {
            Section::Lamps => {
                if icon_button(ui, ICON_ADD, &add).clicked() {
                    insert(context, NewItem::Light, actions);
                }
            }
            Section::Views => {
                if icon_button(ui, ICON_ADD, &add).clicked() {
                    let like = context.active_view().map(|view| lancer_scene::View::clone(view));
                    insert(context, NewItem::View(like), actions);
                }
            }
            Section::Objects => {
                icon_menu(ui, ICON_ADD, SMALL, &add, |ui| object_menu(ui, context, actions));
            }
            Section::Materials => {
                icon_menu(ui, ICON_ADD, SMALL, &add, |ui| {
                    if ui.button(words::plain_material(lang)).clicked() {
                        ui.close();
                        let item = NewItem::Material { stem: String::new(), surface: Surface::default() };
                        insert(context, item, actions);
                    }
                    ui.separator();
                    if let Some(preset) = preset_list(ui, context) {
                        let item = NewItem::Material { stem: preset.text(lang), surface: preset.surface() };
                        insert(context, item, actions);
                    }
                });
            }
        });
    });
}

/// The kinds of objects that can be added.
pub(crate) fn object_menu(ui: &mut Ui, context: &Context<'_>, actions: &mut Vec<Action>) {
    let lang = context.lang;
    let kinds = [
        (Kind::Sphere, words::sphere(lang), NewItem::Sphere),
        (Kind::Plane, words::plane(lang), NewItem::Plane),
        (Kind::Cube, words::cube(lang), NewItem::Cube),
        (Kind::Parallelepiped, words::parallelepiped(lang), NewItem::Parallelepiped),
        (Kind::Cone, words::cone(lang), NewItem::Cone),
        (Kind::Facet, words::facet(lang), NewItem::Facet),
    ];
    for (kind, name, item) in kinds {
        if ui.button((kind.icon().rich_text().size(16.0), name)).clicked() {
            insert(context, item, actions);
            ui.close();
        }
    }
    if ui.button((Kind::Mesh.icon().rich_text().size(16.0), words::mesh(lang))).clicked() {
        actions.push(Action::File(FileAction::AddMesh));
        ui.close();
    }
}

/// Adds a thing in front of the view that is worked in.
fn insert(context: &Context<'_>, item: NewItem, actions: &mut Vec<Action>) {
    let stage = context.document.stage();
    let at = context.active_view().map_or_else(Standpoint::default, |view| Standpoint::of(view, &stage.scene, None));
    command(added(stage, item, &at), actions);
}

/// A command as actions: its step, then what is selected after it.
fn command(command: Command, actions: &mut Vec<Action>) {
    actions.push(Action::Apply(command.name, command.edit));
    if let Some(items) = command.select {
        let mut selection = Selection::default();
        selection.set(items);
        actions.push(Action::Select(selection));
    }
}

fn icon(stage: &Stage, item: &Item) -> MaterialIcon {
    match item {
        Item::World => ICON_PUBLIC,
        Item::Light(_) => Kind::Light.icon(),
        Item::Material(_) => Kind::Material.icon(),
        Item::View(_) => Kind::View.icon(),
        Item::Object(_) => match item.place(stage).and_then(|place| stage.scene.objects.get(place)).map(|o| &o.shape) {
            Some(Shape::Sphere { .. }) | None => Kind::Sphere.icon(),
            Some(Shape::Plane { .. }) => Kind::Plane.icon(),
            Some(Shape::Facet { .. }) => Kind::Facet.icon(),
            Some(Shape::Cube { .. }) => Kind::Cube.icon(),
            Some(Shape::Parallelepiped { .. }) => Kind::Parallelepiped.icon(),
            Some(Shape::Cone { .. }) => Kind::Cone.icon(),
            Some(Shape::Mesh(_)) => Kind::Mesh.icon(),
        },
    }
}

/// Whether the thing takes part in the picture; `None` for what always does.
fn visible(stage: &Stage, item: &Item) -> Option<bool> {
    let place = item.place(stage)?;
    match item {
        Item::Light(_) => stage.scene.lights.get(place).map(|light| light.visible),
        Item::Object(_) => stage.scene.objects.get(place).map(|object| object.visible),
        Item::World | Item::Material(_) | Item::View(_) => None,
    }
}

fn item_row(ui: &mut Ui, context: &Context<'_>, item: &Item, actions: &mut Vec<Action>) {
    let (lang, stage) = (context.lang, context.document.stage());
    let name = item.name().map_or_else(|| words::world(lang), Name::to_string);
    let shown = visible(stage, item);
    ui.horizontal(|ui| {
        ui.set_height(ROW);
        ui.spacing_mut().item_spacing.x = 6.0;
        if item.name().is_some() {
            ui.add_space(8.0);
        }
        let eye_room = if shown.is_some() { SMALL + 8.0 } else { 2.0 };
        let response = label(ui, context, item, &name, shown == Some(false), eye_room);
        select(ui, context, item, &response, actions);
        reorder(context, item, &response, actions);
        response.context_menu(|ui| menu(ui, context, item, actions));
        if let Some(shown) = shown {
            let (icon, text) = if shown {
                (ICON_VISIBILITY, words::hide(lang, &name))
            } else {
                (ICON_VISIBILITY_OFF, words::show(lang, &name))
            };
            if icon_button(ui, icon, &text).clicked() {
                actions.extend(arrange::shown(stage, [item], !shown).map(|step| Action::Apply(step.name, step.edit)));
            }
        }
    });
}

/// Icon and name, over the whole width that is left.
fn label(ui: &mut Ui, context: &Context<'_>, item: &Item, name: &str, faint: bool, room: f32) -> Response {
    let stage = context.document.stage();
    if let Item::Material(material) = item
        && let Some(material) = stage.scene.material(material)
    {
        swatch(ui, context, &material.surface, 18.0);
    } else {
        let color = if faint { context.palette.line } else { context.palette.weak };

        let (rect, _) = ui.allocate_exact_size(egui::vec2(18.0, SMALL), egui::Sense::hover());
        let icon = icon(stage, item);
        let font = egui::FontId::new(16.0, icon.font_family());
        ui.painter().text(rect.center(), egui::Align2::CENTER_CENTER, icon.codepoint, font, color);
    }
    let text = RichText::new(name);
    let text = if faint { text.weak().italics() } else { text };
    let selected = context.document.selection().contains(item);
    let size = egui::vec2((ui.available_width() - room).max(40.0), SMALL);
    line(ui, size, selected, name, text)
}

/// A click selects, with Ctrl it adds or takes out, with Shift it selects a run; a double click renames or shows.
fn select(ui: &Ui, context: &Context<'_>, item: &Item, response: &Response, actions: &mut Vec<Action>) {
    if response.double_clicked() {
        actions.push(match item {
            Item::View(view) => Action::View(view.clone(), ViewAction::Show),
            Item::World => return,
            Item::Light(_) | Item::Object(_) | Item::Material(_) => Action::Rename(item.clone()),
        });
        return;
    }
    if response.clicked() {
        let modifiers = ui.input(|input| input.modifiers);
        let mut selection = context.document.selection().clone();
        if modifiers.command {
            selection.toggle(item.clone());
        } else if modifiers.shift
            && let Some(first) = selection.primary().cloned()
        {
            selection.set(run(context.document.stage(), &first, item));
        } else {
            selection = Selection::only(item.clone());
        }
        actions.push(Action::Select(selection));
    } else if response.secondary_clicked() && !context.document.selection().contains(item) {
        actions.push(Action::Select(Selection::only(item.clone())));
    }
}

/// The things between two of one section, the last one last.
fn run(stage: &Stage, first: &Item, last: &Item) -> Vec<Item> {
    let same = std::mem::discriminant(first) == std::mem::discriminant(last);
    let (Some(a), Some(b), true) = (first.place(stage), last.place(stage), same) else { return vec![last.clone()] };
    let section = match last {
        Item::Light(_) => Section::Lamps,
        Item::Object(_) => Section::Objects,
        Item::Material(_) => Section::Materials,
        Item::View(_) => Section::Views,
        Item::World => return vec![Item::World],
    };
    let mut items: Vec<Item> = items(stage, section).skip(a.min(b)).take(a.abs_diff(b) + 1).collect();
    if b < a {
        items.reverse();
    }
    items
}

/// A row that is dragged onto another one of its section takes its place; Alt with an arrow key moves it by one.
fn reorder(context: &Context<'_>, item: &Item, response: &Response, actions: &mut Vec<Action>) {
    let stage = context.document.stage();
    let mut to = None;
    if item.name().is_some() {
        response.dnd_set_drag_payload(item.clone());
        if let Some(dropped) = response.dnd_release_payload::<Item>()
            && std::mem::discriminant(&*dropped) == std::mem::discriminant(item)
        {
            to = item.place(stage).map(|place| (Item::clone(&dropped), place));
        }
    }
    if response.has_focus()
        && let Some(place) = item.place(stage)
    {
        let moved = |key| response.ctx.input_mut(|input| input.consume_key(egui::Modifiers::ALT, key));
        if moved(Key::ArrowUp) {
            to = place.checked_sub(1).map(|place| (item.clone(), place));
        } else if moved(Key::ArrowDown) {
            to = Some((item.clone(), place + 1));
        }
    }
    if let Some((item, place)) = to
        && let Some(step) = arrange::reordered(stage, &item, place)
    {
        actions.push(Action::Apply(step.name, step.edit));
    }
}

fn menu(ui: &mut Ui, context: &Context<'_>, item: &Item, actions: &mut Vec<Action>) {
    let (lang, stage) = (context.lang, context.document.stage());
    let Some(place) = item.place(stage) else { return };
    let selection = context.document.selection();
    // what is done to a selected row is done to all of them
    let items: Vec<Item> =
        if selection.contains(item) { selection.iter().cloned().collect() } else { vec![item.clone()] };
    if let Item::View(view) = item
        && ui.button(words::show_view(lang)).clicked()
    {
        actions.push(Action::View(view.clone(), ViewAction::Show));
    }
    if ui.button(words::rename(lang)).clicked() {
        actions.push(Action::Rename(item.clone()));
    }
    if ui.button(words::duplicate(lang)).clicked()
        && let Some(step) = arrange::duplicated(stage, &items)
    {
        command(step, actions);
    }
    for (text, to) in [(words::move_up(lang), place.checked_sub(1)), (words::move_down(lang), Some(place + 1))] {
        if let Some(step) = to.and_then(|to| arrange::reordered(stage, item, to)) {
            if ui.button(text).clicked() {
                actions.push(Action::Apply(step.name, step.edit));
            }
        } else {
            ui.add_enabled(false, egui::Button::new(text));
        }
    }
    ui.separator();
    if ui.button(words::delete(lang)).clicked()
        && let Some(step) = arrange::deleted(stage, &items)
    {
        command(step, actions);
    }
}

/// The row of a thing that gets a new name: Enter takes it, Escape leaves the old one.
fn rename_row(ui: &mut Ui, context: &Context<'_>, item: &Item, actions: &mut Vec<Action>) {
    let Some(name) = item.name() else { return };
    let id = Id::unique(("rename", item));
    let begun = ui.data(|data| data.get_temp::<String>(id));
    let first = begun.is_none();
    let mut text = begun.unwrap_or_else(|| name.to_string());
    let response = ui
        .horizontal(|ui| {
            ui.set_height(ROW);
            ui.add_space(8.0);
            ui.label(icon(context.document.stage(), item).rich_text().size(16.0));
            ui.add(TextEdit::singleline(&mut text).id(id.with("field")).desired_width(f32::INFINITY))
        })
        .inner;
    let label = words::new_name(context.lang, name);
    response.widget_info(|| WidgetInfo { label: Some(label.clone()), ..WidgetInfo::text_edit(true, name, &text, "") });
    if first {
        response.request_focus();
    }
    if !response.lost_focus() {
        ui.data_mut(|data| data.insert_temp(id, text));
        return;
    }
    ui.data_mut(|data| data.remove::<String>(id));
    actions.push(Action::EndRename);
    if ui.input(|input| input.key_pressed(Key::Escape)) {
        return;
    }
    match arrange::renamed(context.document.stage(), item, &text) {
        Ok(step) => actions.extend(step.map(|step| Action::Apply(step.name, step.edit))),
        Err(rule) => actions.push(Action::Say(Toast::failed(super::refusal(rule, context.lang)))),
    }
}

/// How many things a section holds, in words; for the bar at the foot of the window.
pub(crate) fn summary(stage: &Stage, lang: Lang) -> String {
    let scene = &stage.scene;
    format!("{} · {}", number::objects(lang, scene.objects.len()), number::lights(lang, scene.lights.len()))
}
