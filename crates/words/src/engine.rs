//! What is said of the engine and of its instructions, by both programs.

phrases! {
    /// The environment names no instructions.
    unknown_simd(variable, name) {
        "{variable} asks for the instructions `{name}`, which do not exist",
        "{variable} demande les instructions « {name} », qui n'existent pas",
    }
    /// The environment names instructions that the machine lacks.
    missing_simd(variable, name) {
        "{variable} asks for the instructions {name}, which this machine does not have",
        "{variable} demande les instructions {name}, que cette machine n'a pas",
    }
    /// What to do.
    available_simd(names) {
        "this machine can use {names}; without the variable the last of them is used",
        "cette machine peut employer {names} ; sans la variable, c'est le dernier nom qui vaut",
    }
}
