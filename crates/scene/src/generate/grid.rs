//! Facets over a raster of points: two to each cell.

use super::single;
use glam::DVec3;

/// How the rows and columns of a raster end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Ends {
    /// With a border: one more point than cells.
    Open,
    /// In themselves: the last cell joins the first.
    Joined,
}

/// The vertices and facets over `columns` by `rows` cells, whose points are `at(column, row)`. Seen with columns to the
/// right and rows upwards, the facets turn their normals `P0P1 × P0P2` to the viewer.
pub(super) fn grid(
    columns: u32,
    rows: u32,
    ends: Ends,
    mut at: impl FnMut(u32, u32) -> DVec3,
) -> (Vec<DVec3>, Vec<[u32; 3]>) {
    let border = u32::from(ends == Ends::Open);
    let (width, height) = (columns + border, rows + border);
    let points = (0..height).flat_map(|row| (0..width).map(move |column| (column, row)));
    let positions = points.map(|(column, row)| single(at(column, row))).collect();
    let vertex = |column: u32, row: u32| row % height * width + column % width;
    let cells = (0..rows).flat_map(|row| (0..columns).map(move |column| (column, row)));
    let facets = cells
        .flat_map(|(column, row)| {
            let [a, b] = [vertex(column, row), vertex(column + 1, row)];
            let [c, d] = [vertex(column + 1, row + 1), vertex(column, row + 1)];
            [[a, b, c], [c, d, a]]
        })
        .collect();
    (positions, facets)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_raster_has_two_facets_a_cell_that_face_the_viewer() {
        let (positions, facets) =
            grid(3, 2, Ends::Open, |column, row| DVec3::new(f64::from(column), f64::from(row), 0.0));
        assert_eq!((positions.len(), facets.len()), (12, 12));
        for facet in facets {
            let [a, b, c] = facet.map(|vertex| positions[vertex as usize]);
            assert_eq!((b - a).cross(c - a), DVec3::Z);
        }
    }
}
