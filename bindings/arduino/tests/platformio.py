"""Runs platformio_link.py as PlatformIO does, for boards of some processors: which folder it links, or refuses."""

import os
import sys
from pathlib import Path

LIBRARY = Path(sys.argv[1])
SCRIPT = (LIBRARY / "platformio_link.py").read_text()


class Env(dict):
    """What the script asks of the build environment."""

    def __init__(self, board, flags):
        super().__init__(CCFLAGS=flags)
        self.board, self.linked = board, {}

    def BoardConfig(self):  # noqa: N802  (PlatformIO's name)
        return self.board

    def Append(self, **added):  # noqa: N802
        self.linked = added


def linked(board, *flags):
    """The folder that is linked for a board, below `src`."""
    env = Env(board, list(flags))
    os.chdir(LIBRARY)
    exec(compile(SCRIPT, "platformio_link.py", "exec"), {"env": env, "Import": lambda name: None})
    assert env.linked["LIBS"] == ["raylet"]
    return os.path.relpath(env.linked["LIBPATH"][0], LIBRARY / "src")


M4 = {"build.mcu": "stm32f411ceu6", "build.cpu": "cortex-m4"}
assert linked({"build.mcu": "rp2040", "build.cpu": "cortex-m0plus"}, "-mthumb") == "cortex-m0plus"
assert linked({"build.mcu": "esp32c3"}, "-march=rv32imc") == "esp32c3"
assert linked(M4, "-mfpu=fpv4-sp-d16", "-mfloat-abi=hard") == "cortex-m4/fpv4-sp-d16-hard"
assert linked(M4, "-mfloat-abi=softfp", "-mfpu=fpv4-sp-d16") == "cortex-m4/fpv4-sp-d16-softfp"
for board, flags in [({"build.mcu": "atmega328p"}, []), (M4, []), (M4, ["-mfpu=fpv5-d16", "-mfloat-abi=hard"])]:
    try:
        linked(board, *flags)
    except SystemExit as refusal:
        assert "no library for this board's processor" in str(refusal)
    else:
        raise AssertionError(f"{board} is not refused")
print("PlatformIO links the folder of each processor, and refuses others")
