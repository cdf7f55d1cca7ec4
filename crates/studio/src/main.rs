//! The program `lancer-studio`.

use lancer_render::Tracing;
use lancer_studio::arguments::{Arguments, help};
use lancer_studio::{launch, told};
use lancer_words::{Lang, studio::app as words};
use std::io::Write;
use std::process::ExitCode;

fn main() -> ExitCode {
    let locale = sys_locale::get_locale().map(|locale| Lang::of_locale(&locale)).unwrap_or_default();
    match Arguments::read(std::env::args_os().skip(1)) {
        Arguments::Window { lang, open } => match tracing(lang.unwrap_or(locale)) {
            Ok(tracing) => match launch::run(lang, open, tracing) {
                Ok(()) => ExitCode::SUCCESS,
                Err(sentence) => complain(&sentence, 3),
            },
            Err(sentence) => complain(&sentence, 2),
        },
        Arguments::Help(lang) => tell(&help(lang.unwrap_or(locale))),
        Arguments::Version => tell(&format!("lancer-studio {}", env!("CARGO_PKG_VERSION"))),
        Arguments::Wrong(lang, argument) => complain(&words::wrong_argument(lang.unwrap_or(locale), argument), 2),
    }
}

/// The engine with the instructions that the environment asks for, or the sentence that says why it cannot be had.
fn tracing(lang: Lang) -> Result<Tracing, String> {
    let name = std::env::var_os(Tracing::VARIABLE).unwrap_or_default();
    Tracing::simd_named(&name.to_string_lossy()).map(Tracing::Engine).map_err(|error| told::simd(&error, lang))
}

fn tell(text: &str) -> ExitCode {
    // a reader that has gone away wants no more
    let _ = writeln!(std::io::stdout(), "{text}");
    ExitCode::SUCCESS
}

fn complain(sentence: &str, code: u8) -> ExitCode {
    let _ = writeln!(std::io::stderr(), "{sentence}");
    ExitCode::from(code)
}
