/* The host as a machine. */

#include "machine.h"
#include <stdio.h>

void print_text(const char *text) { fputs(text, stdout); }
void print_number(uint32_t number) { printf("%lu", (unsigned long)number); }
void start_machine(void) {}
void stop_machine(int failed) { (void)failed; }
uint32_t instructions(void) { return 0; }
