//! `lfpiv devices`: lists the instruments.

use lfpiv_hw::gige::{Access, FoundCamera, list_devices};

use super::output::{count, print};

/// Lists the cameras that answer on the network.
pub fn devices() -> anyhow::Result<()> {
    let cameras = list_devices()?;
    if cameras.is_empty() {
        return print(
            "No GigE Vision camera answers. Check power and cable, that the camera and this \
             machine are on one subnet, and that no firewall drops UDP port 3956.",
        );
    }
    print(&format!("{} found.\n\n{}", count(cameras.len(), "camera"), table(&cameras)))
}

fn table(cameras: &[FoundCamera]) -> String {
    let head = ["vendor", "model", "serial", "address", "sensor", "state"].map(str::to_owned);
    let rows: Vec<[String; 6]> = [head].into_iter().chain(cameras.iter().map(row)).collect();
    let widths: [usize; 6] = std::array::from_fn(|column| {
        rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0)
    });
    let line = |row: &[String; 6]| {
        let cells: Vec<String> =
            row.iter().zip(widths).map(|(cell, width)| format!("{cell:<width$}")).collect();
        cells.join("  ").trim_end().to_owned()
    };
    rows.iter().map(line).collect::<Vec<String>>().join("\n")
}

fn row(camera: &FoundCamera) -> [String; 6] {
    let state = match &camera.access {
        Access::Free => "free".to_owned(),
        Access::InUse => "in use by another program".to_owned(),
        Access::Unreachable(reason) => format!("unreachable: {reason}"),
    };
    let sensor = match camera.sensor {
        Some(size) => format!("{} x {}", size.columns, size.rows),
        None => "?".to_owned(),
    };
    let FoundCamera { vendor, model, serial, address, .. } = camera.clone();
    [vendor, model, serial, address, sensor, state]
}

#[cfg(test)]
mod tests {
    use lfpiv_hw::gige::ImageSize;

    use super::*;

    #[test]
    fn columns_are_as_wide_as_their_widest_cell() {
        let camera = |serial: &str, access| FoundCamera {
            vendor: "Maker".into(),
            model: "LF-4M".into(),
            serial: serial.into(),
            address: "192.168.10.11".into(),
            sensor: matches!(access, Access::Free)
                .then_some(ImageSize { columns: 2352, rows: 1768 }),
            access,
        };
        let cameras = [
            camera("1", Access::Free),
            camera("20517", Access::Unreachable("nothing answers".into())),
        ];
        assert_eq!(
            table(&cameras),
            "vendor  model  serial  address        sensor       state\n\
             Maker   LF-4M  1       192.168.10.11  2352 x 1768  free\n\
             Maker   LF-4M  20517   192.168.10.11  ?            unreachable: nothing answers"
        );
    }
}
