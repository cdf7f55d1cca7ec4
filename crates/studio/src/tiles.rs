//! The panes of the main window as tiles that split, are dragged and stand behind each other as tabs.

use crate::layout::{Pane, SIMPLIFICATION};
use crate::panels::view::{self, Tools};
use crate::theme;
use crate::view::{LiveView, Picker, header};
use crate::{Action, Context, ViewAction};
use egui::{Align2, Color32, CursorIcon, FontId, Role, Sense, Stroke, Ui, Visuals, WidgetInfo, WidgetText};
use egui_tiles::{SimplificationOptions, TabState, Tile, TileId, UiResponse};
use lancer_document::wireframe::Wireframes;
use lancer_scene::View;
use lancer_words::studio::menu as words;
use std::collections::BTreeMap;
use std::sync::Arc;

/// Room on each side of a tab's title.
const MARGIN: f32 = 10.0;
/// Room for the cross that closes a tab.
const CLOSE: f32 = 16.0;

/// What the tiles are drawn from.
pub(crate) struct Tiles<'a> {
    pub(crate) context: &'a Context<'a>,
    pub(crate) live: &'a mut BTreeMap<String, LiveView>,
    pub(crate) picker: &'a Picker,
    pub(crate) wireframes: &'a mut Wireframes,
    pub(crate) actions: &'a mut Vec<Action>,
}

impl Tiles<'_> {
    fn view(&self, name: &str) -> Option<&Arc<View>> {
        self.context.document.stage().views.iter().find(|view| &*view.name == name)
    }

    fn view_of<'t>(&self, tiles: &'t egui_tiles::Tiles<Pane>, tile: TileId) -> Option<&'t str> {
        match tiles.get(tile) {
            Some(Tile::Pane(pane)) => Some(&pane.view),
            Some(Tile::Container(_)) | None => None,
        }
    }
}

impl egui_tiles::Behavior<Pane> for Tiles<'_> {
    fn pane_ui(&mut self, ui: &mut Ui, _tile: TileId, pane: &mut Pane) -> UiResponse {
        let view = self.view(&pane.view).cloned();
        if let (Some(view), Some(live)) = (view, self.live.get_mut(&pane.view)) {
            let tools = Tools { picker: self.picker, wireframes: self.wireframes };
            self.actions.extend(view::show(ui, self.context, live, &view, tools));
        }
        UiResponse::None
    }

    fn tab_title_for_pane(&mut self, pane: &Pane) -> WidgetText {
        pane.view.as_str().into()
    }

    fn tab_ui(
        &mut self,
        tiles: &mut egui_tiles::Tiles<Pane>,
        ui: &mut Ui,
        id: egui::Id,
        tile: TileId,
        state: &TabState,
    ) -> egui::Response {
        let (palette, lang) = (self.context.palette, self.context.lang);
        let view = self.view_of(tiles, tile).unwrap_or_default().to_owned();
        let color = match (state.active, self.context.active == Some(view.as_str())) {
            (true, true) => palette.text,
            (true, false) | (false, _) => palette.weak,
        };
        let galley = ui.painter().layout_no_wrap(view.clone(), theme::title_font(12.5), color);
        let height = ui.available_height();
        let size = egui::vec2(galley.size().x + 2.0 * MARGIN + CLOSE, height);
        let (_, rect) = ui.allocate_space(size);
        let response = ui.interact(rect, id, Sense::click_and_drag()).on_hover_cursor(CursorIcon::Grab);
        response.widget_info(|| WidgetInfo::selected(Role::Tab, true, state.active, &view));
        if state.is_being_dragged {
            return response;
        }
        let place = egui::pos2(rect.left() + MARGIN, rect.center().y - galley.size().y / 2.0);
        ui.painter().galley(place, galley, color);
        if state.active && self.context.active == Some(view.as_str()) {
            let line = rect.left() + 6.0..=rect.right() - 4.0;
            ui.painter().hline(line, rect.bottom() - 1.0, Stroke::new(2.0, palette.accent));
        }
        let cross = egui::Rect::from_center_size(
            rect.right_center() - egui::vec2(CLOSE / 2.0 + 2.0, 0.0),
            egui::Vec2::splat(18.0),
        );
        let close = ui.interact(cross, id.with("close"), Sense::click());
        let name = format!("{} · {view}", words::close_view(lang));
        let close = crate::chrome::named(close, Role::Button, None, &name);
        if close.hovered() || close.has_focus() {
            ui.painter().rect_filled(cross, 4.0, palette.hover);
        }
        let icon = egui_material_icons::icons::ICON_CLOSE;
        let font = FontId::new(13.0, icon.font_family());
        ui.painter().text(cross.center(), Align2::CENTER_CENTER, icon.codepoint, font, palette.weak);
        if close.clicked() || response.clicked_by(egui::PointerButton::Middle) {
            self.actions.push(Action::View(view.as_str().into(), ViewAction::Close));
        } else if response.clicked() {
            self.actions.push(Action::View(view.as_str().into(), ViewAction::Focus));
        }
        response
    }

    fn top_bar_right_ui(
        &mut self,
        tiles: &egui_tiles::Tiles<Pane>,
        ui: &mut Ui,
        _tile: TileId,
        tabs: &egui_tiles::Tabs,
        _scroll: &mut f32,
    ) {
        let name = tabs.active.and_then(|tile| self.view_of(tiles, tile));
        let view = name.and_then(|name| self.view(name)).cloned();
        if let (Some(view), Some(live)) = (view, name.and_then(|name| self.live.get(name))) {
            ui.add_space(2.0);
            self.actions.extend(header(ui, self.context, live, &view));
        }
    }

    fn tab_bar_height(&self, _style: &egui::Style) -> f32 {
        28.0
    }

    fn gap_width(&self, _style: &egui::Style) -> f32 {
        3.0
    }

    fn min_size(&self) -> f32 {
        120.0
    }

    fn simplification_options(&self) -> SimplificationOptions {
        SIMPLIFICATION
    }

    fn tab_bar_color(&self, _visuals: &Visuals) -> Color32 {
        self.context.palette.bar
    }

    fn tab_bar_hline_stroke(&self, _visuals: &Visuals) -> Stroke {
        Stroke::new(1.0, self.context.palette.line)
    }

    fn resize_stroke(&self, _style: &egui::Style, state: egui_tiles::ResizeState) -> Stroke {
        let color = match state {
            egui_tiles::ResizeState::Idle => self.context.palette.line,
            egui_tiles::ResizeState::Hovering | egui_tiles::ResizeState::Dragging => self.context.palette.accent,
        };
        Stroke::new(self.gap_width(&egui::Style::default()), color)
    }

    fn drag_preview_color(&self, _visuals: &Visuals) -> Color32 {
        self.context.palette.accent.gamma_multiply(0.35)
    }

    fn cycle_tabs_with_keyboard(&self) -> bool {
        true
    }
}
