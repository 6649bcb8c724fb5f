//! What the page [docs/try](../../../docs/try/index.html) asks the library: the code of every answer on the page.
//!
//! | module | what it holds |
//! |---|---|
//! | `number` | the number types, their tiers, and a world in each |
//! | `solid` | the solids of the page, by number |
//! | `world` | solids, rays and a view; all hits, and rows of a picture |
//! | `exports` | functions that take and give numbers, as JavaScript calls them |
//!
//! The page has all hits and no nearest ones, to be sent as less than 400 KB.

#[expect(unsafe_code, reason = "exported names")]
pub mod exports;
pub mod number;
pub mod solid;
pub mod world;
