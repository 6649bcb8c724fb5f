//! Runs this program under valgrind's callgrind and reads what it counted.
//!
//! Nothing is counted but within [`counted`] and whenever it returns callgrind writes down what was
//! counted since the last time: one valgrind for all cases, and nothing unsafe in here.

use crate::cost::{self, Case, Name, QUERIES};
use crate::workloads::{self, Workload};
use raylet_tables::Figures;
use std::env;
use std::error::Error;
use std::fs::{self, File};
use std::hint::black_box;
use std::io::{BufRead, BufReader};
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// The argument that makes this program run the queries and do nothing else.
pub const UNDER_VALGRIND: &str = "--under-valgrind";

/// Every case, always in the same order. In front stands one that does nothing: what a call costs.
fn cases() -> Vec<Case> {
    let mut cases = vec![nothing()];
    cases.extend(cost::of_primitives::<false>(&|name| match name.query {
        "nearest" | "occlusion" => true,
        "normal" | "uv" => matches!(name.number, "f32" | "I16F16"),
        _ => false,
    }));
    cases.extend(cost::of_textbook());
    cases.extend(cost::of_scenes());
    cases
}

fn nothing() -> Case {
    #[inline(never)]
    fn nothing<P, I>(subject: &P, input: &I) {
        black_box((subject, input));
    }
    let name = Name { subject: "nothing".into(), query: "nothing", number: "any", tier: "any", rays: "any" };
    Case::new(name, 0, vec![0; QUERIES], nothing::<u64, u64>)
}

/// [`counted`] as valgrind calls it. (A pattern would do to toggle the counting, but not to write down what was
/// counted.)
const COUNTED: &str = "instructions::callgrind::counted";

/// What callgrind counts.
#[inline(never)]
fn counted(run: &dyn Fn()) {
    black_box(run)();
}

/// The queries of a workload in blocks of as many as there are numbered functions.
fn blocks(workload: &Workload) -> impl Iterator<Item = Range<usize>> + use<> {
    let queries = workload.queries;
    (0..queries).step_by(NUMBERS).map(move |first| first..queries.min(first + NUMBERS))
}

/// Runs some queries of a workload, each by a function of its own, so that callgrind knows them apart.
#[inline(never)]
fn singly(workload: &Workload, block: Range<usize>) {
    for (index, query) in block.zip(numbered::ALL.as_flattened()) {
        black_box(query)(black_box(workload), index);
    }
}

/// How many numbered functions there are.
const NUMBERS: usize = numbered::ALL.as_flattened().len();

/// What the hundred functions begin with in callgrind's text.
const NUMBERED: &str = "instructions::callgrind::numbered::";

/// A hundred functions that do the same, of different names.
mod numbered {
    use crate::workloads::Workload;
    use std::hint::black_box;

    macro_rules! units {
        ($tens:ident: $($name:ident)+) => {
            pub mod $tens {
                use super::{Workload, black_box};
                $(
                    #[inline(never)]
                    pub fn $name(workload: &Workload, index: usize) {
                        // Another text in each: equal functions are merged.
                        black_box(concat!(stringify!($tens), stringify!($name)));
                        workload.run(index);
                    }
                )+
                pub const ALL: [fn(&Workload, usize); 10] = [$($name),+];
            }
        };
    }
    macro_rules! tens {
        ($($tens:ident)+) => {
            $(units!($tens: n0 n1 n2 n3 n4 n5 n6 n7 n8 n9);)+
            pub const ALL: [[fn(&Workload, usize); 10]; 10] = [$($tens::ALL),+];
        };
    }
    tens!(t0 t1 t2 t3 t4 t5 t6 t7 t8 t9);
}

/// Runs everything once: what this program does under valgrind.
///
/// In a thread: where the first one's stack begins depends on the length of the program's path and of the environment,
/// and so would what copying takes, which looks at alignments.
pub fn run_queries() {
    let asking = std::thread::spawn(|| {
        for case in cases() {
            counted(&|| case.run());
        }
        for workloads in [workloads::all(), workloads::away_from_grazing()] {
            // Callgrind counts calls, not instructions, outside of what is counted too, and forgets them when it has
            // written them down: this part takes the calls by which the workloads were made.
            counted(&|| workloads.iter().for_each(|workload| singly(workload, 0..workload.queries)));
            for workload in &workloads {
                for block in blocks(workload) {
                    counted(&|| singly(workload, block.clone()));
                }
            }
        }
    });
    // Should it have failed, the figures are not complete, which is noticed.
    let _ = asking.join();
}

/// What was counted.
pub struct Counted {
    /// Instructions a query, for every case.
    pub cost: Figures,
    /// Of every workload the mean, the 99 %, the worst, and how many of a hundred queries are left to the solver.
    pub workloads: Figures,
    /// Of the rays away from grazing of every solid the mean, the 99.9 %, the worst, and how many of a hundred are left
    /// to the solver.
    pub away_from_grazing: Figures,
}

/// Instructions a query, for every case and workload.
pub fn count() -> Result<Counted, Box<dyn Error>> {
    let file = env::temp_dir().join(format!("raylet-callgrind-{}", std::process::id()));
    let parts = run(&file);
    // The file is of no use to anyone, whatever became of it.
    let _ = fs::remove_file(&file);
    let (mut parts, cases) = (parts?.into_iter(), cases());
    let mut next = || parts.next().ok_or("callgrind did not count all cases");
    let nothing = next()?.instructions;
    let mut cost = Figures::new();
    for case in cases.iter().skip(1) {
        let net = next()?.instructions.saturating_sub(nothing);
        let queries = QUERIES as u64;
        cost.insert(case.name.to_string(), (net + queries / 2) / queries);
    }
    let mut figures_of = |workloads: &[Workload], tail: Tail| -> Result<Figures, Box<dyn Error>> {
        next()?;
        let mut figures = Figures::new();
        for workload in workloads {
            let mut whole = Part::default();
            for _ in blocks(workload) {
                let Part { singly, solved, .. } = next()?;
                whole.singly.extend(singly);
                whole.solved += solved;
            }
            if whole.singly.len() != workload.queries {
                return Err(format!("callgrind counted {} queries of {}", whole.singly.len(), workload.name).into());
            }
            figures.extend(summary(&workload.name, tail, &whole));
            if let Some(off) = workload.off {
                let told = [("off, units", off.units), ("wrong", off.wrong)];
                figures.extend(told.map(|(what, figure)| (format!("{} | {what}", workload.name), figure)));
            }
        }
        Ok(figures)
    };
    let workloads = figures_of(&workloads::all(), OF_A_HUNDRED)?;
    let away_from_grazing = figures_of(&workloads::away_from_grazing(), OF_A_THOUSAND)?;
    if parts.next().is_some() {
        return Err("callgrind counted more cases than there are".into());
    }
    Ok(Counted { cost, workloads, away_from_grazing })
}

/// A quantile: its name, and of how many queries it is the second most expensive.
type Tail = (&'static str, usize);

const OF_A_HUNDRED: Tail = ("99 %", 100);
const OF_A_THOUSAND: Tail = ("99.9 %", 1_000);

/// The figures of a workload, each under its name.
fn summary(name: &str, (quantile, of): Tail, part: &Part) -> Vec<(String, u64)> {
    let mut counts: Vec<_> = part.singly.iter().map(|count| count.saturating_sub(ASKING)).collect();
    counts.sort_unstable();
    let Some(&worst) = counts.last() else { return vec![] };
    let count = counts.len() as u64;
    let mean = (counts.iter().sum::<u64>() + count / 2) / count;
    let nearly_worst = counts[(counts.len() * (of - 1)).div_ceil(of).saturating_sub(1)];
    let solved = (100 * part.solved + count / 2) / count;
    [("mean", mean), (quantile, nearly_worst), ("worst", worst), ("solved, %", solved)]
        .map(|(what, figure)| (format!("{name} | {what}"), figure))
        .into()
}

/// What it takes to come to a query and back: the numbered function, the closure and the call through a pointer.
const ASKING: u64 = 25;

/// What was counted until a function returned.
#[derive(Default)]
struct Part {
    instructions: u64,
    /// The same of each numbered function.
    singly: Vec<u64>,
    /// How often the solver was called by what is not of it.
    solved: u64,
}

/// Runs valgrind and reads what it counted in each part.
fn run(file: &Path) -> Result<Vec<Part>, Box<dyn Error>> {
    let program: PathBuf = env::current_exe()?;
    let status = Command::new("valgrind")
        .args(["--quiet", "--tool=callgrind", "--combine-dumps=yes", "--compress-strings=no"])
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
    parts(BufReader::new(File::open(file)?))
}

/// The parts that a returning function ended; what follows the last is the end of the program.
///
/// `fn=` names a function, `cfn=` one that it calls, `calls=` says how often, and the line behind that ends with what
/// these calls took.
fn parts(text: impl BufRead) -> Result<Vec<Part>, Box<dyn Error>> {
    let mut parts: Vec<Part> = Vec::new();
    let (mut by_a_function, mut callee, mut is_call) = (false, String::new(), false);
    for line in text.lines() {
        let line = line?;
        let number = |text: Option<&str>| -> Result<u64, Box<dyn Error>> {
            Ok(text.unwrap_or_default().parse().map_err(|error| format!("{line}: {error}"))?)
        };
        if let Some(trigger) = line.strip_prefix("desc: Trigger:") {
            by_a_function = trigger.contains(COUNTED);
            continue;
        }
        if !by_a_function {
            continue;
        }
        if let Some(total) = line.strip_prefix("summary:") {
            let instructions = number(total.split_whitespace().next())?;
            parts.push(Part { instructions, ..Part::default() });
        }
        let Some(part) = parts.last_mut() else { continue };
        if let Some(name) = line.strip_prefix("cfn=") {
            callee = name.into();
        } else if let Some(calls) = line.strip_prefix("calls=") {
            is_call = true;
            if callee.contains(OTHERS) {
                part.solved += number(calls.split_whitespace().next())?;
            }
        } else if is_call {
            is_call = false;
            if callee.starts_with(NUMBERED) {
                part.singly.push(number(line.split_whitespace().last())?);
            }
        }
    }
    Ok(parts)
}

/// The function, not inlined, that passes a query on to the other methods of its tier.
const OTHERS: &str = "raylet::query::others";

#[cfg(test)]
mod tests {
    use super::{OTHERS, parts};

    /// Queries that pass on would seem to be decided by the first method if the function had another name.
    #[test]
    fn the_function_that_is_counted_is_there() {
        let text = std::fs::read_to_string(raylet_tables::in_repository("src/query.rs")).unwrap();
        assert!(OTHERS.ends_with("query::others") && text.contains("#[cold]\n#[inline(never)]\nfn others<"));
    }

    #[test]
    fn queries_that_pass_on_are_counted() {
        let text = "desc: Trigger: --dump-after=instructions::callgrind::counted\nsummary: 99\n\
            fn=raylet::shape::nearest\ncfn=raylet::query::others\ncalls=2 0\n0 10\ncfn=raylet::query::others'2\ncalls=1 0\n0 10\n\
            fn=raylet::query::others\ncfn=raylet::solve::flat::plane\ncalls=5 0\n0 3\n";
        let parts = parts(text.as_bytes()).unwrap();
        assert_eq!(parts.iter().map(|part| part.solved).collect::<Vec<_>>(), [3]);
    }
}
