//! The library's own tests lend their exact oracle, their number types as it sees them, and their rays.
#![allow(dead_code, clippy::should_implement_trait)]

#[path = "../../../tests/support/exact_types.rs"]
pub mod exact_types;
#[path = "../../../tests/support/oracle/mod.rs"]
pub mod oracle;
#[path = "../../../tests/support/random.rs"]
pub mod random;
#[path = "../../../tests/support/subject.rs"]
pub mod subject;
#[path = "../../../tests/support/workload.rs"]
pub mod workload;
