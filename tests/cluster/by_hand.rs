//! A worker that does not do as it should: the coordinator's side of the rules.

use lfpiv::{
    acquisition::journal::RecordedRun,
    archive::{RawLevel, ShotResult},
    cluster::{Attempt, Begin, ClientError, CoordinatorClient, Delivery, Job, Tokens, Verdict},
    config::Config,
};
use lfpiv_core::{
    measurement::Processor,
    reconstruction::{FrameLight, MaximumProjection},
};

use crate::{
    broker::{Nats, first_job},
    processes::{coordinator, wait_until, worker},
    recorded::{assert_same, copied, recorded_otherwise},
};

/// What a worker makes of the job.
fn measured(job: &Job, client: &CoordinatorClient) -> Delivery {
    let assignment = client.assignment().expect("a coordinator");
    let config = Config::parse("the run's", &assignment.configuration).expect("a configuration");
    let processor = Processor::new(config.measurement()).expect("a bench");
    let mut result = None;
    for shot in [&assignment.reference.shot, &job.shot] {
        let frames = shot
            .frames
            .iter()
            .map(|pair| pair.each_ref().map(|frame| client.frame(frame).expect("a frame")));
        let pair = lfpiv_core::lightfield::ImagePair { cameras: frames.collect() };
        let mut measured = processor.process(pair).expect("a result");
        measured.field.dt_s = shot.dt_us() * 1e-6;
        result = Some(ShotResult { measured, time: shot.time(), raw: RawLevel::Synced });
    }
    Delivery {
        shot: job.shot.number,
        attempt: Attempt { issue: job.issue, delivery: 1 },
        worker: "by hand".into(),
        model_sha256: job.model_sha256.clone(),
        result: result.expect("two shots"),
    }
}

/// Light that nobody has asked for.
fn dark() -> FrameLight {
    let plane = || MaximumProjection { size: [8, 8], intensity: vec![0.0; 64] };
    FrameLight { volume: None, projections: [plane(), plane(), plane()] }
}

#[test]
fn every_delivery_is_checked_and_the_first_one_counts() {
    let root = tempfile::tempdir().expect("a folder");
    let run = recorded_otherwise(&root.path().join("bench"), ("seed = 1", "seed = 4"), 6);
    let at_once = copied(&run, &root.path().join("at_once"));
    assert!(crate::bench::lfpiv(&["process", at_once.to_str().expect("UTF-8")]).status.success());
    let nats = Nats::start(root.path());
    let coordinator = coordinator(root.path(), &run, &nats.url(), &[]);
    let job = first_job(&nats.url());
    let client = CoordinatorClient::new(&job.address, &job.tokens);
    let shot = job.shot.number;

    // Only with the run's tokens, and each for its own.
    let Tokens { read, .. } = &job.tokens;
    let reader =
        CoordinatorClient::new(&job.address, &Tokens { read: read.clone(), work: read.clone() });
    assert!(reader.frame(&job.shot.frames[0][0]).is_ok());
    assert!(matches!(reader.deliver(b"anything"), Err(ClientError::Stale(_))));
    for token in ["", "0123456789abcdef0123456789abcdef"] {
        let tokens = Tokens { read: token.into(), work: token.into() };
        let stranger = CoordinatorClient::new(&job.address, &tokens);
        let refused = stranger.begin(shot, Attempt { issue: 1, delivery: 1 }, "stranger");
        assert!(matches!(refused, Err(ClientError::Stale(_))), "{refused:?}");
        assert!(matches!(stranger.frame(&job.shot.frames[0][0]), Err(ClientError::Stale(_))));
        assert!(matches!(stranger.deliver(b"anything"), Err(ClientError::Stale(_))));
    }
    let whole = client.packed(&job.shot.frames[0][0]).expect("a record");
    let place = job.shot.frames[0][0];
    let url = format!("{}/work/v1/records/{}/{}", job.address, place.segment, place.offset);
    let mut part = ureq::get(&url)
        .header("Authorization", format!("Bearer {read}"))
        .header("Range", "bytes=100-199")
        .call()
        .expect("an answer");
    assert_eq!(part.status(), 206);
    assert_eq!(part.body_mut().read_to_vec().expect("bytes"), whole[100..200]);
    let mut nowhere = job.shot.frames[0][0];
    nowhere.offset += 1;
    assert!(matches!(client.frame(&nowhere), Err(ClientError::Frame(_))));

    let right = measured(&job, &client);
    let refused = |bytes: &[u8], why: &str| match client.deliver(bytes) {
        Err(ClientError::Refused(words)) => assert!(words.contains(why), "{words}"),
        other => panic!("{other:?}, and not {why}"),
    };
    let mut changed = right.encode();
    let middle = changed.len() / 2;
    changed[middle] ^= 4;
    refused(&changed, "its bytes have changed on the way");
    refused(&right.encode()[..middle], "changed");
    refused(b"", "no result");
    let with = |change: &dyn Fn(&mut Delivery)| {
        let mut delivery = right.clone();
        change(&mut delivery);
        delivery.encode()
    };
    let infinite = |of: &mut Delivery| of.result.measured.field.peak_ratio[0] = f32::INFINITY;
    refused(&with(&infinite), "not finite");
    refused(&with(&|of| of.shot = 1000), "is not to be measured");
    refused(&with(&|of| of.model_sha256.push('0')), "another forward model");
    refused(&with(&|of| of.result.measured.field.dt_s *= 2.0), "times");
    refused(&with(&|of| of.result.measured.field.grid.first_mm[0] += 1.0), "elsewhere");
    let light = |of: &mut Delivery| of.result.measured.light = Some([dark(), dark()]);
    refused(&with(&light), "its light is not that of the run's volume");

    // Delivered twice, by two workers, and once otherwise.
    assert_eq!(client.deliver(&right.encode()).expect("taken"), Verdict::First);
    assert_eq!(client.deliver(&right.encode()).expect("taken"), Verdict::Duplicate);
    let by_another = with(&|of| {
        of.worker = "another".into();
        of.attempt.delivery = 2;
        of.result.measured.seconds.judge_s += 1.0;
    });
    assert_eq!(client.deliver(&by_another).expect("taken"), Verdict::Duplicate);
    let otherwise = with(&|of| {
        of.worker = "otherwise".into();
        let number = &mut of.result.measured.field.displacement_vox[0][0];
        *number = f32::from_bits(number.to_bits() ^ 1);
    });
    assert_eq!(client.deliver(&otherwise).expect("taken"), Verdict::Unequal);
    let begin = client.begin(shot, Attempt { issue: 1, delivery: 3 }, "late");
    assert_eq!(begin.expect("an answer"), Begin::Settled);

    let _worker = worker(root.path(), &nats.url(), "real", &[]);
    let ended = coordinator.wait();
    assert_eq!(ended.code, Some(1), "{ended:?}");
    assert!(ended.stderr.contains("unequal results"), "{ended:?}");
    let makers = format!("shot {shot}: by hand (");
    assert!(ended.stderr.contains(&makers) && ended.stderr.contains("otherwise ("), "{ended:?}");
    assert!(ended.stdout.contains("real: 4 shots"), "{ended:?}");
    assert!(ended.stdout.contains("9 results refused"), "{ended:?}");
    assert_same(&at_once, &run);
}

#[test]
fn a_shot_that_nobody_can_measure_is_given_up_with_reasons() {
    let root = tempfile::tempdir().expect("a folder");
    let run = recorded_otherwise(&root.path().join("bench"), ("seed = 1", "seed = 5"), 5);
    let nats = Nats::start(root.path());
    let coordinator = coordinator(root.path(), &run, &nats.url(), &[]);
    let job = first_job(&nats.url());
    let client = CoordinatorClient::new(&job.address, &job.tokens);
    let shots: Vec<u64> =
        RecordedRun::open(&run).expect("a run").index().shots.into_keys().collect();
    let [failing, deadly] = [shots[2], shots[4]];
    for delivery in 1..=3 {
        let attempt = Attempt { issue: 1, delivery };
        assert_eq!(client.begin(failing, attempt, "one").expect("an answer"), Begin::Measure);
        // Told twice, as when an answer is lost, it counts once.
        for _ in 0..2 {
            client.fail(failing, attempt, "one", "too dark").expect("an answer");
        }
    }
    for delivery in 1..=11 {
        let attempt = Attempt { issue: 1, delivery };
        let expected = if delivery <= 10 { Begin::Measure } else { Begin::Settled };
        let begin = client.begin(deadly, attempt, &format!("lost {delivery}"));
        assert_eq!(begin.expect("an answer"), expected, "{delivery}");
    }
    let again = client.begin(failing, Attempt { issue: 1, delivery: 4 }, "one");
    assert_eq!(again.expect("an answer"), Begin::Settled);
    wait_until("both are reported", || coordinator.log().matches("is given up").count() >= 2);

    let _worker = worker(root.path(), &nats.url(), "real", &[]);
    let ended = coordinator.wait();
    assert_eq!(ended.code, Some(1), "{ended:?}");
    for words in [
        "2 shots gave no result".to_owned(),
        format!("shot {failing}: one: too dark; one: too dark; one: too dark"),
        format!("shot {deadly}: lost 1: did not end; lost 2: did not end"),
    ] {
        assert!(ended.stderr.contains(&words), "{words}: {ended:?}");
    }
    assert!(ended.stdout.contains("5 shots recorded, 0 had a result, 3 have one now"), "{ended:?}");

    // The next call tries them again.
    let ended = crate::processes::coordinator(root.path(), &run, &nats.url(), &[]).wait();
    assert_eq!(ended.code, Some(0), "{ended:?}");
    assert!(ended.stdout.contains("3 had a result, 5 have one now"), "{ended:?}");
}
