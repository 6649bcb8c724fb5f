"""The table between two marks of a page: written, or compared."""

import sys
from pathlib import Path

DOCS = Path(__file__).parents[2] / "docs"


def write_or_compare(page: str, mark: str, table: str, command: str, renew: bool) -> int:
    """Writes a table into a page of `docs`, or says that the page has another one."""
    path, first, last = DOCS / page, f"<!-- {mark}: written by `{command} --renew` -->\n", f"<!-- /{mark} -->\n"
    text = path.read_text()
    start, end = text.index(first) + len(first), text.index(last)
    written = text[:start] + "\n" + table.rstrip("\n") + "\n\n" + text[end:]
    if renew:
        path.write_text(written)
    elif written != text:
        print(f"docs/{page} has other figures; if these are right: {command} --renew", file=sys.stderr)
        return 1
    return 0
