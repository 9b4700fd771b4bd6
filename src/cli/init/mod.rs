//! `lfpiv init`: writes a commented configuration from answers about the bench.

mod questions;
mod text;

use std::{
    io::{self, BufRead, IsTerminal, Write},
    path::PathBuf,
};

use anyhow::{Context, bail};
use lfpiv_hw::gige::{FoundCamera, ImageSize, list_devices};

use self::{
    questions::{Answers, Question, questions},
    text::configuration,
};
use super::output::print;
use crate::{
    archive::write_replacing,
    config::{ConfigFile, Purpose},
};

/// Arguments of `lfpiv init`.
#[derive(Debug, clap::Args)]
pub struct InitArgs {
    /// File for the configuration; it must not exist.
    #[arg(long, value_name = "FILE", default_value = "bench.toml")]
    pub out: PathBuf,
    /// Ask nothing: keys not given with --set take their defaults.
    #[arg(long)]
    pub defaults: bool,
    /// An answer, as KEY=VALUE; `lfpiv init --defaults --set help=` lists the keys. Can be repeated.
    #[arg(long, value_name = "KEY=VALUE", value_parser = key_and_value)]
    pub set: Vec<(String, String)>,
    /// Read the sensor's size from this camera on the network, by its IP address or serial number.
    #[arg(long, value_name = "CAMERA")]
    pub camera: Option<String>,
}

/// Asks questions on standard error, reads answers from standard input, writes the file and prints
/// the next steps.
pub fn init(args: &InitArgs) -> anyhow::Result<()> {
    let out = args.out.display();
    if args.out.exists() {
        bail!("{out} exists already: choose another --out or remove it");
    }
    let questions = questions();
    let mut given = given(args, &questions)?;
    if let Some(camera) = &args.camera {
        let (sensor, address) = found(camera)?;
        given.push(("sensor_columns", sensor.columns.to_string()));
        given.push(("sensor_rows", sensor.rows.to_string()));
        given.push(("addresses", address));
    }
    let mut answers = Answers::default();
    let mut lines = io::stdin().lock().lines();
    for question in &questions {
        let answer = match given.iter().find(|(key, _)| *key == question.key) {
            Some((_, answer)) => {
                (question.check)(answer).with_context(|| format!("--set {}", question.key))?;
                answer.clone()
            }
            None if args.defaults => (question.default)(&answers)?,
            None => ask(question, &answers, &mut lines)?,
        };
        answers.set(question.key, answer);
    }
    let text = configuration(&answers)?;
    write_replacing(&args.out, |writer| writer.write_all(text.as_bytes()))?;
    // Inconsistencies are reported now, and the user can correct them in the file.
    let purpose =
        if answers.text("addresses").is_empty() { Purpose::Images } else { Purpose::Bench };
    ConfigFile::load_for(purpose, &args.out)
        .with_context(|| format!("{out} is written, but its values are not consistent yet"))?;
    print(&format!(
        "{out} is written. Next:\n  lfpiv check --config {out}     check it and see what could be \
         better\n  lfpiv plan --config {out}      the uncertainty to expect"
    ))
}

/// Answers from the command line.
fn given(args: &InitArgs, questions: &[Question]) -> anyhow::Result<Vec<(&'static str, String)>> {
    let mut given = Vec::new();
    for (key, answer) in &args.set {
        match questions.iter().find(|question| question.key == key) {
            Some(question) => given.push((question.key, answer.clone())),
            None => {
                let lines = questions.iter().map(|q| format!("\n  {:26} {}", q.key, q.text));
                bail!("{key:?} is not a key; the keys are{}", lines.collect::<String>())
            }
        }
    }
    Ok(given)
}

/// Asks until the answer is valid; an empty answer gives the default.
fn ask(
    question: &Question,
    answers: &Answers,
    lines: &mut impl Iterator<Item = io::Result<String>>,
) -> anyhow::Result<String> {
    let default = (question.default)(answers)?;
    loop {
        // On standard error, because standard output is for results.
        let mut stderr = io::stderr();
        write!(stderr, "{} [{default}]: ", question.text).context("cannot ask")?;
        stderr.flush().context("cannot ask")?;
        let Some(line) = lines.next() else {
            bail!(
                "no answer to {:?}: answer every question, or give --defaults and all other values \
                 with --set KEY=VALUE",
                question.text
            );
        };
        let line = line.context("cannot read the answer")?;
        if !io::stdin().is_terminal() {
            writeln!(stderr).context("cannot ask")?;
        }
        let answer = line.trim();
        if answer.is_empty() {
            return Ok(default);
        }
        match (question.check)(answer) {
            Ok(()) => return Ok(answer.to_owned()),
            Err(error) => writeln!(stderr, "{error:#}").context("cannot ask")?,
        }
    }
}

/// The size of a camera's sensor, and its address.
fn found(camera: &str) -> anyhow::Result<(ImageSize, String)> {
    let found = list_devices()?;
    let is_it = |found: &FoundCamera| found.address == camera || found.serial == camera;
    let Some(found) = found.into_iter().find(is_it) else {
        bail!("no camera {camera} answers: `lfpiv devices` lists the cameras that answer");
    };
    let sensor = found.sensor.with_context(|| {
        format!(
            "camera {camera} does not report its sensor's size: another program may be using it"
        )
    })?;
    Ok((sensor, found.address))
}

fn key_and_value(text: &str) -> Result<(String, String), String> {
    let (key, value) = text.split_once('=').ok_or_else(|| format!("'{text}' has no ="))?;
    Ok((key.trim().to_owned(), value.trim().to_owned()))
}
