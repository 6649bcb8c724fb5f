/* What raystones.c has of the board that it was written for. */
#include <stdio.h>
#define IO_OUT(port, value) ((void)0)
#define IO_LEDS 0
