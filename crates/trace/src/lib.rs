//! Rays to colours.
