"""The most rounds of loops, of bounds.toml."""

import tomllib
from pathlib import Path

from longest import Loop


class Bounds:
    """What bounds.toml says."""

    def __init__(self, path: Path) -> None:
        table = tomllib.loads(path.read_text())
        self._counted, self._loops = table["counted"], table["loop"]

    def is_counted(self, name: str) -> bool:
        """True if the third argument of the function says how much it does."""
        return self._most(name) is not None

    def _most(self, name: str) -> int | None:
        return next((line["most"] for line in self._counted if line["function"] in name), None)

    def rounds(self, loop: Loop, count: int | None) -> int | None:
        """The most rounds of a loop, for this third argument if it is known."""
        for line in self._loops:
            if line["function"] in loop.function and line.get("number", loop.number) == loop.number:
                if "rounds" in line:
                    return line["rounds"]
                return max(1, -(-(self._most(loop.function) if count is None else count) // line["of_a_round"]))
        return None
