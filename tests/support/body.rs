//! A body for masks, as an STL file.

/// A cylinder along z about `axis_mm`, longer than any volume of the tests.
pub fn cylinder(axis_mm: [f64; 2], radius_mm: f64) -> String {
    const SIDES: usize = 24;
    let at = |n: usize, z: f64| {
        let angle = std::f64::consts::TAU * (n % SIDES) as f64 / SIDES as f64;
        [axis_mm[0] + radius_mm * angle.cos(), axis_mm[1] + radius_mm * angle.sin(), z]
    };
    let mut text = String::from("solid cylinder\n");
    for n in 0..SIDES {
        let [a, b, c, d] = [at(n, -5.0), at(n + 1, -5.0), at(n + 1, 5.0), at(n, 5.0)];
        let [bottom, top] = [-5.0, 5.0].map(|z| [axis_mm[0], axis_mm[1], z]);
        for triangle in [[a, b, c], [a, c, d], [bottom, b, a], [top, d, c]] {
            text += "facet normal 0 0 0\nouter loop\n";
            for [x, y, z] in triangle {
                text += &format!("vertex {x:.6} {y:.6} {z:.6}\n");
            }
            text += "endloop\nendfacet\n";
        }
    }
    text + "endsolid cylinder\n"
}
