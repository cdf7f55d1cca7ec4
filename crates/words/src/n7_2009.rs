//! placeholder

phrases! {}
