//! What README says, held against what was measured.

use super::{
    super::{Report, tables::mean_of_components, text::number},
    Reached, Verdict,
};
use crate::{Case, Claim, Row};

/// A row for every claim of the suite's cases.
pub(super) fn claims(report: &Report) -> Vec<Reached> {
    let of_case = |case: &Case| -> Vec<Reached> {
        case.claims.iter().map(|claim| reached(case, claim, &rows(report, case, claim))).collect()
    };
    report.suite.cases.iter().flat_map(of_case).collect()
}

/// The rows that a claim is about: two cameras, the case's first method, every seed.
fn rows<'a>(report: &Report<'a>, case: &Case, claim: &Claim) -> Vec<&'a Row> {
    let of_claim = |row: &&Row| {
        row.case == case.name
            && row.ppm == claim.ppm
            && row.cameras == 2
            && case.methods.first().is_none_or(|method| row.method == *method)
    };
    report.record.rows.iter().filter(of_claim).collect()
}

/// Means over the rows against what is claimed, component by component.
fn reached(case: &Case, claim: &Claim, rows: &[&Row]) -> Reached {
    let claimed = [claim.error_vox, claim.true_windows_vox, claim.true_followed_vox];
    let figures = [Row::error_vox, Row::true_windows_vox, Row::true_followed_vox];
    let measured = figures.map(|figure| mean_of_components(rows, figure));
    let (verdict, words) = match measured {
        [Some(images), Some(windows), Some(followed)] => {
            let found = [images, windows, followed];
            let mut pairs = found.as_flattened().iter().zip(claimed.as_flattened());
            let holds = |(found, claimed): (&f64, &f64)| *found <= Claim::MARGIN * claimed;
            let verdict = if pairs.all(holds) { Verdict::Met } else { Verdict::Missed };
            (verdict, in_words(found))
        }
        _ => (Verdict::NotMeasured, String::new()),
    };
    Reached {
        work: format!("README: {} at {} ppm, mean |error| along x, y, z", case.name, claim.ppm),
        bar: format!("≤ {} × {}", Claim::MARGIN, in_words(claimed)),
        measured: words,
        verdict,
    }
}

fn in_words(figures: [[f64; 3]; 3]) -> String {
    let [images, windows, followed] = figures.map(|figures| figures.map(number).join(", "));
    format!("{images} voxel; true particles, windows only {windows}; followed {followed}")
}

#[cfg(test)]
mod tests {
    use super::*;

    const CASE: &str = "name = 'a'\nset = 's'\nmeasure = 'velocity'\nconfig = 'a.toml'\n[[claim]]\n\
                        ppm = 1.0\nerror_vox = [0.01, 0.01, 0.02]\n\
                        true_windows_vox = [0.02, 0.02, 0.02]\n\
                        true_followed_vox = [0.001, 0.001, 0.001]\n";

    fn row(error_vox: [f64; 3], followed_vox: f64) -> Row {
        let mut row = Row { case: "a".to_owned(), ppm: 1.0, cameras: 2, ..Row::default() };
        row.set_error(error_vox);
        row.set_true_windows([0.02; 3]);
        row.set_true_followed([followed_vox; 3]);
        row
    }

    fn verdict(rows: &[Row]) -> Verdict {
        let case: Case = toml::from_str(CASE).unwrap();
        let rows: Vec<&Row> = rows.iter().collect();
        reached(&case, &case.claims[0], &rows).verdict
    }

    #[test]
    fn a_claim_holds_to_a_margin_in_every_component_and_figure() {
        assert_eq!(verdict(&[row([0.012, 0.009, 0.025], 0.001)]), Verdict::Met);
        assert_eq!(verdict(&[row([0.009, 0.014, 0.01], 0.001)]), Verdict::Missed);
        assert_eq!(verdict(&[row([0.01, 0.01, 0.02], 0.002)]), Verdict::Missed);
        // The mean over the seeds counts.
        assert_eq!(verdict(&[row([0.014; 3], 0.001), row([0.010; 3], 0.001)]), Verdict::Met);
        assert_eq!(verdict(&[]), Verdict::NotMeasured);
    }
}
