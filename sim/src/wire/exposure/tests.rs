use super::*;
use crate::{BenchGeometry, Scene, test_bench};

const PERIOD_NS: u64 = 100_000_000;

fn wiring() -> Wiring {
    Wiring { lamps: [1, 3], q_switches: [2, 4], cameras: vec![5, 6] }
}

fn bench() -> OpticalBench {
    OpticalBench::new(wiring(), LaserFacts::default(), CameraFacts::default())
}

/// The default timing at 10 Hz, period `number`.
fn nominal(number: u64, dt_us: f64) -> PeriodOutputs {
    let camera_us = 76.0 + dt_us / 2.0;
    let starts_us = [
        (1, 100.0),
        (2, 280.0),
        (3, 100.0 + dt_us),
        (4, 280.0 + dt_us),
        (5, camera_us),
        (6, camera_us),
    ];
    let pulses = starts_us
        .map(|(channel, start_us)| OutputPulse { channel, start_us, width_us: 50.0 })
        .to_vec();
    PeriodOutputs { t0_ns: number * PERIOD_NS, pulses }
}

fn delayed(mut outputs: PeriodOutputs, channel: u8, by_us: f64) -> PeriodOutputs {
    let pulse = outputs.pulses.iter_mut().find(|pulse| pulse.channel == channel).unwrap();
    pulse.start_us += by_us;
    outputs
}

fn without(mut outputs: PeriodOutputs, channel: u8) -> PeriodOutputs {
    outputs.pulses.retain(|pulse| pulse.channel != channel);
    outputs
}

fn energies(exposures: &CameraExposures) -> [Vec<f64>; 2] {
    exposures.light.clone().map(|light| light.iter().map(|pulse| pulse.energy).collect())
}

#[test]
fn planned_pulses_fall_one_into_each_exposure() {
    for dt_us in [4.0, 4.1, 100.0, 202.0] {
        let exposures = bench().period(&nominal(0, dt_us));
        assert_eq!(exposures.len(), 2);
        for camera in exposures {
            assert_eq!(energies(&camera), [[1.0], [1.0]], "dt {dt_us}");
            let dt_s = dt_us * 1e-6;
            assert_eq!(camera.separation_s, Some(dt_s));
            let times = camera.light.map(|light| light[0].at_s);
            assert_eq!(times, [-dt_s / 2.0, dt_s / 2.0], "dt {dt_us}: bit for bit");
        }
    }
}

#[test]
fn the_scene_shows_the_planned_shot_bit_for_bit() {
    let scene = Scene { rays_per_particle: 100, ..Scene::default() };
    let geometry = test_bench::small();
    let exposures = bench().period(&nominal(0, 100.0));
    let light: Vec<_> = exposures.iter().map(|camera| camera.light.clone()).collect();
    let geometry = BenchGeometry { dt_s: exposures[0].separation_s.unwrap(), ..geometry };
    assert_eq!(geometry.dt_s, 100.0 * 1e-6);
    assert_eq!(scene.exposures(&geometry, 1, 0, &light), scene.shot(&geometry, 1, 0));
}

#[test]
fn a_wrong_delay_costs_energy_or_misses_the_exposure() {
    // Q-switch 2 is 40 us late: the rod has lost part of its inversion.
    let late = bench().period(&delayed(nominal(0, 100.0), 4, 40.0));
    let [first, second] = energies(&late[0]);
    assert_eq!(first, [1.0]);
    assert!((second[0] - (-0.5_f64).exp()).abs() < 1e-12);
    assert!((late[0].separation_s.unwrap() - 140e-6).abs() < 1e-15);
    // Cameras 60 us late: both pulses fall into exposure 1 of that camera.
    let shifted = bench().period(&delayed(nominal(0, 100.0), 6, 60.0));
    assert_eq!(energies(&shifted[0]), [[1.0], [1.0]]);
    assert_eq!(energies(&shifted[1]), [vec![1.0, 1.0], vec![]]);
    // Both pulses before the shutter opens.
    let dark = bench().period(&delayed(nominal(0, 100.0), 5, 1000.0));
    assert_eq!(energies(&dark[0]), [Vec::<f64>::new(), vec![]]);
}

#[test]
fn there_is_no_light_in_the_gap() {
    // The gap lasts from 329 to 331 us.
    for (q1_us, exposure_1) in [(328.9, 1), (329.0, 0), (330.9, 0), (331.0, 0)] {
        let outputs = delayed(nominal(0, 100.0), 2, q1_us - 280.0);
        let [first, second] = energies(&bench().period(&outputs)[0]);
        assert_eq!(first.len(), exposure_1, "{q1_us}");
        assert_eq!(second.len(), if q1_us >= 331.0 { 2 } else { 1 }, "{q1_us}");
    }
}

#[test]
fn there_is_no_light_without_lamps_or_before_them() {
    let no_lamp = bench().period(&without(nominal(0, 100.0), 1));
    assert_eq!(energies(&no_lamp[0]), [vec![], vec![1.0]]);
    let lamp_after_q = bench().period(&delayed(nominal(0, 100.0), 1, 200.0));
    assert_eq!(energies(&lamp_after_q[0]), [vec![], vec![1.0]]);
    let no_q_switch = bench().period(&without(nominal(0, 100.0), 4));
    assert_eq!(energies(&no_q_switch[0]), [vec![1.0], vec![]]);
    assert_eq!(no_q_switch[0].separation_s, None);
}

#[test]
fn cold_lamps_give_no_light_until_they_are_warm_and_after_a_pause() {
    let laser = LaserFacts { warm_up_s: 1.0, stays_warm_s: 2.0, ..LaserFacts::default() };
    let mut bench = OpticalBench::new(wiring(), laser, CameraFacts::default());
    let mut lit = |number| !bench.period(&nominal(number, 100.0))[0].light[0].is_empty();
    for number in 0..15 {
        assert_eq!(lit(number), number >= 10, "period {number}");
    }
    // Three seconds later they are cold again.
    assert!(!lit(45) && !lit(46));
    assert!((47..60).filter(|number| lit(*number)).count() == 5);
}

#[test]
fn a_camera_that_reads_out_ignores_its_trigger() {
    let mut bench = bench();
    assert_eq!(bench.period(&nominal(0, 100.0)).len(), 2);
    // 15 Hz: the next trigger comes before the cameras are ready at 80.331 ms.
    let early = PeriodOutputs { t0_ns: 66_666_667, ..nominal(0, 100.0) };
    assert_eq!(bench.period(&early).len(), 0);
    let early = PeriodOutputs { t0_ns: 133_333_333, ..nominal(0, 100.0) };
    assert_eq!(bench.period(&early).len(), 2);
}
