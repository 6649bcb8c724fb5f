/* A library with cylinders, planes and frames alone refuses all else, and says why. */

#include "../include/raylet.h"
#include "machine.h"

int main(void) {
    raylet_shape_i16f16 shape;
    raylet_frame_i16f16 frame;
    raylet_vec3_i16f16 place = {0, 0, 0}, twice = {1 << 17, 1 << 17, 1 << 17};
    const raylet_status refused = -16 * RAYLET_ERROR_KIND;
    int failed = raylet_cylinder_capped_i16f16(&shape, 1 << 16, 1 << 16) != RAYLET_OK;
    start_machine();
    failed |= raylet_frame_at_i16f16(&frame, place) != RAYLET_OK;
    failed |= raylet_shape_in_frame_i16f16(&shape, &frame) != RAYLET_OK;
    failed |= raylet_shape_stretched_i16f16(&shape, &frame, twice) != refused;
    failed |= raylet_sphere_i16f16(&shape, 1 << 16) != refused;
    print_text(raylet_status_text(refused));
    print_text("\n");
    stop_machine(failed);
    return failed;
}
