//! What is said, and to whom. A listener who has left is no reason to fail, and none to panic, as `println!` would.

use std::error::Error;
use std::fmt::Display;
use std::io::{self, ErrorKind, Write};

/// Where the report goes: to standard output, or to standard error if the picture goes there.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Console {
    pub(crate) picture_on_standard_output: bool,
}

impl Console {
    /// Writes some lines of the report.
    ///
    /// A pipe whose reader has closed it is content. Any other failure is an error: the report is not where it should
    /// be.
    pub(crate) fn say(self, text: &str) -> Result<(), Box<dyn Error>> {
        let (said, name) = if self.picture_on_standard_output {
            (write_all(io::stderr().lock(), text), "standard error")
        } else {
            (write_all(io::stdout().lock(), text), "standard output")
        };
        match said {
            Err(error) if error.kind() != ErrorKind::BrokenPipe => Err(format!(
                "cannot write the report to {name}: {error}; the picture is written: send {name} somewhere else to \
                 read of it"
            )
            .into()),
            _ => Ok(()),
        }
    }
}

fn write_all(mut to: impl Write, text: &str) -> io::Result<()> {
    to.write_all(text.as_bytes())?;
    to.flush()
}

/// Says on standard error what whoever looks at the picture should know.
pub(crate) fn warn(warning: impl Display) {
    let _ = write_all(io::stderr().lock(), &format!("warning: {warning}\n"));
}

/// Says on standard error why the program fails.
pub(crate) fn fail(error: impl Display) {
    let _ = write_all(io::stderr().lock(), &format!("error: {error}\n"));
}
