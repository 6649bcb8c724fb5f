/* The counters that raystones.c reads. Both count instructions, as QEMU does, or modelled cycles, as tools/cycles
   does. */
#include <stdint.h>

/* csrr of minstreth (0xb82) and minstret (0xb02), as numbers: the multilib of the compiler has no Zicsr. */
static inline uint64_t rdinstret(void) {
    uint32_t high, low, again;
    do {
        __asm__ volatile(
            ".insn i 0x73, 2, %0, x0, -1150\n .insn i 0x73, 2, %1, x0, -1278\n .insn i 0x73, 2, %2, x0, -1150"
            : "=r"(high), "=r"(low), "=r"(again));
    } while (high != again);
    return (uint64_t)high << 32 | low;
}

static inline uint64_t rdcycle(void) { return rdinstret(); }
