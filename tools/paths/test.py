"""Tests of the longest path and of the stack, by hand-made functions: `python3 test.py`. `.ci/worst` runs them."""

import unittest
from pathlib import Path

import capstone
from bounds import Bounds
from code import Block, Function
from constants import before_blocks
from longest import Longest, components
from stack import Stacks, growth_on_arm, growth_on_riscv, note_constant_of_arm, registers

THUMB = capstone.Cs(capstone.CS_ARCH_ARM, capstone.CS_MODE_THUMB | capstone.CS_MODE_MCLASS)
RISCV = capstone.Cs(capstone.CS_ARCH_RISCV, capstone.CS_MODE_RISCV32 | capstone.CS_MODE_RISCVC)
NOP = "00bf"


def thumb(code: str) -> list:
    return list(THUMB.disasm(bytes.fromhex(code), 0x1000))


class Hand:
    """A program of functions that are made by hand: of each its blocks, and where each leads."""

    is_arm = True

    def __init__(self, functions: dict[int, dict[int, tuple[str, list[int], list[tuple[int, int]]]]]) -> None:
        self.names = {start: f"f{start}" for start in functions}
        self._functions = {}
        for start, blocks in functions.items():
            of = Function(f"f{start}", start, start + 100)
            for at, (code, after, calls) in blocks.items():
                of.blocks[at] = Block(at, thumb(code), after, calls)
            self._functions[start] = of

    def containing(self, address: int) -> int | None:
        return address if address in self._functions else None

    def function(self, start: int) -> Function:
        return self._functions[start]

    def bytes_at(self, address: int, count: int) -> bytes:
        return (-1000 & 0xFFFF_FFFF).to_bytes(4, "little")


class Rounds:
    """The same bound for every loop; no function counts."""

    def __init__(self, rounds: int | None) -> None:
        self._rounds = rounds

    def is_counted(self, name: str) -> bool:
        return name == "f500"

    def rounds(self, loop, count):
        return count if loop.function == "f500" else self._rounds


def longest(blocks, rounds=None, others=None) -> int:
    return Longest(Hand({0: blocks, **(others or {})}), Rounds(rounds)).of(0)


class LongestPath(unittest.TestCase):
    def test_the_longer_of_two_branches_counts(self):
        blocks = {0: (NOP * 2, [10, 20], []), 10: (NOP * 3, [30], []), 20: (NOP * 7, [30], []), 30: (NOP, [], [])}
        self.assertEqual(longest(blocks), 2 + 7 + 1)

    def test_a_loop_counts_as_often_as_its_bound_says(self):
        # 4 before, then rounds of 2 + 3, of which the last leaves after 2.
        blocks = {0: (NOP * 4, [10], []), 10: (NOP * 2, [20, 30], []), 20: (NOP * 3, [10], []), 30: (NOP, [], [])}
        self.assertEqual(longest(blocks, 6), 4 + 5 * (2 + 3) + 2 + 1)
        self.assertEqual(longest(blocks, 1), 4 + 2 + 1)

    def test_loops_within_loops_multiply(self):
        blocks = {
            0: (NOP, [10], []),
            10: (NOP * 2, [20], []),
            20: (NOP * 5, [20, 30], []),
            30: (NOP * 3, [10, 40], []),
            40: (NOP, [], []),
        }
        self.assertEqual(longest(blocks, 4), 1 + 4 * (2 + 4 * 5 + 3) + 1)

    def test_a_loop_with_two_entries_takes_all_its_blocks(self):
        blocks = {0: (NOP, [10, 20], []), 10: (NOP * 2, [20], []), 20: (NOP * 3, [10, 30], []), 30: (NOP, [], [])}
        self.assertEqual(longest(blocks, 5), 1 + 5 * (2 + 3) + 1)

    def test_calls_count_where_they_are(self):
        blocks = {0: (NOP * 2, [], [(0, 50), (1, 50)])}
        self.assertEqual(longest(blocks, None, {50: {50: (NOP * 10, [], [])}}), 2 + 2 * 10)

    def test_a_loop_without_a_bound_is_told(self):
        of = Longest(Hand({0: {0: (NOP, [0, 10], []), 10: (NOP, [], [])}}), Rounds(None))
        of.of(0)
        self.assertEqual([(loop.function, loop.number) for loop in of.missing], [("f0", 1)])

    def test_a_count_that_is_a_constant_at_the_call_bounds_the_loop(self):
        # movs r2, #9, in a block before; f500 does one round for each.
        blocks = {0: ("0922", [10], []), 10: (NOP, [], [(0, 500)])}
        counted = {500: {500: (NOP * 2, [500, 510], []), 510: (NOP, [], [])}}
        self.assertEqual(longest(blocks, None, counted), 2 + 9 * 2 + 1)

    def test_components_come_the_last_first(self):
        found = components({1, 2, 3, 4}, {1: [2], 2: [3], 3: [2, 4], 4: []})
        self.assertEqual([sorted(group) for group in found], [[4], [2, 3], [1]])

    def test_a_constant_is_known_only_if_every_way_has_it(self):
        # movs r2, #9 and movs r2, #8 on the way to 30.
        blocks = {0: (NOP, [10, 20], []), 10: ("0922", [30], []), 20: ("0822", [30], []), 30: (NOP, [], [])}
        self.assertNotIn("r2", before_blocks(Hand({0: blocks}).function(0))[30])
        blocks[20] = ("0922", [30], [])
        self.assertEqual(before_blocks(Hand({0: blocks}).function(0))[30]["r2"], 9)


class Stack(unittest.TestCase):
    def test_lists_of_registers_are_counted(self):
        for text, count in (("{r4, r5, r6, r7, lr}", 5), ("{r0}", 1), ("{d8, d9}", 2), ("{s16-s19}", 4)):
            self.assertEqual(registers(text), count)

    def test_instructions_of_arm_make_the_stack_longer(self):
        codes = (("f0b5", 20), ("f0bd", -20), ("8fb0", 60), ("0fb0", -60), ("2de9f04f", 36), ("2ded028b", 8))
        for code, growth in codes:
            (i,) = thumb(code)
            self.assertEqual(growth_on_arm(Hand({}), i, {}), growth, f"{i.mnemonic} {i.op_str}")

    def test_a_frame_of_which_the_size_is_loaded(self):
        # ldr r6, [pc, #4]; add sp, r6
        constants = {}
        first, second = thumb("014eb544")
        note_constant_of_arm(Hand({}), first, constants)
        self.assertEqual(growth_on_arm(Hand({}), second, constants), 1000)

    def test_instructions_of_riscv_make_the_stack_longer(self):
        for code, growth in (("3971", 64), ("2161", -64), ("130101c0", 1024)):
            (i,) = RISCV.disasm(bytes.fromhex(code), 0x1000)
            self.assertEqual(growth_on_riscv(i), growth, f"{i.mnemonic} {i.op_str}")

    def test_the_deepest_call_counts(self):
        # push {r4, r5, r6, r7, lr}; a call; sub sp, #60; another call.
        blocks = {0: ("f0b5" + NOP + "8fb0" + NOP, [], [(1, 100), (3, 200)])}
        stacks = Stacks(Hand({0: blocks, 100: {100: ("8fb0", [], [])}, 200: {200: ("8fb0", [], [])}}))
        self.assertEqual(stacks.of(0), 20 + 60 + 60)
        self.assertEqual(stacks.path(0), [("f0", 140), ("f200", 60)])


class Table(unittest.TestCase):
    def test_every_line_has_a_bound_and_a_reason(self):
        bounds = Bounds(Path(__file__).parent / "bounds.toml")
        for line in bounds._loops:
            self.assertTrue(("rounds" in line) != ("of_a_round" in line) and line["why"], line)
            self.assertTrue("of_a_round" not in line or bounds.is_counted(line["function"]), line)


if __name__ == "__main__":
    unittest.main()
