//! What a linked program is made of.

use object::{Object, ObjectSection, ObjectSymbol, RelocationTarget, SectionKind, SymbolKind};
use raylet_tables::Outcome;
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

/// A function or a table that was linked.
pub struct Symbol {
    /// Its name as people write it.
    pub name: String,
    /// The functions that mention it, as far as the linker kept note of it (`--emit-relocs`).
    pub callers: BTreeSet<String>,
}

/// The source files that instructions of a linked program come from, inlined functions included, by its line tables.
///
/// Only those whose path contains one of `folders`, from there on.
pub fn sources(path: &Path, folders: &[&str]) -> Outcome<BTreeSet<String>> {
    let data = fs::read(path).map_err(|error| format!("{}: {error}; build it first", path.display()))?;
    let file = object::File::parse(&*data).map_err(|error| format!("{}: {error}", path.display()))?;
    let lines = addr2line::Loader::new(path).map_err(|error| format!("{}: {error}", path.display()))?;
    let mut sources = BTreeSet::new();
    for section in file.sections().filter(|section| section.kind() == SectionKind::Text) {
        // Arm's Thumb and RISC-V's compressed instructions stand at even addresses.
        for address in (section.address()..section.address() + section.size()).step_by(2) {
            let mut frames = lines.find_frames(address)?;
            while let Some(frame) = frames.next()? {
                let file = frame.location.and_then(|location| location.file);
                if let Some(file) =
                    file.and_then(|file| folders.iter().find_map(|of| file.find(of).map(|start| &file[start..])))
                {
                    sources.insert(file.to_owned());
                }
            }
        }
    }
    Ok(sources)
}

/// A linked program.
pub struct Program {
    /// Everything with a name.
    pub symbols: Vec<Symbol>,
    /// Bytes of code and constants: what a chip must hold in its flash.
    pub bytes: u64,
}

impl Program {
    /// Reads an ELF file.
    pub fn read(path: &Path) -> Outcome<Self> {
        let data = fs::read(path).map_err(|error| format!("{}: {error}; build it first", path.display()))?;
        let file = object::File::parse(&*data).map_err(|error| format!("{}: {error}", path.display()))?;
        let functions: Vec<_> = file.symbols().filter(|symbol| symbol.kind() == SymbolKind::Text).collect();
        let caller = |address: u64| {
            let found = functions.iter().find(|f| (f.address() & !1..(f.address() & !1) + f.size()).contains(&address));
            found.and_then(|f| f.name().ok()).map(demangled)
        };
        let mut mentions = Vec::new();
        for section in file.sections().filter(|section| section.kind() == SectionKind::Text) {
            for (address, relocation) in section.relocations() {
                if let RelocationTarget::Symbol(index) = relocation.target() {
                    mentions.push((index, address));
                }
            }
        }
        let named = |symbol: &object::Symbol<'_, '_>| matches!(symbol.kind(), SymbolKind::Text | SymbolKind::Data);
        let symbols = file.symbols().filter(named).filter_map(|symbol| {
            let name = demangled(symbol.name().ok().filter(|name| !name.is_empty())?);
            // Looked up only where it is wanted: there are thousands.
            let wanted = crate::forbidden::any(&name);
            let mentioned = mentions.iter().filter(|(index, _)| wanted && *index == symbol.index());
            let callers = mentioned.filter_map(|(_, address)| caller(*address)).filter(|by| *by != name).collect();
            Some(Symbol { name, callers })
        });
        let bytes =
            file.sections().filter(|section| is_flash(section.kind(), section.name().unwrap_or(""))).map(|s| s.size());
        Ok(Self { symbols: symbols.collect(), bytes: bytes.sum() })
    }
}

/// Tables for unwinding are dropped by the linker scripts of every runtime.
fn is_flash(kind: SectionKind, name: &str) -> bool {
    let is_unwinding = name.starts_with(".ARM.ex") || name.starts_with(".eh_frame");
    matches!(kind, SectionKind::Text | SectionKind::ReadOnlyData | SectionKind::ReadOnlyString) && !is_unwinding
}

fn demangled(name: &str) -> String {
    format!("{:#}", rustc_demangle::demangle(name))
}
