//! The same rays put to raylet, to other libraries and to the textbook: how fast, and how wrong. What it finds stands
//! in `data/peers.tsv`, and in part in `docs/peers.md`.

pub mod contestant;
pub mod document;
pub mod embedded_3dgfx_rays;
pub mod entrants;
pub mod environment;
pub mod errors;
pub mod measure;
pub mod names;
pub mod number;
#[cfg(feature = "parry")]
pub mod parry;
pub mod pose;
pub mod raylet_tiers;
pub mod rays;
pub mod sizes;
pub mod speed;
pub mod stored;
pub mod textbook;
#[cfg(feature = "parry")]
pub mod users;
