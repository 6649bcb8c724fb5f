//! Whether what is written to standard output reaches anybody, where the system tells (Linux): nothing else would
//! notice.
//!
//! The Rust runtime opens `/dev/null` in place of a standard output that is closed, and takes a standard output that
//! may only be read for one that was written to. Both lose a picture without an error.

use std::fs;
use std::path::Path;

/// Why a picture on standard output would be lost, and what to do; `None` if nothing speaks against it.
pub(crate) fn fault() -> Option<&'static str> {
    let description = fs::read_to_string("/proc/self/fdinfo/1").ok()?;
    match access(&description)? {
        Access::Read => Some(
            "standard output is open for reading only: redirect it to a file or a program, or give --output a name",
        ),
        // A shell opens `> /dev/null` for writing only, and that is as it was meant. The runtime opens it for both. So
        // do some programs that start others: they are told how to say that they want no picture.
        Access::Both if fs::read_link("/proc/self/fd/1").ok()? == Path::new("/dev/null") => Some(
            "standard output is closed (or /dev/null, open for reading too), and the picture would be lost: redirect \
             standard output to a file or a program, or give --output a name; with -o /dev/null no picture is kept",
        ),
        Access::Write | Access::Both => None,
    }
}

/// What an open file may be used for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Access {
    Read,
    Write,
    Both,
}

/// From the line `flags:` of a file in `/proc/self/fdinfo`, which is octal; the last two bits are the access mode.
fn access(description: &str) -> Option<Access> {
    let flags = description.lines().find_map(|line| line.strip_prefix("flags:"))?;
    match u32::from_str_radix(flags.trim(), 8).ok()? & 3 {
        0 => Some(Access::Read),
        1 => Some(Access::Write),
        2 => Some(Access::Both),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::{Access, access};

    #[test]
    fn the_access_mode_is_in_the_last_bits() {
        for (flags, expected) in [
            ("0100000", Some(Access::Read)),
            ("0102001", Some(Access::Write)),
            ("0100002", Some(Access::Both)),
            ("3", None),
            ("x", None),
        ] {
            assert_eq!(access(&format!("pos:\t0\nflags:\t{flags}\nmnt_id:\t15\n")), expected, "{flags}");
        }
        assert_eq!(access("pos:\t0\n"), None);
    }
}
