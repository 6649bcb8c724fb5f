"""The functions of a linked program: blocks of instructions, where each leads, and what each calls."""

import re
import struct
from bisect import bisect_right
from dataclasses import dataclass, field
from pathlib import Path

import capstone
from capstone import CS_ARCH_ARM, CS_ARCH_RISCV, CS_MODE_MCLASS, CS_MODE_RISCV32, CS_MODE_RISCVC, CS_MODE_THUMB

SYMBOL, FUNCTION = 16, 2
# The conditions of a branch of Arm's.
CONDITION = r"(?:eq|ne|cs|hs|cc|lo|mi|pl|vs|vc|hi|ls|ge|lt|gt|le)"


class Unknown(Exception):
    """Code that is not understood; the message says where."""


@dataclass
class Block:
    """Instructions that are carried out one after the other."""

    start: int
    instructions: list[capstone.CsInsn]
    # The blocks that may follow, by address.
    after: list[int] = field(default_factory=list)
    # The functions that its instructions call, each with the index of the instruction; and the one that it ends in.
    calls: list[tuple[int, int]] = field(default_factory=list)
    leaves_to: int | None = None


@dataclass
class Function:
    """A function: its name, and its blocks by address; the first is at its start."""

    name: str
    start: int
    end: int
    blocks: dict[int, Block] = field(default_factory=dict)


class Program:
    """A linked program of 32 bits, by its symbols."""

    def __init__(self, path: Path) -> None:
        self.image = path.read_bytes()
        assert self.image[:6] == b"\x7fELF\x01\x01", f"{path}: no program of 32 bits, little-endian"
        (machine,) = struct.unpack_from("<H", self.image, 18)
        self.is_arm = machine == 40
        if self.is_arm:
            self.decoder = capstone.Cs(CS_ARCH_ARM, CS_MODE_THUMB | CS_MODE_MCLASS)
        else:
            self.decoder = capstone.Cs(CS_ARCH_RISCV, CS_MODE_RISCV32 | CS_MODE_RISCVC)
        self.decoder.detail = False
        self.segments = [
            (header[2], header[1], header[4])
            for header in self._headers(28, 42, "<8I")
            if header[0] == 1 and header[4]
        ]
        functions = {}
        for name, value, size, kind in self._symbols():
            start = value & ~1 if self.is_arm else value
            if kind == FUNCTION and size and (start not in functions or functions[start][1] < size):
                functions[start] = (name, size)
        self.starts = sorted(functions)
        self.names = {start: functions[start][0] for start in self.starts}
        self.sizes = {start: functions[start][1] for start in self.starts}
        self._read: dict[int, Function] = {}

    def _headers(self, table: int, counts: int, form: str) -> list[tuple[int, ...]]:
        (start,) = struct.unpack_from("<I", self.image, table)
        size, count = struct.unpack_from("<HH", self.image, counts)
        return [struct.unpack_from(form, self.image, start + i * size) for i in range(count)]

    def _symbols(self):
        sections = self._headers(32, 46, "<10I")
        for _, kind, _, _, start, length, link, *_ in sections:
            if kind != 2:
                continue
            for place in range(start, start + length, SYMBOL):
                name, value, size, info = struct.unpack_from("<IIIB", self.image, place)
                name += sections[link][4]
                yield self.image[name : self.image.index(b"\0", name)].decode(), value, size, info & 15

    def bytes_in_flash(self) -> int:
        """What is stored of the program: code, constants, and first values of statics."""
        return sum(size for _, _, size in self.segments)

    def bytes_at(self, address: int, count: int) -> bytes:
        """What is loaded there."""
        for start, offset, size in self.segments:
            if start <= address and address + count <= start + size:
                return self.image[offset + address - start : offset + address - start + count]
        raise Unknown(f"nothing is loaded at {address:#x}")

    def named(self, name: str) -> int:
        """The address of a function."""
        found = [start for start in self.starts if self.names[start] == name]
        if len(found) != 1:
            raise Unknown(f"{len(found)} functions are called {name}")
        return found[0]

    def containing(self, address: int) -> int | None:
        """The start of the function that an address is in."""
        place = bisect_right(self.starts, address) - 1
        if place < 0 or address >= self.starts[place] + self.sizes[self.starts[place]]:
            return None
        return self.starts[place]

    def function(self, start: int) -> Function:
        """The function that starts there, taken apart."""
        if start not in self._read:
            self._read[start] = _taken_apart(self, start)
        return self._read[start]


@dataclass
class Step:
    """Where an instruction leads."""

    targets: list[int] = field(default_factory=list)
    goes_on: bool = True
    call: int | None = None
    # A jump out of the function: a tail call.
    leaves_to: int | None = None


def _number(text: str) -> int:
    return int(text.rsplit("#", 1)[-1].split(",")[-1].strip(), 0)


def _step_of_arm(program: Program, function: Function, i: capstone.CsInsn, before: list[capstone.CsInsn]) -> Step:
    name = i.mnemonic.removesuffix(".w").removesuffix(".n")
    inside = lambda target: function.start <= target < function.end
    if name in ("bl", "blx"):
        if not i.op_str.startswith("#"):
            raise Unknown(f"{function.name}: a call of what is in a register at {i.address:#x}")
        target = _number(i.op_str)
        # In a long function of 16-bit instructions a far jump is a call, whose return address is not used.
        if function.start < target < function.end:
            return Step([target], goes_on=False)
        return Step(call=target)
    if name == "b" or re.fullmatch(f"b{CONDITION}", name) or name in ("cbz", "cbnz"):
        target, goes_on = _number(i.op_str), name != "b"
        return Step([target], goes_on) if inside(target) else Step([], goes_on, leaves_to=target)
    if name == "bx" and i.op_str == "lr" or name in ("pop", "ldm") and "pc" in i.op_str or name == "udf":
        return Step(goes_on=False)
    if name in ("tbb", "tbh"):
        width = 2 if name == "tbh" else 1
        return Step(_offsets_behind(program, function, i.address + 4, i.address + 4, width), goes_on=False)
    if name == "add" and i.op_str.startswith("pc, r"):
        width = 2 if any(b.mnemonic == "ldrh" for b in before[-2:]) else 1
        place = _start_of_table(before[-8:], i.address + 2 + 3 & ~3)
        return Step(_offsets_behind(program, function, place, i.address + 4, width), goes_on=False)
    if name == "mov" and i.op_str.startswith("pc, r"):
        return Step(_addresses_behind(program, function, i.address), goes_on=False)
    if name == "bx" or i.op_str.startswith("pc"):
        raise Unknown(f"{function.name}: a jump to what is in a register at {i.address:#x}")
    return Step()


def _start_of_table(before: list[capstone.CsInsn], behind: int) -> int:
    """Where the table starts that the instructions before a jump read: `adr r, #n`, or `add r, pc` and `[r, #n]`;
    otherwise behind the jump."""
    for at, b in enumerate(before):
        if b.mnemonic == "adr":
            behind = (b.address + 4 & ~3) + _number(b.op_str)
        elif b.mnemonic == "add" and b.op_str.endswith(", pc"):
            loads = [load for load in before[at:] if load.mnemonic in ("ldrb", "ldrh") and "#" in load.op_str]
            behind = b.address + 4 + (_number(loads[0].op_str.rstrip("]")) if loads else 0)
    return behind


def _first_constant_behind(program: Program, function: Function, address: int) -> int:
    """Where the first constant behind an address stands that the function loads."""
    constants = [function.end]
    for place in range(function.start, function.end, 2):
        # ldr r, [pc, #n], of 16 bits. What only looks like one makes a table shorter, which is noticed below.
        (word,) = struct.unpack("<H", program.bytes_at(place, 2))
        if word >> 11 == 0b01001:
            constants.append((place + 4 & ~3) + (word & 0xFF) * 4)
    return min(constant for constant in constants if constant > address + 2)


def _offsets_behind(program: Program, function: Function, place: int, pc: int, width: int) -> list[int]:
    """The targets of a table of bytes or halfwords, in steps of two from `pc`. It ends at the first of them or at a
    constant."""
    end = _first_constant_behind(program, function, place)
    targets, start = [], place
    while place + width <= end:
        target = pc + 2 * int.from_bytes(program.bytes_at(place, width), "little")
        # What fills up, or a `nop` that does before a constant.
        if not place < target < function.end or program.bytes_at(place, 2) == b"\xc0\x46":
            break
        end = min(end, target)
        targets.append(target)
        place += width
    if len(targets) < 2:
        raise Unknown(f"{function.name}: no table at {start:#x}")
    return targets


def _addresses_behind(program: Program, function: Function, address: int) -> list[int]:
    """The targets of a table of words behind `mov pc, r`, which ends at the first of them."""
    start, targets = address + 2 + 3 & ~3, []
    end = function.end
    while start + 4 * len(targets) < end:
        target = int.from_bytes(program.bytes_at(start + 4 * len(targets), 4), "little")
        if not target & 1 or not function.start <= target < function.end:
            break
        end = min(end, target & ~1)
        targets.append(target & ~1)
    if len(targets) < 2:
        raise Unknown(f"{function.name}: no table behind {address:#x}")
    return targets


def _step_of_riscv(program: Program, function: Function, i: capstone.CsInsn, before: list[capstone.CsInsn]) -> Step:
    name, operands = i.mnemonic.removeprefix("c."), [part.strip() for part in i.op_str.split(",")]
    inside = lambda target: function.start <= target < function.end
    # capstone gives offsets from the instruction.
    to = lambda: i.address + int(operands[-1], 0)
    if name in ("j", "jal"):
        target = to()
        if name == "jal" and (len(operands) == 1 or operands[0] == "ra"):
            return Step(call=target)
        return Step([target], False) if inside(target) else Step([], False, leaves_to=target)
    if re.fullmatch(r"b(eq|ne|lt|ge|ltu|geu|gt|le|gtu|leu)z?", name):
        target = to()
        return Step([target]) if inside(target) else Step([], leaves_to=target)
    if name == "ret" or name in ("jr", "jalr") and operands == ["ra"] and name == "jr":
        return Step(goes_on=False)
    if name in ("jr", "jalr"):
        # auipc of the same register before: a far call, or a far jump.
        register = operands[-1] if "(" not in operands[-1] else operands[-1].split("(")[1].rstrip(")")
        register, offset = (operands[1], operands[2]) if len(operands) == 3 else (register, operands[-1].split("(")[0])
        last = before[-1] if before else None
        if last is not None and last.mnemonic == "auipc" and last.op_str.split(",")[0] == register:
            upper = int(last.op_str.split(",")[1], 0) << 12
            offset = int(offset, 0) if re.fullmatch(r"-?(0x)?[0-9a-f]+", offset) else 0
            target = (last.address + upper + offset) & 0xFFFF_FFFF
            links = name == "jalr" and (len(operands) == 1 or operands[0] in ("ra", "t0"))
            return Step(call=target) if links else Step([], False, leaves_to=target)
        return Step(_table_of_riscv(program, function, i, before), goes_on=False)
    if name in ("unimp", "ebreak"):
        return Step(goes_on=name == "ebreak")
    return Step()


def _table_of_riscv(
    program: Program, function: Function, i: capstone.CsInsn, before: list[capstone.CsInsn]
) -> list[int]:
    """The targets of a jump by a table of words: its address is loaded by `lui` and `addi`, and a word of it from
    there. It ends where a word is no place in the function."""
    text = [(b.mnemonic.removeprefix("c."), [part.strip() for part in b.op_str.split(",")]) for b in before[-12:]]
    for at in range(len(text) - 1, -1, -1):
        name, operands = text[at]
        upper = [int(o[1], 0) for n, o in text[:at] if n == "lui" and o[0] == operands[0]]
        if name == "addi" and len(operands) >= 2 and upper and operands[-1].lstrip("-").isalnum():
            place, targets = (upper[-1] << 12) + int(operands[-1], 0) & 0xFFFF_FFFF, []
            while True:
                try:
                    target = int.from_bytes(program.bytes_at(place + 4 * len(targets), 4), "little")
                except Unknown:
                    break
                if not function.start <= target < function.end:
                    break
                targets.append(target)
            if len(targets) > 1:
                return targets
    raise Unknown(f"{function.name}: a jump to what is in a register at {i.address:#x}: {i.mnemonic} {i.op_str}")


def _taken_apart(program: Program, start: int) -> Function:
    function = Function(program.names[start], start, start + program.sizes[start])
    step_of = _step_of_arm if program.is_arm else _step_of_riscv
    code = program.bytes_at(start, function.end - start)
    # From the start along every branch: constants between the instructions are not reached.
    instructions: dict[int, tuple[capstone.CsInsn, Step]] = {}
    leaders, waiting = {start}, [start]
    while waiting:
        address, before = waiting.pop(), []
        while address not in instructions:
            if not start <= address < function.end:
                raise Unknown(f"{function.name}: goes on behind its end, at {address:#x}")
            i = next(program.decoder.disasm(code[address - start : address - start + 4], address, 1), None)
            if i is None:
                raise Unknown(f"{function.name}: no instruction at {address:#x}")
            step = step_of(program, function, i, before)
            instructions[address] = (i, step)
            before.append(i)
            leaders.update(step.targets)
            waiting.extend(step.targets)
            if not step.goes_on:
                break
            address += i.size
            if step.targets or step.leaves_to is not None:
                leaders.add(address)
    for leader in sorted(leaders):
        block, address = Block(leader, []), leader
        while True:
            i, step = instructions[address]
            if step.call is not None:
                block.calls.append((len(block.instructions), step.call))
            block.instructions.append(i)
            address += i.size
            if step.targets or step.leaves_to is not None or not step.goes_on or address in leaders:
                block.after = [*step.targets, *([address] if step.goes_on else [])]
                block.leaves_to = step.leaves_to
                break
        function.blocks[leader] = block
    return function
