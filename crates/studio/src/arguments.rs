//! The command line: `lancer-studio [SCENE] [VIEWS…] [--lang en|fr]`.

use lancer_words::{Lang, studio::app as words};
use std::ffi::OsString;
use std::path::PathBuf;

/// What the command line asks for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Arguments {
    /// A window.
    Window {
        /// The language that was asked for.
        lang: Option<Lang>,
        /// A scene, then documents of views.
        open: Vec<PathBuf>,
    },
    /// The help.
    Help(Option<Lang>),
    /// The version.
    Version,
    /// The command line is wrong: the argument that is.
    Wrong(Option<Lang>, String),
}

impl Arguments {
    /// Reads the arguments behind the program's name.
    pub fn read(args: impl IntoIterator<Item = OsString>) -> Arguments {
        let (mut lang, mut open, mut wrong, mut help, mut version) = (None, Vec::new(), None, false, false);
        let mut args = args.into_iter();
        let mut only_files = false;
        while let Some(arg) = args.next() {
            let text = arg.to_string_lossy().into_owned();
            let mut language = |code: Option<&str>| {
                let known = Lang::ALL.into_iter().find(|lang| Some(lang.code()) == code);
                lang = lang.or(known);
                wrong = wrong.take().or(known.is_none().then(|| format!("--lang {}", code.unwrap_or_default())));
            };
            match text.as_str() {
                _ if only_files => open.push(arg.into()),
                "--" => only_files = true,
                "--help" | "-h" => help = true,
                "--version" | "-V" => version = true,
                "--lang" => language(args.next().map(|code| code.to_string_lossy().into_owned()).as_deref()),
                option if option.starts_with("--lang=") => language(option.strip_prefix("--lang=")),
                option if option.starts_with('-') => wrong = wrong.or(Some(text)),
                _ => open.push(arg.into()),
            }
        }
        match wrong {
            _ if help => Arguments::Help(lang),
            _ if version => Arguments::Version,
            Some(wrong) => Arguments::Wrong(lang, wrong),
            None => Arguments::Window { lang, open },
        }
    }
}

/// The help of the command line.
pub fn help(lang: Lang) -> String {
    words::usage(lang)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(line: &str) -> Arguments {
        Arguments::read(line.split_whitespace().map(OsString::from))
    }

    #[test]
    fn files_and_a_language() {
        let window = |lang, open: &[&str]| Arguments::Window { lang, open: open.iter().map(PathBuf::from).collect() };
        assert_eq!(read(""), window(None, &[]));
        assert_eq!(read("a.xml --lang fr v.xml"), window(Some(Lang::French), &["a.xml", "v.xml"]));
        assert_eq!(read("--lang=en -- --lang"), window(Some(Lang::English), &["--lang"]));
    }

    #[test]
    fn what_is_wrong_is_named() {
        assert_eq!(read("--lang de"), Arguments::Wrong(None, "--lang de".into()));
        assert_eq!(read("--lang"), Arguments::Wrong(None, "--lang ".into()));
        assert_eq!(read("a.xml --fast --slow"), Arguments::Wrong(None, "--fast".into()));
        assert_eq!(read("--fast --help --lang fr"), Arguments::Help(Some(Lang::French)));
        assert_eq!(read("-V"), Arguments::Version);
    }
}
