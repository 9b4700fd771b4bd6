//! `lfpiv bench`: declared cases against declared methods, in one report.

use std::{fs, path::PathBuf};

use anyhow::{Context, bail};
use lfpiv::cli::output::{count, print};
use lfpiv_bench::{
    Row, RunOptions, Suite, read_peers,
    report::{REPORT_HTML, Report, Verdict},
    run,
};

/// Arguments of `lfpiv bench`.
#[derive(Debug, clap::Args)]
pub struct BenchArgs {
    /// What to measure: cases and methods (TOML).
    #[arg(long, value_name = "FILE", default_value = "bench/report.toml")]
    pub suite: PathBuf,
    /// Folder for report.html, report.json, rows.csv and curves.csv.
    #[arg(long, value_name = "DIR", default_value = "results/bench")]
    pub out: PathBuf,
    /// Set of cases to measure; may be given several times; all when absent.
    #[arg(long = "set", value_name = "NAME")]
    pub sets: Vec<String>,
    /// Rows of other programs on the same images (JSON), to stand beside ours.
    #[arg(long, value_name = "FILE")]
    pub peers: Option<PathBuf>,
}

/// Measures every case with every method and writes the report; prints a line per row and the
/// bars at the end. A missed bar is a result, not an error; a case that cannot be measured is one,
/// after the report of the others is written.
pub fn bench(args: &BenchArgs) -> anyhow::Result<()> {
    let mut suite = Suite::load(&args.suite)?;
    suite.select(&args.sets)?;
    let peers = args.peers.as_deref().map(read_peers).transpose()?.unwrap_or_default();
    fs::create_dir_all(&args.out)
        .with_context(|| format!("cannot create {}", args.out.display()))?;
    let own = std::env::current_exe().context("cannot find this program's own file")?;
    let program = own.with_file_name("lfpiv");
    let options = RunOptions { program: &program, work: &args.out.join("work") };
    let record = run(&suite, options, &mut |row| tracing::info!("{}", line(row)))?;
    let report = Report { suite: &suite, record: &record, peers: &peers };
    report.write(&args.out)?;
    for reached in report.reached() {
        let verdict = match reached.verdict {
            Verdict::Met => "met   ",
            Verdict::Missed => "missed",
            Verdict::NotMeasured => continue,
        };
        print(&format!("{verdict} {}: {}; {}", reached.work, reached.bar, reached.measured))?;
    }
    let page = args.out.join(REPORT_HTML);
    print(&format!("{} in {}", count(record.rows.len(), "row"), page.display()))?;
    if record.failures.is_empty() {
        return Ok(());
    }
    let failed = count(record.failures.len(), "case");
    bail!("{failed} could not be measured:\n  {}", record.failures.join("\n  "))
}

/// A row in a line.
fn line(row: &Row) -> String {
    let three = |figures: [f64; 3]| figures.map(|f| format!("{f:.4}")).join(" ");
    let facts = [
        row.depth_mm.map(|depth| format!("depth {depth} mm")),
        row.seconds.map(|seconds| format!("{seconds:.3} s")),
        row.q.map(|q| format!("Q {q:.4}")),
        row.error_vox().map(|error| format!("error {} voxel", three(error))),
        row.unseen_vox().map(|e| format!("between vectors {}", three(e))),
        row.wavelength_vox.map(|wavelength| format!("wave of {wavelength:.0} voxels")),
        row.amplitude_vox.map(|amplitude| format!("amplitude {amplitude:.2}")),
        row.gain.map(|gain| format!("gain {gain:.3}")),
        row.true_windows_vox().map(|e| format!("true particles, windows only {}", three(e))),
        row.true_followed_vox().map(|e| format!("followed {}", three(e))),
        row.valid_share.map(|share| format!("{:.1} % valid", 100.0 * share)),
        row.covered_68
            .zip(row.covered_95)
            .map(|(one, two)| format!("{:.0} and {:.0} % covered", 100.0 * one, 100.0 * two)),
        particles(row),
        row.fwhm_mm.map(|width| format!("FWHM {width:.4} mm")),
        row.centroid_error_mm.map(|error| format!("centroid off by {error:.4} mm")),
        row.peak_mb.map(|peak| format!("{peak:.0} MB")),
        row.matrix_mb.map(|size| format!("matrix {size:.0} MB")),
        row.subset_matrix_mb.map(|size| format!("largest subset {size:.1} MB")),
    ];
    let facts: Vec<String> = facts.into_iter().flatten().collect();
    format!(
        "{}, {} ppm, {} camera(s), {}, seed {}: {}",
        row.case,
        row.ppm,
        row.cameras,
        row.method,
        row.seed,
        facts.join(", ")
    )
}

/// What a row says of placed particles.
fn particles(row: &Row) -> Option<String> {
    let percent = |share: Option<f64>| {
        share.map_or_else(|| "none".to_owned(), |share| format!("{:.1} %", 100.0 * share))
    };
    Some(format!(
        "particles: {} found ({} far from focus, {} near it), {} false, displacement error median \
         {:.4} mean {:.4} voxel, intervals hold {} and {}",
        percent(row.particles_found),
        percent(row.particles_found_far),
        percent(row.particles_found_near),
        percent(Some(row.particles_false?)),
        row.particles_median_error_vox?,
        row.particles_mean_error_vox?,
        percent(row.covered_68),
        percent(row.covered_95)
    ))
}
