use super::{
    super::{
        VectorStatus,
        test_data::{DarkThird, Particles, error_vox, frames},
    },
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

/// Voxels of a plate across x, and of the flow on either side of it.
const PLATE: std::ops::Range<f64> = 34.0..54.0;

/// Two flows that a plate parts: each is sheared along y, they differ by 3 voxels.
fn parted([x, y, _]: [f64; 3]) -> [f64; 3] {
    let side = if x < PLATE.start { -1.0 } else { 1.0 };
    [0.0, 1.5 * side, 0.03 * side * (y - 20.0)]
}

/// The plate, and the frames of particles beside it.
fn beside_plate() -> (VolumeGrid, Arc<VolumeMask>, [Particles; 2]) {
    let grid = VolumeGrid { voxels: [88, 48, 48], voxel_mm: 0.1, centre_mm: [0.0; 3] };
    let in_plate = |x: f64| PLATE.contains(&(x + 0.5));
    let flow = (0..grid.len()).map(|n| !in_plate(grid.indices(n as u32)[0] as f64)).collect();
    let mask = VolumeMask { grid: grid.clone(), flow };
    let seen = frames(3, &grid, 4000, parted).map(|mut particles| {
        particles.retain(|(at, _)| !in_plate(grid.index_of(0, at[0]).round()));
        particles
    });
    (grid, Arc::new(mask), seen)
}

#[test]
fn nothing_reaches_across_a_plate() {
    let (grid, mask, seen) = beside_plate();
    for particles in [false, true] {
        let settings = VelocimetrySettings { follow_particles: particles, ..Default::default() };
        let errors = |mask: Option<Arc<VolumeMask>>| {
            let interrogation = Interrogation::new(&grid, 4, &settings).with_mask(mask.clone());
            let cloud_grid = interrogation.cloud_grid();
            let [a, b] =
                seen.each_ref().map(|frame| PointCloud::from_particles(frame, &cloud_grid));
            let field = interrogation.measure(&a, &b, 1e-4);
            let (mut worst, mut spin, mut valid, mut flow) = (0.0f64, 0.0f64, 0, 0);
            for n in 0..field.grid.len() {
                let at_mm = field.grid.position_mm(n);
                let is_flow = mask.as_ref().is_none_or(|mask| mask.is_flow(at_mm));
                assert_eq!(field.status[n] == VectorStatus::Masked, !is_flow, "{at_mm:?}");
                if !is_flow {
                    assert_eq!(
                        (field.displacement_vox[n], field.has_gradient[n]),
                        ([0.0; 3], false)
                    );
                    continue;
                }
                flow += 1;
                if field.status[n] == VectorStatus::Valid {
                    valid += 1;
                    let error = error_vox(&field, &grid, parted, n);
                    worst = error.iter().fold(worst, |worst, error| worst.max(error.abs()));
                }
                if field.has_gradient[n] {
                    spin = spin.max(f64::from(field.vorticity[n][2].abs()));
                }
            }
            (worst, spin, valid as f64 / flow as f64)
        };
        let (masked, whole) = (errors(Some(mask.clone())), errors(None));
        println!("largest error, |vorticity| about z, valid share: {masked:?}, unmasked {whole:?}");
        let most = if particles { 0.005 } else { 0.04 };
        assert!(masked.0 < most && masked.1 < most / 4.0 && masked.2 > 0.98, "{masked:?}");
        // The test would notice.
        assert!(whole.1 > 0.05, "{whole:?}");
    }
}

#[test]
fn windows_around_a_thin_body_are_counted() {
    let (grid, mask, _) = beside_plate();
    let settings = VelocimetrySettings::default();
    let interrogation = Interrogation::new(&grid, 4, &settings).with_mask(Some(mask.clone()));
    let in_flow = interrogation.in_flow().unwrap();
    assert_eq!(in_flow.around_bodies, 0);
    assert!(in_flow.vectors < interrogation.vector_grid().len());
    let wide = VelocimetrySettings { window_mm: 2.8, ..settings };
    let interrogation = Interrogation::new(&grid, 4, &wide).with_mask(Some(mask));
    assert!(interrogation.in_flow().unwrap().around_bodies > 0);
}

/// A mask that leaves nothing out changes no bit.
#[test]
fn a_mask_of_flow_alone_changes_nothing() {
    let (grid, mask, seen) = beside_plate();
    let all = VolumeMask { grid: grid.clone(), flow: vec![true; mask.flow.len()] };
    let settings = VelocimetrySettings::default();
    let fields = [None, Some(Arc::new(all))].map(|mask| {
        let interrogation = Interrogation::new(&grid, 4, &settings).with_mask(mask);
        let cloud_grid = interrogation.cloud_grid();
        let [a, b] = seen.each_ref().map(|frame| PointCloud::from_particles(frame, &cloud_grid));
        interrogation.measure(&a, &b, 1e-4)
    });
    assert_eq!(fields[0], fields[1]);
}
