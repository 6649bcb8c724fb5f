/* raylet: where a ray meets a solid, on which part of its surface, and which way that faces.
 *
 * Written by `bindings/c/generate`. SPDX-License-Identifier: MIT OR Apache-2.0 */

#ifndef RAYLET_H
#define RAYLET_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* The nodes of a hierarchy of so many shapes. */
#define RAYLET_NODES(count) ((count) < 1 ? 1 : 2 * (count) - 1)

/**
 * The most hits of a solid on one line.
 */
#define RAYLET_MOST_HITS 4

/**
 * The most crossings that `raylet_crossings_…` finds.
 */
#define RAYLET_MOST_CROSSINGS 32

/**
 * The most solids of which it finds them: a bit of a `uint32_t` each.
 */
#define RAYLET_MOST_SOLIDS 32

/**
 * The parts of a surface: `part` of a hit.
 */
typedef enum {
  /**
   * The curved side, or the whole surface of a sphere or a flat part. Rims, seams and the apex belong to it.
   */
  RAYLET_PART_SIDE = 0,
  /**
   * The cap or round end at the lower end of the axis; the lowest face of a cuboid or a prism.
   */
  RAYLET_PART_BASE = 1,
  /**
   * The cap or round end at the upper end of the axis; the highest face of a cuboid or a prism.
   */
  RAYLET_PART_TOP = 2,
  /**
   * The face of a cuboid at the lowest x.
   */
  RAYLET_PART_LEFT = 3,
  /**
   * The face of a cuboid at the highest x.
   */
  RAYLET_PART_RIGHT = 4,
  /**
   * The face of a cuboid at the lowest z.
   */
  RAYLET_PART_BACK = 5,
  /**
   * The face of a cuboid at the highest z.
   */
  RAYLET_PART_FRONT = 6,
  /**
   * The inner side of a tube. Its rims belong to it.
   */
  RAYLET_PART_INNER = 7,
  /**
   * Facet 0 of a prism or a polyhedron. Facet n is `RAYLET_PART_FACET_0 + n`, n below 16.
   */
  RAYLET_PART_FACET_0 = 8,
} raylet_part;

/**
 * How a ray crosses a surface: `crossing` of a hit.
 */
typedef enum {
  /**
   * From the outside: into a solid, or through an open surface from its front.
   */
  RAYLET_ENTER = 0,
  /**
   * From the inside: out of a solid, or through an open surface from its back.
   */
  RAYLET_EXIT = 1,
  /**
   * The line touches the surface in one point and stays on its side.
   */
  RAYLET_TOUCH = 2,
} raylet_crossing_kind;

/**
 * The sides from which a surface is seen.
 */
typedef enum {
  /**
   * From both sides.
   */
  RAYLET_BOTH = 0,
  /**
   * From outside, or of an open surface from the front: no exit is reported.
   */
  RAYLET_OUTSIDE = 1,
  /**
   * From inside, or of an open surface from the back: no enter is reported.
   */
  RAYLET_INSIDE = 2,
} raylet_visible;

/**
 * Towards which side of a surface a ray departs.
 */
typedef enum {
  /**
   * Along the outward normal: reflected outside, or refracted out.
   */
  RAYLET_OUTWARDS = 0,
  /**
   * Against the outward normal: refracted in, or reflected inside.
   */
  RAYLET_INWARDS = 1,
} raylet_leaving;

/**
 * What is wrong: the first part of an error code.
 */
typedef enum {
  /**
   * A radius.
   */
  RAYLET_ERROR_RADIUS = 1,
  /**
   * A height.
   */
  RAYLET_ERROR_HEIGHT = 2,
  /**
   * A slope.
   */
  RAYLET_ERROR_SLOPE = 3,
  /**
   * A half extent.
   */
  RAYLET_ERROR_HALF_EXTENT = 4,
  /**
   * A coordinate of a vertex.
   */
  RAYLET_ERROR_VERTEX = 5,
  /**
   * A coordinate of a corner.
   */
  RAYLET_ERROR_CORNER = 6,
  /**
   * A coefficient of a quadric of revolution.
   */
  RAYLET_ERROR_COEFFICIENT = 7,
  /**
   * The normal of a half-space.
   */
  RAYLET_ERROR_HALF_SPACE = 8,
  /**
   * A coordinate of the position of a frame.
   */
  RAYLET_ERROR_POSITION = 9,
  /**
   * The normal of a plane.
   */
  RAYLET_ERROR_NORMAL = 10,
  /**
   * A component of an axis of a matrix.
   */
  RAYLET_ERROR_AXIS = 11,
  /**
   * A factor of a scale.
   */
  RAYLET_ERROR_SCALE = 12,
  /**
   * A coordinate of a ray's origin.
   */
  RAYLET_ERROR_ORIGIN = 13,
  /**
   * A coordinate of a ray's target.
   */
  RAYLET_ERROR_TARGET = 14,
  /**
   * The vector of a ray's direction.
   */
  RAYLET_ERROR_DIRECTION = 15,
  /**
   * An end of a ray's range.
   */
  RAYLET_ERROR_RANGE_END = 16,
  /**
   * The lower height is not below the upper one.
   */
  RAYLET_ERROR_HEIGHTS = 32,
  /**
   * The inner radius is not below the outer one.
   */
  RAYLET_ERROR_RADII = 33,
  /**
   * The minor radius of a torus is not below the major one.
   */
  RAYLET_ERROR_RING = 34,
  /**
   * A quadric of revolution has no radius somewhere.
   */
  RAYLET_ERROR_OUTLINE = 35,
  /**
   * The vertices lie on a line.
   */
  RAYLET_ERROR_VERTICES = 36,
  /**
   * A polyhedron has no half-space, or more than 16.
   */
  RAYLET_ERROR_FACE_COUNT = 37,
  /**
   * Half-spaces bound no solid.
   */
  RAYLET_ERROR_UNBOUNDED = 38,
  /**
   * A prism has fewer than 3 corners, or more than 16.
   */
  RAYLET_ERROR_CORNER_COUNT = 39,
  /**
   * The corners of a prism do not turn to the left around a convex polygon.
   */
  RAYLET_ERROR_CORNERS = 40,
  /**
   * The axes do not span a right-handed frame.
   */
  RAYLET_ERROR_AXES = 41,
  /**
   * The angle is not between -360 and 360 degrees.
   */
  RAYLET_ERROR_ANGLE = 42,
  /**
   * The quaternion is not finite, nearly zero or very long.
   */
  RAYLET_ERROR_QUATERNION = 43,
  /**
   * The matrix has no inverse.
   */
  RAYLET_ERROR_SINGULAR = 44,
  /**
   * The start of a ray's range lies above its end.
   */
  RAYLET_ERROR_RANGE = 45,
  /**
   * There are fewer nodes than the shapes need.
   */
  RAYLET_ERROR_NODES = 46,
  /**
   * A hierarchy holds at most 2^30 - 1 shapes.
   */
  RAYLET_ERROR_TOO_MANY_SHAPES = 47,
  /**
   * There are more crossings than there is room for.
   */
  RAYLET_ERROR_FULL = 48,
  /**
   * There are more solids than a set can hold.
   */
  RAYLET_ERROR_TOO_MANY_SOLIDS = 49,
  /**
   * The first numbers of the tier do not decide the ray.
   */
  RAYLET_ERROR_UNDECIDED = 50,
  /**
   * A pointer is null.
   */
  RAYLET_ERROR_NULL = 51,
  /**
   * The part or the crossing of a hit is none.
   */
  RAYLET_ERROR_HIT = 52,
  /**
   * A choice of sides is none.
   */
  RAYLET_ERROR_CHOICE = 53,
  /**
   * A vector, as a direction.
   */
  RAYLET_ERROR_VALUE = 54,
  /**
   * The library was built without this kind of solid or placement.
   */
  RAYLET_ERROR_KIND = 55,
  /**
   * Another error.
   */
  RAYLET_ERROR_OTHER = 56,
} raylet_error;

/**
 * What is wrong with a value: the second part of an error code.
 */
typedef enum {
  /**
   * The error itself says it.
   */
  RAYLET_FAULT_NONE = 0,
  /**
   * It is infinite or NaN.
   */
  RAYLET_FAULT_NOT_FINITE = 1,
  /**
   * It is negative.
   */
  RAYLET_FAULT_NEGATIVE = 2,
  /**
   * It is zero.
   */
  RAYLET_FAULT_ZERO = 3,
  /**
   * It is below the least that the number type's budget allows.
   */
  RAYLET_FAULT_BELOW_BUDGET = 4,
  /**
   * It is beyond the number type's budget.
   */
  RAYLET_FAULT_BEYOND_BUDGET = 5,
  /**
   * It is beyond what the number type can hold.
   */
  RAYLET_FAULT_BEYOND_TYPE = 6,
  /**
   * Its length is not 1.
   */
  RAYLET_FAULT_NOT_UNIT = 7,
  /**
   * It has no direction.
   */
  RAYLET_FAULT_NO_DIRECTION = 8,
} raylet_fault;

/**
 * What a function returns: zero or more as its comment says, or a negative error code,
 * `-(16 * raylet_error + raylet_fault)`. `raylet_status_text` says it in words.
 */
typedef int32_t raylet_status;

/**
 * A hit: where a ray meets a surface.
 */
typedef struct {
  /**
   * The distance along the ray.
   */
  float t;
  /**
   * A `raylet_part`.
   */
  uint8_t part;
  /**
   * A `raylet_crossing_kind`.
   */
  uint8_t crossing;
} raylet_hit_f32;

/**
 * A solid or an open surface, placed in the world. It is a value: it may be copied, and needs no release.
 */
typedef struct {
  /**
   * Not to be read or written.
   */
  uint64_t opaque[16];
} raylet_shape_f32;

/**
 * A ray: an origin, a direction, a range of `t`, and the surface that it departs from, if any.
 */
typedef struct {
  /**
   * Not to be read or written.
   */
  uint64_t opaque[5];
} raylet_ray_f32;

/**
 * A point, a vector of any length, or, with components in the number type's unit, a direction.
 */
typedef struct {
  /**
   * To the right.
   */
  float x;
  /**
   * Upwards.
   */
  float y;
  /**
   * Towards the viewer.
   */
  float z;
} raylet_vec3_f32;

/**
 * All hits of a solid on one ray, sorted by `t`.
 */
typedef struct {
  /**
   * The hits; those from `count` on mean nothing.
   */
  raylet_hit_f32 hits[RAYLET_MOST_HITS];
  /**
   * How many there are.
   */
  uint8_t count;
  /**
   * True if the ray starts inside the solid: the first hit is then an exit without an enter.
   */
  bool starts_inside;
  /**
   * True if the ray lies in an open or infinite surface. There are then no hits.
   */
  bool is_coincident;
  /**
   * Over which interval of `t` it does.
   */
  float coincident[2];
} raylet_hits_f32;

/**
 * The surface of a shape at a hit, from which point, normal, coordinates and tangents are computed.
 */
typedef struct {
  /**
   * Not to be read or written.
   */
  uint64_t opaque[22];
} raylet_surface_f32;

/**
 * Many shapes with a hierarchy of boxes around them. The list and the nodes must stay where they are, unchanged,
 * as long as it is used.
 */
typedef struct {
  /**
   * Not to be read or written.
   */
  uint64_t opaque[6];
} raylet_shapes_f32;

/**
 * A node of a hierarchy of many shapes.
 */
typedef struct {
  /**
   * Not to be read or written.
   */
  uint64_t opaque[4];
} raylet_node_f32;

/**
 * A crossing of one of many solids.
 */
typedef struct {
  /**
   * Where, on which part, and how.
   */
  raylet_hit_f32 hit;
  /**
   * The index of the solid.
   */
  uint32_t solid;
  /**
   * The solids that the ray is inside of before the crossing: bit i is solid i.
   */
  uint32_t before;
  /**
   * Those that it is inside of behind it.
   */
  uint32_t after;
} raylet_crossing_f32;

/**
 * A position and three axes at right angles, which place a shape.
 */
typedef struct {
  /**
   * Not to be read or written.
   */
  uint64_t opaque[6];
} raylet_frame_f32;

/**
 * A half-space, of which polyhedra are made.
 */
typedef struct {
  /**
   * Not to be read or written.
   */
  uint64_t opaque[3];
} raylet_half_space_f32;

/**
 * A fixed-point number: an integer in units of 2^-16 (`I16F16`). The unit of directions is 2^-30: components of
 * directions and normals, and surface coordinates, are in that. (In `float` both are 1.)
 */
typedef int32_t raylet_i16f16;

/**
 * A hit: where a ray meets a surface.
 */
typedef struct {
  /**
   * The distance along the ray.
   */
  raylet_i16f16 t;
  /**
   * A `raylet_part`.
   */
  uint8_t part;
  /**
   * A `raylet_crossing_kind`.
   */
  uint8_t crossing;
} raylet_hit_i16f16;

/**
 * A solid or an open surface, placed in the world. It is a value: it may be copied, and needs no release.
 */
typedef struct {
  /**
   * Not to be read or written.
   */
  uint64_t opaque[16];
} raylet_shape_i16f16;

/**
 * A ray: an origin, a direction, a range of `t`, and the surface that it departs from, if any.
 */
typedef struct {
  /**
   * Not to be read or written.
   */
  uint64_t opaque[5];
} raylet_ray_i16f16;

/**
 * A point, a vector of any length, or, with components in the number type's unit, a direction.
 */
typedef struct {
  /**
   * To the right.
   */
  raylet_i16f16 x;
  /**
   * Upwards.
   */
  raylet_i16f16 y;
  /**
   * Towards the viewer.
   */
  raylet_i16f16 z;
} raylet_vec3_i16f16;

/**
 * All hits of a solid on one ray, sorted by `t`.
 */
typedef struct {
  /**
   * The hits; those from `count` on mean nothing.
   */
  raylet_hit_i16f16 hits[RAYLET_MOST_HITS];
  /**
   * How many there are.
   */
  uint8_t count;
  /**
   * True if the ray starts inside the solid: the first hit is then an exit without an enter.
   */
  bool starts_inside;
  /**
   * True if the ray lies in an open or infinite surface. There are then no hits.
   */
  bool is_coincident;
  /**
   * Over which interval of `t` it does.
   */
  raylet_i16f16 coincident[2];
} raylet_hits_i16f16;

/**
 * The surface of a shape at a hit, from which point, normal, coordinates and tangents are computed.
 */
typedef struct {
  /**
   * Not to be read or written.
   */
  uint64_t opaque[22];
} raylet_surface_i16f16;

/**
 * Many shapes with a hierarchy of boxes around them. The list and the nodes must stay where they are, unchanged,
 * as long as it is used.
 */
typedef struct {
  /**
   * Not to be read or written.
   */
  uint64_t opaque[6];
} raylet_shapes_i16f16;

/**
 * A node of a hierarchy of many shapes.
 */
typedef struct {
  /**
   * Not to be read or written.
   */
  uint64_t opaque[4];
} raylet_node_i16f16;

/**
 * A crossing of one of many solids.
 */
typedef struct {
  /**
   * Where, on which part, and how.
   */
  raylet_hit_i16f16 hit;
  /**
   * The index of the solid.
   */
  uint32_t solid;
  /**
   * The solids that the ray is inside of before the crossing: bit i is solid i.
   */
  uint32_t before;
  /**
   * Those that it is inside of behind it.
   */
  uint32_t after;
} raylet_crossing_i16f16;

/**
 * A position and three axes at right angles, which place a shape.
 */
typedef struct {
  /**
   * Not to be read or written.
   */
  uint64_t opaque[6];
} raylet_frame_i16f16;

/**
 * A half-space, of which polyhedra are made.
 */
typedef struct {
  /**
   * Not to be read or written.
   */
  uint64_t opaque[3];
} raylet_half_space_i16f16;

/**
 * Done.
 */
#define RAYLET_OK 0

#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

/**
 * The nearest visible hit within the range of a ray: 1 and the hit, or 0. In the tier Stable, as all queries whose
 * names name no tier.
 */
raylet_status raylet_nearest_f32(raylet_hit_f32 *hit,
                                 const raylet_shape_f32 *shape,
                                 const raylet_ray_f32 *ray);

/**
 * As `raylet_nearest_f32`, in the tier Plain.
 */
raylet_status raylet_nearest_plain_f32(raylet_hit_f32 *hit,
                                       const raylet_shape_f32 *shape,
                                       const raylet_ray_f32 *ray);

/**
 * As `raylet_nearest_f32`, in the tier Fast.
 */
raylet_status raylet_nearest_fast_f32(raylet_hit_f32 *hit,
                                      const raylet_shape_f32 *shape,
                                      const raylet_ray_f32 *ray);

/**
 * As `raylet_nearest_f32`, in the tier Exact.
 */
raylet_status raylet_nearest_exact_f32(raylet_hit_f32 *hit,
                                       const raylet_shape_f32 *shape,
                                       const raylet_ray_f32 *ray);

/**
 * The nearest hit by the first numbers of the tier Stable alone: 1 and the hit, 0, or `RAYLET_ERROR_UNDECIDED`. For
 * the least flash, and the least time of the slowest ray.
 */
raylet_status raylet_try_nearest_f32(raylet_hit_f32 *hit,
                                     const raylet_shape_f32 *shape,
                                     const raylet_ray_f32 *ray);

/**
 * As `raylet_try_nearest_f32`, in the tier Plain.
 */
raylet_status raylet_try_nearest_plain_f32(raylet_hit_f32 *hit,
                                           const raylet_shape_f32 *shape,
                                           const raylet_ray_f32 *ray);

/**
 * As `raylet_try_nearest_f32`, in the tier Fast.
 */
raylet_status raylet_try_nearest_fast_f32(raylet_hit_f32 *hit,
                                          const raylet_shape_f32 *shape,
                                          const raylet_ray_f32 *ray);

/**
 * 1 if a ray hits the shape within its range, or 0.
 */
raylet_status raylet_occludes_f32(const raylet_shape_f32 *shape, const raylet_ray_f32 *ray);

/**
 * As `raylet_occludes_f32`, in the tier Plain.
 */
raylet_status raylet_occludes_plain_f32(const raylet_shape_f32 *shape, const raylet_ray_f32 *ray);

/**
 * As `raylet_occludes_f32`, in the tier Fast.
 */
raylet_status raylet_occludes_fast_f32(const raylet_shape_f32 *shape, const raylet_ray_f32 *ray);

/**
 * As `raylet_occludes_f32`, in the tier Exact.
 */
raylet_status raylet_occludes_exact_f32(const raylet_shape_f32 *shape, const raylet_ray_f32 *ray);

/**
 * 1 if a point is in the closed solid, or 0; 0 of an open surface.
 */
raylet_status raylet_contains_f32(const raylet_shape_f32 *shape, raylet_vec3_f32 point);

/**
 * As `raylet_contains_f32`, in the tier Plain.
 */
raylet_status raylet_contains_plain_f32(const raylet_shape_f32 *shape, raylet_vec3_f32 point);

/**
 * As `raylet_contains_f32`, in the tier Fast.
 */
raylet_status raylet_contains_fast_f32(const raylet_shape_f32 *shape, raylet_vec3_f32 point);

/**
 * As `raylet_contains_f32`, in the tier Exact.
 */
raylet_status raylet_contains_exact_f32(const raylet_shape_f32 *shape, raylet_vec3_f32 point);

/**
 * All visible hits within the range of a ray, sorted by `t`: their number, up to `RAYLET_MOST_HITS`.
 */
raylet_status raylet_all_hits_f32(raylet_hits_f32 *hits,
                                  const raylet_shape_f32 *shape,
                                  const raylet_ray_f32 *ray);

/**
 * As `raylet_all_hits_f32`, in the tier Plain.
 */
raylet_status raylet_all_hits_plain_f32(raylet_hits_f32 *hits,
                                        const raylet_shape_f32 *shape,
                                        const raylet_ray_f32 *ray);

/**
 * As `raylet_all_hits_f32`, in the tier Fast.
 */
raylet_status raylet_all_hits_fast_f32(raylet_hits_f32 *hits,
                                       const raylet_shape_f32 *shape,
                                       const raylet_ray_f32 *ray);

/**
 * As `raylet_all_hits_f32`, in the tier Exact.
 */
raylet_status raylet_all_hits_exact_f32(raylet_hits_f32 *hits,
                                        const raylet_shape_f32 *shape,
                                        const raylet_ray_f32 *ray);

/**
 * The surface of a shape at a hit of a ray with it.
 */
raylet_status raylet_surface_at_f32(raylet_surface_f32 *surface,
                                    const raylet_shape_f32 *shape,
                                    const raylet_ray_f32 *ray,
                                    const raylet_hit_f32 *hit);

/**
 * The point of the hit.
 */
raylet_status raylet_surface_point_f32(raylet_vec3_f32 *point, const raylet_surface_f32 *surface);

/**
 * The outward normal, of length 1, in the unit of directions.
 */
raylet_status raylet_surface_normal_f32(raylet_vec3_f32 *normal, const raylet_surface_f32 *surface);

/**
 * The normal on the side that the ray comes from.
 */
raylet_status raylet_surface_normal_towards_ray_f32(raylet_vec3_f32 *normal,
                                                    const raylet_surface_f32 *surface);

/**
 * The cosine of the angle between the line of the ray and the normal, from 0 to 1, as a number.
 */
raylet_status raylet_surface_cosine_f32(float *cosine, const raylet_surface_f32 *surface);

/**
 * Surface coordinates, each from 0 to 1, in the unit of directions.
 */
raylet_status raylet_surface_uv_f32(float (*uv)[2], const raylet_surface_f32 *surface);

/**
 * Where the hit lies in the bounding box of the solid along its axes, each from 0 to 1, in the unit of directions.
 */
raylet_status raylet_surface_uvw_f32(float (*uvw)[3],
                                     const raylet_surface_f32 *surface);

/**
 * The directions in the world in which u and v grow, of length 1, in the unit of directions.
 */
raylet_status raylet_surface_tangents_f32(raylet_vec3_f32 *along_u,
                                          raylet_vec3_f32 *along_v,
                                          const raylet_surface_f32 *surface);

/**
 * Makes a hierarchy of a list of shapes in the given nodes: `RAYLET_NODES(count)` of them. List and nodes must stay
 * where they are, unchanged, as long as it is used. To move a shape, change the list and build it again.
 */
raylet_status raylet_shapes_build_f32(raylet_shapes_f32 *shapes,
                                      const raylet_shape_f32 *list,
                                      size_t count,
                                      raylet_node_f32 *nodes,
                                      size_t node_count);

/**
 * The nearest hit of a ray with any of the shapes: 1, the index of its shape and the hit; or 0.
 */
raylet_status raylet_shapes_nearest_f32(uint32_t *shape,
                                        raylet_hit_f32 *hit,
                                        const raylet_shapes_f32 *shapes,
                                        const raylet_ray_f32 *ray);

/**
 * As `raylet_shapes_nearest_f32`, in the tier Plain.
 */
raylet_status raylet_shapes_nearest_plain_f32(uint32_t *shape,
                                              raylet_hit_f32 *hit,
                                              const raylet_shapes_f32 *shapes,
                                              const raylet_ray_f32 *ray);

/**
 * As `raylet_shapes_nearest_f32`, in the tier Fast.
 */
raylet_status raylet_shapes_nearest_fast_f32(uint32_t *shape,
                                             raylet_hit_f32 *hit,
                                             const raylet_shapes_f32 *shapes,
                                             const raylet_ray_f32 *ray);

/**
 * As `raylet_shapes_nearest_f32`, in the tier Exact.
 */
raylet_status raylet_shapes_nearest_exact_f32(uint32_t *shape,
                                              raylet_hit_f32 *hit,
                                              const raylet_shapes_f32 *shapes,
                                              const raylet_ray_f32 *ray);

/**
 * 1 if a ray hits any of the shapes within its range, or 0.
 */
raylet_status raylet_shapes_occlude_f32(const raylet_shapes_f32 *shapes, const raylet_ray_f32 *ray);

/**
 * As `raylet_shapes_occlude_f32`, in the tier Plain.
 */
raylet_status raylet_shapes_occlude_plain_f32(const raylet_shapes_f32 *shapes,
                                              const raylet_ray_f32 *ray);

/**
 * As `raylet_shapes_occlude_f32`, in the tier Fast.
 */
raylet_status raylet_shapes_occlude_fast_f32(const raylet_shapes_f32 *shapes,
                                             const raylet_ray_f32 *ray);

/**
 * As `raylet_shapes_occlude_f32`, in the tier Exact.
 */
raylet_status raylet_shapes_occlude_exact_f32(const raylet_shapes_f32 *shapes,
                                              const raylet_ray_f32 *ray);

/**
 * Calls `each` with every shape that a ray hits or starts inside of, in no order; the number of calls. The hits are
 * there until it returns.
 */
raylet_status raylet_shapes_hits_f32(const raylet_shapes_f32 *shapes,
                                     const raylet_ray_f32 *ray,
                                     void (*each)(void *context,
                                                  uint32_t shape,
                                                  const raylet_hits_f32 *hits),
                                     void *context);

/**
 * As `raylet_shapes_hits_f32`, in the tier Plain.
 */
raylet_status raylet_shapes_hits_plain_f32(const raylet_shapes_f32 *shapes,
                                           const raylet_ray_f32 *ray,
                                           void (*each)(void *context,
                                                        uint32_t shape,
                                                        const raylet_hits_f32 *hits),
                                           void *context);

/**
 * As `raylet_shapes_hits_f32`, in the tier Fast.
 */
raylet_status raylet_shapes_hits_fast_f32(const raylet_shapes_f32 *shapes,
                                          const raylet_ray_f32 *ray,
                                          void (*each)(void *context,
                                                       uint32_t shape,
                                                       const raylet_hits_f32 *hits),
                                          void *context);

/**
 * As `raylet_shapes_hits_f32`, in the tier Exact.
 */
raylet_status raylet_shapes_hits_exact_f32(const raylet_shapes_f32 *shapes,
                                           const raylet_ray_f32 *ray,
                                           void (*each)(void *context,
                                                        uint32_t shape,
                                                        const raylet_hits_f32 *hits),
                                           void *context);

/**
 * All crossings of a ray with up to `RAYLET_MOST_SOLIDS` solids, in order, and which solids it is inside of between
 * them: their number, up to `capacity` and `RAYLET_MOST_CROSSINGS`. Where solids touch, the order is that of one
 * solid after the other; see the documentation of `raylet::solids`.
 */
raylet_status raylet_crossings_f32(raylet_crossing_f32 *crossings,
                                   size_t capacity,
                                   const raylet_shape_f32 *list,
                                   size_t count,
                                   const raylet_ray_f32 *ray);

/**
 * As `raylet_crossings_f32`, in the tier Plain.
 */
raylet_status raylet_crossings_plain_f32(raylet_crossing_f32 *crossings,
                                         size_t capacity,
                                         const raylet_shape_f32 *list,
                                         size_t count,
                                         const raylet_ray_f32 *ray);

/**
 * As `raylet_crossings_f32`, in the tier Fast.
 */
raylet_status raylet_crossings_fast_f32(raylet_crossing_f32 *crossings,
                                        size_t capacity,
                                        const raylet_shape_f32 *list,
                                        size_t count,
                                        const raylet_ray_f32 *ray);

/**
 * As `raylet_crossings_f32`, in the tier Exact.
 */
raylet_status raylet_crossings_exact_f32(raylet_crossing_f32 *crossings,
                                         size_t capacity,
                                         const raylet_shape_f32 *list,
                                         size_t count,
                                         const raylet_ray_f32 *ray);

/**
 * Places a shape by a frame, instead of what placed it before.
 */
raylet_status raylet_shape_in_frame_f32(raylet_shape_f32 *shape, const raylet_frame_f32 *frame);

/**
 * Places a shape by a frame, and stretches it along the axes of the frame by positive factors.
 */
raylet_status raylet_shape_stretched_f32(raylet_shape_f32 *shape,
                                         const raylet_frame_f32 *frame,
                                         raylet_vec3_f32 scale);

/**
 * Places a shape by a matrix: where its origin and its unit vectors along x, y and z go.
 */
raylet_status raylet_shape_in_matrix_f32(raylet_shape_f32 *shape,
                                         raylet_vec3_f32 position,
                                         raylet_vec3_f32 x,
                                         raylet_vec3_f32 y,
                                         raylet_vec3_f32 z);

/**
 * Moves a shape, however it is placed.
 */
raylet_status raylet_shape_move_to_f32(raylet_shape_f32 *shape, raylet_vec3_f32 position);

/**
 * Makes a shape seen from these sides only: a `raylet_visible`.
 */
raylet_status raylet_shape_seen_from_f32(raylet_shape_f32 *shape, uint8_t visible);

/**
 * The box around a shape along the axes of the world; an infinite shape has the largest or infinite numbers.
 */
raylet_status raylet_shape_bounds_f32(raylet_vec3_f32 *low,
                                      raylet_vec3_f32 *high,
                                      const raylet_shape_f32 *shape);

/**
 * A frame along the axes of the world.
 */
raylet_status raylet_frame_at_f32(raylet_frame_f32 *frame, raylet_vec3_f32 position);

/**
 * A frame with its y axis along a vector of any length, for a solid whose base is there.
 */
raylet_status raylet_frame_from_base_and_axis_f32(raylet_frame_f32 *frame,
                                                  raylet_vec3_f32 base,
                                                  raylet_vec3_f32 axis);

/**
 * The same, for a solid of this height whose middle is there.
 */
raylet_status raylet_frame_from_centre_and_axis_f32(raylet_frame_f32 *frame,
                                                    raylet_vec3_f32 centre,
                                                    raylet_vec3_f32 axis,
                                                    float height);

/**
 * A frame turned about an axis of any length through its position, counter-clockwise as seen from the tip of the
 * axis.
 */
raylet_status raylet_frame_turned_about_f32(raylet_frame_f32 *frame,
                                            raylet_vec3_f32 position,
                                            raylet_vec3_f32 axis,
                                            float degrees);

/**
 * A frame turned by the quaternion (x, y, z, w), of any length near 1; its components are in the unit of directions.
 */
raylet_status raylet_frame_from_quaternion_f32(raylet_frame_f32 *frame,
                                               raylet_vec3_f32 position,
                                               float x,
                                               float y,
                                               float z,
                                               float w);

/**
 * A frame with its y axis from one point to another; the distance between them is the height of a solid that reaches
 * from one to the other.
 */
raylet_status raylet_frame_between_f32(raylet_frame_f32 *frame,
                                       float *height,
                                       raylet_vec3_f32 from,
                                       raylet_vec3_f32 to);

/**
 * A frame with its z axis along `forward`, and `up` towards its y axis; both of any length.
 */
raylet_status raylet_frame_looking_f32(raylet_frame_f32 *frame,
                                       raylet_vec3_f32 position,
                                       raylet_vec3_f32 forward,
                                       raylet_vec3_f32 up);

/**
 * A frame with these axes, which are nearly at right angles and right-handed, of any length.
 */
raylet_status raylet_frame_from_axes_f32(raylet_frame_f32 *frame,
                                         raylet_vec3_f32 position,
                                         raylet_vec3_f32 x,
                                         raylet_vec3_f32 y,
                                         raylet_vec3_f32 z);

/**
 * A frame that is given in another one, as a frame in the world.
 */
raylet_status raylet_frame_to_world_f32(raylet_frame_f32 *frame,
                                        const raylet_frame_f32 *outer,
                                        const raylet_frame_f32 *inner);

/**
 * A point of the world in the coordinates of a frame.
 */
raylet_status raylet_frame_point_to_local_f32(raylet_vec3_f32 *out,
                                              const raylet_frame_f32 *frame,
                                              raylet_vec3_f32 point);

/**
 * A point in the coordinates of a frame in those of the world.
 */
raylet_status raylet_frame_point_to_world_f32(raylet_vec3_f32 *out,
                                              const raylet_frame_f32 *frame,
                                              raylet_vec3_f32 point);

/**
 * A ray from a point towards a vector of any length. `t` is distance.
 */
raylet_status raylet_ray_along_f32(raylet_ray_f32 *ray,
                                   raylet_vec3_f32 origin,
                                   raylet_vec3_f32 direction);

/**
 * A ray from a point with a direction of length 1, whose components are in the unit of directions: as
 * `raylet_surface_normal_f32` gives them.
 */
raylet_status raylet_ray_in_direction_f32(raylet_ray_f32 *ray,
                                          raylet_vec3_f32 origin,
                                          raylet_vec3_f32 direction);

/**
 * A ray from a point towards another.
 */
raylet_status raylet_ray_towards_f32(raylet_ray_f32 *ray,
                                     raylet_vec3_f32 origin,
                                     raylet_vec3_f32 target);

/**
 * The ray from a point to another, which ends there.
 */
raylet_status raylet_ray_segment_f32(raylet_ray_f32 *ray, raylet_vec3_f32 a, raylet_vec3_f32 b);

/**
 * Sets the range of `t`; hits outside it are not reported. It is 0 to the largest number if it is not set.
 */
raylet_status raylet_ray_set_range_f32(raylet_ray_f32 *ray,
                                       float start,
                                       float end);

/**
 * Says that a ray starts on this part of the surface of a shape, so that it does not meet that surface at once.
 * `leaving` is a `raylet_leaving`. `shape` is the index of the shape in its list; for a shape by itself it has no
 * effect.
 */
raylet_status raylet_ray_departing_f32(raylet_ray_f32 *ray,
                                       uint32_t shape,
                                       uint8_t part,
                                       uint8_t leaving);

/**
 * The point at `t`.
 */
raylet_status raylet_ray_at_f32(raylet_vec3_f32 *point, const raylet_ray_f32 *ray, float t);

/**
 * The direction of length 1, in the unit of directions.
 */
raylet_status raylet_ray_direction_f32(raylet_vec3_f32 *direction, const raylet_ray_f32 *ray);

/**
 * The plane y = 0, with its normal along +y.
 */
raylet_status raylet_plane_f32(raylet_shape_f32 *shape);

/**
 * A ball about the origin.
 */
raylet_status raylet_sphere_f32(raylet_shape_f32 *shape, float radius);

/**
 * A solid cylinder without ends about the y axis.
 */
raylet_status raylet_cylinder_infinite_f32(raylet_shape_f32 *shape, float radius);

/**
 * The side of a cylinder about the y axis, from y = 0 up: an open surface.
 */
raylet_status raylet_cylinder_open_f32(raylet_shape_f32 *shape, float radius, float height);

/**
 * A solid cylinder about the y axis, from y = 0 up.
 */
raylet_status raylet_cylinder_capped_f32(raylet_shape_f32 *shape, float radius, float height);

/**
 * A solid double cone without ends about the y axis, with its apex at the origin. `slope` is radius over height.
 */
raylet_status raylet_cone_double_f32(raylet_shape_f32 *shape,
                                     float slope);

/**
 * The upper half of a double cone.
 */
raylet_status raylet_cone_nappe_f32(raylet_shape_f32 *shape, float slope);

/**
 * The side of a cone from its apex at the origin up: an open surface.
 */
raylet_status raylet_cone_open_f32(raylet_shape_f32 *shape, float slope, float height);

/**
 * A solid cone from its apex at the origin up.
 */
raylet_status raylet_cone_capped_f32(raylet_shape_f32 *shape, float slope, float height);

/**
 * The side of a truncated cone from y = 0 up: an open surface.
 */
raylet_status raylet_frustum_open_f32(raylet_shape_f32 *shape,
                                      float base_radius,
                                      float top_radius,
                                      float height);

/**
 * A solid truncated cone from y = 0 up.
 */
raylet_status raylet_frustum_f32(raylet_shape_f32 *shape,
                                 float base_radius,
                                 float top_radius,
                                 float height);

/**
 * A cylinder from y = 0 to `height` with half balls at its ends, which `height` excludes.
 */
raylet_status raylet_capsule_f32(raylet_shape_f32 *shape, float radius, float height);

/**
 * The hull of two balls: about the origin, and about (0, height, 0).
 */
raylet_status raylet_round_cone_f32(raylet_shape_f32 *shape,
                                    float base_radius,
                                    float top_radius,
                                    float height);

/**
 * A box about the origin, by half of its extents.
 */
raylet_status raylet_cuboid_f32(raylet_shape_f32 *shape, float half_x, float half_y, float half_z);

/**
 * All points no farther than `radius` from a box about the origin, which is given by half of its extents.
 */
raylet_status raylet_rounded_cuboid_f32(raylet_shape_f32 *shape,
                                        float half_x,
                                        float half_y,
                                        float half_z,
                                        float radius);

/**
 * A solid tube about the y axis, from y = 0 up.
 */
raylet_status raylet_tube_f32(raylet_shape_f32 *shape,
                              float inner_radius,
                              float outer_radius,
                              float height);

/**
 * A torus about the y axis, in the plane y = 0.
 */
raylet_status raylet_torus_f32(raylet_shape_f32 *shape, float major_radius, float minor_radius);

/**
 * A disc about the origin in the plane y = 0.
 */
raylet_status raylet_disc_f32(raylet_shape_f32 *shape, float radius);

/**
 * A disc with a round hole.
 */
raylet_status raylet_annulus_f32(raylet_shape_f32 *shape, float inner_radius, float outer_radius);

/**
 * A rectangle about the origin in the plane y = 0, by half of its extents.
 */
raylet_status raylet_rectangle_f32(raylet_shape_f32 *shape, float half_x, float half_z);

/**
 * A triangle, anticlockwise as seen from its front.
 */
raylet_status raylet_triangle_f32(raylet_shape_f32 *shape,
                                  raylet_vec3_f32 a,
                                  raylet_vec3_f32 b,
                                  raylet_vec3_f32 c);

/**
 * The quadric of revolution x^2 + z^2 = a y^2 + 2 b y + radius^2, between two heights; `is_open` leaves out its caps.
 */
raylet_status raylet_revolved_f32(raylet_shape_f32 *shape,
                                  float a,
                                  float b,
                                  float radius,
                                  float low,
                                  float high,
                                  bool is_open);

/**
 * A bowl from its vertex at the origin up, full.
 */
raylet_status raylet_paraboloid_f32(raylet_shape_f32 *shape, float focal_length, float height);

/**
 * An ellipsoid of revolution about the origin, between two heights.
 */
raylet_status raylet_spheroid_f32(raylet_shape_f32 *shape,
                                  float radius,
                                  float half_height,
                                  float low,
                                  float high);

/**
 * A ball about the origin between two heights.
 */
raylet_status raylet_ball_zone_f32(raylet_shape_f32 *shape, float radius, float low, float high);

/**
 * A hyperboloid of one sheet with its waist at the origin, between two heights.
 */
raylet_status raylet_hyperboloid_f32(raylet_shape_f32 *shape,
                                     float waist,
                                     float slope,
                                     float low,
                                     float high);

/**
 * A hyperboloid of one sheet by its radii at both ends, its smaller waist, which is at y = 0, and its height.
 */
raylet_status raylet_tower_f32(raylet_shape_f32 *shape,
                               float base_radius,
                               float waist,
                               float top_radius,
                               float height);

/**
 * A prism over a convex polygon with 3 to 16 corners, from y = 0 up. `corners` are `count` pairs of x and z,
 * counter-clockwise as seen from +y. They must stay where they are, unchanged, as long as the shape is used: they may
 * lie in flash.
 */
raylet_status raylet_prism_f32(raylet_shape_f32 *shape,
                               const float *corners,
                               size_t count,
                               float height);

/**
 * The half-space on the side of a plane that `normal` points away from. `point` is on the plane; `normal` has any
 * length.
 */
raylet_status raylet_half_space_through_f32(raylet_half_space_f32 *half_space,
                                            raylet_vec3_f32 point,
                                            raylet_vec3_f32 normal);

/**
 * What 1 to 16 half-spaces have in common, which must be bounded. They must stay where they are, unchanged, as long
 * as the shape is used.
 */
raylet_status raylet_polyhedron_f32(raylet_shape_f32 *shape,
                                    const raylet_half_space_f32 *faces,
                                    size_t count);

/**
 * What a box, from its lowest to its highest corner, has in common with up to 16 half-spaces, which must stay where
 * they are, unchanged, as long as the shape is used.
 */
raylet_status raylet_polyhedron_within_f32(raylet_shape_f32 *shape,
                                           raylet_vec3_f32 low,
                                           raylet_vec3_f32 high,
                                           const raylet_half_space_f32 *faces,
                                           size_t count);

/**
 * An ellipsoid about the origin, which places it already: `raylet_ellipsoid_in_frame_f32` turns and moves it.
 */
raylet_status raylet_ellipsoid_f32(raylet_shape_f32 *shape,
                                   float radius_x,
                                   float radius_y,
                                   float radius_z);

/**
 * An ellipsoid about the origin of a frame, along its axes.
 */
raylet_status raylet_ellipsoid_in_frame_f32(raylet_shape_f32 *shape,
                                            float radius_x,
                                            float radius_y,
                                            float radius_z,
                                            const raylet_frame_f32 *frame);

/**
 * The nearest visible hit within the range of a ray: 1 and the hit, or 0. In the tier Stable, as all queries whose
 * names name no tier.
 */
raylet_status raylet_nearest_i16f16(raylet_hit_i16f16 *hit,
                                    const raylet_shape_i16f16 *shape,
                                    const raylet_ray_i16f16 *ray);

/**
 * As `raylet_nearest_i16f16`, in the tier Plain.
 */
raylet_status raylet_nearest_plain_i16f16(raylet_hit_i16f16 *hit,
                                          const raylet_shape_i16f16 *shape,
                                          const raylet_ray_i16f16 *ray);

/**
 * As `raylet_nearest_i16f16`, in the tier Fast.
 */
raylet_status raylet_nearest_fast_i16f16(raylet_hit_i16f16 *hit,
                                         const raylet_shape_i16f16 *shape,
                                         const raylet_ray_i16f16 *ray);

/**
 * As `raylet_nearest_i16f16`, in the tier Exact.
 */
raylet_status raylet_nearest_exact_i16f16(raylet_hit_i16f16 *hit,
                                          const raylet_shape_i16f16 *shape,
                                          const raylet_ray_i16f16 *ray);

/**
 * The nearest hit by the first numbers of the tier Stable alone: 1 and the hit, 0, or `RAYLET_ERROR_UNDECIDED`. For
 * the least flash, and the least time of the slowest ray.
 */
raylet_status raylet_try_nearest_i16f16(raylet_hit_i16f16 *hit,
                                        const raylet_shape_i16f16 *shape,
                                        const raylet_ray_i16f16 *ray);

/**
 * As `raylet_try_nearest_i16f16`, in the tier Plain.
 */
raylet_status raylet_try_nearest_plain_i16f16(raylet_hit_i16f16 *hit,
                                              const raylet_shape_i16f16 *shape,
                                              const raylet_ray_i16f16 *ray);

/**
 * As `raylet_try_nearest_i16f16`, in the tier Fast.
 */
raylet_status raylet_try_nearest_fast_i16f16(raylet_hit_i16f16 *hit,
                                             const raylet_shape_i16f16 *shape,
                                             const raylet_ray_i16f16 *ray);

/**
 * 1 if a ray hits the shape within its range, or 0.
 */
raylet_status raylet_occludes_i16f16(const raylet_shape_i16f16 *shape,
                                     const raylet_ray_i16f16 *ray);

/**
 * As `raylet_occludes_i16f16`, in the tier Plain.
 */
raylet_status raylet_occludes_plain_i16f16(const raylet_shape_i16f16 *shape,
                                           const raylet_ray_i16f16 *ray);

/**
 * As `raylet_occludes_i16f16`, in the tier Fast.
 */
raylet_status raylet_occludes_fast_i16f16(const raylet_shape_i16f16 *shape,
                                          const raylet_ray_i16f16 *ray);

/**
 * As `raylet_occludes_i16f16`, in the tier Exact.
 */
raylet_status raylet_occludes_exact_i16f16(const raylet_shape_i16f16 *shape,
                                           const raylet_ray_i16f16 *ray);

/**
 * 1 if a point is in the closed solid, or 0; 0 of an open surface.
 */
raylet_status raylet_contains_i16f16(const raylet_shape_i16f16 *shape, raylet_vec3_i16f16 point);

/**
 * As `raylet_contains_i16f16`, in the tier Plain.
 */
raylet_status raylet_contains_plain_i16f16(const raylet_shape_i16f16 *shape,
                                           raylet_vec3_i16f16 point);

/**
 * As `raylet_contains_i16f16`, in the tier Fast.
 */
raylet_status raylet_contains_fast_i16f16(const raylet_shape_i16f16 *shape,
                                          raylet_vec3_i16f16 point);

/**
 * As `raylet_contains_i16f16`, in the tier Exact.
 */
raylet_status raylet_contains_exact_i16f16(const raylet_shape_i16f16 *shape,
                                           raylet_vec3_i16f16 point);

/**
 * All visible hits within the range of a ray, sorted by `t`: their number, up to `RAYLET_MOST_HITS`.
 */
raylet_status raylet_all_hits_i16f16(raylet_hits_i16f16 *hits,
                                     const raylet_shape_i16f16 *shape,
                                     const raylet_ray_i16f16 *ray);

/**
 * As `raylet_all_hits_i16f16`, in the tier Plain.
 */
raylet_status raylet_all_hits_plain_i16f16(raylet_hits_i16f16 *hits,
                                           const raylet_shape_i16f16 *shape,
                                           const raylet_ray_i16f16 *ray);

/**
 * As `raylet_all_hits_i16f16`, in the tier Fast.
 */
raylet_status raylet_all_hits_fast_i16f16(raylet_hits_i16f16 *hits,
                                          const raylet_shape_i16f16 *shape,
                                          const raylet_ray_i16f16 *ray);

/**
 * As `raylet_all_hits_i16f16`, in the tier Exact.
 */
raylet_status raylet_all_hits_exact_i16f16(raylet_hits_i16f16 *hits,
                                           const raylet_shape_i16f16 *shape,
                                           const raylet_ray_i16f16 *ray);

/**
 * The surface of a shape at a hit of a ray with it.
 */
raylet_status raylet_surface_at_i16f16(raylet_surface_i16f16 *surface,
                                       const raylet_shape_i16f16 *shape,
                                       const raylet_ray_i16f16 *ray,
                                       const raylet_hit_i16f16 *hit);

/**
 * The point of the hit.
 */
raylet_status raylet_surface_point_i16f16(raylet_vec3_i16f16 *point,
                                          const raylet_surface_i16f16 *surface);

/**
 * The outward normal, of length 1, in the unit of directions.
 */
raylet_status raylet_surface_normal_i16f16(raylet_vec3_i16f16 *normal,
                                           const raylet_surface_i16f16 *surface);

/**
 * The normal on the side that the ray comes from.
 */
raylet_status raylet_surface_normal_towards_ray_i16f16(raylet_vec3_i16f16 *normal,
                                                       const raylet_surface_i16f16 *surface);

/**
 * The cosine of the angle between the line of the ray and the normal, from 0 to 1, as a number.
 */
raylet_status raylet_surface_cosine_i16f16(raylet_i16f16 *cosine,
                                           const raylet_surface_i16f16 *surface);

/**
 * Surface coordinates, each from 0 to 1, in the unit of directions.
 */
raylet_status raylet_surface_uv_i16f16(raylet_i16f16 (*uv)[2],
                                       const raylet_surface_i16f16 *surface);

/**
 * Where the hit lies in the bounding box of the solid along its axes, each from 0 to 1, in the unit of directions.
 */
raylet_status raylet_surface_uvw_i16f16(raylet_i16f16 (*uvw)[3],
                                        const raylet_surface_i16f16 *surface);

/**
 * The directions in the world in which u and v grow, of length 1, in the unit of directions.
 */
raylet_status raylet_surface_tangents_i16f16(raylet_vec3_i16f16 *along_u,
                                             raylet_vec3_i16f16 *along_v,
                                             const raylet_surface_i16f16 *surface);

/**
 * Makes a hierarchy of a list of shapes in the given nodes: `RAYLET_NODES(count)` of them. List and nodes must stay
 * where they are, unchanged, as long as it is used. To move a shape, change the list and build it again.
 */
raylet_status raylet_shapes_build_i16f16(raylet_shapes_i16f16 *shapes,
                                         const raylet_shape_i16f16 *list,
                                         size_t count,
                                         raylet_node_i16f16 *nodes,
                                         size_t node_count);

/**
 * The nearest hit of a ray with any of the shapes: 1, the index of its shape and the hit; or 0.
 */
raylet_status raylet_shapes_nearest_i16f16(uint32_t *shape,
                                           raylet_hit_i16f16 *hit,
                                           const raylet_shapes_i16f16 *shapes,
                                           const raylet_ray_i16f16 *ray);

/**
 * As `raylet_shapes_nearest_i16f16`, in the tier Plain.
 */
raylet_status raylet_shapes_nearest_plain_i16f16(uint32_t *shape,
                                                 raylet_hit_i16f16 *hit,
                                                 const raylet_shapes_i16f16 *shapes,
                                                 const raylet_ray_i16f16 *ray);

/**
 * As `raylet_shapes_nearest_i16f16`, in the tier Fast.
 */
raylet_status raylet_shapes_nearest_fast_i16f16(uint32_t *shape,
                                                raylet_hit_i16f16 *hit,
                                                const raylet_shapes_i16f16 *shapes,
                                                const raylet_ray_i16f16 *ray);

/**
 * As `raylet_shapes_nearest_i16f16`, in the tier Exact.
 */
raylet_status raylet_shapes_nearest_exact_i16f16(uint32_t *shape,
                                                 raylet_hit_i16f16 *hit,
                                                 const raylet_shapes_i16f16 *shapes,
                                                 const raylet_ray_i16f16 *ray);

/**
 * 1 if a ray hits any of the shapes within its range, or 0.
 */
raylet_status raylet_shapes_occlude_i16f16(const raylet_shapes_i16f16 *shapes,
                                           const raylet_ray_i16f16 *ray);

/**
 * As `raylet_shapes_occlude_i16f16`, in the tier Plain.
 */
raylet_status raylet_shapes_occlude_plain_i16f16(const raylet_shapes_i16f16 *shapes,
                                                 const raylet_ray_i16f16 *ray);

/**
 * As `raylet_shapes_occlude_i16f16`, in the tier Fast.
 */
raylet_status raylet_shapes_occlude_fast_i16f16(const raylet_shapes_i16f16 *shapes,
                                                const raylet_ray_i16f16 *ray);

/**
 * As `raylet_shapes_occlude_i16f16`, in the tier Exact.
 */
raylet_status raylet_shapes_occlude_exact_i16f16(const raylet_shapes_i16f16 *shapes,
                                                 const raylet_ray_i16f16 *ray);

/**
 * Calls `each` with every shape that a ray hits or starts inside of, in no order; the number of calls. The hits are
 * there until it returns.
 */
raylet_status raylet_shapes_hits_i16f16(const raylet_shapes_i16f16 *shapes,
                                        const raylet_ray_i16f16 *ray,
                                        void (*each)(void *context,
                                                     uint32_t shape,
                                                     const raylet_hits_i16f16 *hits),
                                        void *context);

/**
 * As `raylet_shapes_hits_i16f16`, in the tier Plain.
 */
raylet_status raylet_shapes_hits_plain_i16f16(const raylet_shapes_i16f16 *shapes,
                                              const raylet_ray_i16f16 *ray,
                                              void (*each)(void *context,
                                                           uint32_t shape,
                                                           const raylet_hits_i16f16 *hits),
                                              void *context);

/**
 * As `raylet_shapes_hits_i16f16`, in the tier Fast.
 */
raylet_status raylet_shapes_hits_fast_i16f16(const raylet_shapes_i16f16 *shapes,
                                             const raylet_ray_i16f16 *ray,
                                             void (*each)(void *context,
                                                          uint32_t shape,
                                                          const raylet_hits_i16f16 *hits),
                                             void *context);

/**
 * As `raylet_shapes_hits_i16f16`, in the tier Exact.
 */
raylet_status raylet_shapes_hits_exact_i16f16(const raylet_shapes_i16f16 *shapes,
                                              const raylet_ray_i16f16 *ray,
                                              void (*each)(void *context,
                                                           uint32_t shape,
                                                           const raylet_hits_i16f16 *hits),
                                              void *context);

/**
 * All crossings of a ray with up to `RAYLET_MOST_SOLIDS` solids, in order, and which solids it is inside of between
 * them: their number, up to `capacity` and `RAYLET_MOST_CROSSINGS`. Where solids touch, the order is that of one
 * solid after the other; see the documentation of `raylet::solids`.
 */
raylet_status raylet_crossings_i16f16(raylet_crossing_i16f16 *crossings,
                                      size_t capacity,
                                      const raylet_shape_i16f16 *list,
                                      size_t count,
                                      const raylet_ray_i16f16 *ray);

/**
 * As `raylet_crossings_i16f16`, in the tier Plain.
 */
raylet_status raylet_crossings_plain_i16f16(raylet_crossing_i16f16 *crossings,
                                            size_t capacity,
                                            const raylet_shape_i16f16 *list,
                                            size_t count,
                                            const raylet_ray_i16f16 *ray);

/**
 * As `raylet_crossings_i16f16`, in the tier Fast.
 */
raylet_status raylet_crossings_fast_i16f16(raylet_crossing_i16f16 *crossings,
                                           size_t capacity,
                                           const raylet_shape_i16f16 *list,
                                           size_t count,
                                           const raylet_ray_i16f16 *ray);

/**
 * As `raylet_crossings_i16f16`, in the tier Exact.
 */
raylet_status raylet_crossings_exact_i16f16(raylet_crossing_i16f16 *crossings,
                                            size_t capacity,
                                            const raylet_shape_i16f16 *list,
                                            size_t count,
                                            const raylet_ray_i16f16 *ray);

/**
 * Places a shape by a frame, instead of what placed it before.
 */
raylet_status raylet_shape_in_frame_i16f16(raylet_shape_i16f16 *shape,
                                           const raylet_frame_i16f16 *frame);

/**
 * Places a shape by a frame, and stretches it along the axes of the frame by positive factors.
 */
raylet_status raylet_shape_stretched_i16f16(raylet_shape_i16f16 *shape,
                                            const raylet_frame_i16f16 *frame,
                                            raylet_vec3_i16f16 scale);

/**
 * Places a shape by a matrix: where its origin and its unit vectors along x, y and z go.
 */
raylet_status raylet_shape_in_matrix_i16f16(raylet_shape_i16f16 *shape,
                                            raylet_vec3_i16f16 position,
                                            raylet_vec3_i16f16 x,
                                            raylet_vec3_i16f16 y,
                                            raylet_vec3_i16f16 z);

/**
 * Moves a shape, however it is placed.
 */
raylet_status raylet_shape_move_to_i16f16(raylet_shape_i16f16 *shape, raylet_vec3_i16f16 position);

/**
 * Makes a shape seen from these sides only: a `raylet_visible`.
 */
raylet_status raylet_shape_seen_from_i16f16(raylet_shape_i16f16 *shape, uint8_t visible);

/**
 * The box around a shape along the axes of the world; an infinite shape has the largest or infinite numbers.
 */
raylet_status raylet_shape_bounds_i16f16(raylet_vec3_i16f16 *low,
                                         raylet_vec3_i16f16 *high,
                                         const raylet_shape_i16f16 *shape);

/**
 * A frame along the axes of the world.
 */
raylet_status raylet_frame_at_i16f16(raylet_frame_i16f16 *frame, raylet_vec3_i16f16 position);

/**
 * A frame with its y axis along a vector of any length, for a solid whose base is there.
 */
raylet_status raylet_frame_from_base_and_axis_i16f16(raylet_frame_i16f16 *frame,
                                                     raylet_vec3_i16f16 base,
                                                     raylet_vec3_i16f16 axis);

/**
 * The same, for a solid of this height whose middle is there.
 */
raylet_status raylet_frame_from_centre_and_axis_i16f16(raylet_frame_i16f16 *frame,
                                                       raylet_vec3_i16f16 centre,
                                                       raylet_vec3_i16f16 axis,
                                                       raylet_i16f16 height);

/**
 * A frame turned about an axis of any length through its position, counter-clockwise as seen from the tip of the
 * axis.
 */
raylet_status raylet_frame_turned_about_i16f16(raylet_frame_i16f16 *frame,
                                               raylet_vec3_i16f16 position,
                                               raylet_vec3_i16f16 axis,
                                               raylet_i16f16 degrees);

/**
 * A frame turned by the quaternion (x, y, z, w), of any length near 1; its components are in the unit of directions.
 */
raylet_status raylet_frame_from_quaternion_i16f16(raylet_frame_i16f16 *frame,
                                                  raylet_vec3_i16f16 position,
                                                  raylet_i16f16 x,
                                                  raylet_i16f16 y,
                                                  raylet_i16f16 z,
                                                  raylet_i16f16 w);

/**
 * A frame with its y axis from one point to another; the distance between them is the height of a solid that reaches
 * from one to the other.
 */
raylet_status raylet_frame_between_i16f16(raylet_frame_i16f16 *frame,
                                          raylet_i16f16 *height,
                                          raylet_vec3_i16f16 from,
                                          raylet_vec3_i16f16 to);

/**
 * A frame with its z axis along `forward`, and `up` towards its y axis; both of any length.
 */
raylet_status raylet_frame_looking_i16f16(raylet_frame_i16f16 *frame,
                                          raylet_vec3_i16f16 position,
                                          raylet_vec3_i16f16 forward,
                                          raylet_vec3_i16f16 up);

/**
 * A frame with these axes, which are nearly at right angles and right-handed, of any length.
 */
raylet_status raylet_frame_from_axes_i16f16(raylet_frame_i16f16 *frame,
                                            raylet_vec3_i16f16 position,
                                            raylet_vec3_i16f16 x,
                                            raylet_vec3_i16f16 y,
                                            raylet_vec3_i16f16 z);

/**
 * A frame that is given in another one, as a frame in the world.
 */
raylet_status raylet_frame_to_world_i16f16(raylet_frame_i16f16 *frame,
                                           const raylet_frame_i16f16 *outer,
                                           const raylet_frame_i16f16 *inner);

/**
 * A point of the world in the coordinates of a frame.
 */
raylet_status raylet_frame_point_to_local_i16f16(raylet_vec3_i16f16 *out,
                                                 const raylet_frame_i16f16 *frame,
                                                 raylet_vec3_i16f16 point);

/**
 * A point in the coordinates of a frame in those of the world.
 */
raylet_status raylet_frame_point_to_world_i16f16(raylet_vec3_i16f16 *out,
                                                 const raylet_frame_i16f16 *frame,
                                                 raylet_vec3_i16f16 point);

/**
 * A ray from a point towards a vector of any length. `t` is distance.
 */
raylet_status raylet_ray_along_i16f16(raylet_ray_i16f16 *ray,
                                      raylet_vec3_i16f16 origin,
                                      raylet_vec3_i16f16 direction);

/**
 * A ray from a point with a direction of length 1, whose components are in the unit of directions: as
 * `raylet_surface_normal_i16f16` gives them.
 */
raylet_status raylet_ray_in_direction_i16f16(raylet_ray_i16f16 *ray,
                                             raylet_vec3_i16f16 origin,
                                             raylet_vec3_i16f16 direction);

/**
 * A ray from a point towards another.
 */
raylet_status raylet_ray_towards_i16f16(raylet_ray_i16f16 *ray,
                                        raylet_vec3_i16f16 origin,
                                        raylet_vec3_i16f16 target);

/**
 * The ray from a point to another, which ends there.
 */
raylet_status raylet_ray_segment_i16f16(raylet_ray_i16f16 *ray,
                                        raylet_vec3_i16f16 a,
                                        raylet_vec3_i16f16 b);

/**
 * Sets the range of `t`; hits outside it are not reported. It is 0 to the largest number if it is not set.
 */
raylet_status raylet_ray_set_range_i16f16(raylet_ray_i16f16 *ray,
                                          raylet_i16f16 start,
                                          raylet_i16f16 end);

/**
 * Says that a ray starts on this part of the surface of a shape, so that it does not meet that surface at once.
 * `leaving` is a `raylet_leaving`. `shape` is the index of the shape in its list; for a shape by itself it has no
 * effect.
 */
raylet_status raylet_ray_departing_i16f16(raylet_ray_i16f16 *ray,
                                          uint32_t shape,
                                          uint8_t part,
                                          uint8_t leaving);

/**
 * The point at `t`.
 */
raylet_status raylet_ray_at_i16f16(raylet_vec3_i16f16 *point,
                                   const raylet_ray_i16f16 *ray,
                                   raylet_i16f16 t);

/**
 * The direction of length 1, in the unit of directions.
 */
raylet_status raylet_ray_direction_i16f16(raylet_vec3_i16f16 *direction,
                                          const raylet_ray_i16f16 *ray);

/**
 * The plane y = 0, with its normal along +y.
 */
raylet_status raylet_plane_i16f16(raylet_shape_i16f16 *shape);

/**
 * A ball about the origin.
 */
raylet_status raylet_sphere_i16f16(raylet_shape_i16f16 *shape, raylet_i16f16 radius);

/**
 * A solid cylinder without ends about the y axis.
 */
raylet_status raylet_cylinder_infinite_i16f16(raylet_shape_i16f16 *shape, raylet_i16f16 radius);

/**
 * The side of a cylinder about the y axis, from y = 0 up: an open surface.
 */
raylet_status raylet_cylinder_open_i16f16(raylet_shape_i16f16 *shape,
                                          raylet_i16f16 radius,
                                          raylet_i16f16 height);

/**
 * A solid cylinder about the y axis, from y = 0 up.
 */
raylet_status raylet_cylinder_capped_i16f16(raylet_shape_i16f16 *shape,
                                            raylet_i16f16 radius,
                                            raylet_i16f16 height);

/**
 * A solid double cone without ends about the y axis, with its apex at the origin. `slope` is radius over height.
 */
raylet_status raylet_cone_double_i16f16(raylet_shape_i16f16 *shape,
                                        raylet_i16f16 slope);

/**
 * The upper half of a double cone.
 */
raylet_status raylet_cone_nappe_i16f16(raylet_shape_i16f16 *shape, raylet_i16f16 slope);

/**
 * The side of a cone from its apex at the origin up: an open surface.
 */
raylet_status raylet_cone_open_i16f16(raylet_shape_i16f16 *shape,
                                      raylet_i16f16 slope,
                                      raylet_i16f16 height);

/**
 * A solid cone from its apex at the origin up.
 */
raylet_status raylet_cone_capped_i16f16(raylet_shape_i16f16 *shape,
                                        raylet_i16f16 slope,
                                        raylet_i16f16 height);

/**
 * The side of a truncated cone from y = 0 up: an open surface.
 */
raylet_status raylet_frustum_open_i16f16(raylet_shape_i16f16 *shape,
                                         raylet_i16f16 base_radius,
                                         raylet_i16f16 top_radius,
                                         raylet_i16f16 height);

/**
 * A solid truncated cone from y = 0 up.
 */
raylet_status raylet_frustum_i16f16(raylet_shape_i16f16 *shape,
                                    raylet_i16f16 base_radius,
                                    raylet_i16f16 top_radius,
                                    raylet_i16f16 height);

/**
 * A cylinder from y = 0 to `height` with half balls at its ends, which `height` excludes.
 */
raylet_status raylet_capsule_i16f16(raylet_shape_i16f16 *shape,
                                    raylet_i16f16 radius,
                                    raylet_i16f16 height);

/**
 * The hull of two balls: about the origin, and about (0, height, 0).
 */
raylet_status raylet_round_cone_i16f16(raylet_shape_i16f16 *shape,
                                       raylet_i16f16 base_radius,
                                       raylet_i16f16 top_radius,
                                       raylet_i16f16 height);

/**
 * A box about the origin, by half of its extents.
 */
raylet_status raylet_cuboid_i16f16(raylet_shape_i16f16 *shape,
                                   raylet_i16f16 half_x,
                                   raylet_i16f16 half_y,
                                   raylet_i16f16 half_z);

/**
 * All points no farther than `radius` from a box about the origin, which is given by half of its extents.
 */
raylet_status raylet_rounded_cuboid_i16f16(raylet_shape_i16f16 *shape,
                                           raylet_i16f16 half_x,
                                           raylet_i16f16 half_y,
                                           raylet_i16f16 half_z,
                                           raylet_i16f16 radius);

/**
 * A solid tube about the y axis, from y = 0 up.
 */
raylet_status raylet_tube_i16f16(raylet_shape_i16f16 *shape,
                                 raylet_i16f16 inner_radius,
                                 raylet_i16f16 outer_radius,
                                 raylet_i16f16 height);

/**
 * A torus about the y axis, in the plane y = 0.
 */
raylet_status raylet_torus_i16f16(raylet_shape_i16f16 *shape,
                                  raylet_i16f16 major_radius,
                                  raylet_i16f16 minor_radius);

/**
 * A disc about the origin in the plane y = 0.
 */
raylet_status raylet_disc_i16f16(raylet_shape_i16f16 *shape, raylet_i16f16 radius);

/**
 * A disc with a round hole.
 */
raylet_status raylet_annulus_i16f16(raylet_shape_i16f16 *shape,
                                    raylet_i16f16 inner_radius,
                                    raylet_i16f16 outer_radius);

/**
 * A rectangle about the origin in the plane y = 0, by half of its extents.
 */
raylet_status raylet_rectangle_i16f16(raylet_shape_i16f16 *shape,
                                      raylet_i16f16 half_x,
                                      raylet_i16f16 half_z);

/**
 * A triangle, anticlockwise as seen from its front.
 */
raylet_status raylet_triangle_i16f16(raylet_shape_i16f16 *shape,
                                     raylet_vec3_i16f16 a,
                                     raylet_vec3_i16f16 b,
                                     raylet_vec3_i16f16 c);

/**
 * The quadric of revolution x^2 + z^2 = a y^2 + 2 b y + radius^2, between two heights; `is_open` leaves out its caps.
 */
raylet_status raylet_revolved_i16f16(raylet_shape_i16f16 *shape,
                                     raylet_i16f16 a,
                                     raylet_i16f16 b,
                                     raylet_i16f16 radius,
                                     raylet_i16f16 low,
                                     raylet_i16f16 high,
                                     bool is_open);

/**
 * A bowl from its vertex at the origin up, full.
 */
raylet_status raylet_paraboloid_i16f16(raylet_shape_i16f16 *shape,
                                       raylet_i16f16 focal_length,
                                       raylet_i16f16 height);

/**
 * An ellipsoid of revolution about the origin, between two heights.
 */
raylet_status raylet_spheroid_i16f16(raylet_shape_i16f16 *shape,
                                     raylet_i16f16 radius,
                                     raylet_i16f16 half_height,
                                     raylet_i16f16 low,
                                     raylet_i16f16 high);

/**
 * A ball about the origin between two heights.
 */
raylet_status raylet_ball_zone_i16f16(raylet_shape_i16f16 *shape,
                                      raylet_i16f16 radius,
                                      raylet_i16f16 low,
                                      raylet_i16f16 high);

/**
 * A hyperboloid of one sheet with its waist at the origin, between two heights.
 */
raylet_status raylet_hyperboloid_i16f16(raylet_shape_i16f16 *shape,
                                        raylet_i16f16 waist,
                                        raylet_i16f16 slope,
                                        raylet_i16f16 low,
                                        raylet_i16f16 high);

/**
 * A hyperboloid of one sheet by its radii at both ends, its smaller waist, which is at y = 0, and its height.
 */
raylet_status raylet_tower_i16f16(raylet_shape_i16f16 *shape,
                                  raylet_i16f16 base_radius,
                                  raylet_i16f16 waist,
                                  raylet_i16f16 top_radius,
                                  raylet_i16f16 height);

/**
 * A prism over a convex polygon with 3 to 16 corners, from y = 0 up. `corners` are `count` pairs of x and z,
 * counter-clockwise as seen from +y. They must stay where they are, unchanged, as long as the shape is used: they may
 * lie in flash.
 */
raylet_status raylet_prism_i16f16(raylet_shape_i16f16 *shape,
                                  const raylet_i16f16 *corners,
                                  size_t count,
                                  raylet_i16f16 height);

/**
 * The half-space on the side of a plane that `normal` points away from. `point` is on the plane; `normal` has any
 * length.
 */
raylet_status raylet_half_space_through_i16f16(raylet_half_space_i16f16 *half_space,
                                               raylet_vec3_i16f16 point,
                                               raylet_vec3_i16f16 normal);

/**
 * What 1 to 16 half-spaces have in common, which must be bounded. They must stay where they are, unchanged, as long
 * as the shape is used.
 */
raylet_status raylet_polyhedron_i16f16(raylet_shape_i16f16 *shape,
                                       const raylet_half_space_i16f16 *faces,
                                       size_t count);

/**
 * What a box, from its lowest to its highest corner, has in common with up to 16 half-spaces, which must stay where
 * they are, unchanged, as long as the shape is used.
 */
raylet_status raylet_polyhedron_within_i16f16(raylet_shape_i16f16 *shape,
                                              raylet_vec3_i16f16 low,
                                              raylet_vec3_i16f16 high,
                                              const raylet_half_space_i16f16 *faces,
                                              size_t count);

/**
 * An ellipsoid about the origin, which places it already: `raylet_ellipsoid_in_frame_i16f16` turns and moves it.
 */
raylet_status raylet_ellipsoid_i16f16(raylet_shape_i16f16 *shape,
                                      raylet_i16f16 radius_x,
                                      raylet_i16f16 radius_y,
                                      raylet_i16f16 radius_z);

/**
 * An ellipsoid about the origin of a frame, along its axes.
 */
raylet_status raylet_ellipsoid_in_frame_i16f16(raylet_shape_i16f16 *shape,
                                               raylet_i16f16 radius_x,
                                               raylet_i16f16 radius_y,
                                               raylet_i16f16 radius_z,
                                               const raylet_frame_i16f16 *frame);

uint32_t raylet_measured_f32(const raylet_shape_f32 *shape,
                             const raylet_ray_f32 *ray,
                             uint32_t times);

uint32_t raylet_measured_i16f16(const raylet_shape_i16f16 *shape,
                                const raylet_ray_i16f16 *ray,
                                uint32_t times);

/**
 * The text of an error code, in English, such as "the radius is negative". Of a status that is no error, "no error".
 */
const char *raylet_status_text(raylet_status status);

#ifdef __cplusplus
}  // extern "C"
#endif  // __cplusplus

#endif  /* RAYLET_H */
