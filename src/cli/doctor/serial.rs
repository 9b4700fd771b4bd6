//! Checks whether the synchroniser's serial port exists and is accessible. It is not opened,
//! because that could disturb a working unit.

use std::{
    fs, io,
    os::unix::fs::{FileTypeExt, MetadataExt},
    path::Path,
};

use rustix::fs::{Access, AtFlags, CWD, accessat};

use super::Finding;

const CHECK: &str = "serial port";

/// Checks the port.
pub fn examine(port: &Path) -> Finding {
    let name = port.display();
    let metadata = match fs::metadata(port) {
        Ok(metadata) => metadata,
        Err(error) => return unreachable(port, &error),
    };
    if !metadata.file_type().is_char_device() {
        return Finding::problem(
            CHECK,
            format!("{name} is not a serial port but a file of another kind"),
            "correct instruments.synchroniser.port; ls /dev/serial/by-id shows ports",
        );
    }
    match accessat(CWD, port, Access::READ_OK | Access::WRITE_OK, AtFlags::EACCESS) {
        Ok(()) => Finding::ok(CHECK, format!("{name} exists and is accessible")),
        Err(error) => {
            let group = group_name(metadata.gid());
            Finding::problem(
                CHECK,
                format!("{name} is not accessible to this user: {error}"),
                format!("sudo adduser \"$USER\" {group}, then log in again"),
            )
        }
    }
}

fn unreachable(port: &Path, error: &io::Error) -> Finding {
    let name = port.display();
    let found = format!("{name}: {error}");
    let missing = error.kind() == io::ErrorKind::NotFound;
    let todo = if missing && fs::symlink_metadata(port).is_ok() {
        "the link leads nowhere: the program that creates the port is not running"
    } else if missing {
        "plug in the adapter, find its name in /dev/serial/by-id and correct \
         instruments.synchroniser.port"
    } else {
        "give this user access to the folder"
    };
    Finding::problem(CHECK, found, todo)
}

/// The group's name, or its number if it has none.
fn group_name(gid: u32) -> String {
    let groups = fs::read_to_string("/etc/group").unwrap_or_default();
    let named = groups.lines().find_map(|line| {
        let mut fields = line.split(':');
        let name = fields.next()?;
        (fields.nth(1)?.parse() == Ok(gid)).then(|| name.to_owned())
    });
    named.unwrap_or_else(|| gid.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cli::doctor::Verdict;

    #[test]
    fn groups_have_names() {
        assert_eq!(group_name(0), "root");
        assert_eq!(group_name(4_123_456_789), "4123456789");
    }

    #[test]
    fn a_port_is_an_existing_character_device() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("ttyUSB0");
        assert!(examine(&path).advice.unwrap().contains("plug in the adapter"));
        std::os::unix::fs::symlink("/nowhere/at/all", &path).unwrap();
        assert!(examine(&path).advice.unwrap().contains("link leads nowhere"));
        let file = folder.path().join("file");
        fs::write(&file, "").unwrap();
        assert!(examine(&file).found.contains("another kind"));
        assert_eq!(examine(Path::new("/dev/null")).verdict, Verdict::Ok);
    }
}
