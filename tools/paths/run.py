"""The longest paths and the stacks of linked programs, by their instructions; the tables of two pages.

    run.py stack PROGRAM FUNCTION...     the calls that take the most of the stack
    run.py worst FOLDER [--renew]        docs/worst-case.md: of each target the program `worst` and what it printed
    run.py sensor FOLDER [--renew]       docs/range-sensor.md: of each target the programs `sensor` and `zones`
"""

import argparse
import json
import re
import sys
from pathlib import Path

from bounds import Bounds
from code import Program, Unknown
from longest import Longest
from page import compiled, write_or_compare
from stack import Stacks

CHIPS = {
    "thumbv6m-none-eabi": "Cortex-M0+",
    "thumbv7m-none-eabi": "Cortex-M3",
    "thumbv7em-none-eabihf": "Cortex-M4F",
    "riscv32imc-unknown-none-elf": "RV32IMC",
}


def stack(program: Path, functions: list[str]) -> int:
    """Prints the calls that take the most."""
    program, failed = Program(program), 0
    for function in functions:
        try:
            for name, taken in Stacks(program).path(program.named(function)):
                print(f"{taken} bytes\t{name}")
        except Unknown as unknown:
            print(unknown, file=sys.stderr)
            failed = 1
    return failed


def worst(folder: Path, renew: bool) -> int:
    """Writes or compares the table of longest paths; fails if a search found more than that."""
    table = "| chip | solid | numbers | mean | 99 % | longest, of users | longest, found | bound | of that | stack |\n"
    table += "|---|---|---|---:|---:|---:|---:|---:|---:|---:|\n"
    failed = 0
    for target in (target for target in CHIPS if (folder / target / "worst.out").exists()):
        program = Program(folder / target / "worst")
        paths, stacks = Longest(program, Bounds(Path(__file__).parent / "bounds.toml")), Stacks(program)
        for line in (folder / target / "worst.out").read_text().splitlines():
            row = json.loads(line)
            start = program.named(row["function"])
            bound, taken = paths.of(start), stacks.of(start)
            if bound < row["found"]:
                print(f"{target}: {row['function']} took {row['found']}, more than {bound}", file=sys.stderr)
                failed = 1
            figures = [row["mean"], row["nearly"], row["worst"], row["found"], bound]
            cells = [CHIPS[target], row["solid"], row["tier"], *(f"{figure:,}" for figure in figures)]
            table += f"| {' | '.join(cells)} | {bound / row['found']:.2f} | {taken:,} |\n"
        for loop in paths.missing:
            name = f"{target}: {loop.function}"
            print(f"{name}: bounds.toml has no line for loop {loop.number}, at {loop.address:#x}", file=sys.stderr)
            failed = 1
    table += compiled()
    print(table)
    write_or_compare("worst-case.md", "worst", table, ".ci/worst", renew)
    return failed


def sensor(folder: Path, renew: bool) -> int:
    """Writes or compares the bill of the range sensor."""
    rows: dict[str, list[str]] = {}
    add = lambda name, value: rows.setdefault(name, []).append(value)
    targets = [target for target in CHIPS if (folder / target / "sensor.out").exists()]
    for target in targets:
        printed = (folder / target / "sensor.out").read_text()
        first = re.search(r"bounds (\d+), as seen from a place (\d+), fan of rays (\d+)", printed)
        assert first, f"{target}: the program printed no figures: {printed[:200]}"
        for name, taken in re.findall(r"^  (.+): (\d+)(?:, with other readings)?$", printed, re.MULTILINE):
            add(f"instructions a zone: {name}", f"{int(taken):,}")
        names = ["the bounds, made once", "the bounds as seen from a place", "the fan of rays, made once"]
        for name, taken in zip(names, first.groups()):
            add(f"instructions: {name}", f"{int(taken):,}")
        program = Program(folder / target / "zones")
        add("flash of the whole program `zones`, bytes", f"{program.bytes_in_flash():,}")
        try:
            stacks = Stacks(program)
            add("its stack at most, by its call graph, bytes", f"{stacks.of(program.named('measure')):,}")
        except Unknown as unknown:
            print(f"{target}: {unknown}", file=sys.stderr)
            add("its stack at most, by its call graph, bytes", "–")
    table = f"| | {' | '.join(CHIPS[target] for target in targets)} |\n|---|{'---:|' * len(targets)}\n"
    table += "".join(f"| {name} | {' | '.join(values)} |\n" for name, values in rows.items())
    table += compiled()
    print(table)
    return write_or_compare("range-sensor.md", "sensor", table, ".ci/sensor", renew)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=("stack", "worst", "sensor"))
    parser.add_argument("path", type=Path)
    parser.add_argument("functions", nargs="*")
    parser.add_argument("--renew", action="store_true")
    chosen = parser.parse_args()
    if chosen.what == "stack":
        return stack(chosen.path, chosen.functions)
    return (worst if chosen.what == "worst" else sensor)(chosen.path, chosen.renew)


if __name__ == "__main__":
    sys.exit(main())
