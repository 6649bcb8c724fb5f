/* A range sensor at the origin looks along z at a rail of radius 0.5 m, 4 m in front of it, and at the floor. */

#include "raylet.h"
#include <stdio.h>

/* Stops at the first failure, and says what is wrong. */
#define TRY(call)                                                \
    do {                                                         \
        raylet_status status = call;                             \
        if (status < 0) {                                        \
            fprintf(stderr, "%s\n", raylet_status_text(status)); \
            return 1;                                            \
        }                                                        \
    } while (0)

int main(void) {
    raylet_vec3_f32 start = {-2, 0, 4}, along = {1, 0, 0}, eye = {0, 0, 0}, ahead = {0, 0, 1}, below = {0, -1, 0};
    raylet_frame_f32 frame;
    raylet_shape_f32 list[2];
    raylet_node_f32 nodes[RAYLET_NODES(2)];
    raylet_shapes_f32 shapes;
    raylet_ray_f32 ray;
    raylet_surface_f32 surface;
    raylet_vec3_f32 normal;
    raylet_hit_f32 hit;
    uint32_t which;

    TRY(raylet_cylinder_capped_f32(&list[0], 0.5f, 4.0f));
    TRY(raylet_frame_from_base_and_axis_f32(&frame, start, along));
    TRY(raylet_shape_in_frame_f32(&list[0], &frame));
    TRY(raylet_plane_f32(&list[1]));
    TRY(raylet_shape_move_to_f32(&list[1], below));
    TRY(raylet_shapes_build_f32(&shapes, list, 2, nodes, RAYLET_NODES(2)));

    TRY(raylet_ray_along_f32(&ray, eye, ahead));
    if (raylet_shapes_nearest_f32(&which, &hit, &shapes, &ray) > 0) {
        TRY(raylet_surface_at_f32(&surface, &list[which], &ray, &hit));
        TRY(raylet_surface_normal_f32(&normal, &surface));
        printf("shape %u, %.2f m away, its normal (%.2f, %.2f, %.2f)\n", (unsigned)which, (double)hit.t,
               (double)normal.x, (double)normal.y, (double)normal.z);
    } else {
        printf("nothing in sight\n");
    }
    return 0;
}
