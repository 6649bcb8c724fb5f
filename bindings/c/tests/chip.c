/* An emulated chip as a machine, without a C library: start, semihosting, and a clock that counts instructions. */

#include "machine.h"
#include <stddef.h>

int main(void);
extern uint32_t _data_from, _data, _data_end, _bss, _bss_end, _stack;

static void prepare(void) {
    uint32_t *from = &_data_from, *to;
    for (to = &_data; to < &_data_end;) {
        *to++ = *from++;
    }
    for (to = &_bss; to < &_bss_end;) {
        *to++ = 0;
    }
}

#if defined(__arm__)

static uint32_t semihost(uint32_t operation, const void *argument) {
    register uint32_t r0 __asm__("r0") = operation;
    register const void *r1 __asm__("r1") = argument;
    __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
    return r0;
}

void _start(void);
void _start(void) {
    prepare();
#if defined(__ARM_FP)
    /* Full access to the unit of floats. */
    *(volatile uint32_t *)0xe000ed88 |= 0xf << 20;
    __asm__ volatile("dsb\nisb");
#endif
    main();
}

static void fault(void) {
    print_text("a fault\n");
    stop_machine(1);
}

static uint32_t wraps;

static void tick(void) { wraps++; }

__attribute__((section(".vectors"), used)) static const void *const vectors[16] = {
    &_stack, _start, fault, fault, fault, fault, fault, NULL, NULL, NULL, NULL, fault, fault, NULL, fault, tick};

#define SYSTICK ((volatile uint32_t *)0xe000e010)

void start_machine(void) {
    SYSTICK[1] = 0xffffff;
    SYSTICK[2] = 0;
    SYSTICK[0] = 7;
}

/* The emulator executes 40 instructions a tick of the core clock, which counts down 24 bits. */
uint32_t instructions(void) { return (wraps * 0x1000000u + (0xffffff - SYSTICK[2])) * 40; }

#else

static uint32_t semihost(uint32_t operation, const void *argument) {
    register uint32_t a0 __asm__("a0") = operation;
    register const void *a1 __asm__("a1") = argument;
    __asm__ volatile(".option push\n.option norvc\n.balign 16\n"
                     "slli x0, x0, 0x1f\nebreak\nsrai x0, x0, 7\n.option pop"
                     : "+r"(a0)
                     : "r"(a1)
                     : "memory");
    return a0;
}

__attribute__((used)) static void start(void) {
    prepare();
    main();
}

__attribute__((section(".vectors"), used, naked)) void _start(void) {
    __asm__ volatile(".option push\n.option norelax\nla gp, __global_pointer$\n.option pop\n"
                     "la sp, _stack\ncall start\n1: j 1b");
}

void start_machine(void) {}

uint32_t instructions(void) {
    uint32_t count;
    __asm__ volatile("csrr %0, minstret" : "=r"(count));
    return count;
}

#endif

void print_text(const char *text) { semihost(4, text); }

void print_number(uint32_t number) {
    char text[11], *first = text + 10;
    *first = 0;
    do {
        *--first = (char)('0' + number % 10);
        number /= 10;
    } while (number);
    print_text(first);
}

void stop_machine(int failed) {
    /* ADP_Stopped_ApplicationExit, or ADP_Stopped_RunTimeErrorUnknown. */
    semihost(0x18, (const void *)(failed ? 0x20023u : 0x20026u));
    for (;;) {
    }
}
