//! Frames of the record in the order of the triggers, read a little ahead.

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
    triggers::{Part, RecordedTrigger, RecordedTriggers},
};
use crate::acquisition::journal::{RecordedRun, RecordedRunError};

/// Triggers whose frames are read before they are asked for. With those on their way this bounds
/// the memory, however long the run is.
const READ_AHEAD: usize = 2;

/// What was shown so far.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(crate) struct Shown {
    /// Triggers that showed the frames of the record.
    pub recorded: u64,
    /// Triggers whose light was not that of the record: dark images.
    pub other_light: u64,
    /// Triggers beyond the end of the record: dark images.
    pub beyond: u64,
    /// Triggers whose frames are damaged in the record, and why: they were lost again.
    pub damaged: BTreeMap<u64, String>,
    /// The first thing that could not be shown for another reason.
    pub failure: Option<String>,
}

/// Shows the frames of a recorded run: trigger n those of trigger n.
pub(crate) struct RecordedPictures {
    triggers: Arc<RecordedTriggers>,
    read: Mutex<mpsc::Receiver<anyhow::Result<Vec<Delivery>>>>,
    dark: RawImage,
    laser: LaserFacts,
    shown: Mutex<Shown>,
}

impl RecordedPictures {
    /// Begins to read; images have the size `size` and `count_bits` significant bits.
    ///
    /// # Errors
    /// There is no thread.
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
            .context("no thread to read the record")?;
        let dark = RawImage::new(size.columns, size.rows, vec![0; size.pixels()])?;
        let (laser, shown) = (LaserFacts::default(), Mutex::default());
        Ok(Self { triggers, read: Mutex::new(read), dark, laser, shown })
    }

    /// What was shown so far.
    pub fn shown(&self) -> Shown {
        self.shown.lock().clone()
    }

    fn all_dark(&self, cameras: usize) -> Vec<Delivery> {
        (0..cameras).map(|_| [self.dark.clone(), self.dark.clone()].into()).collect()
    }

    /// The frames of the next trigger, or its number's worth of nothing.
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
            tracing::warn!(trigger, "beyond the end of the record: dark images");
            self.shown.lock().beyond += 1;
            return self.all_dark(light.len());
        };
        let deliveries = self.next(trigger, light.len());
        if light.iter().all(|light| is_as_recorded(light, &recorded.schedule, &self.laser)) {
            self.shown.lock().recorded += 1;
            return deliveries;
        }
        tracing::warn!(trigger, "the light is not that of the record: dark images");
        self.shown.lock().other_light += 1;
        self.all_dark(light.len())
    }
}

/// Reads one trigger after the other.
struct Reader {
    recorded: RecordedRun,
    triggers: Arc<RecordedTriggers>,
    size: ImageSize,
    count_bits: u32,
}

impl Reader {
    /// Until the end of the record, or until nobody asks any more.
    fn read_all(&self, frames: &mpsc::SyncSender<anyhow::Result<Vec<Delivery>>>) {
        for trigger in (0..).map_while(|number| self.triggers.get(number)) {
            if frames.send(self.deliveries(trigger)).is_err() {
                return;
            }
        }
    }

    fn deliveries(&self, trigger: &RecordedTrigger) -> anyhow::Result<Vec<Delivery>> {
        let part = |part: &Part| match part {
            Part::Missed => Ok(Delivery::Missed),
            Part::Frames([a, b]) => Ok(Delivery::Frames([self.image(*a)?, self.image(*b)?])),
        };
        trigger.cameras.iter().map(part).collect()
    }

    fn image(&self, place: Option<Position>) -> anyhow::Result<Option<RawImage>> {
        let Some(place) = place else { return Ok(None) };
        let image = self.recorded.image(place)?;
        let size = ImageSize { columns: image.columns(), rows: image.rows() };
        anyhow::ensure!(
            size == self.size,
            "an image of {} x {} pixels among others of {} x {}",
            size.columns,
            size.rows,
            self.size.columns,
            self.size.rows
        );
        let brightest = image.counts().iter().copied().max().unwrap_or_default();
        anyhow::ensure!(
            u32::from(brightest) >> self.count_bits == 0,
            "a count of {brightest} in a run of {} bits: it cannot be sent as it is",
            self.count_bits
        );
        Ok(Some(image))
    }
}
