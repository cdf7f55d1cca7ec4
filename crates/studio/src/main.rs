//! The program `lancer-studio`.
fn main() {}
