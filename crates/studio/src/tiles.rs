//! The panes of the main window as tiles that split, are dragged and stand behind each other as tabs.

use crate::layout::{Pane, SIMPLIFICATION};
use crate::panels::view::{self, Tools};
use crate::view::{LiveView, Picker, header};
use crate::{Action, Context, ViewAction};
use egui::{Color32, Stroke, Ui, Visuals, WidgetText};
use egui_tiles::{SimplificationOptions, TabState, Tile, TileId, UiResponse};
use lancer_document::wireframe::Wireframes;
use lancer_scene::View;
use std::collections::BTreeMap;
use std::sync::Arc;

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

    fn is_tab_closable(&self, _tiles: &egui_tiles::Tiles<Pane>, _tile: TileId) -> bool {
        true
    }

    fn on_tab_close(&mut self, tiles: &mut egui_tiles::Tiles<Pane>, tile: TileId) -> bool {
        if let Some(name) = self.view_of(tiles, tile) {
            self.actions.push(Action::View(name.into(), ViewAction::Close));
        }
        false
    }

    fn on_tab_button(
        &mut self,
        tiles: &mut egui_tiles::Tiles<Pane>,
        tile: TileId,
        response: egui::Response,
    ) -> egui::Response {
        if response.clicked()
            && let Some(name) = self.view_of(tiles, tile)
        {
            self.actions.push(Action::View(name.into(), ViewAction::Focus));
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

    fn tab_title_spacing(&self, _visuals: &Visuals) -> f32 {
        10.0
    }

    fn tab_bar_color(&self, _visuals: &Visuals) -> Color32 {
        self.context.palette.bar
    }

    fn tab_bg_color(
        &self,
        _visuals: &Visuals,
        _tiles: &egui_tiles::Tiles<Pane>,
        _tile: TileId,
        _state: &TabState,
    ) -> Color32 {
        Color32::TRANSPARENT
    }

    fn tab_outline_stroke(
        &self,
        _visuals: &Visuals,
        _tiles: &egui_tiles::Tiles<Pane>,
        _tile: TileId,
        _state: &TabState,
    ) -> Stroke {
        Stroke::NONE
    }

    fn tab_bar_hline_stroke(&self, _visuals: &Visuals) -> Stroke {
        Stroke::new(1.0, self.context.palette.line)
    }

    fn tab_text_color(
        &self,
        _visuals: &Visuals,
        tiles: &egui_tiles::Tiles<Pane>,
        tile: TileId,
        state: &TabState,
    ) -> Color32 {
        let palette = self.context.palette;
        let active = self.view_of(tiles, tile).is_some() && self.view_of(tiles, tile) == self.context.active;
        match (active, state.active) {
            (true, _) => palette.accent,
            (false, true) => palette.text,
            (false, false) => palette.weak,
        }
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
