"""For PlatformIO: links the library that was compiled for the board's processor.

The folders are those of the Arduino library specification: `src/{build.mcu}`, and on processors with a floating-point
unit below it `{fpu}-{float-abi}`, as the compiler's options name them.
"""

import os

Import("env")  # noqa: F821  (SCons gives it)


def folder_of(env):
    """Where the library for this board is, or none."""
    board = env.BoardConfig()
    flags = dict(str(flag)[2:].split("=", 1) for flag in env.get("CCFLAGS", []) if str(flag).startswith("-m")
                 and "=" in str(flag))
    floats = f"{flags['fpu']}-{flags['float-abi']}" if "fpu" in flags and "float-abi" in flags else ""
    for key in ("build.mcu", "build.cpu"):
        folder = os.path.join(os.getcwd(), "src", board.get(key, "none"), floats)
        if os.path.exists(os.path.join(folder, "libraylet.a")):
            return folder
    return None


found = folder_of(env)  # noqa: F821
if found is None:
    raise SystemExit("raylet has no library for this board's processor: it has them for cortex-m0plus, cortex-m4 with "
                     "fpv4-sp-d16, and esp32c3")
env.Append(LIBPATH=[found], LIBS=["raylet"])  # noqa: F821
