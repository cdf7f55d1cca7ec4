//! The one catalogue of lancer's words, in English and French.
//!
//! Every sentence that a person reads stands here as a function of the language and of its arguments, so the compiler
//! proves that no translation and no argument is missing. A file holds one area of words; the macro `phrases!` writes
//! the functions.
//!
//! ```
//! use lancer_words::{Lang, number};
//! assert_eq!(number::objects(Lang::French, 0), "0 objet");
//! assert_eq!(number::objects(Lang::English, 2), "2 objects");
//! ```

#[macro_use]
mod phrases;

pub mod arithmetic;
pub mod attribute;
pub mod binary;
pub mod cli;
pub mod digits;
pub mod engine;
pub mod explain;
pub mod export;
pub mod file;
mod lang;
pub mod lint;
pub mod mesh;
pub mod n7_2009;
pub mod nff;
pub mod number;
pub mod picture;
pub mod preset;
pub mod step;
pub mod studio;
pub mod term;
pub mod text;
pub mod xml;

pub use lang::Lang;
