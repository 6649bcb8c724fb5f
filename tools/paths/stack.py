"""The most bytes of the stack that a function may take, with all that it calls."""

import re

from code import Function, Program, Unknown


def registers(text: str) -> int:
    """How many registers a list in braces has."""
    count = 0
    for part in text.strip("{} ").split(","):
        ends = [int(n) for n in re.findall(r"\d+", part)]
        count += ends[1] - ends[0] + 1 if "-" in part else 1
    return count


def growth_on_arm(program: Program, i, constants: dict[str, int]) -> int:
    """By how many bytes an instruction makes the stack longer. `constants` are the registers whose values are known."""
    name, operands = i.mnemonic.removesuffix(".w"), i.op_str
    if name == "push" or name == "vpush":
        width = 8 if name == "vpush" and "d" in operands else 4
        return width * registers(operands)
    if name in ("pop", "vpop"):
        width = 8 if name == "vpop" and "d" in operands else 4
        return -width * registers(operands)
    if name.startswith("stmdb") and operands.startswith("sp!"):
        return 4 * registers(operands.split("{")[1])
    if name.startswith("ldm") and operands.startswith("sp!"):
        return -4 * registers(operands.split("{")[1])
    if name.startswith("str") and operands.endswith("]!") and "[sp, #-" in operands:
        return int(operands.split("#-")[1].rstrip("]!"), 0)
    if name.startswith("ldr") and re.search(r"\[sp\], #", operands):
        return -int(operands.rsplit("#", 1)[1], 0)
    if name in ("sub", "subw", "add", "addw") and operands.split(",")[0] == "sp":
        sign = 1 if name.startswith("sub") else -1
        last = operands.split(",")[-1].strip()
        if last.startswith("#"):
            return sign * int(last[1:], 0)
        if last in constants:
            value = constants[last]
            return sign * (value - (1 << 32) if value >= 1 << 31 else value)
        raise Unknown(f"the stack grows by {last} at {i.address:#x}")
    return 0


def note_constant_of_arm(program: Program, i, constants: dict[str, int]) -> None:
    """Keeps the values of registers that are loaded from the code."""
    first = i.op_str.split(",")[0].strip()
    literal = re.fullmatch(r"(r\d+), \[pc, #(.+)\]", i.op_str)
    if i.mnemonic.startswith("ldr") and literal:
        address = ((i.address + 4) & ~3) + int(literal[2], 0)
        constants[literal[1]] = int.from_bytes(program.bytes_at(address, 4), "little")
    elif i.mnemonic in ("mov", "movs", "movw", "mov.w") and "#" in i.op_str:
        constants[first] = int(i.op_str.rsplit("#", 1)[1], 0)
    elif not i.mnemonic.startswith(("str", "cmp", "tst", "push", "b")):
        constants.pop(first, None)


def growth_on_riscv(i) -> int:
    name, operands = i.mnemonic.removeprefix("c."), [part.strip() for part in i.op_str.split(",")]
    if operands[0] != "sp":
        return 0
    if name == "addi16sp" or name == "addi" and operands[1] in ("sp",) or name == "addi" and len(operands) == 2:
        return -int(operands[-1], 0)
    if name in ("add", "sub", "mv"):
        raise Unknown(f"the stack grows by a register at {i.address:#x}")
    return 0


class Stacks:
    """The stacks of a program's functions."""

    def __init__(self, program: Program) -> None:
        self.program = program
        self.known: dict[int, int] = {}
        self.through: dict[int, int | None] = {}
        self.under_way: list[int] = []

    def of(self, start: int) -> int:
        """Of the function that starts there."""
        if start in self.known:
            return self.known[start]
        if start in self.under_way:
            circle = [self.program.names[of] for of in self.under_way[self.under_way.index(start) :]]
            raise Unknown("functions call each other in a circle: " + ", ".join(circle))
        self.under_way.append(start)
        self.known[start], self.through[start] = self._walk(self.program.function(start))
        self.under_way.pop()
        return self.known[start]

    def _walk(self, function: Function) -> tuple[int, int | None]:
        program, most, through = self.program, 0, None
        depths, waiting = {function.start: 0}, [function.start]

        def take(depth: int, callee: int | None) -> None:
            nonlocal most, through
            if depth > most:
                most, through = depth, callee

        while waiting:
            block = function.blocks[waiting.pop()]
            depth, constants = depths[block.start], {}
            calls = dict(block.calls)
            for index, i in enumerate(block.instructions):
                depth += growth_on_arm(program, i, constants) if program.is_arm else growth_on_riscv(i)
                take(depth, None)
                if program.is_arm:
                    note_constant_of_arm(program, i, constants)
                if index in calls:
                    take(depth + self.of(self.start_of(calls[index])), calls[index])
            if block.leaves_to is not None:
                take(depth + self.of(self.start_of(block.leaves_to)), block.leaves_to)
            for after in block.after:
                if after not in depths:
                    depths[after] = depth
                    waiting.append(after)
                elif depths[after] != depth:
                    raise Unknown(f"{function.name}: two depths of the stack at {after:#x}")
        return most, through

    def start_of(self, address: int) -> int:
        """The function of an address that is called, or jumped to."""
        start = self.program.containing(address)
        if start is None:
            raise Unknown(f"no function is at {address:#x}")
        return start

    def path(self, start: int) -> list[tuple[str, int]]:
        """The calls that take the most: each function with what it takes, all that it calls included."""
        self.of(start)
        path, at = [], start
        while at is not None:
            path.append((self.program.names[at], self.known[at]))
            callee = self.through[at]
            at = None if callee is None else self.start_of(callee)
        return path
