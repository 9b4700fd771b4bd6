//! Pictures of values on a grid of cells, in steps of shade.

use plotters::{
    prelude::{ChartBuilder, PathElement, Rectangle},
    style::Color,
};

use super::{
    chart::COLOURS,
    picture::{FINE, RULE, letters, picture},
    text::number,
};

/// Shades on each side of zero.
const SHADES: f32 = 8.0;

/// Room for an axis's name, in units.
const NAME: i32 = 24;

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
        let size = self.size.map(|cells| (cells as f64 * self.cell).round() as i32 + NAME);
        let description = format!("{description}; deepest shade {}", number(f64::from(self.full)));
        picture(size, &description, |area| {
            let [columns, rows] = self.size;
            let mut chart = ChartBuilder::on(area)
                .set_left_and_bottom_label_area_size(NAME * FINE)
                .build_cartesian_2d(0..columns.max(1), 0..rows.max(1))?;
            chart
                .configure_mesh()
                .disable_mesh()
                .disable_axes()
                .x_desc(self.axes[0])
                .y_desc(self.axes[1])
                .axis_desc_style(letters())
                .draw()?;
            chart.draw_series(self.cells())?;
            let frame = [(0, 0), (columns, 0), (columns, rows), (0, rows), (0, 0)];
            chart.draw_series([PathElement::new(frame, RULE.stroke_width(FINE as u32))])?;
            Ok(())
        })
    }

    /// All cells that are not blank, neighbours of one shade in a row as one piece.
    fn cells(&self) -> Vec<Rectangle<(usize, usize)>> {
        let mut cells = Vec::new();
        for (row, values) in self.values.chunks(self.size[0].max(1)).enumerate() {
            let shades: Vec<i32> = values.iter().map(|value| self.shade(*value)).collect();
            let mut end = 0;
            for same in shades.chunk_by(|a, b| a == b) {
                let (start, shade) = (end, same[0]);
                end += same.len();
                if shade != 0 {
                    let colour = COLOURS[usize::from(shade < 0)];
                    let depth = f64::from(shade.abs()) / f64::from(SHADES);
                    let corners = [(start, row + 1), (end, row)];
                    cells.push(Rectangle::new(corners, colour.mix(depth).filled()));
                }
            }
        }
        cells
    }

    fn shade(&self, value: f32) -> i32 {
        let share = value / self.full.max(f32::MIN_POSITIVE);
        (share * SHADES).round().clamp(-SHADES, SHADES) as i32
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_neighbours_are_one_piece_and_each_sign_has_its_colour() {
        let values = [1.0, 1.0, 0.0, -1.0];
        let map = HeatMap { size: [2, 2], values: &values, full: 1.0, axes: ["x", "y"], cell: 4.0 };
        let svg = map.svg("test");
        assert_eq!(svg.matches("<rect").count(), 2, "{svg}");
        let cell = |colour: &str| {
            let cell = svg.lines().find(|line| line.starts_with("<rect") && line.contains(colour));
            ["x", "y", "width", "height"].map(|name| {
                let (_, value) = cell.unwrap().split_once(&format!(" {name}=\"")).unwrap();
                value.split_once('"').unwrap().0.parse::<i32>().unwrap()
            })
        };
        // plotters ends its axes on the last step, not after it.
        let near = |a: [i32; 4], b: [i32; 4]| a.iter().zip(b).all(|(a, b)| a.abs_diff(b) <= 1);
        assert!(near(cell("#0072B2"), [96, 16, 32, 16]), "{svg}");
        assert!(near(cell("#D55E00"), [112, 0, 16, 16]), "{svg}");
    }
}
