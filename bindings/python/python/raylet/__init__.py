"""Where rays meet solids: a million rays in one call, in f32, f64 and fixed point (I16F16).

A shape is made once, and rounded to the number type of the arrays that it is asked about::

    import numpy as np, raylet

    can = raylet.cylinder(radius=0.5, height=2.0).standing(base=(0, 0, 4), axis=(1, 0, 0))
    hits = can.nearest(np.zeros((1, 3), np.float32), np.array([[0, 0, 1]], np.float32), normals=True)
    hits.t, hits.normal         # [3.5], [[0, 0, -1]]

Arrays of `float32` and `float64` are computed in these types; arrays of `int32` in I16F16, in units of 2**-16
(:func:`to_i16f16`, :func:`from_i16f16`). Directions have any length; `t` is a distance. Calls use all cores and release
the interpreter's lock.
"""

from dataclasses import dataclass

import numpy

from . import _raylet

PARTS = tuple(_raylet.parts())
"""The parts of a surface: `PARTS[part]` is the name of a hit's part."""
CROSSINGS = ("enter", "exit", "touch")
"""How a ray crosses a surface: `CROSSINGS[crossing]`."""


@dataclass(frozen=True)
class Hits:
    """The nearest hit of each ray.

    `t` is NaN for a miss, and -2**31 in I16F16; `part` and `crossing` are -1 then. `normal` has the shape (n, 3), or is
    None; in I16F16 its components are in units of 2**-30.
    """

    t: numpy.ndarray
    part: numpy.ndarray
    crossing: numpy.ndarray
    normal: "numpy.ndarray | None" = None

    @property
    def hit(self):
        """True for each ray that hits."""
        return self.part >= 0


class Shape:
    """A solid or an open surface, placed in the world. It does not change; methods return another one."""

    __slots__ = ("_inner",)

    def __init__(self, inner):
        self._inner = inner

    def at(self, position):
        """The same shape with its own origin there, not turned."""
        return self.turned(position, (0.0, 0.0, 0.0, 1.0))

    def standing(self, base, axis=(0.0, 1.0, 0.0)):
        """The same shape with its own origin at `base`, and its y axis along `axis`, of any length."""
        return Shape(self._inner.standing(tuple(base), tuple(axis)))

    def turned(self, position, quaternion):
        """The same shape with its own origin there, turned by a quaternion (x, y, z, w)."""
        return Shape(self._inner.turned(tuple(position), tuple(quaternion)))

    def stretched(self, factors):
        """The same shape stretched by three positive factors along its own axes."""
        return Shape(self._inner.stretched(tuple(factors)))

    def nearest(self, origins, directions, tier="stable", normals=False, threads=None):
        """The nearest hit of each ray, as :class:`Hits`.

        `origins` and `directions` have the shape (n, 3) and one type: `float32`, `float64`, or `int32` for I16F16. One
        of them may have the shape (3,), for all rays. `tier` is "plain", "fast", "stable" or "exact" (not in
        `float64`). `threads` is the number of cores at most, all by default.

        Raises ValueError for a ray that cannot be made, such as one without a direction, and says which.
        """
        origins, directions = numpy.asarray(origins), numpy.asarray(directions)
        if origins.dtype != directions.dtype:
            raise TypeError(f"origins are {origins.dtype} and directions {directions.dtype}: both must have one type")
        if origins.ndim == 1 or directions.ndim == 1:
            origins, directions = numpy.broadcast_arrays(numpy.atleast_2d(origins), numpy.atleast_2d(directions))
        origins, directions = numpy.ascontiguousarray(origins), numpy.ascontiguousarray(directions)
        return Hits(**self._inner.nearest(origins, directions, tier, normals, threads))

    def __repr__(self):
        return f"raylet.{self._inner!r}"


def _shape(kind, *sizes):
    return Shape(_raylet.Shape(kind, [float(size) for size in sizes]))


def sphere(radius):
    """A ball about the origin."""
    return _shape("sphere", radius)


def cylinder(radius, height=None, open=False):
    """A cylinder about the y axis, from y = 0 up; without ends if it has no height, without caps if it is open."""
    if height is None:
        return _shape("infinite cylinder", radius)
    return _shape("open cylinder" if open else "cylinder", radius, height)


def cone(slope, height=None, open=False, double=False):
    """A cone about the y axis, from its apex at the origin up. `slope` is radius over height."""
    if height is None:
        return _shape("double cone" if double else "infinite cone", slope)
    return _shape("open cone" if open else "cone", slope, height)


def frustum(base_radius, top_radius, height, open=False):
    """A truncated cone about the y axis, from y = 0 up."""
    return _shape("open frustum" if open else "frustum", base_radius, top_radius, height)


def capsule(radius, height):
    """A cylinder with half balls at its ends, which `height` excludes."""
    return _shape("capsule", radius, height)


def round_cone(base_radius, top_radius, height):
    """The hull of two balls, about the origin and about (0, height, 0)."""
    return _shape("round cone", base_radius, top_radius, height)


def cuboid(half_x, half_y, half_z, radius=None):
    """A box about the origin by half of its extents; with a radius all points no farther than that from the box."""
    if radius is None:
        return _shape("cuboid", half_x, half_y, half_z)
    return _shape("rounded cuboid", half_x, half_y, half_z, radius)


def tube(inner_radius, outer_radius, height):
    """A solid tube about the y axis, from y = 0 up."""
    return _shape("tube", inner_radius, outer_radius, height)


def torus(major_radius, minor_radius):
    """A torus about the y axis."""
    return _shape("torus", major_radius, minor_radius)


def plane():
    """The plane y = 0."""
    return _shape("plane")


def disc(radius, inner_radius=None):
    """A disc in the plane y = 0; with an inner radius it has a hole."""
    return _shape("disc", radius) if inner_radius is None else _shape("annulus", inner_radius, radius)


def rectangle(half_x, half_z):
    """A rectangle in the plane y = 0 by half of its extents."""
    return _shape("rectangle", half_x, half_z)


def triangle(a, b, c):
    """A triangle, anticlockwise as seen from its front."""
    return _shape("triangle", *a, *b, *c)


def paraboloid(focal_length, height):
    """A full bowl from its vertex at the origin up."""
    return _shape("paraboloid", focal_length, height)


def hyperboloid(waist, slope, low, high):
    """A hyperboloid of one sheet with its waist at the origin, between two heights."""
    return _shape("hyperboloid", waist, slope, low, high)


def to_i16f16(numbers):
    """Numbers as I16F16: `int32` in units of 2**-16, rounded to the nearest."""
    return numpy.rint(numpy.asarray(numpy.float64(numbers)) * 65536).astype(numpy.int32)


def from_i16f16(bits):
    """The numbers of an array in I16F16, as `float64`."""
    return numpy.asarray(bits) / 65536
