"""The most instructions that a function may carry out, with all that it calls: the longest path through its blocks.

A loop is a set of blocks from each of which every other can be reached. It is entered at one block, its head, and is
gone through as often as the table of bounds says. Paths that no input takes count too: so this is an upper bound.
"""

from dataclasses import dataclass

from code import Function, Program, Unknown


@dataclass
class Loop:
    """A loop: the function that it is in, its number there by address, and how many instructions it has."""

    function: str
    number: int
    address: int
    instructions: int


class Missing(Exception):
    """A loop without a bound."""

    def __init__(self, loop: Loop) -> None:
        super().__init__(f"{loop.function}: no bound of loop {loop.number} at {loop.address:#x}")
        self.loop = loop


class Longest:
    """The longest paths of a program. `bound` gives the most rounds of a loop, or None if it is not known."""

    def __init__(self, program: Program, bound) -> None:
        self.program, self.bound = program, bound
        self.known: dict[int, int] = {}
        self.missing: list[Loop] = []

    def of(self, start: int) -> int:
        """Of the function that starts there, its last instruction included."""
        if start not in self.known:
            self.known[start] = 0
            function = self.program.function(start)
            self.known[start] = self._of_function(function)
        return self.known[start]

    def _of_function(self, function: Function) -> int:
        costs = {}
        for block in function.blocks.values():
            cost = len(block.instructions)
            for _, callee in block.calls:
                cost += self.of(self._start_of(callee))
            if block.leaves_to is not None:
                cost += self.of(self._start_of(block.leaves_to))
            costs[block.start] = cost
        after = {block.start: [to for to in block.after] for block in function.blocks.values()}
        self._number = 0
        lengths = self._lengths(function, set(costs), function.start, costs, after)
        return max(lengths.values())

    def _start_of(self, address: int) -> int:
        start = self.program.containing(address)
        if start is None:
            raise Unknown(f"no function is at {address:#x}")
        return start

    def _lengths(
        self, function: Function, blocks: set[int], head: int, costs: dict[int, int], after: dict[int, list[int]]
    ) -> dict[int, int]:
        """The longest way from the head to each block, both included; edges back to the head are left out."""
        inner = {block: [to for to in after[block] if to in blocks and to != head] for block in blocks}
        groups = components(blocks, inner)
        group_of = {block: index for index, group in enumerate(groups) for block in group}
        # Groups come in the order of their edges, the first last.
        best: dict[int, int] = {head: 0}
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
        lengths = self._lengths(function, blocks, head, costs, after)
        turns = [block for block in blocks if head in after[block] and block in lengths]
        a_round = max(lengths[block] for block in turns)
        return {block: first + (rounds - 1) * a_round + length for block, length in lengths.items()}

    def _loop(self, function: Function, head: int, blocks: set[int]) -> Loop:
        self._number += 1
        size = sum(len(function.blocks[block].instructions) for block in blocks)
        return Loop(function.name, self._number, head, size)

    def _rounds(self, loop: Loop) -> int:
        rounds = self.bound(loop)
        if rounds is None:
            self.missing.append(loop)
            return 1
        return rounds


def components(nodes: set[int], after: dict[int, list[int]]) -> list[list[int]]:
    """The strongly connected components, the last first (Tarjan, *Depth-first search and linear graph algorithms*, 1972)."""
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
