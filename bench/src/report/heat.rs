//! Pictures of values on a grid of cells, in steps of shade.

use std::fmt::Write;

use super::svg::{Svg, number};

/// Shades on each side of zero; classes `h1`..`h8` above it, `n1`..`n8` below.
const SHADES: usize = 8;

/// Values on a grid, row 0 at the bottom.
#[derive(Debug, Clone)]
pub struct HeatMap<'a> {
    /// Columns and rows.
    pub size: [usize; 2],
    /// Values, row by row.
    pub values: &'a [f32],
    /// The value of the deepest shade.
    pub full: f32,
    /// Names of the two axes.
    pub axes: [&'a str; 2],
    /// Edge of a cell in the picture.
    pub cell: f64,
}

impl HeatMap<'_> {
    /// The picture; `description` says in words what it shows.
    pub fn svg(&self, description: &str) -> String {
        let [columns, rows] = self.size;
        let (width, height) = (columns as f64 * self.cell, rows as f64 * self.cell);
        let mut svg = Svg::new(width + 30.0, height + 26.0);
        svg.raw(&format!(
            "<rect class=\"dark-field\" x=\"26\" y=\"2\" width=\"{width:.1}\" \
             height=\"{height:.1}\"/>"
        ));
        for shade in (-(SHADES as i32)..=SHADES as i32).filter(|shade| *shade != 0) {
            let cells = self.cells_of(shade);
            if !cells.is_empty() {
                let sign = if shade > 0 { 'h' } else { 'n' };
                svg.raw(&format!("<path class=\"{sign}{}\" d=\"{cells}\"/>", shade.unsigned_abs()));
            }
        }
        svg.text("tick", "middle", [26.0 + width / 2.0, height + 18.0], self.axes[0]);
        svg.text_upwards("tick", [16.0, height / 2.0], self.axes[1]);
        svg.finish(&format!("{description}; deepest shade {}", number(f64::from(self.full))))
    }

    /// The cells of one shade as a path, neighbours in a row as one piece.
    fn cells_of(&self, shade: i32) -> String {
        let [columns, rows] = self.size;
        let mut path = String::new();
        for row in 0..rows {
            let y = 2.0 + (rows - 1 - row) as f64 * self.cell;
            let mut column = 0;
            while column < columns {
                let same = |c: &usize| self.shade(row * columns + c) == shade;
                let run = (column..columns).take_while(same).count();
                if run > 0 {
                    let (x, wide) = (26.0 + column as f64 * self.cell, run as f64 * self.cell);
                    // Writing to a String does not fail.
                    let _ =
                        write!(path, "M{x:.1} {y:.1}h{wide:.1}v{c:.1}h-{wide:.1}z", c = self.cell);
                }
                column += run.max(1);
            }
        }
        path
    }

    fn shade(&self, cell: usize) -> i32 {
        let share =
            self.values.get(cell).copied().unwrap_or(0.0) / self.full.max(f32::MIN_POSITIVE);
        let deepest = SHADES as f32;
        (share * deepest).round().clamp(-deepest, deepest) as i32
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_neighbours_are_one_piece() {
        let values = [1.0, 1.0, 0.0, -1.0];
        let map = HeatMap { size: [2, 2], values: &values, full: 1.0, axes: ["x", "y"], cell: 4.0 };
        assert_eq!(map.cells_of(8), "M26.0 6.0h8.0v4.0h-8.0z");
        assert_eq!(map.cells_of(-8), "M30.0 2.0h4.0v4.0h-4.0z");
        assert!(map.svg("test").contains("class=\"n8\""));
    }
}
