//! A picture in memory, and on disk as PPM and PNG.

use std::error::Error;
use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

/// Eight bits a channel, row after row from the upper left.
#[derive(Clone, Debug)]
pub(crate) struct Image {
    pub(crate) width: u16,
    pub(crate) height: u16,
    pub(crate) pixels: Vec<[u8; 3]>,
}

impl Image {
    pub(crate) fn black(width: u16, height: u16) -> Self {
        Self { width, height, pixels: vec![[0; 3]; usize::from(width) * usize::from(height)] }
    }

    /// Portable pixmap, binary ("P6").
    fn write_ppm(&self, mut to: impl Write) -> io::Result<()> {
        write!(to, "P6\n{} {}\n255\n", self.width, self.height)?;
        to.write_all(self.pixels.as_flattened())?;
        to.flush()
    }

    fn write_png(&self, to: impl Write) -> Result<(), png::EncodingError> {
        let mut encoder = png::Encoder::new(to, u32::from(self.width), u32::from(self.height));
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        let mut writer = encoder.write_header()?;
        writer.write_image_data(self.pixels.as_flattened())?;
        writer.finish()
    }
}

/// The files that a picture goes to.
#[derive(Debug)]
pub(crate) struct Files {
    ppm: Option<PathBuf>,
    png: Option<PathBuf>,
}

impl Files {
    /// `output` as the user gave it, or `out/<scene>`; `label` goes behind the name, before the extension.
    pub(crate) fn new(output: Option<&Path>, scene: &str, label: &str) -> Self {
        let default = Path::new("out").join(scene);
        let output = output.unwrap_or(&default);
        let extension = output.extension().and_then(|extension| extension.to_str()).map(str::to_ascii_lowercase);
        let (ppm, png) = match extension.as_deref() {
            Some("ppm") => (true, false),
            Some("png") => (false, true),
            _ => (true, true),
        };
        let stem = if ppm && png { output.to_owned() } else { output.with_extension("") };
        let file = |extension: &str| {
            let mut name = stem.clone().into_os_string();
            name.push(format!("{label}.{extension}"));
            PathBuf::from(name)
        };
        Self { ppm: ppm.then(|| file("ppm")), png: png.then(|| file("png")) }
    }

    /// Writes the picture, creating folders on the way, and returns the names for a message.
    pub(crate) fn write(&self, image: &Image) -> Result<String, Box<dyn Error>> {
        let mut names = Vec::new();
        for path in [&self.ppm, &self.png].into_iter().flatten() {
            self.write_one(image, path).map_err(|error| format!("cannot write {}: {error}", path.display()))?;
            names.push(path.display().to_string());
        }
        Ok(names.join(", "))
    }

    fn write_one(&self, image: &Image, path: &Path) -> Result<(), Box<dyn Error>> {
        if let Some(folder) = path.parent() {
            fs::create_dir_all(folder)?;
        }
        let file = BufWriter::new(File::create(path)?);
        if self.ppm.as_deref() == Some(path) {
            image.write_ppm(file)?;
        } else {
            image.write_png(file)?;
        }
        Ok(())
    }
}
