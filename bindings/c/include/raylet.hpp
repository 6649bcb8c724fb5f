/// The C++ interface of raylet: types over `raylet.h` whose values are always made, in `float` and `raylet::I16F16`.
///
/// Nothing here allocates, throws or needs a release: all values are copied as their bytes. What may fail returns a
/// `raylet::Result`. C++17. SPDX-License-Identifier: MIT OR Apache-2.0
#ifndef RAYLET_HPP
#define RAYLET_HPP

#include "raylet.h"
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>

namespace raylet {

/// A fixed-point number in units of 2^-16.
struct I16F16 {
    std::int32_t bits;

    static constexpr I16F16 of(double value) { return {static_cast<std::int32_t>(value * 65536.0)}; }
    constexpr double to_double() const { return bits / 65536.0; }
    friend constexpr bool operator==(I16F16 a, I16F16 b) { return a.bits == b.bits; }
    friend constexpr bool operator<(I16F16 a, I16F16 b) { return a.bits < b.bits; }
};

/// An error: its code, and what it says.
struct Error {
    raylet_status code;

    const char *text() const { return raylet_status_text(code); }
};

/// A value, or an error. Ask before you take the value.
template <class T> class Result {
  public:
    Result(const T &value) : value_(value), code_(0) {}
    Result(Error error) : code_(error.code) {}

    explicit operator bool() const { return value_.has_value(); }
    const T &operator*() const { return *value_; }
    const T *operator->() const { return &*value_; }
    const T &value_or(const T &other) const { return value_ ? *value_ : other; }
    Error error() const { return {code_}; }

  private:
    std::optional<T> value_;
    raylet_status code_;
};

enum class Tier { plain, fast, stable, exact };

/// The functions and types of C in one number type.
template <class Number> struct Api;

#define RAYLET_TIERS_(name, NUMBER)                              \
    template <Tier tier, class... Given> static raylet_status name(Given... given) { \
        if constexpr (tier == Tier::plain) {                     \
            return raylet_##name##_plain_##NUMBER(given...);     \
        } else if constexpr (tier == Tier::fast) {               \
            return raylet_##name##_fast_##NUMBER(given...);      \
        } else if constexpr (tier == Tier::exact) {              \
            return raylet_##name##_exact_##NUMBER(given...);     \
        } else {                                                 \
            return raylet_##name##_##NUMBER(given...);           \
        }                                                        \
    }
#define RAYLET_SAME_(name, NUMBER) static constexpr auto name = raylet_##name##_##NUMBER;
#define RAYLET_API_(CPP, NUMBER)                                                              \
    template <> struct Api<CPP> {                                                             \
        using Raw = decltype(raylet_vec3_##NUMBER::x);                                        \
        using Vec3 = raylet_vec3_##NUMBER;                                                    \
        using Frame = raylet_frame_##NUMBER;                                                  \
        using Shape = raylet_shape_##NUMBER;                                                  \
        using Ray = raylet_ray_##NUMBER;                                                      \
        using Hit = raylet_hit_##NUMBER;                                                      \
        using Hits = raylet_hits_##NUMBER;                                                    \
        using Surface = raylet_surface_##NUMBER;                                              \
        using Node = raylet_node_##NUMBER;                                                    \
        using Shapes = raylet_shapes_##NUMBER;                                                \
        using Crossing = raylet_crossing_##NUMBER;                                            \
        RAYLET_SAME_(plane, NUMBER) RAYLET_SAME_(sphere, NUMBER)                              \
        RAYLET_SAME_(cylinder_infinite, NUMBER) RAYLET_SAME_(cylinder_open, NUMBER)           \
        RAYLET_SAME_(cylinder_capped, NUMBER) RAYLET_SAME_(cone_double, NUMBER)               \
        RAYLET_SAME_(cone_nappe, NUMBER) RAYLET_SAME_(cone_open, NUMBER)                      \
        RAYLET_SAME_(cone_capped, NUMBER) RAYLET_SAME_(frustum_open, NUMBER)                  \
        RAYLET_SAME_(frustum, NUMBER) RAYLET_SAME_(capsule, NUMBER)                           \
        RAYLET_SAME_(round_cone, NUMBER) RAYLET_SAME_(cuboid, NUMBER)                         \
        RAYLET_SAME_(rounded_cuboid, NUMBER) RAYLET_SAME_(tube, NUMBER)                       \
        RAYLET_SAME_(torus, NUMBER) RAYLET_SAME_(disc, NUMBER) RAYLET_SAME_(annulus, NUMBER)  \
        RAYLET_SAME_(rectangle, NUMBER) RAYLET_SAME_(triangle, NUMBER)                        \
        RAYLET_SAME_(paraboloid, NUMBER) RAYLET_SAME_(spheroid, NUMBER)                       \
        RAYLET_SAME_(ball_zone, NUMBER) RAYLET_SAME_(hyperboloid, NUMBER)                     \
        RAYLET_SAME_(tower, NUMBER) RAYLET_SAME_(ellipsoid, NUMBER)                           \
        RAYLET_SAME_(shape_in_frame, NUMBER) RAYLET_SAME_(shape_stretched, NUMBER)            \
        RAYLET_SAME_(shape_in_matrix, NUMBER) RAYLET_SAME_(shape_move_to, NUMBER)             \
        RAYLET_SAME_(shape_seen_from, NUMBER)                                                 \
        RAYLET_SAME_(frame_at, NUMBER) RAYLET_SAME_(frame_from_base_and_axis, NUMBER)         \
        RAYLET_SAME_(frame_turned_about, NUMBER) RAYLET_SAME_(frame_looking, NUMBER)          \
        RAYLET_SAME_(frame_from_axes, NUMBER) RAYLET_SAME_(frame_to_world, NUMBER)            \
        RAYLET_SAME_(ray_along, NUMBER) RAYLET_SAME_(ray_in_direction, NUMBER)                \
        RAYLET_SAME_(ray_towards, NUMBER) RAYLET_SAME_(ray_segment, NUMBER)                   \
        RAYLET_SAME_(ray_set_range, NUMBER) RAYLET_SAME_(ray_departing, NUMBER)               \
        RAYLET_SAME_(ray_at, NUMBER) RAYLET_SAME_(surface_at, NUMBER)                         \
        RAYLET_SAME_(surface_point, NUMBER) RAYLET_SAME_(surface_normal, NUMBER)              \
        RAYLET_SAME_(surface_uv, NUMBER) RAYLET_SAME_(shapes_build, NUMBER)                   \
        RAYLET_TIERS_(nearest, NUMBER) RAYLET_TIERS_(occludes, NUMBER)                        \
        RAYLET_TIERS_(contains, NUMBER) RAYLET_TIERS_(all_hits, NUMBER)                       \
        RAYLET_TIERS_(shapes_nearest, NUMBER) RAYLET_TIERS_(shapes_occlude, NUMBER)           \
        RAYLET_TIERS_(crossings, NUMBER)                                                      \
    };

RAYLET_API_(float, f32)
RAYLET_API_(I16F16, i16f16)
#undef RAYLET_API_
#undef RAYLET_SAME_
#undef RAYLET_TIERS_

namespace detail {

inline float raw(float number) { return number; }
inline std::int32_t raw(I16F16 number) { return number.bits; }
template <class Number> Number cooked(typename Api<Number>::Raw raw) {
    if constexpr (std::is_same_v<Number, float>) {
        return raw;
    } else {
        return Number{raw};
    }
}

/// What a function of C makes in its first argument.
template <class T, class Raw, class Make, class... Given> Result<T> made(Make make, Given... given) {
    Raw raw;
    const raylet_status status = make(&raw, given...);
    if (status < 0) {
        return Error{status};
    }
    return T(raw);
}

} // namespace detail

template <class Number> struct Vec3 {
    Number x, y, z;

    typename Api<Number>::Vec3 raw() const { return {detail::raw(x), detail::raw(y), detail::raw(z)}; }
    static Vec3 of(const typename Api<Number>::Vec3 &raw) {
        return {detail::cooked<Number>(raw.x), detail::cooked<Number>(raw.y), detail::cooked<Number>(raw.z)};
    }
};

/// A position and three axes at right angles.
template <class Number> class Frame {
  public:
    using Made = Result<Frame>;
    using Raw = typename Api<Number>::Frame;
    using Vec = Vec3<Number>;

    static Made at(Vec position) { return make(Api<Number>::frame_at, position.raw()); }
    static Made from_base_and_axis(Vec base, Vec axis) {
        return make(Api<Number>::frame_from_base_and_axis, base.raw(), axis.raw());
    }
    static Made turned_about(Vec position, Vec axis, Number degrees) {
        return make(Api<Number>::frame_turned_about, position.raw(), axis.raw(), detail::raw(degrees));
    }
    static Made looking(Vec position, Vec forward, Vec up) {
        return make(Api<Number>::frame_looking, position.raw(), forward.raw(), up.raw());
    }
    static Made from_axes(Vec position, Vec x, Vec y, Vec z) {
        return make(Api<Number>::frame_from_axes, position.raw(), x.raw(), y.raw(), z.raw());
    }
    /// A frame that is given in this one, in the world.
    Made to_world(const Frame &inner) const { return make(Api<Number>::frame_to_world, &raw_, &inner.raw_); }

    explicit Frame(const Raw &raw) : raw_(raw) {}
    const Raw &raw() const { return raw_; }

  private:
    template <class Make, class... Given> static Made make(Make function, Given... given) {
        return detail::made<Frame, Raw>(function, given...);
    }
    Raw raw_;
};

/// A ray; `t` is distance.
template <class Number> class Ray {
  public:
    using Made = Result<Ray>;
    using Raw = typename Api<Number>::Ray;
    using Vec = Vec3<Number>;

    static Made along(Vec origin, Vec direction) {
        return detail::made<Ray, Raw>(Api<Number>::ray_along, origin.raw(), direction.raw());
    }
    static Made towards(Vec origin, Vec target) {
        return detail::made<Ray, Raw>(Api<Number>::ray_towards, origin.raw(), target.raw());
    }
    static Made segment(Vec a, Vec b) { return detail::made<Ray, Raw>(Api<Number>::ray_segment, a.raw(), b.raw()); }
    /// The same ray with this range.
    Made between(Number start, Number end) const {
        Ray ray = *this;
        const raylet_status status = Api<Number>::ray_set_range(&ray.raw_, detail::raw(start), detail::raw(end));
        return status < 0 ? Made(Error{status}) : Made(ray);
    }
    /// The same ray, departing from a part of the surface of a shape.
    Made departing(std::uint32_t shape, std::uint8_t part, raylet_leaving leaving) const {
        Ray ray = *this;
        const raylet_status status = Api<Number>::ray_departing(&ray.raw_, shape, part, leaving);
        return status < 0 ? Made(Error{status}) : Made(ray);
    }
    Vec at(Number t) const {
        typename Api<Number>::Vec3 point;
        Api<Number>::ray_at(&point, &raw_, detail::raw(t));
        return Vec::of(point);
    }

    explicit Ray(const Raw &raw) : raw_(raw) {}
    const Raw &raw() const { return raw_; }

  private:
    Raw raw_;
};

/// A hit.
template <class Number> struct Hit {
    Number t;
    raylet_part part;
    raylet_crossing_kind crossing;
    typename Api<Number>::Hit raw;

    explicit Hit(const typename Api<Number>::Hit &hit)
        : t(detail::cooked<Number>(hit.t)), part(static_cast<raylet_part>(hit.part)),
          crossing(static_cast<raylet_crossing_kind>(hit.crossing)), raw(hit) {}
};

/// All hits of a solid on one ray: a range of `Hit`.
template <class Number> class Hits {
  public:
    explicit Hits(const typename Api<Number>::Hits &raw) : raw_(raw) {}

    std::size_t size() const { return raw_.count; }
    bool empty() const { return raw_.count == 0; }
    Hit<Number> operator[](std::size_t i) const { return Hit<Number>(raw_.hits[i]); }
    bool starts_inside() const { return raw_.starts_inside; }

    class Iterator {
      public:
        Iterator(const typename Api<Number>::Hit *at) : at_(at) {}
        Hit<Number> operator*() const { return Hit<Number>(*at_); }
        Iterator &operator++() {
            ++at_;
            return *this;
        }
        friend bool operator!=(Iterator a, Iterator b) { return a.at_ != b.at_; }

      private:
        const typename Api<Number>::Hit *at_;
    };
    Iterator begin() const { return raw_.hits; }
    Iterator end() const { return raw_.hits + raw_.count; }

  private:
    typename Api<Number>::Hits raw_;
};

/// The surface of a shape at a hit.
template <class Number> class Surface {
  public:
    explicit Surface(const typename Api<Number>::Surface &raw) : raw_(raw) {}

    Vec3<Number> point() const {
        typename Api<Number>::Vec3 point;
        Api<Number>::surface_point(&point, &raw_);
        return Vec3<Number>::of(point);
    }
    /// The outward normal, with components in the unit of directions.
    typename Api<Number>::Vec3 normal() const {
        typename Api<Number>::Vec3 normal;
        Api<Number>::surface_normal(&normal, &raw_);
        return normal;
    }

  private:
    typename Api<Number>::Surface raw_;
};

/// A solid or an open surface, placed in the world.
template <class Number> class Shape {
  public:
    using Made = Result<Shape>;
    using Raw = typename Api<Number>::Shape;
    using C = Api<Number>;
    using Vec = Vec3<Number>;

    static Made plane() { return make(C::plane); }
    static Made sphere(Number radius) { return make(C::sphere, radius); }
    static Made cylinder_infinite(Number radius) { return make(C::cylinder_infinite, radius); }
    static Made cylinder_open(Number radius, Number height) { return make(C::cylinder_open, radius, height); }
    static Made cylinder(Number radius, Number height) { return make(C::cylinder_capped, radius, height); }
    static Made cone_double(Number slope) { return make(C::cone_double, slope); }
    static Made cone_nappe(Number slope) { return make(C::cone_nappe, slope); }
    static Made cone_open(Number slope, Number height) { return make(C::cone_open, slope, height); }
    static Made cone(Number slope, Number height) { return make(C::cone_capped, slope, height); }
    static Made frustum_open(Number base, Number top, Number height) {
        return make(C::frustum_open, base, top, height);
    }
    static Made frustum(Number base, Number top, Number height) { return make(C::frustum, base, top, height); }
    static Made capsule(Number radius, Number height) { return make(C::capsule, radius, height); }
    static Made round_cone(Number base, Number top, Number height) { return make(C::round_cone, base, top, height); }
    static Made cuboid(Number half_x, Number half_y, Number half_z) { return make(C::cuboid, half_x, half_y, half_z); }
    static Made rounded_cuboid(Number half_x, Number half_y, Number half_z, Number radius) {
        return make(C::rounded_cuboid, half_x, half_y, half_z, radius);
    }
    static Made tube(Number inner, Number outer, Number height) { return make(C::tube, inner, outer, height); }
    static Made torus(Number major, Number minor) { return make(C::torus, major, minor); }
    static Made disc(Number radius) { return make(C::disc, radius); }
    static Made annulus(Number inner, Number outer) { return make(C::annulus, inner, outer); }
    static Made rectangle(Number half_x, Number half_z) { return make(C::rectangle, half_x, half_z); }
    static Made triangle(Vec a, Vec b, Vec c) {
        return detail::made<Shape, Raw>(C::triangle, a.raw(), b.raw(), c.raw());
    }
    static Made paraboloid(Number focal_length, Number height) { return make(C::paraboloid, focal_length, height); }
    static Made spheroid(Number radius, Number half_height, Number low, Number high) {
        return make(C::spheroid, radius, half_height, low, high);
    }
    static Made ball_zone(Number radius, Number low, Number high) { return make(C::ball_zone, radius, low, high); }
    static Made hyperboloid(Number waist, Number slope, Number low, Number high) {
        return make(C::hyperboloid, waist, slope, low, high);
    }
    static Made tower(Number base, Number waist, Number top, Number height) {
        return make(C::tower, base, waist, top, height);
    }
    static Made ellipsoid(Number x, Number y, Number z) { return make(C::ellipsoid, x, y, z); }

    /// The same shape, placed.
    Made in(const Frame<Number> &frame) const { return changed(C::shape_in_frame, &frame.raw()); }
    Made stretched(const Frame<Number> &frame, Vec scale) const {
        return changed(C::shape_stretched, &frame.raw(), scale.raw());
    }
    Made moved_to(Vec position) const { return changed(C::shape_move_to, position.raw()); }
    Made seen_from(raylet_visible visible) const {
        return changed(C::shape_seen_from, static_cast<std::uint8_t>(visible));
    }

    template <Tier tier = Tier::stable> std::optional<Hit<Number>> nearest(const Ray<Number> &ray) const {
        typename C::Hit hit;
        if (C::template nearest<tier>(&hit, &raw_, &ray.raw()) > 0) {
            return Hit<Number>(hit);
        }
        return std::nullopt;
    }
    template <Tier tier = Tier::stable> Hits<Number> hits(const Ray<Number> &ray) const {
        typename C::Hits hits;
        C::template all_hits<tier>(&hits, &raw_, &ray.raw());
        return Hits<Number>(hits);
    }
    template <Tier tier = Tier::stable> bool occludes(const Ray<Number> &ray) const {
        return C::template occludes<tier>(&raw_, &ray.raw()) > 0;
    }
    template <Tier tier = Tier::stable> bool contains(Vec point) const {
        return C::template contains<tier>(&raw_, point.raw()) > 0;
    }
    /// The surface at a hit of the ray with this shape.
    Surface<Number> surface(const Ray<Number> &ray, const Hit<Number> &hit) const {
        typename C::Surface surface;
        C::surface_at(&surface, &raw_, &ray.raw(), &hit.raw);
        return Surface<Number>(surface);
    }

    explicit Shape(const Raw &raw) : raw_(raw) {}
    const Raw &raw() const { return raw_; }

  private:
    template <class Make, class... Given> static Made make(Make function, Given... given) {
        return detail::made<Shape, Raw>(function, detail::raw(given)...);
    }
    template <class Change, class... Given> Made changed(Change change, Given... given) const {
        Shape shape = *this;
        const raylet_status status = change(&shape.raw_, given...);
        return status < 0 ? Made(Error{status}) : Made(shape);
    }
    Raw raw_;
};

/// Up to `N` shapes with a hierarchy, which it owns. It is rebuilt when a shape is added; it is not copied, since the
/// hierarchy points into it.
template <class Number, std::size_t N> class Shapes {
  public:
    using C = Api<Number>;

    Shapes() = default;
    Shapes(const Shapes &) = delete;
    Shapes &operator=(const Shapes &) = delete;

    /// The index of the shape.
    Result<std::uint32_t> add(const Shape<Number> &shape) {
        if (count_ == N) {
            return Error{-16 * RAYLET_ERROR_FULL};
        }
        list_[count_] = shape.raw();
        const raylet_status status = C::shapes_build(&shapes_, list_.data(), count_ + 1, nodes_.data(), nodes_.size());
        if (status < 0) {
            return Error{status};
        }
        return static_cast<std::uint32_t>(count_++);
    }
    std::size_t size() const { return count_; }
    Shape<Number> operator[](std::size_t i) const { return Shape<Number>(list_[i]); }

    /// The nearest hit and the index of its shape.
    struct Nearest {
        std::uint32_t shape;
        Hit<Number> hit;
    };
    template <Tier tier = Tier::stable> std::optional<Nearest> nearest(const Ray<Number> &ray) const {
        std::uint32_t shape;
        typename C::Hit hit;
        if (count_ > 0 && C::template shapes_nearest<tier>(&shape, &hit, &shapes_, &ray.raw()) > 0) {
            return Nearest{shape, Hit<Number>(hit)};
        }
        return std::nullopt;
    }
    template <Tier tier = Tier::stable> bool occlude(const Ray<Number> &ray) const {
        return count_ > 0 && C::template shapes_occlude<tier>(&shapes_, &ray.raw()) > 0;
    }

  private:
    std::array<typename C::Shape, N> list_;
    std::array<typename C::Node, RAYLET_NODES(N)> nodes_;
    typename C::Shapes shapes_;
    std::size_t count_ = 0;
};

} // namespace raylet

#endif
