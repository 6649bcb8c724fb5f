"""The constants that registers and words of the stack hold, block by block."""

import re

from code import Block, Function, Program

# What a call may change, beside the result.
CHANGED = {"r0", "r1", "r2", "r3", "r12", "ip", "lr", *(f"a{n}" for n in range(8)), *(f"t{n}" for n in range(7)), "ra"}

State = dict[str, int]


def _slot(text: str) -> str | None:
    """The word of the stack that an operand names."""
    arm = re.search(r"\[sp(?:, #(\w+))?\]$", text)
    if arm:
        return f"sp+{int(arm[1] or '0', 0)}"
    riscv = re.search(r"(-?\w+)\(sp\)$", text)
    return f"sp+{int(riscv[1], 0)}" if riscv else None


def step(state: State, i) -> None:
    """What an instruction changes."""
    name = i.mnemonic.removeprefix("c.").removesuffix(".w")
    operands = [part.strip() for part in i.op_str.split(",")]
    first, last = operands[0], operands[-1].lstrip("#")
    is_number = re.fullmatch(r"-?(0x)?[0-9a-f]+", last) is not None and last[:1] in "-0123456789"
    if name in ("str", "sw", "swsp"):
        slot = _slot(i.op_str)
        if slot and first in state:
            state[slot] = state[first]
        elif slot:
            state.pop(slot, None)
    elif name.startswith(("cmp", "tst", "cbz", "cbnz", "b", "st", "sb", "sh", "vst", "nop", "push", "it")):
        pass
    elif name in ("ldr", "lw", "lwsp") and _slot(i.op_str) in state:
        state[first] = state[_slot(i.op_str)]
    elif name in ("mov", "movs", "movw", "li", "mv") and len(operands) == 2 and (is_number or last in state):
        state[first] = int(last, 0) if is_number else state[last]
    elif name.startswith(("ldm", "pop", "umull", "smull", "umlal", "smlal", "ldrd")):
        for register in re.findall(r"\b[a-z]+\d*\b", i.op_str):
            state.pop(register, None)
    else:
        state.pop(first, None)
        if name in ("adds", "subs") and first == "sp" or first == "sp":
            # The words of the stack have other names now.
            for slot in [slot for slot in state if slot.startswith("sp+")]:
                state.pop(slot)


def after_call(state: State) -> None:
    """What a call changes: registers. Words that hold what is needed later are not those that it is given."""
    for register in CHANGED:
        state.pop(register, None)


def before_blocks(function: Function) -> dict[int, State]:
    """What is known where each block begins, whichever way led there."""
    known: dict[int, State] = {function.start: {}}
    waiting = [function.start]
    while waiting:
        block = function.blocks[waiting.pop()]
        state = through(block, known[block.start], len(block.instructions))
        for to in block.after:
            old = known.get(to)
            new = dict(state) if old is None else {key: value for key, value in old.items() if state.get(key) == value}
            if new != old:
                known[to] = new
                waiting.append(to)
    return known


def through(block: Block, before: State, count: int) -> State:
    """What is known after so many instructions of a block."""
    state, calls = dict(before), {index for index, _ in block.calls}
    for index, i in enumerate(block.instructions[:count]):
        step(state, i)
        if index in calls:
            after_call(state)
    return state
