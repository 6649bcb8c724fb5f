/* One query in fixed point, for its size: by the functions of C, by the same in Rust, or none. */

#include "../include/raylet.h"
#include "machine.h"

uint32_t raylet_measured_i16f16(const raylet_shape_i16f16 *shape, const raylet_ray_i16f16 *ray, uint32_t times);

/* Made elsewhere, as in a list in flash. */
static raylet_shape_i16f16 shape;
static raylet_ray_i16f16 ray;

int main(void) {
    start_machine();
#if defined(IN_RUST)
    print_number(raylet_measured_i16f16(&shape, &ray, 1));
#elif !defined(NOTHING)
    raylet_hit_i16f16 hit;
    print_number((uint32_t)raylet_nearest_i16f16(&hit, &shape, &ray));
#endif
    (void)shape, (void)ray;
    stop_machine(0);
    return 0;
}
