"""Runs a firmware program and prints what it prints: figures in modelled cycles.

    run.py --target TARGET --counter LIBRARY [--ends most|least|instructions] [--classes] PROGRAM

`instructions` counts each instruction as one, as QEMU does: to compare. `--classes` tells on stderr what was measured, by
class of instruction.
"""

import argparse
import sys
from pathlib import Path

from machine import Machine, Program
from model import ENDS, Model


def main() -> int:
    parser = argparse.ArgumentParser(description="Runs a firmware program with a clock of modelled cycles.")
    parser.add_argument("--target", required=True)
    parser.add_argument("--counter", required=True, type=Path, help="the library raylet-cycles")
    parser.add_argument("--ends", choices=ENDS, default="most")
    parser.add_argument("--classes", action="store_true")
    parser.add_argument("program", type=Path)
    chosen = parser.parse_args()
    machine = Machine(chosen.target, Program(chosen.program), Model(chosen.target, chosen.ends), chosen.counter)
    status = machine.run()
    sys.stdout.buffer.write(machine.output)
    if chosen.classes:
        tally = machine.classes()
        for name, count in tally.most_common():
            print(f"{chosen.target}\t{name}\t{100 * count / tally.total():.2f} %", file=sys.stderr)
    return status


if __name__ == "__main__":
    sys.exit(main())
