"""Writes or compares the table of docs/raystones.md from what the two programs have printed.

    table.py FOLDER [--renew]
"""

import re
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "paths"))
from page import write_or_compare


def of_c(text: str) -> int:
    """What a pixel takes: the program prints pixels per million, of the picture without output first."""
    found = re.search(r"40x20 .*RAYSTONES=([0-9.]+)", text)
    assert found, f"the C program printed no figure: {text[:200]}"
    return round(1e6 / float(found[1]))


def of_rust(text: str) -> dict[str, tuple[int, int]]:
    """What a pixel takes, and rays, by number type and tier."""
    rows = [line.split("\t") for line in text.splitlines() if "\t" in line]
    return {name: (int(taken), int(rays)) for name, taken, rays, _ in rows}


def main() -> int:
    folder = Path(sys.argv[1])
    read = lambda name: (folder / name).read_text(errors="replace")
    pixels = 40 * 20
    rows = [("`raystones.c` (`-O3`)", of_c(read("c.instructions")), of_c(read("c.cycles")), "–")]
    instructions, cycles = of_rust(read("rust.instructions")), of_rust(read("rust.cycles"))
    for name, (taken, rays) in instructions.items():
        rows.append((f"`raylet`, {name}", taken, cycles[name][0], f"{rays / pixels:.2f}"))
    table = "| program | instructions a pixel | modelled cycles a pixel | rays a pixel | Raystones |\n"
    table += "|---|---:|---:|---:|---:|\n"
    for name, taken, modelled, rays in rows:
        # The upper end of the model's ranges, and three digits of what is modelled.
        table += f"| {name} | {taken:,} | {float(f'{modelled:.3g}'):,.0f} | {rays} | {1e6 / modelled:.1f} |\n"
    print(table)
    return write_or_compare("raystones.md", "raystones", table, ".ci/raystones", "--renew" in sys.argv)


if __name__ == "__main__":
    sys.exit(main())
