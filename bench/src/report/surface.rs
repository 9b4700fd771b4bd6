//! An iso-surface as shaded triangles: marching tetrahedra, seen from a corner.

use plotters::{
    element::{PathElement, Polygon},
    style::{Color, HSLColor},
};

use super::picture::{Area, Drawn, FINE, RULE, picture};

/// Steps between the lattice's nodes, by cubic interpolation: a ring on a coarse lattice is round.
const UPSAMPLING: usize = 2;

/// Hue of the surface, and lightness where it is turned away from the light and towards it.
const HUE: f64 = 205.0 / 360.0;
const DARKEST: f64 = 0.28;
const BRIGHTEST: f64 = 0.76;

/// Where the eye is: turned about z and raised, in radians.
const TURN: f64 = 0.6;
const TILT: f64 = 0.55;

/// The six tetrahedra of a cube about its diagonal; corner bits are x, y, z.
const TETRAHEDRA: [[usize; 4]; 6] =
    [[0, 1, 3, 7], [0, 3, 2, 7], [0, 2, 6, 7], [0, 6, 4, 7], [0, 4, 5, 7], [0, 5, 1, 7]];

/// Values on the nodes of a lattice, stored z, y, x.
#[derive(Debug, Clone, PartialEq)]
pub struct Scalars {
    /// Nodes along x, y, z.
    pub nodes: [usize; 3],
    /// Values.
    pub values: Vec<f64>,
}

type Triangle = [[f64; 3]; 3];

impl Scalars {
    /// The surface where the values cross `level`, seen from above and one side. `height` is that
    /// of the picture.
    pub fn surface_svg(&self, level: f64, height: i32, description: &str) -> String {
        let fine = (0..3).fold(self.clone(), |scalars, axis| scalars.upsampled(axis));
        let middle = fine.nodes.map(|n| (n as f64 - 1.0) / 2.0);
        let largest = middle.iter().copied().fold(1.0, f64::max);
        let half = f64::from(height * FINE) / 2.0;
        let scale = half / (1.45 * largest);
        let place = |[right, up, _]: [f64; 3]| {
            ((1.5 * half + scale * right).round() as i32, (half - scale * up).round() as i32)
        };
        let mut seen: Vec<Triangle> = fine
            .triangles(level)
            .into_iter()
            .map(|triangle| triangle.map(|p| turned([0, 1, 2].map(|axis| p[axis] - middle[axis]))))
            .collect();
        // What is nearer is painted over what is behind it.
        let depth = |eye: &Triangle| eye.iter().map(|p| p[2]).sum::<f64>();
        seen.sort_by(|a, b| depth(a).total_cmp(&depth(b)));
        picture([height * 3 / 2, height], description, |area| {
            frame(area, middle, place)?;
            seen.iter()
                .try_for_each(|eye| area.draw(&Polygon::new(eye.map(place), shade(eye).filled())))
        })
    }

    /// Twice the nodes along an axis: Catmull-Rom between them.
    fn upsampled(&self, axis: usize) -> Self {
        let old = self.nodes[axis];
        if old < 2 {
            return self.clone();
        }
        let mut nodes = self.nodes;
        nodes[axis] = (old - 1) * UPSAMPLING + 1;
        let mut values = Vec::with_capacity(nodes.iter().product());
        for k in 0..nodes[2] {
            for j in 0..nodes[1] {
                for i in 0..nodes[0] {
                    let mut at = [i, j, k];
                    let fine = at[axis];
                    let node = |n: i64| {
                        at[axis] = n.clamp(0, old as i64 - 1) as usize;
                        self.value(at)
                    };
                    let cell = (fine / UPSAMPLING) as i64;
                    let [a, b, c, d] = [-1, 0, 1, 2].map(|n| cell + n).map(node);
                    let t = (fine % UPSAMPLING) as f64 / UPSAMPLING as f64;
                    values.push(
                        b + 0.5
                            * t
                            * (c - a
                                + t * (2.0 * a - 5.0 * b + 4.0 * c - d
                                    + t * (3.0 * (b - c) + d - a))),
                    );
                }
            }
        }
        Self { nodes, values }
    }

    fn value(&self, [i, j, k]: [usize; 3]) -> f64 {
        self.values[(k * self.nodes[1] + j) * self.nodes[0] + i]
    }

    /// Triangles of the surface, in node coordinates, wound so that normals point to lower values.
    fn triangles(&self, level: f64) -> Vec<Triangle> {
        let cells = self.nodes.map(|n| n.saturating_sub(1));
        let mut triangles = Vec::new();
        for k in 0..cells[2] {
            for j in 0..cells[1] {
                for i in 0..cells[0] {
                    let corner = |n: usize| [i + (n & 1), j + (n >> 1 & 1), k + (n >> 2 & 1)];
                    for tetrahedron in TETRAHEDRA {
                        let corners = tetrahedron.map(|n| {
                            let at = corner(n);
                            (at.map(|c| c as f64), self.value(at) - level)
                        });
                        cut(&corners, &mut triangles);
                    }
                }
            }
        }
        triangles
    }
}

/// The triangles in which a tetrahedron with values at its corners crosses zero.
fn cut(corners: &[([f64; 3], f64); 4], triangles: &mut Vec<Triangle>) {
    let (inside, outside): (Vec<_>, Vec<_>) =
        corners.iter().copied().partition(|(_, value)| *value > 0.0);
    let mut push = |triangle: Triangle| {
        let normal = normal(&triangle);
        let outwards = centre(&outside).zip(centre(&inside)).is_some_and(|(out, inn)| {
            (0..3).map(|a| normal[a] * (out[a] - inn[a])).sum::<f64>() > 0.0
        });
        let [a, b, c] = triangle;
        triangles.push(if outwards { triangle } else { [a, c, b] });
    };
    match (inside.as_slice(), outside.as_slice()) {
        ([a], [b, c, d]) | ([b, c, d], [a]) => {
            push([crossing(a, b), crossing(a, c), crossing(a, d)]);
        }
        ([a, b], [c, d]) => {
            let quad = [crossing(a, c), crossing(a, d), crossing(b, d), crossing(b, c)];
            push([quad[0], quad[1], quad[2]]);
            push([quad[0], quad[2], quad[3]]);
        }
        _ => {}
    }
}

fn crossing(&(a, va): &([f64; 3], f64), &(b, vb): &([f64; 3], f64)) -> [f64; 3] {
    let t = va / (va - vb);
    std::array::from_fn(|axis| a[axis] + t * (b[axis] - a[axis]))
}

fn centre(corners: &[([f64; 3], f64)]) -> Option<[f64; 3]> {
    let count = corners.len() as f64;
    (!corners.is_empty()).then(|| {
        std::array::from_fn(|axis| corners.iter().map(|(p, _)| p[axis]).sum::<f64>() / count)
    })
}

fn normal([a, b, c]: &Triangle) -> [f64; 3] {
    let u: [f64; 3] = std::array::from_fn(|axis| b[axis] - a[axis]);
    let v: [f64; 3] = std::array::from_fn(|axis| c[axis] - a[axis]);
    [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
}

/// World to eye: x to the right, y up, z towards the reader.
fn turned([x, y, z]: [f64; 3]) -> [f64; 3] {
    let (right, away) = (x * TURN.cos() + y * TURN.sin(), y * TURN.cos() - x * TURN.sin());
    [right, z * TILT.cos() + away * TILT.sin(), z * TILT.sin() - away * TILT.cos()]
}

/// Light comes from over the reader's left shoulder.
fn shade(eye: &Triangle) -> HSLColor {
    const LIGHT: [f64; 3] = [-0.35, 0.55, 0.76];
    let normal = normal(eye);
    let length = normal.iter().map(|n| n * n).sum::<f64>().sqrt().max(f64::MIN_POSITIVE);
    let cosine = (0..3).map(|a| normal[a] * LIGHT[a]).sum::<f64>() / length;
    HSLColor(HUE, 0.55, DARKEST + (BRIGHTEST - DARKEST) * cosine.max(0.0))
}

/// The edges of the volume.
fn frame(area: &Area, half: [f64; 3], place: impl Fn([f64; 3]) -> (i32, i32)) -> Drawn {
    let corner = |n: usize| -> [f64; 3] {
        turned(std::array::from_fn(|a| if n >> a & 1 == 1 { half[a] } else { -half[a] }))
    };
    for from in 0..8usize {
        for to in (0..3).map(|a| from | 1 << a).filter(|to| *to != from) {
            let edge = [from, to].map(|n| place(corner(n)));
            area.draw(&PathElement::new(edge, RULE.stroke_width(FINE as u32)))?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ball_has_the_surface_of_a_ball_and_its_normals_point_outwards() {
        let n = 15;
        let radius_of = |i: usize| (i as f64 - 7.0).powi(2);
        let values = (0..n * n * n)
            .map(|v| 5.0 - (radius_of(v % n) + radius_of(v / n % n) + radius_of(v / n / n)).sqrt())
            .collect();
        let ball = Scalars { nodes: [n; 3], values };
        let triangles = ball.triangles(0.0);
        let mut area = 0.0;
        for triangle in &triangles {
            let normal = normal(triangle);
            area += normal.iter().map(|c| c * c).sum::<f64>().sqrt() / 2.0;
            let outwards: f64 = (0..3).map(|a| normal[a] * (triangle[0][a] - 7.0)).sum();
            assert!(outwards >= -1e-9, "{triangle:?}");
        }
        let expected = 4.0 * std::f64::consts::PI * 25.0;
        assert!((area / expected - 1.0).abs() < 0.03, "{area}");
        let svg = ball.surface_svg(0.0, 100, "ball");
        let fine = (0..3).fold(ball, |ball, axis| ball.upsampled(axis));
        assert_eq!(svg.matches("<polygon").count(), fine.triangles(0.0).len());
        let towards_the_light = HSLColor(HUE, 0.55, BRIGHTEST).rgb();
        let brightest =
            svg.lines().filter_map(|line| line.split_once("fill=\"#")).map(|(_, fill)| {
                u8::from_str_radix(&fill[..2], 16).expect("a colour in hexadecimal digits")
            });
        assert!(brightest.max().unwrap().abs_diff(towards_the_light.0) < 3);
    }
}
