use super::{
    super::test_data::{DarkThird, Particles},
    *,
};

fn measured(grid: &VolumeGrid, frames: &[Particles; 2], particles: bool) -> VelocityField {
    let settings = VelocimetrySettings { follow_particles: particles, ..Default::default() };
    let interrogation = Interrogation::new(grid, 4, &settings);
    let cloud_grid = interrogation.cloud_grid();
    let [a, b] = frames.each_ref().map(|frame| PointCloud::from_particles(frame, &cloud_grid));
    interrogation.measure(&a, &b, 1e-4)
}

#[test]
fn a_dark_third_costs_the_vectors_in_the_light_nothing() {
    let volume = DarkThird::new();
    let frames = volume.frames(1);
    for particles in [false, true] {
        let [whole, ended] =
            [&volume.whole, &volume.ended].map(|grid| measured(grid, &frames, particles));
        volume.assert_same_error(&whole, &ended);
    }
}
