//! Everything that menus, tool bar and keys can do, each once: its words, its keys, when it is possible and what it
//! asks for.

use crate::context::Context;
use crate::kind::Kind;
use crate::menus::MENUS;
use crate::{Action, Exported, FileAction, Tab, ViewAction, WindowAction};
use egui::{Key, KeyboardShortcut, Modifiers};
use egui_material_icons::MaterialIcon;
use egui_material_icons::icons as icon;
use lancer_document::navigate::Side;
use lancer_document::{Command, Item, Selection, arrange};
use lancer_formats::picture::Format;
use lancer_words::{Lang, studio::app, studio::menu as words};

/// Something that a menu, a button or a key does.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Entry {
    /// Begins a new scene.
    New,
    /// Opens a scene or views.
    Open,
    /// Saves the scene.
    Save,
    /// Saves the scene elsewhere.
    SaveAs,
    /// Loads views.
    LoadViews,
    /// Saves the views.
    SaveViews,
    /// Saves the views elsewhere.
    SaveViewsAs,
    /// Writes the scene or the views for another program.
    Export(Exported),
    /// Saves the picture of the active view.
    SavePicture,
    /// Ends the program.
    Quit,
    /// Takes a step back.
    Undo,
    /// Brings a step back.
    Redo,
    /// Copies the selection.
    Duplicate,
    /// Deletes the selection.
    Delete,
    /// Renames what is selected.
    Rename,
    /// Hides the selection from the picture, or shows it.
    ToggleVisible,
    /// Selects every object and lamp.
    SelectAll,
    /// Selects nothing.
    SelectNone,
    /// Adds something.
    Add(Kind),
    /// Shows a copy of the active view on its right.
    SplitRight,
    /// Shows a copy of the active view below it.
    SplitBelow,
    /// Puts the active view into a window of its own, or back.
    Detach,
    /// Closes the active view's pane.
    CloseView,
    /// Makes the next view the active one.
    NextView,
    /// Looks along an axis.
    Look(Side),
    /// Makes the selection fill the active view.
    Frame,
    /// Shows or hides grid and axes.
    Grid,
    /// Makes the picture fit its pane, or not.
    Fit,
    /// Shows or hides the outliner.
    Outliner,
    /// Shows or hides the properties.
    Properties,
    /// Shows or hides the tabs at the bottom.
    Tabs,
    /// Brings a tab to the front.
    ShowTab(Tab),
    /// Everything larger.
    ZoomIn,
    /// Everything smaller.
    ZoomOut,
    /// The usual size.
    ZoomReset,
    /// Panels and panes as in the beginning.
    ResetLayout,
    /// Rests or goes on.
    Pause,
    /// Begins the picture again.
    Restart,
    /// Puts the picture on the clipboard.
    CopyPicture,
    /// No rectangle is refined first any more.
    NoRegion,
    /// The sheet of shortcuts.
    Shortcuts,
    /// What the program is.
    About,
}

const NONE: Modifiers = Modifiers::NONE;
const CTRL: Modifiers = Modifiers::COMMAND;
const CTRL_SHIFT: Modifiers = Modifiers::COMMAND.plus(Modifiers::SHIFT);
const SHIFT: Modifiers = Modifiers::SHIFT;

impl Entry {
    /// The name of the entry.
    pub fn name(self, lang: Lang) -> String {
        match self {
            Entry::New => words::new(lang),
            Entry::Open => words::open(lang),
            Entry::Save => words::save(lang),
            Entry::SaveAs => words::save_as(lang),
            Entry::LoadViews => words::load_views(lang),
            Entry::SaveViews => words::save_views(lang),
            Entry::SaveViewsAs => words::save_views_as(lang),
            Entry::Export(what) => format!("{}…", what.name(lang)),
            Entry::SavePicture => words::save_picture(lang),
            Entry::Quit => words::quit(lang),
            Entry::Undo => words::undo(lang),
            Entry::Redo => words::redo(lang),
            Entry::Duplicate => words::duplicate(lang),
            Entry::Delete => words::delete(lang),
            Entry::Rename => words::rename(lang),
            Entry::ToggleVisible => words::toggle_visible(lang),
            Entry::SelectAll => words::select_all(lang),
            Entry::SelectNone => words::select_none(lang),
            Entry::Add(kind) => kind.words().0(lang),
            Entry::SplitRight => words::split_right(lang),
            Entry::SplitBelow => words::split_below(lang),
            Entry::Detach => words::detach(lang),
            Entry::CloseView => words::close_view(lang),
            Entry::NextView => words::next_view(lang),
            Entry::Look(side) => side_name(side, lang),
            Entry::Frame => words::frame(lang),
            Entry::Grid => words::grid(lang),
            Entry::Fit => words::fit(lang),
            Entry::Outliner => words::show_outliner(lang),
            Entry::Properties => words::show_properties(lang),
            Entry::Tabs => words::show_tabs(lang),
            Entry::ShowTab(tab) => tab_name(tab, lang),
            Entry::ZoomIn => words::zoom_in(lang),
            Entry::ZoomOut => words::zoom_out(lang),
            Entry::ZoomReset => words::zoom_reset(lang),
            Entry::ResetLayout => words::reset_layout(lang),
            Entry::Pause => words::pause(lang),
            Entry::Restart => words::restart(lang),
            Entry::CopyPicture => words::copy_picture(lang),
            Entry::NoRegion => words::no_region(lang),
            Entry::Shortcuts => words::shortcuts(lang),
            Entry::About => words::about(lang),
        }
    }

    /// The name with what the entry is about just now: the step that would be undone.
    #[expect(clippy::wildcard_enum_match_arm, reason = "most entries are always called the same")]
    pub fn title(self, context: &Context<'_>) -> String {
        let (lang, history) = (context.lang, context.document.history());
        match self {
            Entry::Undo => history.undoable().map(|step| words::undo_step(lang, step.text(lang))),
            Entry::Redo => history.redoable().map(|step| words::redo_step(lang, step.text(lang))),
            Entry::Pause if context.pane.is_some_and(|pane| pane.paused) => Some(words::resume(lang)),
            Entry::Detach if context.pane.is_some_and(|pane| pane.detached) => Some(words::attach(lang)),
            Entry::Add(kind) => Some(words::add_kind(lang, kind.words().0(lang))),
            _other => None,
        }
        .unwrap_or_else(|| self.name(lang))
    }

    /// The picture of the entry, where it has one.
    pub fn icon(self) -> Option<MaterialIcon> {
        Some(match self {
            Entry::New => icon::ICON_NOTE_ADD,
            Entry::Open => icon::ICON_FOLDER_OPEN,
            Entry::Save => icon::ICON_SAVE,
            Entry::SavePicture => icon::ICON_IMAGE,
            Entry::Undo => icon::ICON_UNDO,
            Entry::Redo => icon::ICON_REDO,
            Entry::Duplicate => icon::ICON_CONTENT_COPY,
            Entry::Delete => icon::ICON_DELETE,
            Entry::Rename => icon::ICON_EDIT,
            Entry::ToggleVisible => icon::ICON_VISIBILITY_OFF,
            Entry::Add(kind) => kind.words().1,
            Entry::SplitRight => icon::ICON_SPLITSCREEN_RIGHT,
            Entry::SplitBelow => icon::ICON_SPLITSCREEN_BOTTOM,
            Entry::Detach => icon::ICON_OPEN_IN_NEW,
            Entry::CloseView => icon::ICON_CLOSE,
            Entry::Frame => icon::ICON_FILTER_CENTER_FOCUS,
            Entry::Grid => icon::ICON_GRID_4X4,
            Entry::Fit => icon::ICON_FIT_SCREEN,
            Entry::Pause => icon::ICON_PAUSE,
            Entry::Restart => icon::ICON_REFRESH,
            Entry::CopyPicture => icon::ICON_CONTENT_COPY,
            Entry::Shortcuts => icon::ICON_KEYBOARD,
            Entry::About => icon::ICON_INFO,
            Entry::SaveAs
            | Entry::LoadViews
            | Entry::SaveViews
            | Entry::SaveViewsAs
            | Entry::Export(_)
            | Entry::Quit
            | Entry::SelectAll
            | Entry::SelectNone
            | Entry::NextView
            | Entry::Look(_)
            | Entry::Outliner
            | Entry::Properties
            | Entry::Tabs
            | Entry::ShowTab(_)
            | Entry::ZoomIn
            | Entry::ZoomOut
            | Entry::ZoomReset
            | Entry::ResetLayout
            | Entry::NoRegion => return None,
        })
    }

    /// The keys of the entry, the ones that menus show first.
    pub fn keys(self) -> &'static [KeyboardShortcut] {
        macro_rules! keys {
            ($($modifiers:ident $key:ident),*) => {{
                const KEYS: &[KeyboardShortcut] = &[$(KeyboardShortcut::new($modifiers, Key::$key)),*];
                KEYS
            }};
        }
        match self {
            Entry::New => keys![CTRL N],
            Entry::Open => keys![CTRL O],
            Entry::Save => keys![CTRL S],
            Entry::SaveAs => keys![CTRL_SHIFT S],
            Entry::SavePicture => keys![CTRL E],
            Entry::Quit => keys![CTRL Q],
            Entry::Undo => keys![CTRL Z],
            Entry::Redo => keys![CTRL_SHIFT Z, CTRL Y],
            Entry::Duplicate => keys![CTRL D],
            Entry::Delete => keys![NONE Delete],
            Entry::Rename => keys![NONE F2],
            Entry::ToggleVisible => keys![NONE H],
            Entry::SelectAll => keys![CTRL A],
            Entry::SelectNone => keys![CTRL_SHIFT A],
            Entry::SplitRight => keys![CTRL Backslash],
            Entry::SplitBelow => keys![CTRL_SHIFT Backslash],
            Entry::Detach => keys![CTRL_SHIFT O],
            Entry::CloseView => keys![CTRL W],
            Entry::NextView => keys![NONE F6],
            Entry::Look(Side::Front) => keys![NONE Num1],
            Entry::Look(Side::Back) => keys![SHIFT Num1],
            Entry::Look(Side::Right) => keys![NONE Num3],
            Entry::Look(Side::Left) => keys![SHIFT Num3],
            Entry::Look(Side::Top) => keys![NONE Num7],
            Entry::Look(Side::Bottom) => keys![SHIFT Num7],
            Entry::Frame => keys![NONE F],
            Entry::Grid => keys![NONE G],
            Entry::Pause => keys![NONE P],
            Entry::Restart => keys![NONE F5],
            Entry::CopyPicture => keys![CTRL_SHIFT C],
            Entry::ZoomIn => keys![CTRL Plus, CTRL Equals],
            Entry::ZoomOut => keys![CTRL Minus],
            Entry::ZoomReset => keys![CTRL Num0],
            Entry::Outliner => keys![NONE F9],
            Entry::Tabs => keys![NONE F10],
            Entry::Properties => keys![NONE F11],
            Entry::Shortcuts => keys![NONE F1],
            Entry::ShowTab(Tab::Text) => keys![CTRL Num1],
            Entry::ShowTab(Tab::Xml) => keys![CTRL Num2],
            Entry::ShowTab(Tab::Explain) => keys![CTRL Num3],
            Entry::ShowTab(Tab::Problems) => keys![CTRL Num4],
            Entry::ShowTab(Tab::History) => keys![CTRL Num5],
            Entry::Add(_)
            | Entry::LoadViews
            | Entry::SaveViews
            | Entry::SaveViewsAs
            | Entry::Export(_)
            | Entry::Fit
            | Entry::ResetLayout
            | Entry::NoRegion
            | Entry::About => &[],
        }
    }

    /// Whether the entry is a switch, and its position.
    #[expect(clippy::wildcard_enum_match_arm, reason = "most entries are no switches")]
    pub fn checked(self, context: &Context<'_>) -> Option<bool> {
        let settings = context.settings;
        match self {
            Entry::Outliner => Some(settings.outliner),
            Entry::Properties => Some(settings.properties),
            Entry::Tabs => Some(settings.tabs),
            Entry::Grid => Some(context.pane.is_some_and(|pane| pane.grid)),
            Entry::Fit => Some(context.pane.is_some_and(|pane| pane.fit)),
            _other => None,
        }
    }

    /// What the entry asks for; `None` where it is not possible just now.
    pub fn actions(self, context: &Context<'_>) -> Option<Vec<Action>> {
        let document = context.document;
        let (stage, selection) = (document.stage(), document.selection());
        let file = |action| Some(vec![Action::File(action)]);
        let window = |action| Some(vec![Action::Window(action)]);
        let run = |command: Option<Command>| command.map(|command| vec![Action::Run(command)]);
        let view = |action: &dyn Fn(crate::context::PaneState) -> ViewAction| {
            let name = context.active_view()?.name.clone();
            Some(vec![Action::View(name, action(context.pane?))])
        };
        let zoom = |factor: f32| window(WindowAction::Zoom(factor));
        match self {
            Entry::New => file(FileAction::New),
            Entry::Open => file(FileAction::Open(None)),
            Entry::Save => file(FileAction::Save),
            Entry::SaveAs => file(FileAction::SaveAs),
            Entry::LoadViews => file(FileAction::LoadViews),
            Entry::SaveViews => file(FileAction::SaveViews),
            Entry::SaveViewsAs => file(FileAction::SaveViewsAs),
            // a camera needs a view
            Entry::Export(Exported::Povray) if stage.views.is_empty() => None,
            Entry::Export(what) => file(FileAction::Export(what)),
            Entry::SavePicture => view(&|_| ViewAction::SavePicture(Format::PlainPpm)),
            Entry::Quit => file(FileAction::Quit),
            Entry::Undo => document.history().undoable().map(|_| vec![Action::Undo]),
            Entry::Redo => document.history().redoable().map(|_| vec![Action::Redo]),
            Entry::Duplicate => run(arrange::duplicated(stage, selection.iter())),
            Entry::Delete => run(arrange::deleted(stage, selection.iter())),
            Entry::Rename => {
                selection.primary().filter(|item| item.name().is_some()).map(|item| vec![Action::Rename(item.clone())])
            }
            Entry::ToggleVisible => {
                let hide = arrange::shown(stage, selection.iter(), false);
                run(hide.or_else(|| arrange::shown(stage, selection.iter(), true)))
            }
            Entry::SelectAll => {
                let lights = stage.scene.lights.iter().map(|light| Item::Light(light.name.clone()));
                let objects = stage.scene.objects.iter().map(|object| Item::Object(object.name.clone()));
                let mut all = Selection::default();
                all.set(lights.chain(objects));
                (!all.is_empty()).then(|| vec![Action::Select(all)])
            }
            Entry::SelectNone => (!selection.is_empty()).then(|| vec![Action::Select(Selection::default())]),
            Entry::Add(kind) => match kind.item(context) {
                Some(item) => Some(vec![Action::Add(item)]),
                None => file(FileAction::AddMesh),
            },
            Entry::SplitRight => view(&|_| ViewAction::Split(egui_tiles::LinearDir::Horizontal)),
            Entry::SplitBelow => view(&|_| ViewAction::Split(egui_tiles::LinearDir::Vertical)),
            Entry::Detach => view(&|pane| if pane.detached { ViewAction::Attach } else { ViewAction::Detach }),
            Entry::CloseView => view(&|_| ViewAction::Close),
            Entry::NextView => view(&|_| ViewAction::FocusNext),
            Entry::Look(side) => view(&|_| ViewAction::Look(side)),
            Entry::Frame => view(&|_| ViewAction::Frame),
            Entry::Grid => view(&|pane| ViewAction::Grid(!pane.grid)),
            Entry::Fit => view(&|pane| ViewAction::Fit(!pane.fit)),
            Entry::Outliner => window(WindowAction::Outliner(!context.settings.outliner)),
            Entry::Properties => window(WindowAction::Properties(!context.settings.properties)),
            Entry::Tabs => window(WindowAction::Tabs(!context.settings.tabs)),
            Entry::ShowTab(tab) => Some(vec![Action::ShowTab(tab)]),
            Entry::ZoomIn => zoom(context.settings.zoom + 0.1),
            Entry::ZoomOut => zoom(context.settings.zoom - 0.1),
            Entry::ZoomReset => zoom(1.0),
            Entry::ResetLayout => window(WindowAction::ResetLayout),
            Entry::Pause => view(&|pane| ViewAction::Pause(!pane.paused)),
            Entry::Restart => view(&|_| ViewAction::Restart),
            Entry::CopyPicture => view(&|_| ViewAction::CopyPicture),
            Entry::NoRegion => view(&|_| ViewAction::First(None)),
            Entry::Shortcuts => window(WindowAction::Shortcuts(true)),
            Entry::About => window(WindowAction::About(true)),
        }
    }

    /// Whether its keys work while text is typed: those of files and of the window do.
    fn works_while_typing(self) -> bool {
        matches!(
            self,
            Entry::New
                | Entry::Open
                | Entry::Save
                | Entry::SaveAs
                | Entry::SavePicture
                | Entry::Quit
                | Entry::ZoomIn
                | Entry::ZoomOut
                | Entry::ZoomReset
                | Entry::Shortcuts
                | Entry::NextView
                | Entry::Restart
                | Entry::Outliner
                | Entry::Tabs
                | Entry::Properties
                | Entry::ShowTab(_)
        )
    }

    /// Every entry that has keys.
    pub fn with_keys() -> impl Iterator<Item = Entry> {
        MENUS
            .iter()
            .flat_map(|(_, _, groups)| groups.iter())
            .flat_map(|group| group.iter())
            .copied()
            .filter(|entry| !entry.keys().is_empty())
    }
}

/// What the keys that were pressed ask for; they are taken out of the input.
pub fn pressed(ctx: &egui::Context, context: &Context<'_>) -> Vec<Action> {
    let typing = ctx.text_edit_focused();
    let mut entries: Vec<(KeyboardShortcut, Entry)> = Entry::with_keys()
        .filter(|entry| !typing || entry.works_while_typing())
        .flat_map(|entry| entry.keys().iter().map(move |keys| (*keys, entry)))
        .collect();
    // a shortcut with fewer modifiers would also take the one with more
    entries.sort_by_key(|(keys, _)| std::cmp::Reverse(u8::from(keys.modifiers.shift)));
    let mut actions = Vec::new();
    for (keys, entry) in entries {
        if ctx.input_mut(|input| input.consume_shortcut(&keys) || consume_by_place(input, keys)) {
            actions.extend(entry.actions(context).unwrap_or_default());
        }
    }
    actions
}

/// Takes a key by its place on the keyboard: with Shift, or on a French keyboard without it, digits and the backslash
/// are other signs.
fn consume_by_place(input: &mut egui::InputState, keys: KeyboardShortcut) -> bool {
    let digit = |key: &Key| (Key::Num0..=Key::Num9).contains(key);
    if !digit(&keys.logical_key) && keys.logical_key != Key::Backslash {
        return false;
    }
    let before = input.events.len();
    input.events.retain(|event| {
        let wanted = matches!(event, egui::Event::Key { physical_key: Some(place), pressed: true, modifiers, .. }
            if *place == keys.logical_key && modifiers.matches_exact(keys.modifiers));
        !wanted
    });
    input.events.len() < before
}

/// The name of a side.
fn side_name(side: Side, lang: Lang) -> String {
    match side {
        Side::Front => words::front(lang),
        Side::Back => words::back(lang),
        Side::Right => words::right(lang),
        Side::Left => words::left(lang),
        Side::Top => words::top(lang),
        Side::Bottom => words::bottom(lang),
    }
}

/// The name of a tab.
pub fn tab_name(tab: Tab, lang: Lang) -> String {
    match tab {
        Tab::Text => app::tab_text(lang),
        Tab::Xml => app::tab_xml(lang),
        Tab::Explain => app::tab_explain(lang),
        Tab::Problems => app::tab_problems(lang),
        Tab::History => app::tab_history(lang),
    }
}
