"""The table between two marks of a page: written, or compared."""

import re
import subprocess
import sys
from pathlib import Path

DOCS = Path(__file__).parents[2] / "docs"


# What the last line of a table says that depends on the compiler.
COMPILED = "Compiled by `{}`."


def compiled() -> str:
    """The last line of a table whose figures depend on the compiler."""
    version = subprocess.run(["rustc", "--version"], capture_output=True, text=True, check=True).stdout.strip()
    return "\n" + COMPILED.format(version) + "\n"


def write_or_compare(page: str, mark: str, table: str, command: str, renew: bool) -> int:
    """Writes a table into a page of `docs`, or says that the page has another one. Figures of another compiler are not
    compared."""
    path, first, last = DOCS / page, f"<!-- {mark}: written by `{command} --renew` -->\n", f"<!-- /{mark} -->\n"
    text = path.read_text()
    start, end = text.index(first) + len(first), text.index(last)
    written = text[:start] + "\n" + table.rstrip("\n") + "\n\n" + text[end:]
    compilers = [re.findall(COMPILED.format("(.*)"), of) for of in (text[start:end], table)]
    if renew:
        path.write_text(written)
    elif compilers[0] != compilers[1]:
        print(f"docs/{page} is of another compiler, {compilers[0]}: the figures are not compared")
    elif written != text:
        print(f"docs/{page} has other figures; if these are right: {command} --renew", file=sys.stderr)
        return 1
    return 0
