"""Compares what a firmware program printed in QEMU and here, with an instruction as a cycle: figures of instructions are equal,
but for the grain of the clock.

    compare.py QEMU HERE
"""

import json
import sys
from pathlib import Path
from typing import Any, Iterator

# The clock's grain is 40 instructions, of the 4,000 that a measurement takes at least.
HUNDREDTHS, LEAST = 1, 2


def figures(value: Any, name: str = "") -> Iterator[tuple[str, int]]:
    """The figures of a line, named by all that is in it; those of the stack and the pictures left out."""
    if isinstance(value, dict):
        texts = [text for text in value.values() if isinstance(text, str)]
        if value.get("of") != "stack":
            for key, part in value.items():
                if key not in ("stack", "rays", "levels"):
                    yield from figures(part, " | ".join([name, *texts, key]))
    elif isinstance(value, int):
        yield name, value


def read(text: str) -> dict[str, int]:
    return {name: figure for line in text.splitlines() for name, figure in figures(json.loads(line))}


def differing(qemu: dict[str, int], here: dict[str, int]) -> list[str]:
    """What is too far off, or is missing on one side."""
    faults = [f"only one has {name}" for name in qemu.keys() ^ here.keys()]
    for name in qemu.keys() & here.keys():
        if abs(qemu[name] - here[name]) > max(LEAST, qemu[name] * HUNDREDTHS / 100):
            faults.append(f"{name}: {qemu[name]} in QEMU, {here[name]} here")
    return sorted(faults)


def main() -> int:
    qemu, here = (read(Path(path).read_text()) for path in sys.argv[1:])
    faults = differing(qemu, here)
    equal = sum(qemu[name] == here[name] for name in qemu.keys() & here.keys())
    print(f"{len(qemu)} counts of instructions, {equal} equal to QEMU's, {len(faults)} too far off")
    print(*faults[:20], sep="\n", end="\n" if faults else "")
    return 1 if faults or not qemu else 0


if __name__ == "__main__":
    sys.exit(main())
