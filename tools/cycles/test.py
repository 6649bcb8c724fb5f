"""Tests of the model, by instructions assembled by hand: `python3 test.py`. `.ci/cycles` runs them first; they take a second."""

import struct
import sys
import unittest
from pathlib import Path

from compare import differing, read
from machine import EBREAK, as_unicorn_can
from model import Cost, Model

M0, M3, M4, RISCV = "thumbv6m-none-eabi", "thumbv7m-none-eabi", "thumbv7em-none-eabihf", "riscv32imc-unknown-none-elf"

# A class each: the chip, an instruction, its class, cycles at least and at most, and how many more where it branches.
SINGLE: list[tuple[str, str, str, str, tuple[int, int], tuple[int, int]]] = [
    (M0, "6641", "adcs r6, r4", "simple", (1, 1), (1, 1)),
    (M0, "5843", "muls r0, r3, r0", "multiply", (1, 1), (0, 0)),
    (M0, "cc68", "ldr r4, [r1, #12]", "load", (2, 2), (0, 0)),
    (M0, "0060", "str r0, [r0]", "store", (2, 2), (0, 0)),
    (M0, "f0b5", "push {r4, r5, r6, r7, lr}", "several", (6, 6), (0, 0)),
    (M0, "4cc5", "stm r5!, {r2, r3, r6}", "several", (4, 4), (0, 0)),
    (M0, "f0bd", "pop {r4, r5, r6, r7, pc}", "pop", (6, 6), (2, 2)),
    (M0, "00d1", "bne", "branch", (1, 1), (1, 1)),
    (M0, "7047", "bx lr", "branch", (1, 1), (1, 1)),
    (M0, "00f090f8", "bl", "call", (1, 1), (2, 2)),
    (M0, "bff35f8f", "dmb", "special", (3, 3), (0, 0)),
    (M3, "7041", "adcs r0, r6", "simple", (1, 1), (1, 3)),
    (M3, "c8bf", "it gt", "conditions", (0, 1), (0, 0)),
    (M3, "6343", "muls r3, r4, r3", "multiply", (1, 1), (0, 0)),
    (M3, "01fb0633", "mla r3, r1, r6, r3", "multiply_and_add", (2, 2), (0, 0)),
    (M3, "a3fb000c", "umull r0, ip, r3, r0", "multiply_long", (3, 5), (0, 0)),
    (M3, "c5fb0614", "smlal r1, r4, r5, r6", "multiply_long_and_add", (4, 7), (0, 0)),
    (M3, "b3fbf2f2", "udiv r2, r3, r2", "divide", (2, 12), (0, 0)),
    (M3, "4078", "ldrb r0, [r0, #1]", "load", (2, 2), (1, 3)),
    (M3, "cdf808c0", "str ip, [sp, #8]", "store", (1, 1), (0, 0)),
    (M3, "8854", "strb r0, [r1, r2]", "store_by_register", (2, 2), (0, 0)),
    (M3, "d5e90006", "ldrd r0, r6, [r5]", "pair", (3, 3), (0, 0)),
    (M3, "51e8003f", "ldrex r3, [r1]", "exclusive", (2, 2), (0, 0)),
    (M3, "95e8400c", "ldm r5, {r6, sl, fp}", "several", (4, 4), (1, 3)),
    (M3, "59b3", "cbz r1", "branch", (1, 1), (1, 3)),
    (M3, "dfe801f0", "tbb [pc, r1]", "table", (2, 2), (1, 3)),
    (M3, "eff31080", "mrs r0, primask", "special", (1, 2), (0, 0)),
    (M4, "54eb0601", "adcs r1, r4, r6", "simple", (1, 1), (1, 3)),
    (M4, "c8bf", "it gt", "conditions", (0, 1), (0, 0)),
    (M4, "13fb3322", "smlatt r2, r3, r3, r2", "multiply", (1, 1), (0, 0)),
    (M4, "a2fb0116", "umull r1, r6, r2, r1", "multiply_long", (1, 1), (0, 0)),
    (M4, "b3fbf2f2", "udiv r2, r3, r2", "divide", (2, 12), (0, 0)),
    (M4, "4a68", "ldr r2, [r1, #4]", "load", (2, 2), (1, 3)),
    (M4, "0391", "str r1, [sp, #12]", "store", (1, 1), (0, 0)),
    (M4, "0b50", "str r3, [r1, r0]", "store_by_register", (2, 2), (0, 0)),
    (M4, "c0e90212", "strd r1, r2, [r0, #8]", "pair", (3, 3), (0, 0)),
    (M4, "51e8003f", "ldrex r3, [r1]", "exclusive", (2, 2), (0, 0)),
    (M4, "bde8000f", "pop {r8, sb, sl, fp}", "several", (5, 5), (1, 3)),
    (M4, "9047", "blx r2", "branch", (1, 1), (1, 3)),
    (M4, "dfe813f0", "tbh [pc, r3, lsl #1]", "table", (2, 2), (1, 3)),
    (M4, "eff31080", "mrs r0, primask", "special", (1, 2), (0, 0)),
    (M4, "b0ee408a", "vmov.f32 s16, s0", "float_move", (1, 1), (0, 0)),
    (M4, "f1ee10fa", "vmrs apsr_nzcv, fpscr", "float_move", (1, 1), (0, 0)),
    (M4, "55ec109b", "vmov sb, r5, d0", "float_move_pair", (2, 2), (0, 0)),
    (M4, "30ee010a", "vadd.f32 s0, s0, s2", "float_arithmetic", (1, 1), (0, 0)),
    (M4, "01ee003a", "vmla.f32 s6, s2, s0", "float_multiply_and_add", (3, 3), (0, 0)),
    (M4, "81ee000a", "vdiv.f32 s0, s2, s0", "float_divide", (14, 14), (0, 0)),
    (M4, "b1eec00a", "vsqrt.f32 s0, s0", "float_root", (14, 14), (0, 0)),
    (M4, "91ed000a", "vldr s0, [r1]", "float_memory", (2, 2), (0, 0)),
    (M4, "9aec04eb", "vldmia sl, {d14, d15}", "float_memory", (5, 5), (0, 0)),
    (RISCV, "33040100", "add s0, sp, zero", "simple", (1, 1), (0, 0)),
    (RISCV, "f32340f1", "csrr t2, mhartid", "control_register", (1, 1), (0, 0)),
    (RISCV, "b3b7f703", "mulhu a5, a5, t6", "multiply", (1, 1), (0, 0)),
    (RISCV, "3344f502", "div s0, a0, a5", "divide", (18, 19), (0, 0)),
    (RISCV, "3354f502", "divu s0, a0, a5", "divide_unsigned", (18, 18), (0, 0)),
    (RISCV, "b240", "lw ra, 12(sp)", "load", (1, 1), (0, 0)),
    (RISCV, "2320a100", "sw a0, 0(sp)", "store", (1, 1), (0, 0)),
    (RISCV, "67808000", "jalr zero, 8(ra)", "jump", (1, 1), (1, 1)),
    (RISCV, "8287", "jr a5", "jump", (1, 1), (1, 1)),
    (RISCV, "89c9", "beqz a1", "branch", (1, 1), (1, 1)),
]

# Two instructions whose cycles are not the sum of each alone.
JOINED: list[tuple[str, str, str, int]] = [
    (M3, "4a680b60", "ldr r2, [r1, #4]; str r3, [r1]", 2 + 1 - 1),
    (M3, "4a681360", "ldr r2, [r1, #4]; str r3, [r2]: its address", 2 + 1),
    (M3, "4a688b54", "ldr r2, [r1, #4]; strb r3, [r1, r2]: its address", 2 + 2),
    (M3, "4a681b18", "ldr r2, [r1, #4]; adds r3, r3, r0", 2 + 1),
    (M0, "4a680b60", "ldr r2, [r1, #4]; str r3, [r1]", 2 + 2),
    (M4, "4a680b60", "ldr r2, [r1, #4]; str r3, [r1]", 2 + 1 - 1),
    (M4, "30ee010a20ee021a", "vadd s0, s0, s2; vmul s2, s0, s4: it uses s0", 1 + 1 + 1),
    (M4, "30ee010a21ee022a", "vadd s0, s0, s2; vmul s4, s2, s4", 1 + 1),
    (M4, "30ee010a01ee020a", "vadd s0, s0, s2; vmla s0, s2, s4: it adds to s0", 1 + 3),
    (M4, "30ee010a00ee021a", "vadd s0, s0, s2; vmla s2, s0, s4: it multiplies s0", 1 + 1 + 3),
    (RISCV, "83a54500" "b3855500", "lw a1, 4(a1); add a1, a1, t0: it uses a1", 1 + 1 + 1),
    (RISCV, "83a54500" "3385a200", "lw a1, 4(a1); add a0, t0, a0", 1 + 1),
    (RISCV, "83a54500" "2320b100", "lw a1, 4(a1); sw a1, 0(sp): it stores a1", 1 + 1),
    (RISCV, "83a54500" "23a0a500", "lw a1, 4(a1); sw a0, 0(a1): its address", 1 + 1 + 1),
    (RISCV, "83a54500" "6395c500", "lw a1, 4(a1); bne a1, a2: it uses a1", 1 + 1 + 1),
    (RISCV, "83a54500" "8505", "lw a1, 4(a1); addi a1, 1, compressed", 1 + 1 + 1),
    (RISCV, "83a54500" "8545", "lw a1, 4(a1); li a1, 1, compressed", 1 + 1),
]


def cost(target: str, code: str, end: str = "most", address: int = 0x1000) -> Cost:
    return Model(target, end).block(bytes.fromhex(code), address)


class Latencies(unittest.TestCase):
    def test_an_instruction_takes_what_its_class_does(self) -> None:
        for target, code, text, name, cycles, taken in SINGLE:
            with self.subTest(f"{target}: {text}"):
                least, most = cost(target, code, "least"), cost(target, code)
                self.assertEqual(most.classes, (name,))
                self.assertEqual((least.cycles, most.cycles), cycles)
                self.assertEqual((least.taken, most.taken), taken)

    def test_every_class_is_tested(self) -> None:
        for target in (M0, M3, M4, RISCV):
            tested = {name for of, _, _, name, *_ in SINGLE if of == target}
            self.assertEqual(tested, set(Model(target).classes), target)

    def test_two_instructions_are_joined(self) -> None:
        for target, code, text, cycles in JOINED:
            with self.subTest(f"{target}: {text}"):
                self.assertEqual(cost(target, code).cycles, cycles)

    def test_an_instruction_may_count_as_one(self) -> None:
        for target, code, text, *_ in SINGLE + JOINED:
            with self.subTest(f"{target}: {text}"):
                counted = cost(target, code, "instructions")
                self.assertEqual((counted.cycles, counted.taken, counted.entered), (len(counted.classes), 0, 0))
                self.assertFalse(counted.predicted)

    def test_an_unaligned_target_takes_one_more(self) -> None:
        wide, narrow = "33040100", "8505"
        entered = [cost(RISCV, code, address=address).entered for code in (wide, narrow) for address in (0x1000, 0x1002)]
        self.assertEqual(entered, [0, 1, 0, 0])
        self.assertEqual(cost(M3, "a3fb000c", address=0x1002).entered, 0)

    def test_a_branch_back_is_predicted(self) -> None:
        back, forth, jump = "e3d304fe", "630e0504", "8287"
        self.assertEqual([cost(RISCV, code).predicted for code in (back, forth, jump)], [True, False, False])
        self.assertFalse(cost(RISCV, back, "instructions").predicted)

    def test_what_no_class_names_is_an_error(self) -> None:
        for target, code, text in [(M3, "00de", "udf"), (RISCV, "73005010", "wfi"), (M0, "c8bf", "it gt")]:
            with self.subTest(text), self.assertRaises(ValueError):
                cost(target, code)


class Instructions(unittest.TestCase):
    def test_the_counter_is_read_from_memory(self) -> None:
        for before, after in [("f32620b0", "83260000"), ("732520b8", "03254000")]:
            self.assertEqual(as_unicorn_can(bytes.fromhex(before)).hex(), after)

    def test_other_control_registers_stay(self) -> None:
        code = bytes.fromhex("f32340f1")
        self.assertEqual(as_unicorn_can(code), code)

    def test_a_call_of_the_host_is_an_ecall_and_another_breakpoint_is_not(self) -> None:
        call = as_unicorn_can(bytes.fromhex("1310f001" "73001000" "13507040"))
        self.assertEqual(struct.unpack("<III", call)[1], 0x73)
        self.assertEqual(as_unicorn_can(EBREAK), EBREAK)


class Comparison(unittest.TestCase):
    COST = '{"subject":"sphere","tier":"Fast","of":"%s","figure":%d}'
    EFFECTS = '{"set":"none","alone":{"instructions":%d,"stack":8},"among_all":{"instructions":5,"stack":%d,"rays":3}}'

    def test_figures_are_read_by_name_without_the_stack(self) -> None:
        self.assertEqual(read(f"{self.COST}\n{self.COST}" % ("hit", 7, "stack", 9)), {" | sphere | Fast | hit | figure": 7})
        of = " | none"
        self.assertEqual(
            read(self.EFFECTS % (4, 9)), {f"{of} | alone | instructions": 4, f"{of} | among_all | instructions": 5}
        )

    def test_a_hundredth_or_two_may_differ(self) -> None:
        for qemu, here, faults in [(10, 12, 0), (10, 13, 1), (1000, 990, 0), (1000, 1011, 1)]:
            self.assertEqual(len(differing({"a": qemu}, {"a": here})), faults, (qemu, here))

    def test_what_only_one_has_is_a_fault(self) -> None:
        self.assertEqual(differing({"a": 1}, {"b": 1}), ["only one has a", "only one has b"])


if __name__ == "__main__":
    sys.path.insert(0, str(Path(__file__).parent))
    unittest.main()
