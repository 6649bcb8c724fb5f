//! Runs this program under valgrind's callgrind and reads what it counted.
//!
//! Nothing is counted but within [`counted`], and whenever that function returns callgrind writes down what was counted since the
//! last time: one valgrind for all cases, and nothing unsafe in here.

use crate::cost::{self, Case, Name, QUESTIONS};
use raylet_tables::Figures;
use std::env;
use std::error::Error;
use std::fs;
use std::hint::black_box;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// The argument that makes this program ask the questions and do nothing else.
pub const UNDER_VALGRIND: &str = "--under-valgrind";

/// Every case, always in the same order. In front stands one that asks nothing: what asking costs.
fn cases() -> Vec<Case> {
    let mut cases = vec![nothing()];
    cases.extend(cost::of_primitives::<false>(&|name| match name.query {
        "nearest" | "occlusion" => true,
        "normal" | "uv" => matches!(name.number, "f32" | "I16F16"),
        _ => false,
    }));
    cases.extend(cost::of_scenes());
    cases
}

fn nothing() -> Case {
    #[inline(never)]
    fn nothing<P, I>(subject: &P, input: &I) {
        black_box((subject, input));
    }
    let name = Name { subject: "nothing".into(), query: "nothing", number: "any", tier: "any", rays: "any" };
    Case::new(name, 0, vec![0; QUESTIONS], nothing::<u64, u64>)
}

/// [`counted`] as valgrind calls it. (A pattern would do to toggle the counting, but not to write down what was counted.)
const COUNTED: &str = "instructions::callgrind::counted";

/// What callgrind counts.
#[inline(never)]
fn counted(case: &Case) {
    black_box(case).ask();
}

/// Asks everything once: what this program does under valgrind.
///
/// In a thread: where the first one's stack begins depends on the length of the program's path and of the environment, and so
/// would what copying takes, which looks at alignments.
pub fn run_queries() {
    let asking = std::thread::spawn(|| cases().iter().for_each(counted));
    // Should it have failed, the figures are not complete, which is noticed.
    let _ = asking.join();
}

/// Instructions a question, for every case.
pub fn count() -> Result<Figures, Box<dyn Error>> {
    let file = env::temp_dir().join(format!("raylet-callgrind-{}", std::process::id()));
    let totals = run(&file);
    // The file is of no use to anyone, whatever became of it.
    let _ = fs::remove_file(&file);
    let (totals, cases) = (totals?, cases());
    if totals.len() != cases.len() {
        return Err(format!("callgrind counted {} cases of {}", totals.len(), cases.len()).into());
    }
    let nothing = totals.first().copied().unwrap_or_default();
    let questions = QUESTIONS as u64;
    let figures = cases.iter().zip(&totals).skip(1).map(|(case, total)| {
        let net = total.saturating_sub(nothing);
        (case.name.to_string(), (net + questions / 2) / questions)
    });
    Ok(figures.collect())
}

/// Runs valgrind and reads the instructions of each case.
fn run(file: &Path) -> Result<Vec<u64>, Box<dyn Error>> {
    let program: PathBuf = env::current_exe()?;
    let status = Command::new("valgrind")
        .args(["--quiet", "--tool=callgrind", "--combine-dumps=yes"])
        .args([format!("--toggle-collect={COUNTED}"), format!("--dump-after={COUNTED}")])
        .arg(format!("--callgrind-out-file={}", file.display()))
        .arg(program)
        .arg(UNDER_VALGRIND)
        .stdin(Stdio::null())
        .status()
        .map_err(|error| format!("valgrind: {error}; `.ci/instructions` installs it"))?;
    if !status.success() {
        return Err(format!("valgrind: {status}").into());
    }
    totals(&fs::read_to_string(file)?)
}

/// The instructions of each part that the returning function ended; what follows the last is the end of the program.
fn totals(text: &str) -> Result<Vec<u64>, Box<dyn Error>> {
    let mut totals = Vec::new();
    let mut by_the_function = false;
    for line in text.lines() {
        if let Some(trigger) = line.strip_prefix("desc: Trigger:") {
            by_the_function = trigger.contains(COUNTED);
        } else if let Some(total) = line.strip_prefix("summary:").filter(|_| by_the_function) {
            let instructions = total.split_whitespace().next().unwrap_or_default();
            totals.push(instructions.parse().map_err(|error| format!("{line}: {error}"))?);
        }
    }
    Ok(totals)
}
