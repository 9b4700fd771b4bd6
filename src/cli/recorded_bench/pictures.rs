//! Frames of the record in the order of the triggers, read ahead.

use std::{
    collections::BTreeMap,
    sync::{Arc, mpsc},
    thread,
};

use anyhow::{Context, anyhow};
use lfpiv_hw::{RawImage, gige::ImageSize};
use lfpiv_rawlog::Position;
use lfpiv_sim::{
    LightPulse,
    wire::{Delivery, Pictures, exposure::LaserFacts},
};
use parking_lot::Mutex;

use super::{
    light::is_as_recorded,
    triggers::{Delivered, RecordedTrigger, RecordedTriggers},
};
use crate::acquisition::journal::{RecordedRun, RecordedRunError};

/// Number of triggers whose frames are read in advance. It bounds the memory for any length of the
/// run.
const READ_AHEAD: usize = 2;

/// Counts of what was shown.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(crate) struct Shown {
    /// Triggers that showed recorded frames.
    pub recorded: u64,
    /// Triggers with other light than recorded: dark images.
    pub other_light: u64,
    /// Triggers after the end of the record: dark images.
    pub beyond: u64,
    /// Triggers whose frames are damaged in the record, and the reasons. Their frames are sent as
    /// lost.
    pub damaged: BTreeMap<u64, String>,
    /// The first other failure.
    pub failure: Option<String>,
}

/// Shows the frames of a recorded run, those of trigger n at trigger n.
pub(crate) struct RecordedPictures {
    triggers: Arc<RecordedTriggers>,
    read: Mutex<mpsc::Receiver<anyhow::Result<Vec<Delivery>>>>,
    dark: RawImage,
    laser: LaserFacts,
    shown: Mutex<Shown>,
}

impl RecordedPictures {
    /// Starts reading; images have `size` pixels and `count_bits` significant bits.
    ///
    /// # Errors
    /// The reading thread cannot be started.
    pub(super) fn read(
        recorded: RecordedRun,
        triggers: RecordedTriggers,
        size: ImageSize,
        count_bits: u32,
    ) -> anyhow::Result<Self> {
        let triggers = Arc::new(triggers);
        let (frames, read) = mpsc::sync_channel(READ_AHEAD);
        let reader = Reader { recorded, triggers: triggers.clone(), size, count_bits };
        thread::Builder::new()
            .name("recorded frames".into())
            .spawn(move || reader.read_all(&frames))
            .context("cannot start the thread that reads the record")?;
        let dark = RawImage::new(size.columns, size.rows, vec![0; size.pixels()])?;
        let (laser, shown) = (LaserFacts::default(), Mutex::default());
        Ok(Self { triggers, read: Mutex::new(read), dark, laser, shown })
    }

    /// Counts of what was shown so far.
    pub fn shown(&self) -> Shown {
        self.shown.lock().clone()
    }

    fn all_dark(&self, cameras: usize) -> Vec<Delivery> {
        (0..cameras).map(|_| [self.dark.clone(), self.dark.clone()].into()).collect()
    }

    /// The frames of the next trigger; missing frames if they cannot be read.
    fn next(&self, trigger: u64, cameras: usize) -> Vec<Delivery> {
        let error = match self.read.lock().recv() {
            Ok(Ok(deliveries)) => return deliveries,
            Ok(Err(error)) => error,
            Err(_) => anyhow!("the reader of the record has ended"),
        };
        let words = format!("{error:#}");
        tracing::error!(trigger, "frames of the record cannot be shown: {words}");
        let mut shown = self.shown.lock();
        if error.downcast_ref().is_some_and(RecordedRunError::is_damage) {
            shown.damaged.insert(trigger, words);
        } else {
            shown.failure.get_or_insert(format!("trigger {trigger}: {words}"));
        }
        vec![Delivery::Frames([None, None]); cameras]
    }
}

impl Pictures for RecordedPictures {
    fn of(
        &self,
        trigger: u64,
        light: &[[Vec<LightPulse>; 2]],
        _separation_s: Option<f64>,
    ) -> Vec<Delivery> {
        let Some(recorded) = self.triggers.get(trigger) else {
            tracing::warn!(trigger, "after the end of the record: dark images");
            self.shown.lock().beyond += 1;
            return self.all_dark(light.len());
        };
        let deliveries = self.next(trigger, light.len());
        if light.iter().all(|light| is_as_recorded(light, &recorded.schedule, &self.laser)) {
            self.shown.lock().recorded += 1;
            return deliveries;
        }
        tracing::warn!(trigger, "the light differs from the record: dark images");
        self.shown.lock().other_light += 1;
        self.all_dark(light.len())
    }
}

/// Reads the triggers one after the other.
struct Reader {
    recorded: RecordedRun,
    triggers: Arc<RecordedTriggers>,
    size: ImageSize,
    count_bits: u32,
}

impl Reader {
    /// Reads until the end of the record, or until the receiver is dropped.
    fn read_all(&self, frames: &mpsc::SyncSender<anyhow::Result<Vec<Delivery>>>) {
        for trigger in (0..).map_while(|number| self.triggers.get(number)) {
            if frames.send(self.deliveries(trigger)).is_err() {
                return;
            }
        }
    }

    fn deliveries(&self, trigger: &RecordedTrigger) -> anyhow::Result<Vec<Delivery>> {
        let part = |part: &Delivered| match part {
            Delivered::Missed => Ok(Delivery::Missed),
            Delivered::Frames([a, b]) => Ok(Delivery::Frames([self.image(*a)?, self.image(*b)?])),
        };
        trigger.cameras.iter().map(part).collect()
    }

    fn image(&self, place: Option<Position>) -> anyhow::Result<Option<RawImage>> {
        let Some(place) = place else { return Ok(None) };
        let image = self.recorded.image(place)?;
        let size = ImageSize { columns: image.columns(), rows: image.rows() };
        anyhow::ensure!(
            size == self.size,
            "an image has {} x {} pixels, others have {} x {}",
            size.columns,
            size.rows,
            self.size.columns,
            self.size.rows
        );
        let brightest = image.counts().iter().copied().max().unwrap_or_default();
        anyhow::ensure!(
            u32::from(brightest) >> self.count_bits == 0,
            "a count of {brightest} exceeds the run's {} bits, so it cannot be sent unchanged",
            self.count_bits
        );
        Ok(Some(image))
    }
}
