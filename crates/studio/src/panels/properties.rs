//! Every attribute of what is selected. The vocabulary of the documents says which there are; a widget is made for each
//! type of value.

use crate::fields::{self, Home, ScreenKind, Value};
use crate::toasts::Toast;
use crate::widgets::{self, Change, Channels, MaterialChoice, NumberField};
use crate::{Action, Context};
use egui::{Id, RichText, ScrollArea, TextEdit, Ui};
use egui_material_icons::icons::ICON_RESTART_ALT;
use lancer_document::number::NumberError;
use lancer_document::{Item, StepName, arrange, attribute, presets};
use lancer_formats::xml::vocabulary::{self, AttributeRule, ElementRule, Kind};
use lancer_scene::{
    Edit, ListEdit, Material, MaterialRef, Mesh, Name, Object, Shape, Stage, Surface, first_free_name, limits,
};
use lancer_words::{number, studio::panels as words};
use std::sync::Arc;

/// The width of the column of names.
const NAMES: f32 = 78.0;

/// Shows the panel; gives what the user wants.
pub fn show(ui: &mut Ui, context: &Context<'_>) -> Vec<Action> {
    let mut actions = Vec::new();
    ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
        let selection = context.document.selection();
        let Some(item) = selection.primary() else {
            ui.add_space(8.0);
            ui.label(RichText::new(words::nothing_selected(context.lang)).weak());
            return;
        };
        if selection.iter().len() > 1 {
            let name = item.name().map_or_else(|| words::world(context.lang), Name::to_string);
            ui.label(RichText::new(words::several(context.lang, selection.iter().len(), name)).weak());
        }
        let mut sheet = Sheet { context, item, actions: &mut actions, refused: None };
        match item {
            Item::World => sheet.world(ui),
            Item::Light(_) => sheet.light(ui),
            Item::Object(name) => sheet.object(ui, name),
            Item::Material(name) => sheet.material(ui, name),
            Item::View(name) => sheet.view(ui, name),
        }
        if let Some(reason) = sheet.refused {
            actions.push(Action::Say(Toast::failed(reason.text(context.lang))));
        }
    });
    actions
}

/// The sheet of one item while it is shown.
struct Sheet<'a, 'c> {
    context: &'a Context<'c>,
    item: &'a Item,
    actions: &'a mut Vec<Action>,
    refused: Option<NumberError>,
}

impl Sheet<'_, '_> {
    fn stage(&self) -> &Stage {
        self.context.document.stage()
    }

    fn world(&mut self, ui: &mut Ui) {
        self.heading(ui, &words::world(self.context.lang));
        let title = self.stage().scene.name.clone();
        if let Some(new) = self.text(ui, &words::title(self.context.lang), &title)
            && let Some(command) = arrange::titled(self.stage(), &new)
        {
            self.actions.push(Action::Apply(command.name, command.edit));
        }
        self.fields(ui, &vocabulary::WORLD, Home::Item);
    }

    fn light(&mut self, ui: &mut Ui) {
        self.name(ui);
        self.fields(ui, &vocabulary::LIGHT, Home::Item);
    }

    fn object(&mut self, ui: &mut Ui, name: &Name) {
        let Some(object) = self.stage().scene.objects.iter().find(|object| object.name == *name).cloned() else {
            return;
        };
        self.name(ui);
        self.heading(ui, &words::geometry(self.context.lang));
        let rule = element(&object.shape);
        for attribute in rule.attributes.iter().filter(|attribute| attribute.name != "material") {
            self.field(ui, rule, attribute, Home::Item);
        }
        if let Shape::Mesh(mesh) = &object.shape {
            self.mesh(ui, mesh);
        }
        self.heading(ui, &words::material(self.context.lang));
        self.material_of(ui, &object);
        match &object.material {
            MaterialRef::Inline(_) => self.fields(ui, &vocabulary::MATERIAL, Home::Inline),
            MaterialRef::Named(name) => self.shared_material(ui, name),
            MaterialRef::Default => {}
        }
    }

    /// The material that an object shares with others, where it stands; with how many.
    fn shared_material(&mut self, ui: &mut Ui, name: &Name) {
        let lang = self.context.lang;
        let uses = |object: &Arc<Object>| object.material_refs().any(|material| material.name() == Some(name));
        let users = self.stage().scene.objects.iter().filter(|object| uses(object)).count();
        if users > 1 {
            ui.label(RichText::new(words::shared(lang, users)).weak().small());
        }
        let item = Item::Material(name.clone());
        let mut sheet =
            Sheet { context: self.context, item: &item, actions: &mut *self.actions, refused: self.refused.take() };
        sheet.fields(ui, &vocabulary::MATERIAL, Home::Item);
        self.refused = sheet.refused;
    }

    /// What a mesh is made of; its vertices are edited in its file or in the document's text.
    fn mesh(&mut self, ui: &mut Ui, mesh: &Mesh) {
        let lang = self.context.lang;
        let (vertices, facets) = (mesh.geometry.positions.len(), mesh.geometry.facets.len());
        let weak = |ui: &mut Ui, text: String| ui.label(RichText::new(text).weak());
        weak(ui, words::mesh_summary(lang, number::vertices(lang, vertices), number::facets(lang, facets)));
        if let Some(source) = &mesh.source {
            weak(ui, words::mesh_source(lang, source));
        }
        for (part, run) in mesh.geometry.parts.iter().enumerate() {
            let facets = number::facets(lang, run.count as usize);
            weak(ui, words::mesh_part(lang, part + 1, facets));
            let id = Id::unique((self.item, "part", part));
            let choice = widgets::material(ui, id, &run.material, self.context, &words::material(lang));
            if let Some(reference) = choice.and_then(|choice| self.known(choice, &run.material)) {
                let name = attribute::set(self.item, "part");
                let edit = attribute::edit_object(self.stage(), self.item.name().map_or("", |name| name), |object| {
                    if let Shape::Mesh(mesh) = &mut object.shape
                        && let Some(run) = Arc::make_mut(&mut mesh.geometry).parts.get_mut(part)
                    {
                        run.material = reference.clone();
                    }
                });
                self.actions.extend(edit.map(|edit| Action::Apply(name, edit)));
            }
        }
    }

    /// A choice that needs no new material of the scene.
    fn known(&self, choice: MaterialChoice, shown: &MaterialRef) -> Option<MaterialRef> {
        match choice {
            MaterialChoice::Known(reference) => Some(reference),
            MaterialChoice::Own => Some(MaterialRef::Inline(Arc::new(self.stage().scene.surface(shown)))),
            MaterialChoice::New(preset) => preset.map(|preset| MaterialRef::Inline(Arc::new(preset.surface()))),
        }
    }

    /// The material of an object: chosen, its own, or made new in the same step.
    fn material_of(&mut self, ui: &mut Ui, object: &Object) {
        let lang = self.context.lang;
        let id = Id::unique((self.item, "material"));
        let choice = widgets::material(ui, id, &object.material, self.context, &words::material(lang));
        let Some(choice) = choice else { return };
        let step = attribute::set(self.item, "material");
        let stage = self.stage();
        let put = |reference: MaterialRef| {
            attribute::edit_object(stage, &object.name, |object| attribute::set_material(object, reference))
        };
        match choice {
            MaterialChoice::New(preset) => {
                let surface = preset.map_or_else(|| stage.scene.surface(&object.material), presets::Preset::surface);
                let stem = preset.map_or_else(|| "material".to_owned(), |preset| preset.text(lang));
                let material = new_material(stage, &stem, preset.is_some(), surface);
                let name = material.name.clone();
                let add = ListEdit::Insert { index: stage.scene.materials.len(), item: Arc::new(material) };
                let edits = [Some(Edit::Materials(add)), put(MaterialRef::Named(name))];
                self.actions.push(Action::Apply(step, Edit::Batch(edits.into_iter().flatten().collect())));
            }
            MaterialChoice::Known(_) | MaterialChoice::Own => {
                let edit = self.known(choice, &object.material).and_then(put);
                self.actions.extend(edit.map(|edit| Action::Apply(step, edit)));
            }
        }
    }

    fn material(&mut self, ui: &mut Ui, name: &Name) {
        let Some(material) = self.stage().scene.material(name).cloned() else { return };
        self.name(ui);
        let lang = self.context.lang;
        ui.horizontal(|ui| {
            widgets::swatch(ui, self.context, &material.surface, 24.0);
            let chosen =
                ui.menu_button(words::apply_preset(lang), |ui| widgets::preset_list(ui, self.context)).inner.flatten();
            if let Some(preset) = chosen {
                let edit = attribute::edit_material(self.stage(), name, |material| material.surface = preset.surface());
                let step = StepName::Set { item: name.clone(), attribute: "material" };
                self.actions.extend(edit.map(|edit| Action::Apply(step, edit)));
            }
        })
        .response
        .on_hover_text(words::apply_preset_hint(lang));
        self.fields(ui, &vocabulary::MATERIAL, Home::Item);
    }

    fn view(&mut self, ui: &mut Ui, name: &Name) {
        let lang = self.context.lang;
        let Some(view) = self.stage().views.iter().find(|view| view.name == *name).cloned() else { return };
        self.name(ui);
        self.heading(ui, &words::eye(lang));
        self.field_of(ui, &vocabulary::EYE, "at");
        self.heading(ui, &words::screen(lang));
        let kinds = [words::by_look_at(lang), words::by_center(lang), words::by_frame(lang), words::by_corners(lang)];
        let kind = ScreenKind::of(&view);
        let chosen = ScreenKind::ALL.iter().position(|known| *known == kind).unwrap_or(0);
        let label = words::screen_by(lang);
        let change = self.row(ui, &label, "", None, |ui, id| widgets::choice(ui, id, chosen, &kinds, &label));
        if let Change::Set(place) = change
            && let Some(screen) = ScreenKind::ALL.get(place).and_then(|kind| kind.convert(&view))
        {
            let edit = attribute::edit_view(self.stage(), name, |view| view.screen = screen);
            let step = attribute::set(self.item, "screen");
            self.actions.extend(edit.map(|edit| Action::Apply(step, edit)));
        }
        for attribute in ["look-at", "fov", "up"] {
            self.field_of(ui, &vocabulary::EYE, attribute);
        }
        for attribute in ["center", "size", "origin", "u", "v", "corners"] {
            self.field_of(ui, &vocabulary::SCREEN, attribute);
        }
        self.heading(ui, &words::picture(lang));
        self.fields(ui, &vocabulary::VIEW, Home::Item);
    }

    fn heading(&self, ui: &mut Ui, text: &str) {
        ui.add_space(10.0);
        ui.label(RichText::new(text).strong().color(self.context.palette.weak));
        ui.add_space(2.0);
    }

    /// The name of the item, to be typed over.
    fn name(&mut self, ui: &mut Ui) {
        let lang = self.context.lang;
        let Some(name) = self.item.name().cloned() else { return };
        if let Some(new) = self.text(ui, &words::name(lang), &name) {
            match arrange::renamed(self.stage(), self.item, &new) {
                Ok(command) => self.actions.extend(command.map(|command| Action::Apply(command.name, command.edit))),
                Err(rule) => self.actions.push(Action::Say(Toast::failed(super::refusal(rule, lang)))),
            }
        }
    }

    /// A line of text; gives what was typed once it is left.
    fn text(&mut self, ui: &mut Ui, label: &str, value: &str) -> Option<String> {
        let mut typed = None;
        self.row(ui, label, "", None, |ui, id| {
            let mut text = ui.data(|data| data.get_temp::<String>(id)).unwrap_or_else(|| value.to_owned());
            let field = TextEdit::singleline(&mut text).id(id.with("text")).desired_width(f32::INFINITY);
            let response = ui.add(field);
            let enabled = response.enabled();
            response.widget_info(|| egui::WidgetInfo {
                label: Some(label.to_owned()),
                ..egui::WidgetInfo::text_edit(enabled, value, &text, "")
            });
            if response.lost_focus() {
                ui.data_mut(|data| data.remove::<String>(id));
                let escaped = ui.input(|input| input.key_pressed(egui::Key::Escape));
                typed = (!escaped && text != value).then_some(text);
            } else if response.has_focus() {
                ui.data_mut(|data| data.insert_temp(id, text));
            }
            Change::<()>::Kept
        });
        typed
    }

    fn fields(&mut self, ui: &mut Ui, rule: &'static ElementRule, home: Home) {
        for attribute in rule.attributes {
            self.field(ui, rule, attribute, home);
        }
    }

    fn field_of(&mut self, ui: &mut Ui, rule: &'static ElementRule, name: &str) {
        if let Some(attribute) = rule.attribute(name) {
            self.field(ui, rule, attribute, Home::Item);
        }
    }

    /// One attribute: its name with what it means, its widget, and a way back to its default.
    fn field(&mut self, ui: &mut Ui, rule: &ElementRule, attribute: &'static AttributeRule, home: Home) {
        let Some(value) = fields::get(self.stage(), self.item, home, attribute.name) else { return };
        let lang = self.context.lang;
        let default = fields::default(self.item, home, attribute.name).filter(|default| *default != value);
        let hint = hint(rule, attribute, lang);
        let label = lancer_words::attribute::label(lang, rule.name, attribute.name);
        let mut refused = self.refused.take();
        // where a view has no depth limit of its own
        let around = (self.stage().scene.world.depth, lang);
        let change = self
            .row(ui, label, &hint, default, |ui, id| widget(ui, id, &value, (attribute, label), around, &mut refused));
        self.refused = refused;
        self.carry_out(attribute.name, home, change);
    }

    /// A row: the name, a way back to the default if there is one to go to, the widget.
    fn row<T>(
        &mut self,
        ui: &mut Ui,
        label: &str,
        hint: &str,
        default: Option<T>,
        widget: impl FnOnce(&mut Ui, Id) -> Change<T>,
    ) -> Change<T> {
        let lang = self.context.lang;
        let id = Id::unique((self.item, label));
        ui.horizontal_top(|ui| {
            ui.spacing_mut().item_spacing.x = 4.0;
            let size = egui::vec2(NAMES, ui.spacing().interact_size.y);
            let layout = egui::Layout::left_to_right(egui::Align::Center);
            let name = ui.allocate_ui_with_layout(size, layout, |ui| {
                ui.set_min_size(size);
                let response = ui.add(egui::Label::new(RichText::new(label).weak()).truncate());
                if hint.is_empty() { response } else { response.on_hover_text(hint) }
            });
            drop(name);
            let reset_width = 20.0;
            let reset = ui.allocate_ui_with_layout(egui::vec2(reset_width, size.y), layout, |ui| {
                ui.set_min_size(egui::vec2(reset_width, size.y));
                default.and_then(|default| {
                    let name = words::reset(lang, label);
                    let clicked = crate::chrome::small_icon_button(ui, ICON_RESTART_ALT, &name).clicked();
                    clicked.then_some(default)
                })
            });
            let change = ui.scope(|ui| widget(ui, id)).inner;
            match reset.inner {
                Some(default) => Change::Set(default),
                None => change,
            }
        })
        .inner
    }

    /// Makes actions of what a widget says.
    fn carry_out(&mut self, name: &'static str, home: Home, change: Change<Value>) {
        let document = self.context.document;
        let step = attribute::set(self.item, name);
        let edit = |stage: &Stage, value: &Value| fields::set(stage, self.item, home, name, value);
        match change {
            Change::Kept => {}
            Change::Released => self.actions.push(Action::Commit),
            Change::Set(value) => {
                let edit = edit(document.stage(), &value);
                self.actions.extend(edit.map(|edit| Action::Apply(step, edit)));
            }
            Change::Dragging { started, value } => {
                let base = if started { document.stage() } else { document.base() };
                let edit = edit(base, &value);
                if started {
                    self.actions.push(Action::Begin(step));
                }
                self.actions.extend(edit.map(Action::Preview));
            }
        }
    }
}

/// The element that describes a shape.
fn element(shape: &Shape) -> &'static ElementRule {
    match shape {
        Shape::Sphere { .. } => &vocabulary::SPHERE,
        Shape::Plane { .. } => &vocabulary::PLANE,
        Shape::Facet { .. } => &vocabulary::FACET,
        Shape::Cube { .. } => &vocabulary::CUBE,
        Shape::Parallelepiped { .. } => &vocabulary::BOX,
        Shape::Cone { .. } => &vocabulary::CONE,
        Shape::Mesh(_) => &vocabulary::MESH,
    }
}

/// A material of the scene under a free name: the stem itself where it may be taken as it is, or with a number.
fn new_material(stage: &Stage, stem: &str, bare: bool, surface: Surface) -> Material {
    let taken: std::collections::HashSet<Name> =
        stage.scene.materials.iter().map(|material| material.name.clone()).collect();
    let name = if bare && !taken.contains(stem) { Name::from(stem) } else { first_free_name(stem, &taken) };
    Material { name, surface }
}

/// What an attribute means: its term in the subject, its sentence, its range, its formula.
fn hint(rule: &ElementRule, attribute: &AttributeRule, lang: lancer_words::Lang) -> String {
    let mut lines = Vec::new();
    let sentence = (attribute.sentence)(lang);
    let term = if attribute.term.is_empty() { attribute.name } else { attribute.term };
    lines.push(words::meaning(lang, term, sentence));
    if let Some((least, greatest)) = range(attribute.kind) {
        lines.push(words::range(lang, least, greatest));
    }
    let formula = words::formula(rule.name, attribute.name);
    if !formula.is_empty() {
        lines.push(formula.to_owned());
    }
    lines.join("\n")
}

/// The range of a number.
fn range(kind: Kind) -> Option<(f64, f64)> {
    match kind {
        Kind::Color => Some((0.0, 1.0)),
        Kind::Channels(least, greatest) | Kind::Number(least, greatest) => Some((least, greatest)),
        Kind::Integer(least, greatest) => Some((f64::from(least), f64::from(greatest))),
        Kind::Length | Kind::Size => Some((limits::LEAST, limits::COORDINATE)),
        Kind::Version
        | Kind::Text
        | Kind::Name
        | Kind::MaterialName
        | Kind::Path
        | Kind::Point
        | Kind::Factors
        | Kind::Corners
        | Kind::Choice(_)
        | Kind::Steps
        | Kind::Run => None,
    }
}

/// The widget of a value's type.
fn widget(
    ui: &mut Ui,
    id: Id,
    value: &Value,
    (attribute, name): (&'static AttributeRule, &str),
    (world_depth, lang): (u32, lancer_words::Lang),
    refused: &mut Option<NumberError>,
) -> Change<Value> {
    let (least, greatest) = range(attribute.kind).unwrap_or((-limits::COORDINATE, limits::COORDINATE));
    let width = ui.available_width();
    let number =
        |speed: f64, whole: bool| NumberField { name, prefix: "", range: least..=greatest, speed, whole, width };
    let triple = |speed: f64| Channels { name, range: least..=greatest, speed, lang };
    match value {
        Value::Flag(on) => {
            let mut on = *on;
            let response = ui.checkbox(&mut on, "");
            let enabled = response.enabled();
            response.widget_info(|| egui::WidgetInfo::selected(egui::Role::CheckBox, enabled, on, name));
            if response.changed() { Change::Set(Value::Flag(on)) } else { Change::Kept }
        }
        Value::Integer(None) => {
            let mut worlds = true;
            let response = ui.checkbox(&mut worlds, words::world_depth(lang));
            if response.changed() { Change::Set(Value::Integer(Some(world_depth))) } else { Change::Kept }
        }
        Value::Integer(Some(whole)) => widgets::number(ui, f64::from(*whole), &number(0.1, true), refused)
            .map(|whole| Value::Integer(Some(whole as u32))),
        Value::Number(number_) => {
            let speed = if matches!(attribute.kind, Kind::Length) { number_ * 0.01 } else { 0.25 };
            widgets::number(ui, *number_, &number(speed, false), refused).map(Value::Number)
        }
        Value::Point(point) => {
            let speed = if attribute.name == "rotation" { 0.5 } else { 0.01 };
            widgets::point(ui, id, *point, name, speed, refused).map(Value::Point)
        }
        Value::Size(size) => widgets::size(ui, id, *size, name, 0.01, refused).map(Value::Size),
        Value::Corners(corners) => {
            let mut change = Change::Kept;
            ui.vertical(|ui| {
                for (place, corner) in ["BL", "BR", "TR", "TL"].into_iter().enumerate() {
                    let name = format!("{name} {corner}");
                    let new = widgets::point(ui, id.with(place), corners[place], &name, 0.01, refused).map(|point| {
                        let mut corners = *corners;
                        corners[place] = point;
                        // the opposite corner follows: a screen is a parallelogram
                        let [before, after] = [corners[(place + 3) % 4], corners[(place + 1) % 4]];
                        corners[(place + 2) % 4] = before + after - point;
                        Value::Corners(corners)
                    });
                    change = std::mem::replace(&mut change, Change::Kept).or(new);
                }
            });
            change
        }
        Value::Color(color) => widgets::color(ui, id, *color, &triple(0.004), refused).map(Value::Color),
        Value::Channels(channels) => {
            let speed = if attribute.name == "n" { 0.5 } else { 0.005 };
            widgets::channels(ui, id, *channels, &triple(speed), refused).map(Value::Channels)
        }
        Value::Choice(place) => {
            let Kind::Choice(words) = attribute.kind else { return Change::Kept };
            let words: Vec<String> =
                words.iter().map(|word| lancer_words::attribute::choice(lang, word).to_owned()).collect();
            widgets::choice(ui, id, *place, &words, name).map(Value::Choice)
        }
        Value::Steps(steps) => widgets::steps(ui, *steps, lang).map(Value::Steps),
        // shown by the sheet of the object
        Value::Material(_) => Change::Kept,
    }
}
