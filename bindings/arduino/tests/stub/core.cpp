// The core: runs setup() and loop() once, and prints what is on the display, if anything: a row of every eighth pixel
// in hexadecimal for each eighth row, and a checksum of all.
#include "Adafruit_ST7735.h"

extern "C" {
#include "machine.h"
}

Console Serial;
uint16_t Adafruit_ST7735::pixels[160 * 128];

void Console::print(const char *text) { print_text(text); }
void Console::println(const char *text) {
    print_text(text);
    print_text("\n");
}
void Console::print(long number) {
    if (number < 0) {
        print_text("-");
        number = -number;
    }
    print_number(static_cast<uint32_t>(number));
}

static void print_color(uint16_t color) {
    char text[6] = {0, 0, 0, 0, ' ', 0};
    for (int i = 0; i < 4; i++) {
        text[i] = "0123456789abcdef"[color >> (12 - 4 * i) & 15];
    }
    print_text(text);
}

extern "C" int main(void) {
    start_machine();
    setup();
    loop();
    uint32_t sum = 2166136261u, any = 0;
    for (uint16_t color : Adafruit_ST7735::pixels) {
        sum = (sum ^ color) * 16777619u;
        any |= color;
    }
    for (int y = 0; any && y < 128; y += 8) {
        for (int x = 0; x < 160; x += 8) {
            print_color(Adafruit_ST7735::pixels[y * 160 + x]);
        }
        print_text("\n");
    }
    if (any) {
        print_text("sum ");
        print_number(sum);
        print_text("\n");
    }
    stop_machine(0);
    return 0;
}
