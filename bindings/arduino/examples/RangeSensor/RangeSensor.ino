// A simulated range sensor: what a sensor that turns sees of a rail, a post and the floor, in fixed point.
//
// Lengths are in metres, in I16F16: an int32_t in units of 1/65536.

#include <raylet.h>

static raylet_i16f16 metres(double x) { return (raylet_i16f16)(x * 65536.0); }

static raylet_vec3_i16f16 point(double x, double y, double z) {
  raylet_vec3_i16f16 p = { metres(x), metres(y), metres(z) };
  return p;
}

enum { OBSTACLES = 3 };
static raylet_shape_i16f16 obstacles[OBSTACLES];

// Stops with the library's own words if something is refused.
static void must(raylet_status status) {
  if (status >= 0) return;
  Serial.println(raylet_status_text(status));
  while (true) {}
}

void setup() {
  Serial.begin(115200);
  raylet_frame_i16f16 frame;
  raylet_i16f16 length;
  // A rail of radius 0.5 m, 4 m ahead.
  must(raylet_frame_between_i16f16(&frame, &length, point(-2, 0, 4), point(2, 0, 4)));
  must(raylet_cylinder_capped_i16f16(&obstacles[0], metres(0.5), length));
  must(raylet_shape_in_frame_i16f16(&obstacles[0], &frame));
  // A post at the left: the sensor looks along z, and x points to its left.
  must(raylet_frame_between_i16f16(&frame, &length, point(2, -1, 3), point(2, 2, 3)));
  must(raylet_capsule_i16f16(&obstacles[1], metres(0.25), length));
  must(raylet_shape_in_frame_i16f16(&obstacles[1], &frame));
  // The floor, 1 m below the sensor.
  must(raylet_plane_i16f16(&obstacles[2]));
  must(raylet_shape_move_to_i16f16(&obstacles[2], point(0, -1, 0)));
}

// The distance to the nearest obstacle in this direction, in millimetres; -1 if there is none.
static long range(double x, double y, double z) {
  raylet_ray_i16f16 ray;
  must(raylet_ray_along_i16f16(&ray, point(0, 0, 0), point(x, y, z)));
  int32_t nearest = INT32_MAX;
  for (int i = 0; i < OBSTACLES; i++) {
    raylet_hit_i16f16 hit;
    // 1 if it is hit, 0 if not.
    raylet_status found = raylet_nearest_i16f16(&hit, &obstacles[i], &ray);
    must(found);
    if (found > 0 && hit.t < nearest) nearest = hit.t;
  }
  return nearest == INT32_MAX ? -1 : (long)((int64_t)nearest * 1000 / 65536);
}

void loop() {
  // From straight ahead to the left, and a little down.
  for (int step = 0; step <= 8; step++) {
    Serial.print(range(step, -1, 8));
    Serial.print(step < 8 ? " " : "\n");
  }
  delay(1000);
}
