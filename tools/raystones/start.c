/* The start of a program on QEMU's board `virt`, and a console by semihosting. */
#include <stdio.h>

static long host(long operation, const void *block) {
    register long a0 __asm__("a0") = operation;
    register const void *a1 __asm__("a1") = block;
    __asm__ volatile(
        ".option push\n .option norvc\n .balign 16\n slli zero, zero, 0x1f\n ebreak\n srai zero, zero, 7\n .option pop"
        : "+r"(a0) : "r"(a1) : "memory");
    return a0;
}

static int put(char c, FILE *file) {
    (void)file;
    host(0x03, &c); /* SYS_WRITEC */
    return c;
}

static FILE console = FDEV_SETUP_STREAM(put, NULL, NULL, _FDEV_SETUP_WRITE);
FILE *const stdout = &console;

int main(void);

void begin(void) {
    main();
    host(0x18, (void *)0x20026); /* SYS_EXIT, ADP_Stopped_ApplicationExit */
    for (;;) {
    }
}

__asm__(".section .init\n.globl _start\n_start:\n la sp, _stack\n call begin\n");
