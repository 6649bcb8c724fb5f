// A shaded ball and its shadow on a floor, on a display of 160 x 128 pixels with an ST7735.
//
// Wiring as in Adafruit's guide; the pins below are those of a Raspberry Pi Pico. Needs "Adafruit ST7735 and ST7789
// Library". Each pixel is one ray, and one more towards the light where it hits.

#include <Adafruit_ST7735.h>
#include <SPI.h>
#include <raylet.h>

enum { CHIP_SELECT = 17, DATA_COMMAND = 20, RESET_PIN = 21 };
static Adafruit_ST7735 display(CHIP_SELECT, DATA_COMMAND, RESET_PIN);

static raylet_shape_f32 shapes[2];
static const raylet_vec3_f32 eye = { 0, 1.6f, 5 }, light = { 0.48f, 0.8f, 0.36f };

static void must(raylet_status status) {
  if (status >= 0) return;
  Serial.println(raylet_status_text(status));
  while (true) {}
}

// The nearest shape that a ray meets, and where; -1 if there is none.
static int nearest(const raylet_ray_f32 *ray, raylet_hit_f32 *hit) {
  int found = -1;
  for (int i = 0; i < 2; i++) {
    raylet_hit_f32 other;
    if (raylet_nearest_f32(&other, &shapes[i], ray) > 0 && (found < 0 || other.t < hit->t)) {
      found = i;
      *hit = other;
    }
  }
  return found;
}

// The color of a pixel, 5 bits of red, 6 of green, 5 of blue.
static uint16_t color(int x, int y) {
  raylet_ray_f32 ray, to_light;
  raylet_hit_f32 hit;
  raylet_vec3_f32 through = { (x - 79.5f) / 100, (63.5f - y) / 100 - 0.25f, -1.6f };
  must(raylet_ray_along_f32(&ray, eye, through));
  int which = nearest(&ray, &hit);
  if (which < 0) return display.color565(90, 130, 190);

  raylet_surface_f32 surface;
  raylet_vec3_f32 normal, point;
  must(raylet_surface_at_f32(&surface, &shapes[which], &ray, &hit));
  must(raylet_surface_normal_f32(&normal, &surface));
  must(raylet_surface_point_f32(&point, &surface));
  float shade = normal.x * light.x + normal.y * light.y + normal.z * light.z;
  if (which == 1) {
    // Only the ball can throw a shadow on the floor.
    must(raylet_ray_along_f32(&to_light, point, light));
    if (raylet_occludes_f32(&shapes[0], &to_light) > 0) shade = 0;
  }
  float level = 0.15f + 0.85f * (shade > 0 ? shade : 0);
  const float base[2][3] = { { 230, 90, 60 }, { 190, 190, 170 } };
  const float *c = base[which];
  return display.color565((uint8_t)(c[0] * level), (uint8_t)(c[1] * level), (uint8_t)(c[2] * level));
}

void setup() {
  Serial.begin(115200);
  display.initR(INITR_BLACKTAB);
  display.setRotation(1);
  raylet_vec3_f32 centre = { 0, 1, 0 };
  must(raylet_sphere_f32(&shapes[0], 1));
  must(raylet_shape_move_to_f32(&shapes[0], centre));
  must(raylet_plane_f32(&shapes[1]));
  for (int y = 0; y < 128; y++) {
    for (int x = 0; x < 160; x++) display.drawPixel(x, y, color(x, y));
  }
  Serial.println("drawn");
}

void loop() {}
