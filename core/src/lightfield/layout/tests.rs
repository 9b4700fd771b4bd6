//! Views of the bench, their coverage and their decoding.

use super::*;
use crate::test_bench;

#[test]
fn about_250_views_contain_the_light_of_the_aperture() {
    let optics = test_bench::optics();
    let layout = ViewLayout::new(&optics, MicrolensWindow::whole(&optics));
    assert!((230..=290).contains(&layout.views.len()), "{}", layout.views.len());
    let light: f64 = layout
        .views
        .iter()
        .map(|v| match &v.coverage {
            None => 1.0,
            Some(c) => c.iter().map(|&c| f64::from(c)).sum::<f64>() / c.len() as f64,
        })
        .sum();
    // The aperture has pi/4 (25/1.375)^2 = 259.6 cells; shared columns and dim views are lost.
    assert!((235.0..259.6).contains(&light), "{light}");
}

#[test]
fn coverage_of_one_cell_matches_fine_sampling() {
    let aperture = Aperture { radius_mm: 12.5, interval_mm: 1.375 };
    for (u, v) in [(8.0, 8.2), (11.9, 1.0), (0.3, 12.2), (9.0, 9.0), (3.0, 3.0)] {
        let share = aperture.strip(u).covered(v, 1.375);
        let n = 400;
        let inside = (0..n * n)
            .filter(|m| {
                let cell = |m: usize| ((m as f64 + 0.5) / f64::from(n as u32) - 0.5) * 1.375;
                (u + cell(m % n)).hypot(v + cell(m / n)) < 12.5
            })
            .count();
        // A chord that ends inside the cell has an error of up to half a chord spacing.
        assert!((share - inside as f64 / (n * n) as f64).abs() < 0.5 / CHORDS as f64);
    }
}

#[test]
fn views_at_the_edge_are_left_out_or_partly_covered() {
    let optics = test_bench::optics();
    let window = || MicrolensWindow { columns: 40..90, rows: 30..60 };
    let layout = |edge| ViewLayout::with_edge(&optics, window(), edge);
    let sharp = ApertureEdge::sharp(&optics);
    let all = ViewLayout::new(&optics, window());
    let open = layout(ApertureEdge { partly_open_views: false, ..sharp });
    let uncut = |layout: &ViewLayout| layout.views.iter().filter(|v| !v.is_cut()).count();
    let expected = uncut(&all);
    assert!(open.views.len() == expected && expected < all.views.len());
    // With a wider interval fewer cells are fully open.
    let soft = layout(ApertureEdge { interval_mm: 2.0, ..sharp });
    assert!(uncut(&soft) < expected);
}

#[test]
fn decoding_uses_the_pixels_of_the_sampling() {
    let optics = test_bench::optics();
    let (nx, ny) = (optics.sensor.columns, optics.sensor.rows);
    let counts = (0..nx * ny).map(|n| ((n * 7919) % 4096) as u16).collect();
    let image = RawImage::new(nx, ny, counts).unwrap();
    let window = MicrolensWindow { columns: 20..60, rows: 10..50 };
    let layout = ViewLayout::new(&optics, window);
    let stack = layout.decode(&image, |_, _, count| f32::from(count) - 10.0);
    assert_eq!(stack.len(), layout.views.len());
    let index = layout.views.iter().position(|v| (v.k, v.l) == (3, -5)).unwrap();
    let (i, j) = (33, 21);
    let column = layout.columns.sample(3, i).unwrap().pixel as usize;
    let row = layout.rows.sample(-5, j).unwrap().pixel as usize;
    let expected = f32::from(image.row(row)[column]) - 10.0;
    assert_eq!(stack.view(index)[(j - 10) * 40 + (i - 20)], expected);
}
