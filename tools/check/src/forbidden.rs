//! What must not be linked, by name.

/// Something that a program must not contain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Forbidden {
    /// Any way to panic.
    Panic,
    /// An allocator, or anything of the crate `alloc`.
    Allocator,
    /// The machinery that makes text of values.
    Formatting,
    /// An operation on doubles: none of the chips has instructions for them.
    Doubles,
}

impl Forbidden {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Panic, Self::Allocator, Self::Formatting, Self::Doubles];

    /// True if a symbol of this name is one.
    pub fn is(self, name: &str) -> bool {
        match self {
            // `panicked` is the bottom of the panic handler in `proofs`: whatever a compiler calls its ways to panic,
            // they end there.
            Self::Panic => {
                let names = [
                    "core::panicking::",
                    "raylet_proofs::panicked",
                    "rust_begin_unwind",
                    "slice_index_fail",
                    "slice_start_index",
                    "slice_end_index",
                    "::unwrap_failed",
                    "::expect_failed",
                    "panic_bounds_check",
                ];
                names.iter().any(|panic| name.contains(panic))
            }
            Self::Allocator => {
                let names = ["__rust_alloc", "__rust_dealloc", "__rust_realloc", "__rg_alloc", "__rdl_alloc"];
                names.iter().any(|allocator| name.starts_with(allocator))
                    || name.starts_with("alloc::")
                    || name.starts_with("<alloc::")
                    || name == "malloc"
                    || name == "free"
            }
            Self::Formatting => name.contains("core::fmt::"),
            Self::Doubles => is_helper_for_doubles(name) || is_double_function(name),
        }
    }
}

/// True if a symbol of this name is any of them.
pub fn any(name: &str) -> bool {
    Forbidden::ALL.iter().any(|forbidden| forbidden.is(name))
}

/// The compiler's own helpers, under the names of Arm (Arm, *Run-time ABI for the Arm Architecture*, 5.1) and of
/// libgcc.
fn is_helper_for_doubles(name: &str) -> bool {
    let name = name.rsplit("::").next().unwrap_or(name);
    if let Some(arm) = name.strip_prefix("__aeabi_") {
        let operations = ["dadd", "dsub", "drsub", "dmul", "ddiv", "dneg", "f2d", "i2d", "ui2d", "l2d", "ul2d", "h2d"];
        return operations.contains(&arm)
            || arm.starts_with("dcmp")
            || arm.starts_with("cdcmp")
            || arm.starts_with("d2");
    }
    name.strip_prefix("__").is_some_and(|helper| {
        ["df", "df2", "df3"].iter().any(|end| helper.ends_with(end))
            || helper.starts_with("truncdf")
            || helper.starts_with("fixdf")
            || helper.starts_with("fixunsdf")
            || helper.starts_with("extenddf")
    })
}

/// The functions of `libm` that take doubles. Those for `f32` end with an f.
fn is_double_function(name: &str) -> bool {
    let functions = [
        "sqrt",
        "fmod",
        "floor",
        "ceil",
        "trunc",
        "rint",
        "fma",
        "scalbn",
        "atan",
        "atan2",
        "sin",
        "cos",
        "tan",
        "sincos",
        "k_sin",
        "k_cos",
        "k_tan",
        "rem_pio2",
        "rem_pio2_large",
        "pow",
        "exp",
        "exp2",
        "log",
        "log2",
    ];
    let is_from_libm = name.starts_with("libm::") || name.starts_with("compiler_builtins::math::");
    let last = name.rsplit("::").next().unwrap_or(name);
    functions.contains(&last) && (is_from_libm || last == name)
}

#[cfg(test)]
mod tests {
    use super::Forbidden::{Allocator, Doubles, Formatting, Panic};
    use super::*;

    #[test]
    fn each_is_told_by_its_names() {
        let cases: [(Forbidden, &[&str]); 4] = [
            (
                Panic,
                &["core::panicking::panic_fmt", "core::slice::index::slice_index_fail", "core::option::unwrap_failed"],
            ),
            (
                Allocator,
                &["__rust_alloc", "alloc::vec::Vec::push", "<alloc::string::String as core::clone::Clone>::clone"],
            ),
            (Formatting, &["core::fmt::write", "<core::fmt::Formatter>::pad_integral"]),
            (
                Doubles,
                &[
                    "__aeabi_dadd",
                    "__aeabi_dcmplt",
                    "__aeabi_d2f",
                    "__aeabi_f2d",
                    "__extendsfdf2",
                    "__truncdfsf2",
                    "__fixdfsi",
                    "__floatsidf",
                    "compiler_builtins::float::mul::__muldf3",
                    "libm::math::sqrt::sqrt",
                    "libm::math::rem_pio2_large::rem_pio2_large",
                ],
            ),
        ];
        for (forbidden, names) in cases {
            for name in names {
                assert!(forbidden.is(name), "{name}");
            }
        }
    }

    #[test]
    fn what_is_allowed_is_none_of_them() {
        for name in [
            "__aeabi_fadd",
            "__aeabi_f2iz",
            "__aeabi_uldivmod",
            "__aeabi_memcpy",
            "__addsf3",
            "__divsf3",
            "__udivdi3",
            "libm::math::sqrt::sqrtf",
            "libm::math::generic::sqrt::sqrt::<f32>",
            "compiler_builtins::math::full_availability::fmodf",
            "<raylet::shape::Shape<f32>>::bounds",
            "raylet::scalar::square_root::square_root_f32",
        ] {
            assert!(!any(name), "{name}");
        }
    }
}
