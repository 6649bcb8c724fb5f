//! How much memory a program takes before it runs, by the symbols that the runtimes' linker scripts define.

use core::fmt;

unsafe extern "C" {
    #[link_name = "__stext"]
    static CODE: u8;
    #[link_name = "__etext"]
    static CODE_END: u8;
    #[link_name = "__srodata"]
    static CONSTANTS: u8;
    #[link_name = "__erodata"]
    static CONSTANTS_END: u8;
    #[link_name = "__sdata"]
    static DATA: u8;
    #[link_name = "__edata"]
    static DATA_END: u8;
    #[link_name = "__sbss"]
    static ZEROED: u8;
    #[link_name = "__ebss"]
    static ZEROED_END: u8;
}

/// Sizes in bytes.
#[derive(Clone, Copy, Debug)]
pub struct Footprint {
    /// Instructions: `.text`. The vector table, some 200 bytes, is not counted.
    pub code: usize,
    /// Tables, texts and the like: `.rodata`.
    pub constants: usize,
    /// Statics with a first value, which takes flash as well: `.data`.
    pub data: usize,
    /// Statics that start at zero: `.bss`.
    pub zeroed: usize,
}

impl Footprint {
    /// Of this program, all of it: its scene, its formatted output and its runtime too.
    pub fn of_this_program() -> Self {
        let bytes = |start: *const u8, end: *const u8| end as usize - start as usize;
        Self {
            code: bytes(&raw const CODE, &raw const CODE_END),
            constants: bytes(&raw const CONSTANTS, &raw const CONSTANTS_END),
            data: bytes(&raw const DATA, &raw const DATA_END),
            zeroed: bytes(&raw const ZEROED, &raw const ZEROED_END),
        }
    }
}

impl fmt::Display for Footprint {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { code, constants, data, zeroed } = self;
        write!(f, "flash {} bytes (code {code}, constants {constants}, data {data}), ", code + constants + data)?;
        write!(f, "static RAM {} bytes", data + zeroed)
    }
}
