//! Nothing. The tests are the target `units`, whose root is that of the library; `cargo package` in the repository's
//! folder demands a target within each package's own.
