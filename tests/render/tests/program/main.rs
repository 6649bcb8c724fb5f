//! The promise: the program does with files, pipes and options what whoever runs it expects, and says what it does not.

mod support;

mod input;
mod messages;
mod output;
mod pictures;
