//! How far the program is, on standard error, if it takes long and somebody watches.

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::time::{Duration, Instant};

/// A bar that flashes up and is gone helps nobody.
const SOON: Duration = Duration::from_secs(1);

/// One bar for all that is done for a picture: first objects are read, then rows traced.
#[derive(Debug)]
pub(crate) struct Progress {
    bar: ProgressBar,
    start: Instant,
}

impl Progress {
    /// Starts to count the time.
    pub(crate) fn new() -> Self {
        let bar = ProgressBar::with_draw_target(None, ProgressDrawTarget::hidden());
        Self { bar, start: Instant::now() }
    }

    /// What comes next, and of how many steps.
    pub(crate) fn begin(&self, steps: usize, unit: &'static str) {
        // Before the length, or more steps were done than there are.
        self.bar.set_position(0);
        let style = ProgressStyle::with_template(&format!("{{bar:40}} {{pos}}/{{len}} {unit}, {{eta}} left"));
        if let Ok(style) = style {
            self.bar.set_style(style);
        }
        self.bar.set_length(steps as u64);
        self.bar.reset_eta();
    }

    /// One step is done.
    pub(crate) fn step(&self) {
        if self.bar.is_hidden() && self.start.elapsed() > SOON {
            self.bar.set_draw_target(ProgressDrawTarget::stderr());
        }
        self.bar.inc(1);
    }

    /// All is done.
    pub(crate) fn end(&self) {
        self.bar.finish_and_clear();
    }

    /// Seconds since the start.
    pub(crate) fn seconds(&self) -> f64 {
        self.start.elapsed().as_secs_f64()
    }
}
