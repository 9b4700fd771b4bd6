//! The model fit of each shot as variables of a velocity file.

use lfpiv_core::reconstruction::{FitVerdict, ModelFit};

use super::{
    ArchiveError,
    netcdf_file::{Described, NetCdfFile},
};

/// Meanings of `model_fit`, in the order of [`FitVerdict`].
const VERDICTS: &str = "good doubtful poor";

const VERDICT: Described = Described {
    name: "model_fit",
    units: "1",
    long_name: "how well the configured bench explains the images",
};
const UNEXPLAINED: Described = Described {
    name: "unexplained_light",
    units: "1",
    long_name: "residual of each camera's images over the standard deviation of their light, lower quartile of parts of the field",
};
const MICRO_IMAGES: Described = Described {
    name: "micro_image_offset",
    units: "1",
    long_name: "largest distance of a micro-image from its configured place, in pixels",
};
const AGREEMENT: Described = Described {
    name: "camera_agreement",
    units: "1",
    long_name: "correlation of the cameras' light along the direction that both see",
};
const DISPARITY: Described = Described {
    name: "camera_disparity",
    units: "mm",
    long_name: "root-mean-square distance between the places at which the cameras put particles",
};
const VALID_SHARE: Described = Described {
    name: "valid_share",
    units: "1",
    long_name: "share of the windows with particles that gave valid vectors, before the verdict",
};

/// Defines the variables in a file whose record dimension is `shot`, for fits like `fit`.
pub(super) fn define(file: &mut NetCdfFile, fit: &ModelFit) -> Result<(), ArchiveError> {
    file.add_dimension("camera", fit.cameras.len())?;
    file.add_flag(&VERDICT, &["shot"], VERDICTS)?;
    for described in [&UNEXPLAINED, &MICRO_IMAGES] {
        file.add::<f64>(described, &["shot", "camera"])?;
    }
    for described in [&AGREEMENT, &DISPARITY, &VALID_SHARE] {
        file.add::<f64>(described, &["shot"])?;
    }
    for described in [&MICRO_IMAGES, &AGREEMENT, &DISPARITY] {
        file.put_fill_value(described.name, f64::NAN)?;
    }
    Ok(())
}

/// Writes the fit of record `record`; missing numbers become the fill value.
pub(super) fn put(
    file: &mut NetCdfFile,
    record: usize,
    fit: &ModelFit,
) -> Result<(), ArchiveError> {
    let verdict = match fit.verdict {
        FitVerdict::Good => 0i8,
        FitVerdict::Doubtful => 1,
        FitVerdict::Poor => 2,
    };
    let offsets = fit.cameras.iter().map(|camera| camera.micro_image_offset_px);
    let or_fill = |value: Option<f64>| value.unwrap_or(f64::NAN);
    let unexplained: Vec<f64> = fit.cameras.iter().map(|camera| camera.unexplained).collect();
    file.put_record(VERDICT.name, record, &[verdict])?;
    file.put_record(UNEXPLAINED.name, record, &unexplained)?;
    file.put_record(MICRO_IMAGES.name, record, &offsets.map(or_fill).collect::<Vec<_>>())?;
    file.put_record(AGREEMENT.name, record, &[or_fill(fit.camera_agreement)])?;
    file.put_record(DISPARITY.name, record, &[or_fill(fit.camera_disparity_mm)])?;
    file.put_record(VALID_SHARE.name, record, &[fit.valid_share])
}

#[cfg(test)]
mod tests {
    use crate::archive::{test_data::result, write_velocity};
    use lfpiv_core::reconstruction::{CameraFit, FitVerdict, ModelFit};

    #[test]
    fn a_fit_is_stored_per_shot_and_camera() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("velocity.nc");
        let mut result = result([4, 3, 2]);
        let camera = |unexplained| CameraFit { unexplained, micro_image_offset_px: Some(0.25) };
        result.measured.fit = Some(ModelFit {
            verdict: FitVerdict::Doubtful,
            cameras: vec![camera(0.25), camera(0.5)],
            camera_agreement: None,
            camera_disparity_mm: Some(0.07),
            valid_share: 0.75,
            causes: Vec::new(),
        });
        write_velocity(&path, "", 7, &result).unwrap();
        let file = netcdf::open(&path).unwrap();
        let numbers = |name: &str| file.variable(name).unwrap().get_values::<f64, _>(..).unwrap();
        assert_eq!(numbers("model_fit"), [1.0]);
        assert_eq!(numbers("unexplained_light"), [0.25, 0.5]);
        assert_eq!(numbers("micro_image_offset"), [0.25, 0.25]);
        assert_eq!(numbers("camera_disparity"), [0.07]);
        assert_eq!(numbers("valid_share"), [0.75]);
        assert!(numbers("camera_agreement")[0].is_nan());
        let fill = file.variable("camera_agreement").unwrap().attribute_value("_FillValue");
        assert!(fill.is_some());
    }
}
