//! What was compared, and on what: versions, commit, compiler, processor.

use std::path::{Path, PathBuf};
use std::process::Command;

/// The contestants' crates.
const CRATES: [&str; 4] = ["raylet", "parry3d", "parry3d-f64", "embedded-3dgfx"];

/// What a reader needs to know to measure the same.
pub struct Environment {
    /// Crates and their versions, as the lock file has them.
    pub versions: Vec<(&'static str, String)>,
    /// The commit of this repository, and whether files differ from it.
    pub commit: String,
    pub compiler: String,
    pub processor: String,
    /// Whether embedded-3dgfx has the standard library's square roots, or `micromath`'s.
    pub has_exact_roots: bool,
}

impl Environment {
    /// Looks everything up.
    ///
    /// # Errors
    ///
    /// If the lock file cannot be read or does not name a contestant.
    pub fn read() -> Result<Self, String> {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("Cargo.lock");
        let lock =
            std::fs::read_to_string(&path).map_err(|error| format!("{} cannot be read: {error}", path.display()))?;
        let version =
            |name| version_in(&lock, name).ok_or_else(|| format!("{} does not name the crate {name}", path.display()));
        let versions: Result<Vec<_>, String> = CRATES.into_iter().map(|name| Ok((name, version(name)?))).collect();
        Ok(Self {
            versions: versions?,
            commit: commit(),
            compiler: said_by(Command::new("rustc").arg("--version")),
            processor: processor(),
            has_exact_roots: crate::embedded_3dgfx_rays::has_exact_roots(),
        })
    }

    /// The version of a contestant's crate.
    pub fn version(&self, name: &str) -> &str {
        self.versions.iter().find(|(known, _)| *known == name).map_or("?", |(_, version)| version)
    }
}

/// The directory of the repository.
pub fn root() -> PathBuf {
    let package = Path::new(env!("CARGO_MANIFEST_DIR"));
    package.ancestors().nth(2).unwrap_or(package).to_path_buf()
}

fn version_in(lock: &str, name: &str) -> Option<String> {
    let (_, after) = lock.split_once(&format!("name = \"{name}\"\nversion = \""))?;
    after.split_once('"').map(|(version, _)| version.to_owned())
}

fn commit() -> String {
    let git = |arguments: &[&str]| said_by(Command::new("git").arg("-C").arg(root()).args(arguments));
    let changed = git(&["status", "--porcelain", "--", "src", "tools/peers", "Cargo.toml"]);
    let commit = git(&["rev-parse", "--short=12", "HEAD"]);
    if changed.is_empty() { commit } else { format!("{commit}, with changes") }
}

/// What a program prints, or why it does not.
fn said_by(command: &mut Command) -> String {
    match command.output() {
        Ok(output) if output.status.success() => String::from_utf8_lossy(&output.stdout).trim().to_owned(),
        Ok(output) => format!("unknown ({command:?} ended with {})", output.status),
        Err(error) => format!("unknown ({command:?}: {error})"),
    }
}

fn processor() -> String {
    let told = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model = told.lines().find_map(|line| line.strip_prefix("model name")?.split_once(':'));
    let model = model.map_or("unknown", |(_, model)| model.trim());
    format!("{model} ({})", std::env::consts::ARCH)
}
