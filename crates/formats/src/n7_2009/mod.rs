//! placeholder
use crate::Describe;
use lancer_words::Lang;

/// placeholder
#[derive(Clone, Debug, PartialEq)]
pub enum N7Problem {}

impl Describe for N7Problem {
    fn code(&self) -> &'static str {
        match *self {}
    }
    fn message(&self, _lang: Lang) -> String {
        match *self {}
    }
    fn label(&self, _lang: Lang) -> String {
        match *self {}
    }
    fn help(&self, _lang: Lang) -> Option<String> {
        match *self {}
    }
}
