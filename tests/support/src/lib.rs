//! What the tests share: the exact oracle, number types as the oracle sees them, workloads and tables.
// A test fails by a panic.
#![expect(clippy::missing_panics_doc, clippy::missing_errors_doc, reason = "a panic or an error here is a failed test")]

pub mod amount;
pub mod bounds;
pub mod cases;
pub mod climb;
pub mod crowd;
pub mod described;
pub mod exact_types;
pub mod figures;
pub mod hard_case;
#[cfg(feature = "laws")]
pub mod laws;
#[cfg(feature = "laws")]
pub mod laws_distance;
#[cfg(feature = "laws")]
pub mod laws_pose;
pub mod measure;
pub mod method;
pub mod oracle;
pub mod placed;
pub mod promise;
pub mod random;
pub mod subject;
pub mod textbook;
pub mod workload;

pub use raylet_tables::in_repository;
