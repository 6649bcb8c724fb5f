"""A chip that runs a program in Unicorn: memory, semihosting, and a clock that shows modelled cycles."""

import ctypes
import struct
from collections import Counter as Tally
from pathlib import Path
from typing import Iterator

import unicorn
from unicorn import arm_const, riscv_const
from unicorn.unicorn_py3.unicorn import uclib

from model import Model

PAGE = 0x1000
# The first timer of the MPS2 boards, and the grain of the firmware's clock there (examples/firmware/src/clock.rs).
TIMER, GRAIN = 0x4000_2000, 40
# Where RISC-V's counter stands instead of its control registers: within reach of an offset from zero.
REGISTER = 0
# The MPS2 boards: the vector table is at 0, then RAM, PSRAM with the code, and the control registers of the core.
ARM_RAM, ARM_RAM_BYTES, ARM_CODE, ARM_CODE_BYTES, ARM_SYSTEM = 0x2000_0000, 4 << 20, 0x2100_0000, 16 << 20, 0xE000_E000
RISCV_RAM, RISCV_RAM_BYTES = 0x8000_0000, 16 << 20

CPUS = {
    "thumbv6m-none-eabi": arm_const.UC_CPU_ARM_CORTEX_M0,
    "thumbv7m-none-eabi": arm_const.UC_CPU_ARM_CORTEX_M3,
    "thumbv7em-none-eabihf": arm_const.UC_CPU_ARM_CORTEX_M4,
}

EBREAK, ECALL = bytes.fromhex("73001000"), bytes.fromhex("73000000")
# A call of the host has an instruction without effect before and behind.
HOST_CALL = bytes.fromhex("1310f001") + EBREAK + bytes.fromhex("13507040")

# The function of the programs that paints the stack, as it is named when it is linked.
PAINTING = "raylet_programs5stack5depth"

Unknown = ctypes.CFUNCTYPE(None, ctypes.c_uint32, ctypes.c_uint32)


class Program:
    """A linked program: what is loaded where, and which of it is instructions."""

    def __init__(self, path: Path) -> None:
        image = path.read_bytes()
        assert image[:6] == b"\x7fELF\x01\x01", f"{path}: no program of 32 bits, little-endian"
        self.entry, headers = struct.unpack_from("<II", image, 24)
        size, count = struct.unpack_from("<HH", image, 42)
        self.segments: list[tuple[int, bytes]] = []
        self.code: list[tuple[int, int]] = []
        for index in range(count):
            kind, offset, _, physical, stored, _, flags, _ = struct.unpack_from("<8I", image, headers + index * size)
            if kind == 1 and stored:
                self.segments.append((physical, image[offset : offset + stored]))
                if flags & 1:
                    self.code.append((physical, stored))
        self.symbols = dict(_symbols(image))


def _symbols(image: bytes) -> Iterator[tuple[str, int]]:
    """The names of a program, with their addresses."""
    (sections,) = struct.unpack_from("<I", image, 32)
    size, count = struct.unpack_from("<HH", image, 46)
    headers = [struct.unpack_from("<10I", image, sections + index * size) for index in range(count)]
    for _, kind, _, _, start, length, link, *_ in headers:
        if kind == 2:
            for place in range(start, start + length, 16):
                name, address = struct.unpack_from("<II", image, place)
                name += headers[link][4]
                yield image[name : image.index(b"\0", name)].decode(), address


def as_unicorn_can(code: bytes) -> bytes:
    """The same instructions of RISC-V, but for what Unicorn does not do: reads of `minstret` are loads, since its own counter
    counts something else, and calls of the host are `ecall`, since it does not stop at `ebreak`."""
    patched = bytearray(code.replace(HOST_CALL, HOST_CALL.replace(EBREAK, ECALL)))
    for place in range(0, len(code) - 3, 2):
        (word,) = struct.unpack_from("<I", patched, place)
        for control, address in ((0xB02, REGISTER), (0xB82, REGISTER + 4)):
            # csrrs rd, control, zero: lw rd, address(zero)
            if word & 0xFFFF_F07F == control << 20 | 0x2073:
                struct.pack_into("<I", patched, place, address << 20 | 0x2003 | word & 0xF80)
    return bytes(patched)


class Machine:
    """One run of one program."""

    def __init__(self, target: str, program: Program, model: Model, library: Path) -> None:
        self.model = model
        self.output = bytearray()
        self.status: int | None = None
        self._fault: Exception | None = None
        self._classes: dict[tuple[int, int], tuple[str, ...]] = {}
        self._is_arm = target in CPUS
        if self._is_arm:
            self._uc = unicorn.Uc(unicorn.UC_ARCH_ARM, unicorn.UC_MODE_THUMB | unicorn.UC_MODE_MCLASS)
            self._uc.ctl_set_cpu_model(CPUS[target])
            for start, size in ((0, PAGE), (ARM_RAM, ARM_RAM_BYTES), (ARM_CODE, ARM_CODE_BYTES), (ARM_SYSTEM, PAGE)):
                self._uc.mem_map(start, size)
        else:
            self._uc = unicorn.Uc(unicorn.UC_ARCH_RISCV, unicorn.UC_MODE_RISCV32)
            self._uc.mem_map(RISCV_RAM, RISCV_RAM_BYTES)
        for address, content in program.segments:
            executable = any(start == address for start, _ in program.code)
            self._uc.mem_write(address, as_unicorn_can(content) if executable and not self._is_arm else content)
        # The stack is not measured: that takes far longer than all else. What would paint it returns at once.
        for name, address in program.symbols.items():
            if PAINTING in name:
                self._uc.mem_write(address & ~1, bytes.fromhex("7047" if self._is_arm else "8280"))
        self._entry = program.entry
        self._count(program, library)
        self._uc.hook_add(unicorn.UC_HOOK_INTR, self._interrupted)

    def _count(self, program: Program, library: Path) -> None:
        """Hands the counter to the emulator, which calls it without Python."""
        first = min(start for start, _ in program.code)
        end = max(start + size for start, size in program.code)
        counter = ctypes.CDLL(str(library))
        counter.counting_new.restype = ctypes.c_void_p
        counter.counting_learn.restype = ctypes.c_bool
        counter.counting_executions.restype = ctypes.c_uint64
        self._unknown = Unknown(self._learn)
        self._counter = counter
        self._counting = ctypes.c_void_p(
            counter.counting_new(first, end - first, ctypes.c_bool(self.model.predicts), GRAIN, self._unknown)
        )
        pointer = lambda function: ctypes.cast(function, ctypes.c_void_p)
        handle = self._uc._uch  # noqa: SLF001: no public way to give a function of C
        self._hook = ctypes.c_size_t()
        error = uclib.uc_hook_add(
            handle,
            ctypes.byref(self._hook),
            ctypes.c_int(unicorn.UC_HOOK_BLOCK),
            pointer(counter.counting_block),
            self._counting,
            ctypes.c_uint64(1),
            ctypes.c_uint64(0),
        )
        address, read = (TIMER, counter.counting_timer) if self._is_arm else (REGISTER, counter.counting_register)
        error = error or uclib.uc_mmio_map(
            handle, address, PAGE, pointer(read), self._counting, pointer(counter.counting_ignore), self._counting
        )
        if error:
            raise unicorn.UcError(error)

    def _learn(self, address: int, size: int) -> None:
        try:
            cost = self.model.block(bytes(self._uc.mem_read(address, size)), address)
            self._classes[address, address + size] = cost.classes
            learnt = self._counter.counting_learn(
                self._counting, address, address + size, cost.cycles, cost.taken, cost.entered, ctypes.c_bool(cost.predicted)
            )
            if not learnt:
                raise ValueError(f"instructions at {address:#x}, where the program has none")
        except Exception as error:  # noqa: BLE001: the emulator's own code is between here and `run`
            self._fault = error
            self._uc.emu_stop()

    def _interrupted(self, uc: unicorn.Uc, number: int, _: object) -> None:
        """A breakpoint is a call of the host; anything else is a fault."""
        try:
            if self._is_arm:
                place = uc.reg_read(arm_const.UC_ARM_REG_PC)
                if number != 7 or bytes(uc.mem_read(place, 2)) != b"\xab\xbe":
                    raise RuntimeError(f"exception {number} at {place:#x}")
                operation, block = uc.reg_read(arm_const.UC_ARM_REG_R0), uc.reg_read(arm_const.UC_ARM_REG_R1)
                uc.reg_write(arm_const.UC_ARM_REG_R0, self._call(operation, block))
                uc.reg_write(arm_const.UC_ARM_REG_PC, place + 2 | 1)
            else:
                place = uc.reg_read(riscv_const.UC_RISCV_REG_PC)
                if number not in (8, 11):
                    raise RuntimeError(f"exception {number} at {place:#x}")
                # It goes on behind the call by itself.
                operation, block = uc.reg_read(riscv_const.UC_RISCV_REG_A0), uc.reg_read(riscv_const.UC_RISCV_REG_A1)
                uc.reg_write(riscv_const.UC_RISCV_REG_A0, self._call(operation, block))
        except Exception as error:  # noqa: BLE001
            self._fault = error
        if self._fault or self.status is not None:
            uc.emu_stop()

    def _call(self, operation: int, block: int) -> int:
        """Semihosting, as Arm and RISC-V have it: what the programs use of it."""
        words = lambda count: struct.unpack(f"<{count}I", bytes(self._uc.mem_read(block, 4 * count)))
        match operation:
            case 0x01:  # SYS_OPEN: the console
                return 1
            case 0x02:  # SYS_CLOSE
                return 0
            case 0x03:  # SYS_WRITEC
                self.output += bytes(self._uc.mem_read(block, 1))
                return 0
            case 0x05:  # SYS_WRITE
                _, start, length = words(3)
                self.output += bytes(self._uc.mem_read(start, length))
                return 0
            case 0x18:  # SYS_EXIT
                self.status = 0 if block == 0x20026 else 1
                return 0
            case 0x20:  # SYS_EXIT_EXTENDED
                reason, status = words(2)
                self.status = status if reason == 0x20026 else 1
                return 0
        raise RuntimeError(f"semihosting call {operation:#x}")

    def run(self) -> int:
        """Runs the program to its end; its exit status."""
        entry = self._entry
        if self._is_arm:
            stack, entry = struct.unpack("<II", bytes(self._uc.mem_read(0, 8)))
            self._uc.reg_write(arm_const.UC_ARM_REG_SP, stack)
        try:
            self._uc.emu_start(entry, 0xFFFF_FFFF)
        except unicorn.UcError as error:
            place = self._uc.reg_read(arm_const.UC_ARM_REG_PC if self._is_arm else riscv_const.UC_RISCV_REG_PC)
            self._fault = self._fault or RuntimeError(f"{error} at {place:#x}")
        if self._fault:
            raise self._fault
        return 1 if self.status is None else self.status

    def classes(self) -> Tally[str]:
        """Instructions by class that were carried out while the program measured."""
        tally: Tally[str] = Tally()
        ends = (ctypes.c_uint32 * 2)()
        number = 0
        while (executions := self._counter.counting_executions(self._counting, number, ends)) != 2**64 - 1:
            for name in self._classes[ends[0], ends[1]]:
                tally[name] += executions
            number += 1
        return tally
