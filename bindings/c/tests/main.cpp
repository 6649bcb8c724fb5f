// The C++ interface, in both number types: what is made, what is refused, what is found.

#include "raylet.hpp"

extern "C" {
#include "machine.h"
}

static int failures;

static void check(bool holds, const char *what, unsigned line) {
    if (!holds) {
        failures++;
        print_text("line ");
        print_number(line);
        print_text(": ");
        print_text(what);
        print_text("\n");
    }
}

#define CHECK(condition) check(static_cast<bool>(condition), #condition, __LINE__)

static bool same(const char *a, const char *b) {
    while (*a && *a == *b) {
        a++, b++;
    }
    return *a == *b;
}

template <class Number> Number n(double value) {
    if constexpr (std::is_same_v<Number, float>) {
        return static_cast<float>(value);
    } else {
        return Number::of(value);
    }
}

template <class Number> raylet::Vec3<Number> v(double x, double y, double z) {
    return {n<Number>(x), n<Number>(y), n<Number>(z)};
}

template <class Number> void test() {
    using Shape = raylet::Shape<Number>;
    using Frame = raylet::Frame<Number>;
    using Ray = raylet::Ray<Number>;

    const auto can = Shape::cylinder(n<Number>(0.25), n<Number>(1.0));
    const auto frame = Frame::from_base_and_axis(v<Number>(-0.5, 0, 3), v<Number>(1, 0, 0));
    const auto ray = Ray::along(v<Number>(0, 0, 0), v<Number>(0, 0, 1));
    CHECK(can && frame && ray);
    const auto placed = can->in(*frame);
    CHECK(placed);
    const auto hit = placed->nearest(*ray);
    CHECK(hit && hit->t == n<Number>(2.75) && hit->part == RAYLET_PART_SIDE && hit->crossing == RAYLET_ENTER);
    CHECK(placed->surface(*ray, *hit).point().z == n<Number>(2.75));
    CHECK(placed->surface(*ray, *hit).normal().z < 0);
    CHECK(placed->template hits<raylet::Tier::exact>(*ray).size() == 2);
    int exits = 0;
    for (const auto each : placed->template hits<raylet::Tier::fast>(*ray)) {
        exits += each.crossing == RAYLET_EXIT;
    }
    CHECK(exits == 1);
    CHECK(placed->occludes(*ray) && placed->contains(v<Number>(0, 0, 3)) && !placed->contains(v<Number>(0, 0, 4)));
    CHECK(!placed->nearest(*ray->between(n<Number>(0), n<Number>(2))));
    CHECK(placed->seen_from(RAYLET_INSIDE)->nearest(*ray)->crossing == RAYLET_EXIT);

    const auto refused = Shape::sphere(n<Number>(-1));
    CHECK(!refused && same(refused.error().text(), "the radius is negative"));

    raylet::Shapes<Number, 2> shapes;
    CHECK(!shapes.nearest(*ray));
    CHECK(*shapes.add(*placed) == 0 && *shapes.add(*Shape::sphere(n<Number>(1))->moved_to(v<Number>(0, 0, 2))) == 1);
    CHECK(!shapes.add(*placed));
    const auto nearest = shapes.nearest(*ray);
    CHECK(nearest && nearest->shape == 1 && nearest->hit.t == n<Number>(1));
    CHECK(shapes.occlude(*ray));
    // From there into the ball: it is left at its far end.
    const auto inwards = Ray::along(ray->at(nearest->hit.t), v<Number>(0, 0, 1));
    const auto leaving = inwards->departing(1, static_cast<std::uint8_t>(nearest->hit.part), RAYLET_INWARDS);
    CHECK(shapes[1].nearest(*leaving)->t == n<Number>(2));
}

int main() {
    start_machine();
    test<float>();
    test<raylet::I16F16>();
    print_number(static_cast<std::uint32_t>(failures));
    print_text(" failures in C++\n");
    stop_machine(failures != 0);
    return failures != 0;
}
