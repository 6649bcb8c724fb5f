//! Instructions a query: counted, compared with what they were, and published.
//!
//! | room | what it holds |
//! |---|---|
//! | `callgrind` | runs this program under valgrind and reads what it counted |
//! | `baseline` | what was counted before, and how far today's figures are from it |
//! | `document` | `docs/benches.md` |
//! | `grouped` | long figures for people to read, as in the other documents |

pub mod baseline;
pub mod callgrind;
pub mod document;
#[path = "../../examples/accuracy/publish/grouped.rs"]
pub mod grouped;
