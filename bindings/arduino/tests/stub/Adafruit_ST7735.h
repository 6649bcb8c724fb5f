// A display that keeps its pixels, with the functions of Adafruit's library that the example calls.
#ifndef ADAFRUIT_ST7735_H
#define ADAFRUIT_ST7735_H

#include "Arduino.h"

enum { INITR_BLACKTAB = 2 };

class Adafruit_ST7735 {
  public:
    Adafruit_ST7735(int8_t, int8_t, int8_t) {}
    void initR(uint8_t) {}
    void setRotation(uint8_t) {}
    uint16_t color565(uint8_t red, uint8_t green, uint8_t blue) {
        return static_cast<uint16_t>((red & 0xf8) << 8 | (green & 0xfc) << 3 | blue >> 3);
    }
    void drawPixel(int16_t x, int16_t y, uint16_t color) { pixels[y * 160 + x] = color; }
    static uint16_t pixels[160 * 128];
};

#endif
