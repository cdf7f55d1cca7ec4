//! The words around the problems of a report.

phrases! {
    /// Before the rule or the way out.
    help(text) { "help: {text}", "aide : {text}" }
    /// After the first of very many problems.
    and_more(count) { "and {count} more like these", "et {count} autres encore" }
}
