//! How the program looks: a light and a dark theme of neutral greys and one accent colour, the same spacing in both.
//!
//! Pictures are the only colourful thing in the window, so the greys around them lean to no hue that one would see.

use egui::epaint::Shadow;
use egui::{
    Color32, CornerRadius, FontData, FontDefinitions, FontFamily, FontId, Margin, Stroke, Style, TextStyle, Theme, Vec2,
};
use std::sync::Arc;

/// The colours of a theme, by what they are for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Palette {
    /// Behind the panes.
    pub ground: Color32,
    /// Panels.
    pub panel: Color32,
    /// Menu bar, tool bar, headers of panels and panes.
    pub bar: Color32,
    /// Where something is typed.
    pub field: Color32,
    /// Buttons at rest.
    pub button: Color32,
    /// Buttons under the pointer.
    pub hover: Color32,
    /// Buttons while they are pressed.
    pub pressed: Color32,
    /// Lines between things.
    pub line: Color32,
    /// Text.
    pub text: Color32,
    /// Text that explains.
    pub weak: Color32,
    /// The one accent: what is selected, active, or asked for.
    pub accent: Color32,
    /// Behind what is selected.
    pub selected: Color32,
    /// Warnings.
    pub warning: Color32,
    /// Errors.
    pub error: Color32,
    /// Success.
    pub success: Color32,
    /// The ground grid over a picture.
    pub grid: Color32,
    /// The axes x, y, z; letters stand beside them.
    pub axes: [Color32; 3],
}

const fn gray(level: u8) -> Color32 {
    Color32::from_gray(level)
}

const fn rgb(hex: u32) -> Color32 {
    Color32::from_rgb((hex >> 16) as u8, (hex >> 8) as u8, hex as u8)
}

impl Palette {
    /// The dark theme.
    pub const DARK: Palette = Palette {
        ground: gray(20),
        panel: rgb(0x25_26_28),
        bar: rgb(0x2c_2d_30),
        field: rgb(0x1a_1b_1d),
        button: rgb(0x37_39_3c),
        hover: rgb(0x44_46_4a),
        pressed: rgb(0x52_55_59),
        line: rgb(0x3a_3c_3f),
        text: rgb(0xdd_de_e0),
        weak: rgb(0x9a_9d_a1),
        accent: rgb(0x5c_b3_e8),
        selected: rgb(0x25_4b_63),
        warning: rgb(0xe8_b0_4c),
        error: rgb(0xf0_7a_70),
        success: rgb(0x74_c6_8c),
        grid: Color32::from_rgba_premultiplied(90, 90, 90, 90),
        axes: [rgb(0xf0_7a_7a), rgb(0x8c_d0_70), rgb(0x7a_b0_f8)],
    };

    /// The light theme.
    pub const LIGHT: Palette = Palette {
        ground: rgb(0xcf_d0_d2),
        panel: rgb(0xf6_f6_f7),
        bar: rgb(0xec_ec_ee),
        field: gray(255),
        button: rgb(0xe2_e3_e5),
        hover: rgb(0xd6_d7_da),
        pressed: rgb(0xc6_c8_cb),
        line: rgb(0xd2_d4_d7),
        text: rgb(0x26_28_2b),
        weak: rgb(0x5f_63_69),
        accent: rgb(0x0d_6e_a8),
        selected: rgb(0xc4_e0_f2),
        warning: rgb(0x8f_5c_00),
        error: rgb(0xb3_2a_20),
        success: rgb(0x1f_74_3c),
        grid: Color32::from_rgba_premultiplied(90, 90, 90, 90),
        axes: [rgb(0xf0_7a_7a), rgb(0x8c_d0_70), rgb(0x7a_b0_f8)],
    };

    /// The colour of an outline over a picture, the same in both themes: of what was selected last, or of the others.
    pub fn outline(&self, primary: bool) -> Color32 {
        if primary { rgb(0xff_b3_3c) } else { rgb(0xe0_8c_30) }
    }

    /// The colours of a theme.
    pub const fn of(theme: Theme) -> &'static Palette {
        match theme {
            Theme::Dark => &Palette::DARK,
            Theme::Light => &Palette::LIGHT,
        }
    }
}

/// Corners of buttons and fields.
const ROUND: CornerRadius = CornerRadius::same(4);
/// Corners of windows, menus and messages.
const ROUNDER: CornerRadius = CornerRadius::same(8);

/// The family of titles.
const SEMIBOLD: &str = "semibold";

/// The font of titles, in that size.
pub fn title_font(size: f32) -> FontId {
    FontId::new(size, FontFamily::Name(SEMIBOLD.into()))
}

/// Inter for every text, with the toolkit's own fonts behind it for rare signs.
fn fonts() -> FontDefinitions {
    let mut fonts = FontDefinitions::default();
    let behind = fonts.families.get(&FontFamily::Proportional).cloned().unwrap_or_default();
    let faces: [(&str, &'static [u8], FontFamily); 2] = [
        ("Inter", include_bytes!("../fonts/Inter-Regular.ttf"), FontFamily::Proportional),
        ("Inter semibold", include_bytes!("../fonts/Inter-SemiBold.ttf"), FontFamily::Name(SEMIBOLD.into())),
    ];
    for (name, bytes, family) in faces {
        fonts.font_data.insert(name.to_owned(), Arc::new(FontData::from_static(bytes)));
        fonts.families.insert(family, std::iter::once(name.to_owned()).chain(behind.iter().cloned()).collect());
    }
    fonts
}

/// Gives a window both themes, its fonts, the icons and the sizes of text.
pub fn install(ctx: &egui::Context) {
    ctx.set_fonts(fonts());
    egui_material_icons::initialize(ctx);
    for theme in [Theme::Dark, Theme::Light] {
        ctx.style_mut_of(theme, |style| dress(style, Palette::of(theme)));
    }
}

fn dress(style: &mut Style, palette: &Palette) {
    let proportional = |size| FontId::new(size, FontFamily::Proportional);
    style.text_styles = [
        (TextStyle::Small, proportional(11.5)),
        (TextStyle::Body, proportional(13.0)),
        (TextStyle::Button, proportional(13.0)),
        (TextStyle::Heading, title_font(17.0)),
        (TextStyle::Monospace, FontId::new(12.5, FontFamily::Monospace)),
    ]
    .into();

    let spacing = &mut style.spacing;
    spacing.item_spacing = Vec2::new(8.0, 6.0);
    spacing.button_padding = Vec2::new(8.0, 3.0);
    spacing.interact_size = Vec2::new(36.0, 24.0);
    spacing.menu_margin = Margin::same(6);
    spacing.window_margin = Margin::same(16);
    spacing.menu_spacing = 2.0;
    spacing.indent = 16.0;
    spacing.icon_spacing = 6.0;
    spacing.tooltip_width = 420.0;
    spacing.scroll = egui::style::ScrollStyle::thin();

    let visuals = &mut style.visuals;
    visuals.override_text_color = Some(palette.text);
    visuals.weak_text_color = Some(palette.weak);
    visuals.panel_fill = palette.panel;
    visuals.window_fill = palette.panel;
    visuals.window_stroke = Stroke::new(1.0, palette.line);
    visuals.window_corner_radius = ROUNDER;
    visuals.menu_corner_radius = ROUNDER;
    visuals.extreme_bg_color = palette.field;
    visuals.text_edit_bg_color = Some(palette.field);
    visuals.code_bg_color = palette.field;
    visuals.faint_bg_color = palette.bar;
    visuals.hyperlink_color = palette.accent;
    visuals.warn_fg_color = palette.warning;
    visuals.error_fg_color = palette.error;
    visuals.selection.bg_fill = palette.selected;
    visuals.selection.stroke = Stroke::new(1.0, palette.accent);
    visuals.button_frame = true;
    visuals.slider_trailing_fill = true;
    visuals.striped = false;
    let shadow = |blur, alpha| Shadow { offset: [0, 4], blur, spread: 0, color: Color32::from_black_alpha(alpha) };
    visuals.popup_shadow = shadow(12, 60);
    visuals.window_shadow = shadow(24, 80);

    let widgets = &mut visuals.widgets;
    let dress = |widget: &mut egui::style::WidgetVisuals, fill: Color32, border: Color32, text: Color32| {
        widget.bg_fill = fill;
        widget.weak_bg_fill = fill;
        widget.bg_stroke = Stroke::new(1.0, border);
        widget.fg_stroke = Stroke::new(1.0, text);
        widget.corner_radius = ROUND;
        widget.expansion = 0.0;
    };
    dress(&mut widgets.noninteractive, palette.panel, palette.line, palette.text);
    dress(&mut widgets.inactive, palette.button, Color32::TRANSPARENT, palette.text);
    dress(&mut widgets.hovered, palette.hover, Color32::TRANSPARENT, palette.text);
    dress(&mut widgets.active, palette.pressed, palette.accent, palette.text);
    dress(&mut widgets.open, palette.hover, Color32::TRANSPARENT, palette.text);
}
