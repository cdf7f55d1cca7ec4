//! A finished picture: bytes, and the linear colours where a format wants them.

/// Rows of pixels from the top, each pixel three bytes.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// Pixels per row, at least 1.
    pub width: u32,
    /// Rows, at least 1.
    pub height: u32,
    /// `width·height` pixels, row by row from the top, each red, green, blue.
    pub bytes: Vec<[u8; 3]>,
    /// The colours before they became bytes, where they were asked for (EXR).
    pub linear: Option<Vec<[f32; 3]>>,
}

impl Picture {
    /// The bytes of pixel `(x, y)`, counted from the top left; `None` outside.
    pub fn pixel(&self, x: u32, y: u32) -> Option<[u8; 3]> {
        (x < self.width && y < self.height)
            .then(|| self.bytes.get(y as usize * self.width as usize + x as usize).copied())
            .flatten()
    }
}
