"""What a block of instructions takes on a chip: the latencies of `latencies.toml`, and the rules that join two instructions."""

import tomllib
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Iterable

import capstone
from capstone import arm, arm_const, riscv_const

TABLE = Path(__file__).with_name("latencies.toml")

# Which end of a range is taken; or an instruction is one.
ENDS = ("least", "most", "instructions")


@dataclass(frozen=True)
class Latency:
    """Cycles of the instructions of a class."""

    name: str
    cycles: int
    each: int
    taken: int


@dataclass(frozen=True)
class Cost:
    """Cycles of a block, as the counter takes them, and its instructions by class."""

    cycles: int
    taken: int
    entered: int
    predicted: bool
    classes: tuple[str, ...]


def _end(figure: int | list[int], end: str) -> int:
    if isinstance(figure, int):
        return figure
    least, most = figure
    return least if end == "least" else most


class Model:
    """The latencies of a chip."""

    def __init__(self, target: str, end: str = "most") -> None:
        assert end in ENDS
        chip: dict[str, Any] = tomllib.loads(TABLE.read_text())[target]
        self.core: str = chip["core"]
        self.is_arm = target.startswith("thumb")
        # Where an instruction is one, nothing else counts.
        self._as_one = end == "instructions"
        self._rules: dict[str, int] = {
            name: 0 if self._as_one else int(chip.get(name, 0))
            for name in ("load_before_access", "load_before_use", "float_before_use", "unaligned_target")
        }
        self.predicts: bool = chip.get("predicts", False) and not self._as_one
        self.classes: dict[str, Latency] = {}
        self._of: dict[str, Latency] = {}
        for name, row in chip["classes"].items():
            latency = Latency(name, *(_end(row.get(figure, 0), end) for figure in ("cycles", "each", "taken")))
            if self._as_one:
                latency = Latency(name, 1, 0, 0)
            self.classes[name] = latency
            for instruction in row["of"].split():
                assert instruction not in self._of, f"{target}: {instruction} is in two classes"
                self._of[instruction] = latency
        if self.is_arm:
            self._decoder = capstone.Cs(capstone.CS_ARCH_ARM, capstone.CS_MODE_THUMB | capstone.CS_MODE_MCLASS)
        else:
            self._decoder = capstone.Cs(capstone.CS_ARCH_RISCV, capstone.CS_MODE_RISCV32 | capstone.CS_MODE_RISCVC)
        self._decoder.detail = True

    def name(self, instruction: capstone.CsInsn) -> str:
        """The name of an instruction in the table."""
        return str(instruction.insn_name()).removeprefix("c.")

    def latency(self, instruction: capstone.CsInsn) -> Latency:
        """The class of an instruction."""
        name = self.name(instruction)
        latency = self._of.get(name)
        if latency is None:
            raise ValueError(f"{self.core}: no class has {instruction.mnemonic} {instruction.op_str} ({name})")
        if self.is_arm:
            indexed = any(op.type == arm_const.ARM_OP_MEM and op.mem.index for op in instruction.operands)
            if latency.name == "store" and indexed and "store_by_register" in self.classes:
                return self.classes["store_by_register"]
            if name == "vmov" and len(instruction.operands) > 2:
                return self.classes["float_move_pair"]
        return latency

    def block(self, code: bytes, address: int) -> Cost:
        """What a block takes."""
        instructions = list(self._decoder.disasm(code, address))
        decoded = sum(instruction.size for instruction in instructions)
        if decoded != len(code):
            raise ValueError(f"{self.core}: {code[decoded:][:4].hex()} at {address + decoded:#x} is no instruction")
        latencies = [self.latency(instruction) for instruction in instructions]
        cycles = sum(
            latency.cycles + (latency.each * self._words(instruction) if latency.each else 0)
            for latency, instruction in zip(latencies, instructions)
        )
        for latency, first, second in zip(latencies, instructions, instructions[1:]):
            cycles += self._joined(latency, first, second)
        first, last = instructions[0], instructions[-1]
        return Cost(
            cycles=cycles,
            taken=latencies[-1].taken,
            entered=self._rules["unaligned_target"] if first.size == 4 and address % 4 == 2 else 0,
            predicted=self.predicts and latencies[-1].name == "branch" and self._leads_back(last),
            classes=tuple(latency.name for latency in latencies),
        )

    @staticmethod
    def _words(instruction: capstone.CsInsn) -> int:
        """Registers in the list of an Arm instruction; a double is two words."""
        registers = [op.reg for op in instruction.operands if op.type == arm_const.ARM_OP_REG]
        if instruction.id in (arm_const.ARM_INS_LDM, arm_const.ARM_INS_LDMDB, arm_const.ARM_INS_STM, arm_const.ARM_INS_STMDB):
            return len(registers) - 1
        if instruction.id in (arm_const.ARM_INS_PUSH, arm_const.ARM_INS_POP):
            return len(registers)
        names = [str(instruction.reg_name(register)) for register in registers]
        return sum({"s": 1, "d": 2}[name[0]] for name in names if name[0] in "sd" and name[1:].isdigit())

    def _joined(self, latency: Latency, first: capstone.CsInsn, second: capstone.CsInsn) -> int:
        """What two instructions take more, or less, since one follows the other."""
        rules = self._rules
        if rules["load_before_access"] and latency.name == "load":
            single = self._of.get(self.name(second))
            if single and single.name in ("load", "store") and first.operands[0].reg not in _addressed(second):
                return -rules["load_before_access"]
        if rules["load_before_use"] and latency.name == "load":
            if first.operands[0].reg in _used_on_riscv(second, self.name(second)):
                return rules["load_before_use"]
        arithmetic = latency.name.startswith("float_") and latency.name not in ("float_move", "float_move_pair", "float_memory")
        if rules["float_before_use"] and arithmetic and first.operands[0].reg in self._used_on_arm(second):
            return rules["float_before_use"]
        return 0

    def _used_on_arm(self, instruction: capstone.CsInsn) -> Iterable[int]:
        following = self._of.get(self.name(instruction))
        if following and following.name == "float_multiply_and_add":
            return [op.reg for op in instruction.operands[1:]]
        return list(instruction.regs_access()[0])

    @staticmethod
    def _leads_back(instruction: capstone.CsInsn) -> bool:
        offset = instruction.operands[-1]
        return offset.type == riscv_const.RISCV_OP_IMM and offset.imm < 0


def _addressed(instruction: capstone.CsInsn) -> list[int]:
    """The registers that an Arm load or store computes its address of."""
    memory = [op.mem for op in instruction.operands if op.type == arm_const.ARM_OP_MEM]
    return [register for mem in memory for register in (mem.base, mem.index) if register]


# Compressed instructions of two operands that do not read the first.
_ONLY_WRITTEN = ("li", "lui", "mv", "lwsp", "lw", "addi4spn")


def _used_on_riscv(instruction: capstone.CsInsn, name: str) -> list[int]:
    """The registers that a RISC-V instruction reads, but for what it stores."""
    operands = instruction.operands
    read = [op.mem.base for op in operands if op.type == riscv_const.RISCV_OP_MEM]
    registers = [op.reg for op in operands if op.type == riscv_const.RISCV_OP_REG]
    if name.startswith("b") or name in ("jr", "jalr"):
        return read + registers
    if name in ("sb", "sh", "sw", "swsp"):
        return read + registers[1:]
    # Of a compressed instruction the first operand is often read and written.
    if instruction.insn_name().startswith("c.") and name not in _ONLY_WRITTEN:
        return read + registers
    return read + registers[1:]
