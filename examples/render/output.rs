//! Where pictures go. Every file is opened before anything is traced, and left as it was until a picture is there; one
//! that was not there is made again then, so that a program that is interrupted leaves no empty file.

use crate::files;
use crate::image::{Format, Image};
use crate::standard;
use std::error::Error;
use std::ffi::{OsStr, OsString};
use std::fs::{self, File, OpenOptions};
use std::io::{self, BufWriter, IsTerminal};
use std::path::{Path, PathBuf};

/// A place for pictures, as `--output` names it.
#[derive(Debug, PartialEq, Eq)]
enum Place {
    StandardOutput,
    /// A terminal, a pipe or the like: what is written there is no file.
    Device(PathBuf),
    Files {
        folder: PathBuf,
        stem: OsString,
        /// Each with the suffix of its file.
        formats: Vec<(Format, OsString)>,
    },
}

impl Place {
    fn new(output: Option<&Path>, scene: &str) -> Result<Self, String> {
        let both = || vec![(Format::Ppm, "ppm".into()), (Format::Png, "png".into())];
        let inside = |folder: &Path| Self::Files { folder: folder.into(), stem: scene.into(), formats: both() };
        let Some(output) = output else { return Ok(inside(Path::new("out"))) };
        if ["-", "/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"].iter().any(|name| output == Path::new(name)) {
            return Ok(Self::StandardOutput);
        }
        let named_as_folder = output.as_os_str().as_encoded_bytes().last().is_some_and(|last| is_separator(*last));
        let Some(name) = output.file_name().filter(|_| !named_as_folder && !output.is_dir()) else {
            return Ok(inside(output));
        };
        if output.exists() && !output.is_file() {
            return Ok(Self::Device(output.into()));
        }
        let folder = output.parent().unwrap_or(Path::new("")).to_owned();
        // A name that is nothing but a suffix has none for the standard library.
        let all_suffix = name.as_encoded_bytes().strip_prefix(b".").and_then(|_| name.to_str()).map(|name| &name[1..]);
        if let Some((suffix, format)) = all_suffix.and_then(|suffix| Some((suffix, format_of(OsStr::new(suffix))?))) {
            return Ok(Self::Files { folder, stem: "".into(), formats: vec![(format, suffix.into())] });
        }
        let (stem, formats) = match output.extension() {
            None => (name, both()),
            Some(suffix) => {
                let format = format_of(suffix).ok_or_else(|| {
                    format!(
                        "cannot write {}: pictures are PNG or PPM; end the name in .png or .ppm, or leave the suffix \
                         away for both",
                        output.display()
                    )
                })?;
                (output.file_stem().unwrap_or(name), vec![(format, suffix.into())])
            }
        };
        Ok(Self::Files { folder, stem: stem.into(), formats })
    }
}

fn is_separator(byte: u8) -> bool {
    std::path::is_separator(char::from(byte))
}

fn format_of(suffix: &OsStr) -> Option<Format> {
    match suffix.to_str()?.to_ascii_lowercase().as_str() {
        "ppm" => Some(Format::Ppm),
        "png" => Some(Format::Png),
        _ => None,
    }
}

/// One file.
#[derive(Debug)]
struct Target {
    path: PathBuf,
    format: Format,
    /// Open if it was there.
    file: Option<File>,
}

/// The places of one or several pictures, open for writing.
#[derive(Debug)]
pub(crate) struct Output {
    /// For each picture, its files; none if it goes to standard output.
    targets: Vec<Vec<Target>>,
    /// Folders that were made for them, to be removed if they stay empty.
    folders: Vec<PathBuf>,
}

impl Output {
    /// True if a picture goes to standard output.
    pub(crate) fn is_standard(&self) -> bool {
        self.targets.iter().any(Vec::is_empty)
    }

    /// Opens the files of pictures with these labels behind their names.
    ///
    /// `output` is as the user gave it; without it they are `out/<scene>`.
    pub(crate) fn open(output: Option<&Path>, scene: &str, labels: &[String]) -> Result<Self, Box<dyn Error>> {
        let place = Place::new(output, scene)?;
        let mut opened = Self { targets: Vec::new(), folders: Vec::new() };
        if place == Place::StandardOutput {
            if labels.len() > 1 {
                return Err(
                    "standard output holds one picture, and --compare writes three: give --output a name".into()
                );
            }
            if io::stdout().is_terminal() {
                return Err(
                    "a picture would garble the terminal: redirect standard output, or give --output a name".into()
                );
            }
            if let Some(fault) = standard::fault() {
                return Err(fault.into());
            }
        }
        for (index, label) in labels.iter().enumerate() {
            opened.targets.push(Vec::new());
            match &place {
                Place::StandardOutput => {}
                Place::Device(path) => opened.targets[index].push(Target::open(path, Format::Ppm)?),
                Place::Files { folder, stem, formats } => {
                    opened.create(folder)?;
                    for (format, suffix) in formats {
                        let path = folder.join(file_name(stem, label, suffix));
                        opened.targets[index].push(Target::open(&path, *format)?);
                    }
                }
            }
        }
        Ok(opened)
    }

    /// Makes a folder and those that it lies in, and remembers which are new.
    fn create(&mut self, folder: &Path) -> Result<(), String> {
        let missing = folder.ancestors().take_while(|folder| !folder.as_os_str().is_empty() && !folder.exists());
        let missing: Vec<_> = missing.map(Path::to_owned).collect();
        if !missing.is_empty() {
            fs::create_dir_all(folder).map_err(|error| {
                format!("cannot make the folder {}: {error}; {}", folder.display(), files::instead(&error))
            })?;
        }
        self.folders.extend(missing);
        Ok(())
    }

    /// Writes the picture whose label was the first, then the second and so on, and returns its names for a message.
    /// One file that cannot be written does not keep another from being written.
    pub(crate) fn write(&mut self, index: usize, image: &Image) -> Result<String, Box<dyn Error>> {
        let targets = &mut self.targets[index];
        if targets.is_empty() {
            return match image.write(Format::Ppm, &mut BufWriter::new(io::stdout().lock())) {
                Ok(()) => Ok("standard output".into()),
                Err(error) => {
                    let instead = files::instead(&error);
                    Err(format!("cannot write the picture to standard output: {error}; {instead}").into())
                }
            };
        }
        let (mut names, mut failure) = (Vec::new(), None);
        for target in targets {
            match target.write(image) {
                Ok(()) => names.push(target.path.display().to_string()),
                Err(error) => failure = failure.or_else(|| Some(unwritten(&target.path, &error))),
            }
        }
        failure.map_or_else(|| Ok(names.join(", ")), |failure| Err(failure.into()))
    }
}

impl Drop for Output {
    fn drop(&mut self) {
        for folder in &self.folders {
            let _ = fs::remove_dir(folder);
        }
    }
}

impl Target {
    fn open(path: &Path, format: Format) -> Result<Self, String> {
        let is_new = !path.exists();
        let mut file = Some(opened(path).map_err(|error| unwritten(path, &error))?);
        if is_new {
            file = None;
            let _ = fs::remove_file(path);
        }
        Ok(Self { path: path.to_owned(), format, file })
    }

    fn write(&mut self, image: &Image) -> io::Result<()> {
        let file = self.file.take().map_or_else(|| opened(&self.path), Ok)?;
        if file.metadata()?.is_file() {
            file.set_len(0)?;
        }
        image.write(self.format, &mut BufWriter::new(&file))
    }
}

fn opened(path: &Path) -> io::Result<File> {
    OpenOptions::new().write(true).create(true).truncate(false).open(path)
}

fn unwritten(path: &Path, error: &io::Error) -> String {
    format!("cannot write {}: {error}; {}", path.display(), files::instead(error))
}

fn file_name(stem: &OsStr, label: &str, suffix: &OsStr) -> OsString {
    // A name that began with the hyphen of its label would look like an option.
    let label = if stem.is_empty() { label.trim_start_matches('-') } else { label };
    let mut name = stem.to_owned();
    name.push(label);
    name.push(".");
    name.push(suffix);
    name
}
