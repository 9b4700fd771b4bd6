//! Checks the server's address and its token file.

use std::{
    fs,
    io::{self, Read, Write},
    net::{SocketAddr, TcpListener, TcpStream},
    os::unix::fs::{MetadataExt, PermissionsExt},
    path::{Path, PathBuf},
    time::Duration,
};

use rustix::process::geteuid;

use super::Finding;

/// How long to wait for an answer.
const PATIENCE: Duration = Duration::from_secs(1);
/// Mode bits that give other users access to a file.
const OTHERS: u32 = 0o077;

/// Whether the address is free, and which program uses it otherwise.
pub fn address(address: SocketAddr) -> Finding {
    const CHECK: &str = "address";
    match TcpListener::bind(address) {
        Ok(_) => Finding::ok(CHECK, format!("{address} is free")),
        Err(error) if error.kind() == io::ErrorKind::AddrInUse => {
            if is_lfpiv(address) {
                let found = format!("another lfpiv runs at {address}");
                Finding::advice(CHECK, found, "stop it before the next run")
            } else {
                let found = format!("another program uses {address}");
                Finding::problem(CHECK, found, "stop it, or change server.address")
            }
        }
        Err(error) => {
            let found = format!("{address} cannot be used: {error}");
            Finding::problem(CHECK, found, "set server.address to an address of this machine")
        }
    }
}

/// Whether the listening program answers like lfpiv, possibly by asking for a token.
fn is_lfpiv(address: SocketAddr) -> bool {
    let ask = || -> io::Result<String> {
        let mut stream = TcpStream::connect_timeout(&address, PATIENCE)?;
        stream.set_read_timeout(Some(PATIENCE))?;
        stream.set_write_timeout(Some(PATIENCE))?;
        let request =
            format!("GET /api/v1/status HTTP/1.1\r\nHost: {address}\r\nConnection: close\r\n\r\n");
        stream.write_all(request.as_bytes())?;
        let mut answer = String::new();
        stream.take(1 << 16).read_to_string(&mut answer)?;
        Ok(answer)
    };
    ask().is_ok_and(|answer| answer.contains("code_version") || answer.contains("lfpiv"))
}

/// Checks the token file, if the configuration names one: no other user may read it.
pub fn tokens(configuration: &str) -> Option<Finding> {
    const CHECK: &str = "tokens";
    let path = tokens_file(configuration)?;
    let name = path.display();
    let (mode, owner) = match fs::metadata(&path) {
        Ok(metadata) => (metadata.permissions().mode() & 0o777, metadata.uid()),
        Err(error) => {
            let found = format!("{name}: {error}");
            return Some(Finding::problem(
                CHECK,
                found,
                "create the file or correct server.tokens",
            ));
        }
    };
    let found = format!("{name} has mode {mode:04o}");
    let user = geteuid().as_raw();
    if owner != user && owner != 0 {
        let found = format!("{name} belongs to user {owner}");
        return Some(Finding::problem(CHECK, found, format!("chown {user} {name}")));
    }
    Some(if mode & OTHERS == 0 {
        Finding::ok(CHECK, found)
    } else {
        Finding::problem(CHECK, format!("{found}: others can read it"), format!("chmod 600 {name}"))
    })
}

/// `tokens` of the `[server]` table.
fn tokens_file(configuration: &str) -> Option<PathBuf> {
    let table: toml::Table = configuration.parse().ok()?;
    let path = table.get("server")?.get("tokens")?.as_str()?;
    Some(Path::new(path).to_owned())
}

#[cfg(test)]
mod tests {
    use std::thread;

    use super::*;
    use crate::cli::doctor::Verdict;

    #[test]
    fn only_the_owner_may_read_tokens() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("tokens");
        let text = format!("[server]\ntokens = \"{}\"\n", path.display());
        assert_eq!(tokens("[server]\naddress = '127.0.0.1:1'"), None);
        assert_eq!(tokens(&text).unwrap().verdict, Verdict::Problem, "the file is missing");
        fs::write(&path, "read abc\n").unwrap();
        for (mode, verdict) in [(0o640, Verdict::Problem), (0o600, Verdict::Ok)] {
            fs::set_permissions(&path, fs::Permissions::from_mode(mode)).unwrap();
            assert_eq!(tokens(&text).unwrap().verdict, verdict, "{mode:o}");
        }
    }

    #[test]
    fn the_program_at_the_address_is_identified() {
        for (answer, verdict) in [
            ("HTTP/1.1 200 OK\r\n\r\n{\"code_version\":\"0.1.0\"}", Verdict::Advice),
            ("220 mail ready\r\n", Verdict::Problem),
        ] {
            let listener = TcpListener::bind("127.0.0.1:0").unwrap();
            let there = listener.local_addr().unwrap();
            let other = thread::spawn(move || {
                let (mut stream, _) = listener.accept().unwrap();
                assert!(stream.read(&mut [0; 512]).unwrap() > 0);
                stream.write_all(answer.as_bytes()).unwrap();
                listener
            });
            assert_eq!(address(there).verdict, verdict, "{answer}");
            drop(other.join().unwrap());
            assert_eq!(address(there).verdict, Verdict::Ok);
        }
    }
}
