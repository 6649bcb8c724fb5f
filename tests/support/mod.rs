//! What the tests share: the exact oracle, number types as the oracle sees them, workloads and tables.
#![allow(dead_code)] // Every test file uses its own part.

pub mod bounds;
pub mod cases;
pub mod crowd;
pub mod exact_types;
pub mod figures;
pub mod fuzz;
pub mod hard_case;
pub mod laws;
pub mod laws_distance;
pub mod laws_pose;
pub mod measure;
pub mod method;
pub mod oracle;
pub mod placed;
pub mod random;
pub mod subject;
pub mod textbook;
pub mod workload;
