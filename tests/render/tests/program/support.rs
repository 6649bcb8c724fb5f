//! The program in a folder of its own, and what it says.

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::sync::atomic::{AtomicU32, Ordering};
use std::thread;
use std::time::{Duration, Instant};

/// A camera that looks at the origin along -z, a light, a material.
pub(crate) const VIEW: &str = "v from 0 0 5 at 0 0 0 up 0 1 0 angle 45 resolution 8 6\n";
pub(crate) const LIGHT: &str = "l 3 4 5\n";
pub(crate) const BALL: &str = "f 1 1 1 1 0 1 0 1\ns 0 0 0 1\n";

/// The smallest scene that shows something.
pub(crate) fn ball() -> String {
    format!("{VIEW}{LIGHT}{BALL}")
}

/// The example, which cargo builds beside the folder of its tests.
fn program() -> PathBuf {
    let tests = std::env::current_exe().unwrap();
    let program = tests.parent().and_then(Path::parent).unwrap().join("examples").join("render");
    program.with_extension(std::env::consts::EXE_EXTENSION)
}

/// An empty folder, removed at the end.
pub(crate) struct Folder(PathBuf);

impl Folder {
    pub(crate) fn new() -> Self {
        static NUMBER: AtomicU32 = AtomicU32::new(0);
        let number = NUMBER.fetch_add(1, Ordering::Relaxed);
        let path = std::env::temp_dir().join(format!("raylet-render-{}-{number}", std::process::id()));
        fs::create_dir_all(&path).unwrap();
        Self(path)
    }

    /// A folder with a scene in it, `scene.nff`.
    pub(crate) fn with(scene: impl AsRef<[u8]>) -> Self {
        let folder = Self::new();
        fs::write(folder.path("scene.nff"), scene).unwrap();
        folder
    }

    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.0.join(name)
    }

    /// All files below, by name.
    pub(crate) fn files(&self) -> Vec<String> {
        fn below(folder: &Path, prefix: &str, files: &mut Vec<String>) {
            for entry in fs::read_dir(folder).unwrap().map(Result::unwrap) {
                let name = format!("{prefix}{}", entry.file_name().to_str().unwrap());
                if entry.file_type().unwrap().is_dir() {
                    files.push(format!("{name}/"));
                    below(&entry.path(), &format!("{name}/"), files);
                } else {
                    files.push(name);
                }
            }
        }
        let mut files = Vec::new();
        below(&self.0, "", &mut files);
        files.sort();
        files
    }

    pub(crate) fn command(&self, arguments: &str) -> Command {
        let mut command = Command::new(program());
        command.current_dir(&self.0).args(arguments.split_whitespace());
        command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
        command
    }

    /// Runs the program with these arguments, for less than a minute.
    pub(crate) fn run(&self, arguments: &str) -> Said {
        let mut child = self.command(arguments).spawn().unwrap();
        let start = Instant::now();
        while child.try_wait().unwrap().is_none() {
            if start.elapsed() > Duration::from_secs(50) {
                child.kill().unwrap();
                panic!("it takes far too long: {arguments}");
            }
            thread::sleep(Duration::from_millis(2));
        }
        Said::of(&child.wait_with_output().unwrap())
    }

    /// Runs a line of the shell, in which `$render` is the program.
    pub(crate) fn shell(&self, line: &str) -> Said {
        let mut shell = Command::new("sh");
        shell.args(["-c", line]).env("render", program()).current_dir(&self.0);
        Said::of(&shell.output().unwrap())
    }

    /// Runs the program with a text on standard input.
    pub(crate) fn run_with_input(&self, arguments: &str, input: &[u8]) -> Said {
        let mut child = self.command(arguments).stdin(Stdio::piped()).spawn().unwrap();
        // A program that stops reading is no reason to fail here.
        let _ = child.stdin.take().unwrap().write_all(input);
        Said::of(&child.wait_with_output().unwrap())
    }

    pub(crate) fn read(&self, name: &str) -> Vec<u8> {
        fs::read(self.path(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
    }

    /// The pixels of a PPM.
    pub(crate) fn pixels(&self, name: &str) -> Vec<[u8; 3]> {
        pixels(&self.read(name))
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

/// The pixels of a PPM as the program writes it.
pub(crate) fn pixels(ppm: &[u8]) -> Vec<[u8; 3]> {
    let mut lines = ppm.splitn(4, |byte| *byte == b'\n');
    assert_eq!(lines.next(), Some(&b"P6"[..]));
    let size = String::from_utf8(lines.next().unwrap().to_vec()).unwrap();
    assert_eq!(lines.next(), Some(&b"255"[..]));
    let pixels = lines.next().unwrap().as_chunks::<3>().0.to_vec();
    let sides = size.split(' ').map(|side| side.parse::<usize>().unwrap());
    assert_eq!(pixels.len(), sides.product(), "{size}");
    pixels
}

/// What the program said, and whether it succeeded.
#[derive(Debug)]
pub(crate) struct Said {
    pub(crate) code: Option<i32>,
    pub(crate) output: String,
    pub(crate) error: String,
}

impl Said {
    fn of(output: &Output) -> Self {
        let error = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(!error.contains("panicked"), "{error}");
        Self { code: output.status.code(), output: String::from_utf8_lossy(&output.stdout).into_owned(), error }
    }

    /// It did what the options say.
    #[track_caller]
    pub(crate) fn succeeds(self) -> Self {
        assert_eq!(self.code, Some(0), "{self:?}");
        self
    }

    /// It did what the options say, and saw nothing odd.
    #[track_caller]
    pub(crate) fn succeeds_silently(self) -> Self {
        assert_eq!((self.code, self.error.as_str()), (Some(0), ""), "{self:?}");
        self
    }

    /// It failed for this reason, and said nothing else.
    #[track_caller]
    pub(crate) fn fails(self, reason: &str) -> Self {
        assert_eq!((self.code, self.error.trim_end()), (Some(1), format!("error: {reason}").as_str()), "{self:?}");
        self
    }

    /// Its warnings.
    pub(crate) fn warnings(&self) -> Vec<&str> {
        self.error.lines().filter_map(|line| line.strip_prefix("warning: ")).collect()
    }
}
