//! What to do about a file that cannot be read or written.

use crate::suggest;
use std::fs;
use std::io::{Error, ErrorKind};
use std::path::Path;

/// Why a file cannot be read, and what to do.
pub(crate) fn unread(path: &Path, error: &Error) -> String {
    let instead = match error.kind() {
        // Not every system has an error of its own for it.
        kind if kind == ErrorKind::IsADirectory || path.is_dir() => "this is a folder: name a scene file in it".into(),
        ErrorKind::NotFound => {
            beside(path).map_or("check the name and the folder".into(), |name| format!("did you mean {name}?"))
        }
        ErrorKind::NotADirectory => "a file stands where a folder should: correct the path".into(),
        ErrorKind::PermissionDenied => "you may not read it: change its permissions, or read a copy".into(),
        _ => "try again, or read a copy in another folder".to_owned(),
    };
    format!("cannot read {}: {error}; {instead}", path.display())
}

/// A scene file in the same folder whose name is much like this one.
fn beside(path: &Path) -> Option<String> {
    let folder = path.parent()?;
    let listed = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    let names = fs::read_dir(listed).ok()?.filter_map(|entry| entry.ok()?.file_name().into_string().ok());
    let mut names: Vec<_> =
        names.filter(|name| Path::new(name).extension().is_some_and(|suffix| suffix == "nff")).collect();
    // The order of a folder is any; the suggestion should not be.
    names.sort();
    let nearest = suggest::nearest(path.file_name()?.to_str()?, names.iter().map(String::as_str))?;
    Some(folder.join(nearest).display().to_string())
}

/// What to do if a picture or folder cannot be written.
pub(crate) fn instead(error: &Error) -> &'static str {
    match error.kind() {
        ErrorKind::NotADirectory | ErrorKind::AlreadyExists => {
            "a file stands where a folder should: give --output another place"
        }
        ErrorKind::IsADirectory => "a folder has this name: give --output another name",
        ErrorKind::PermissionDenied | ErrorKind::ReadOnlyFilesystem => {
            "you may not write there: give --output another place"
        }
        ErrorKind::StorageFull | ErrorKind::QuotaExceeded => {
            "there is no room left: make some, or give --output another place"
        }
        ErrorKind::BrokenPipe => "what should read it has ended: look there, or give --output a name",
        _ => "give --output another place",
    }
}
