/* What the tests need of the machine that they run on: text, and on a chip the start and a clock. */

#ifndef MACHINE_H
#define MACHINE_H

#include <stdint.h>

/* Random rays of a digest. */
enum { RAYS = 480 };

void print_text(const char *text);
void print_number(uint32_t number);
void start_machine(void);
void stop_machine(int failed);
/* Instructions since the start, as the emulator's clock counts them. */
uint32_t instructions(void);

#endif
