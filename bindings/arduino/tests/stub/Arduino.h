// What the examples need of an Arduino core, for tests without one: text goes to the emulator's console.
#ifndef ARDUINO_H
#define ARDUINO_H

#include <stdint.h>

void setup();
void loop();

struct Console {
    void begin(unsigned long) {}
    void print(const char *text);
    void print(long number);
    void println(const char *text);
};
extern Console Serial;

inline void delay(unsigned long) {}

#endif
