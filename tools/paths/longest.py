"""The most instructions that a function may carry out, with all that it calls: the longest path through its blocks.

A loop is a set of blocks from each of which every other can be reached. It is entered at one block, its head, and is
gone through as often as the table of bounds says. Paths that no input takes count too: so this is an upper bound.
"""

from dataclasses import dataclass

from code import Block, Function, Program, Unknown
from constants import State, before_blocks, through


@dataclass
class Loop:
    """A loop: the function that it is in, its number there by address, and how many instructions it has."""

    function: str
    number: int
    address: int
    instructions: int


class Longest:
    """The longest paths of a program.

    `bounds` has `is_counted(name)`, true for a function whose third argument says how much it does, and
    `rounds(loop, count)`, the most rounds of a loop, or None if that is not known.
    """

    def __init__(self, program: Program, bounds) -> None:
        self.program, self.bounds = program, bounds
        self.known: dict[tuple[int, int | None], int] = {}
        self.missing: list[Loop] = []
        self.count: int | None = None

    def of(self, start: int, count: int | None = None) -> int:
        """Of the function that starts there, its last instruction included."""
        key = (start, count)
        if key not in self.known:
            if not self.bounds.is_counted(self.program.names[start]):
                key, count = (start, None), None
            if key not in self.known:
                outer, self.count = self.count, count
                self.known[key] = self._of_function(self.program.function(start))
                self.count = outer
        return self.known[key]

    def _of_function(self, function: Function) -> int:
        costs, states = {}, before_blocks(function)
        for block in function.blocks.values():
            cost = len(block.instructions)
            for index, callee in block.calls:
                cost += self.of(self._start_of(callee), self._third_argument(states, block, index))
            if block.leaves_to is not None:
                count = self._third_argument(states, block, len(block.instructions))
                cost += self.of(self._start_of(block.leaves_to), count)
            costs[block.start] = cost
        after = {block.start: [to for to in block.after] for block in function.blocks.values()}
        outer, self._number = getattr(self, "_number", 0), 0
        lengths = self._lengths(function, set(costs), function.start, None, costs, after)
        self._number = outer
        leaving = [block.start for block in function.blocks.values() if not block.after or block.leaves_to is not None]
        # What never returns ends anywhere.
        return max(lengths[block] for block in leaving or lengths if block in lengths)

    def _third_argument(self, states: dict[int, State], block: Block, index: int) -> int | None:
        """The constant that the third argument of a call is; for its own calls that of a function that counts by it."""
        value = through(block, states[block.start], index).get("r2" if self.program.is_arm else "a2")
        return self.count if value is None else value

    def _start_of(self, address: int) -> int:
        start = self.program.containing(address)
        if start is None:
            raise Unknown(f"no function is at {address:#x}")
        return start

    def _lengths(
        self,
        function: Function,
        blocks: set[int],
        first: int,
        head: int | None,
        costs: dict[int, int],
        after: dict[int, list[int]],
    ) -> dict[int, int]:
        """The longest way from the first block to each, both included; edges back to a loop's head are left out."""
        inner = {block: [to for to in after[block] if to in blocks and to != head] for block in blocks}
        groups = components(blocks, inner)
        group_of = {block: index for index, group in enumerate(groups) for block in group}
        # Groups come in the order of their edges, the first last.
        best: dict[int, int] = {first: 0}
        lengths: dict[int, int] = {}
        for group in reversed(groups):
            entries = {block: best[block] for block in group if block in best}
            if not entries:
                continue
            if len(group) == 1 and group[0] not in inner[group[0]]:
                within = {group[0]: entries[group[0]] + costs[group[0]]}
            else:
                within = self._through_loop(function, set(group), entries, costs, inner)
            for block, length in within.items():
                lengths[block] = length
                for to in inner[block]:
                    if group_of[to] != group_of[block]:
                        best[to] = max(best.get(to, 0), length)
        return lengths

    def _through_loop(
        self,
        function: Function,
        blocks: set[int],
        entries: dict[int, int],
        costs: dict[int, int],
        after: dict[int, list[int]],
    ) -> dict[int, int]:
        if len(entries) > 1:
            # Entered at several blocks: as one loop, by its lowest; each round is at most all of its blocks.
            head = min(entries)
            first = max(entries.values())
            loop = self._loop(function, head, blocks)
            rounds = self._rounds(loop)
            every = sum(costs[block] for block in blocks)
            return {block: first + rounds * every for block in blocks}
        ((head, first),) = entries.items()
        loop = self._loop(function, head, blocks)
        rounds = self._rounds(loop)
        lengths = self._lengths(function, blocks, head, head, costs, after)
        turns = [block for block in blocks if head in after[block] and block in lengths]
        a_round = max(lengths[block] for block in turns)
        return {block: first + (rounds - 1) * a_round + length for block, length in lengths.items()}

    def _loop(self, function: Function, head: int, blocks: set[int]) -> Loop:
        self._number += 1
        size = sum(len(function.blocks[block].instructions) for block in blocks)
        return Loop(function.name, self._number, head, size)

    def _rounds(self, loop: Loop) -> int:
        rounds = self.bounds.rounds(loop, self.count)
        if rounds is None:
            self.missing.append(loop)
            return 1
        return rounds


def components(nodes: set[int], after: dict[int, list[int]]) -> list[list[int]]:
    """The strongly connected components, the last first (Tarjan, *Depth-first search and linear graph algorithms*,
    1972)."""
    index: dict[int, int] = {}
    low: dict[int, int] = {}
    on_stack: set[int] = set()
    stack: list[int] = []
    found: list[list[int]] = []
    for root in sorted(nodes):
        if root in index:
            continue
        work = [(root, iter(after[root]))]
        index[root] = low[root] = len(index)
        stack.append(root)
        on_stack.add(root)
        while work:
            node, rest = work[-1]
            for to in rest:
                if to not in index:
                    index[to] = low[to] = len(index)
                    stack.append(to)
                    on_stack.add(to)
                    work.append((to, iter(after[to])))
                    break
                if to in on_stack:
                    low[node] = min(low[node], index[to])
            else:
                work.pop()
                if work:
                    low[work[-1][0]] = min(low[work[-1][0]], low[node])
                if low[node] == index[node]:
                    group = []
                    while True:
                        last = stack.pop()
                        on_stack.discard(last)
                        group.append(last)
                        if last == node:
                            break
                    found.append(group)
    return found
