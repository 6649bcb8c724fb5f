/* The C interface: the cases of the Rust smoke test, every kind of refusal, and digests of all answers in all tiers.
 * On a chip also what a query takes, beside the same loop in Rust. */

#include "../include/raylet.h"
#include "machine.h"

static int failures;

static void check(int holds, const char *what, const char *name, int line) {
    if (!holds) {
        failures++;
        print_text("line ");
        print_number((uint32_t)line);
        print_text(": ");
        print_text(name);
        print_text(": ");
        print_text(what);
        print_text("\n");
    }
}

#define CHECK(condition, name) check(condition, #condition, name, __LINE__)

static int same(const char *a, const char *b) {
    while (*a && *a == *b) {
        a++, b++;
    }
    return *a == *b;
}

#define SAME(a, b) same(a, b)

/* FNV-1a, word by word. */
#define ADD(digest, word) (((digest) ^ (word)) * 16777619u)

/* On a chip one number type a program: all solids in all tiers of both have no room in its flash. */
#ifndef WITHOUT_F32
static uint32_t bits_of_float(float number) {
    union {
        float number;
        uint32_t bits;
    } both;
    both.number = number;
    return both.bits;
}

#define NUMBER f32
#define NUM float
#define N(x) ((float)(x))
#define RAW(k) ((float)(k) / 65536.0f)
#define VALUE(x) ((double)(x))
#define BITS(x) bits_of_float(x)
#define UNIT(x) ((float)(x))
#include "cases.inc"
#undef NUMBER
#undef NUM
#undef N
#undef RAW
#undef VALUE
#undef BITS
#undef UNIT
#endif

#ifndef WITHOUT_I16F16
#define NUMBER i16f16
#define NUM raylet_i16f16
#define N(x) ((raylet_i16f16)((x)*65536.0))
#define RAW(k) (k)
#define VALUE(x) ((double)(x) / 65536.0)
#define BITS(x) ((uint32_t)(x))
#define UNIT(x) ((raylet_i16f16)((x)*1073741824.0))
#include "cases.inc"
#endif

static void report(const char *name, uint32_t number) {
    print_text(name);
    print_number(number);
    print_text("\n");
}

#ifdef CHIP
/* In the library with the feature `measure`: the same loops in Rust. */
uint32_t raylet_measured_f32(const raylet_shape_f32 *shape, const raylet_ray_f32 *ray, uint32_t times);
uint32_t raylet_measured_i16f16(const raylet_shape_i16f16 *shape, const raylet_ray_i16f16 *ray, uint32_t times);

enum { TIMES = 4000 };

/* What a query takes in C beyond what it takes in Rust, and that, in instructions. */
#define COST(NUMBER, name, shape, ray)                                      \
    do {                                                                    \
        raylet_hit_##NUMBER hit;                                            \
        uint32_t start, in_c, in_rust, i, found = 0;                        \
        start = instructions();                                             \
        for (i = 0; i < TIMES; i++) {                                       \
            found += (uint32_t)raylet_nearest_##NUMBER(&hit, shape, ray);   \
        }                                                                   \
        in_c = instructions() - start;                                      \
        start = instructions();                                             \
        found -= raylet_measured_##NUMBER(shape, ray, TIMES);               \
        in_rust = instructions() - start;                                   \
        CHECK(found == 0, name);                                            \
        print_text("cost: " name ", " #NUMBER ": ");                        \
        print_number((in_c + TIMES / 2) / TIMES);                           \
        print_text(" in C, ");                                              \
        print_number((in_rust + TIMES / 2) / TIMES);                        \
        print_text(" in Rust\n");                                           \
    } while (0)

static void costs(void) {
#ifndef WITHOUT_F32
    raylet_ray_f32 ray;
    CHECK(raylet_ray_along_f32(&ray, test_v_f32(0.25, 0.5, 8.0), test_v_f32(0.0, 0.0, -1.0)) == 0, "a ray");
    COST(f32, "sphere", &test_shapes_f32[0], &ray);
    COST(f32, "capped cylinder", &test_shapes_f32[3], &ray);
#endif
#ifndef WITHOUT_I16F16
    raylet_ray_i16f16 fixed;
    CHECK(raylet_ray_along_i16f16(&fixed, test_v_i16f16(0.25, 0.5, 8.0), test_v_i16f16(0.0, 0.0, -1.0)) == 0, "a ray");
    COST(i16f16, "sphere", &test_shapes_i16f16[0], &fixed);
    COST(i16f16, "capped cylinder", &test_shapes_i16f16[3], &fixed);
#endif
}
#endif

int main(void) {
    uint32_t of_queries;
    start_machine();
#ifndef WITHOUT_F32
    test_make_f32();
    test_smoke_f32();
    test_refusals_f32();
    test_many_f32();
    of_queries = 2166136261u;
    report("digest of f32: ", test_digest_f32(RAYS, &of_queries));
#ifndef CHIP
    test_rest_f32();
    report("digest of queries in f32: ", of_queries);
#endif
#endif
#ifndef WITHOUT_I16F16
    test_make_i16f16();
    test_smoke_i16f16();
    test_refusals_i16f16();
    test_many_i16f16();
    of_queries = 2166136261u;
    report("digest of i16f16: ", test_digest_i16f16(RAYS, &of_queries));
#ifndef CHIP
    test_rest_i16f16();
    report("digest of queries in i16f16: ", of_queries);
#endif
#endif
#ifdef CHIP
    costs();
#endif
    report("failures: ", (uint32_t)failures);
    stop_machine(failures != 0);
    return failures != 0;
}
