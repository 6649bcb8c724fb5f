"""The package by what it promises: hits, normals, number types, tiers, errors, and cores that change nothing."""

import json
from pathlib import Path

import numpy as np
import pytest
import raylet

TYPES = [np.float32, np.float64, np.int32]


def array(numbers, kind):
    return raylet.to_i16f16(numbers) if kind is np.int32 else np.array(numbers, kind)


def value(numbers, kind):
    return raylet.from_i16f16(numbers) if kind is np.int32 else numbers


@pytest.mark.parametrize("kind", TYPES)
def test_a_lying_cylinder(kind):
    can = raylet.cylinder(0.5, 2.0).standing((-1, 0, 4), (1, 0, 0))
    hits = can.nearest(array([[0, 0, 0], [0, 9, 0]], kind), array([[0, 0, 2], [0, 0, 1]], kind), normals=True)
    assert list(hits.hit) == [True, False]
    assert value(hits.t, kind)[0] == 3.5
    assert raylet.PARTS[hits.part[0]] == "side" and raylet.CROSSINGS[hits.crossing[0]] == "enter"
    unit = 2.0**-30 if kind is np.int32 else 1.0
    assert np.allclose(hits.normal[0] * unit, [0, 0, -1], atol=1e-6)
    assert hits.t.dtype == kind and (hits.part[1], hits.crossing[1]) == (-1, -1)


@pytest.mark.parametrize("kind", TYPES)
@pytest.mark.parametrize("tier", ["plain", "fast", "stable", "exact"])
def test_normals_are_those_of_a_ball(kind, tier):
    if kind is np.float64 and tier == "exact":
        return
    generator = np.random.default_rng(1)
    origins = generator.uniform(-4, 4, (1000, 3))
    origins *= 5 / np.linalg.norm(origins, axis=1, keepdims=True)
    targets = generator.uniform(-0.5, 0.5, (1000, 3))
    o, d = array(origins, kind), array(targets - origins, kind)
    hits = raylet.sphere(1).nearest(o, d, tier=tier, normals=True)
    assert hits.hit.all()
    length = np.linalg.norm(value(d, kind), axis=1, keepdims=True)
    points = value(o, kind) + value(d, kind) / length * value(hits.t, kind)[:, None]
    normals = hits.normal * 2.0**-30 if kind is np.int32 else hits.normal
    assert np.abs(points - normals).max() < 1e-3


def test_cores_change_no_bit():
    generator = np.random.default_rng(2)
    o = generator.uniform(-4, 4, (10007, 3)).astype(np.float32)
    d = generator.uniform(-1, 1, (10007, 3)).astype(np.float32)
    shape = raylet.torus(2, 0.5).stretched((1, 2, 1))
    one, *others = (shape.nearest(o, d, normals=True, threads=n) for n in (1, 7, 0, 10**9))
    for many in others:
        for a, b in [(one.t, many.t), (one.part, many.part), (one.normal, many.normal)]:
            assert a.tobytes() == b.tobytes()


def test_one_origin_for_all_rays():
    hits = raylet.plane().nearest(np.array([0.0, 1, 0]), np.array([[0.0, -1, 0], [0, 1, 0]]))
    assert list(hits.hit) == [True, False]


def test_no_rays():
    assert len(raylet.sphere(1).nearest(np.zeros((0, 3)), np.zeros((0, 3))).t) == 0


@pytest.mark.parametrize(
    "call, error, message",
    [
        (lambda: raylet.sphere(-1), ValueError, "the radius is negative"),
        (lambda: raylet.cylinder(1, 0), ValueError, "the height is zero"),
        (lambda: raylet.sphere(float("nan")), ValueError, "not finite"),
        (lambda: raylet.sphere(1).standing((0, 0, 0), (0, 0, 0)), ValueError, "no direction"),
        (lambda: raylet.sphere(1).stretched((1, 0, 1)), ValueError, "a factor of the scale is zero"),
        (lambda: raylet.sphere(1).nearest(np.zeros((2, 3)), np.array([[1.0, 0, 0], [0, 0, 0]])), ValueError, "ray 1"),
        (lambda: raylet.sphere(1).nearest(np.zeros((1, 3)), np.ones((2, 3))), ValueError, r"shape \(n, 3\)"),
        (lambda: raylet.sphere(1).nearest(np.zeros((1, 2)), np.ones((1, 2))), ValueError, r"shape \(n, 3\)"),
        (lambda: raylet.sphere(1).nearest(np.zeros((1, 3), "f2"), np.ones((1, 3), "f2")), TypeError, "int32"),
        (lambda: raylet.sphere(1).nearest(np.zeros((1, 3), np.float32), np.ones((1, 3))), TypeError, "one type"),
        (lambda: raylet.plane().nearest(np.zeros((1, 3)), np.ones((1, 3)), tier="exact"), ValueError, "no tier exact"),
        (lambda: raylet.sphere(1).nearest(np.zeros((1, 3)), np.ones((1, 3)), tier="best"), ValueError, "tier is"),
        (lambda: raylet._raylet.Shape("egg", []), ValueError, "there is no kind egg"),
        (lambda: raylet._raylet.Shape("sphere", [1, 2]), ValueError, "sphere has 1 sizes"),
    ],
)
def test_refusals(call, error, message):
    with pytest.raises(error, match=message):
        call()


SOLIDS = {
    "sphere": lambda s: raylet.sphere(s["radius"]),
    "cylinder": lambda s: raylet.cylinder(s["radius"], s["height"]),
    "capsule": lambda s: raylet.capsule(s["radius"], s["height"]),
    "cone": lambda s: raylet.cone(s["slope"], s["height"]),
    "frustum": lambda s: raylet.frustum(s["base_radius"], s["top_radius"], s["height"]),
    "box": lambda s: raylet.cuboid(s["half_x"], s["half_y"], s["half_z"]),
    "disc": lambda s: raylet.disc(s["radius"]),
}


@pytest.mark.parametrize("kind, name, units", [(np.float64, "f64", 1000), (np.float32, "f32", 1000)])
def test_hard_cases(kind, name, units):
    """The hard cases of data/cases that stand in the world as they are made."""
    asked = 0
    for line in open(Path(__file__).parents[3] / "data/cases/cases.jsonl"):
        case = json.loads(line)
        ahead = [hit for hit in case[name]["hits"] if float(hit["t"]) > 0]
        unplaced = case["base"] == [0, 0, 0] and case["axis"] == [0, 1, 0]
        if case["solid"]["kind"] not in SOLIDS or not unplaced or not ahead or ahead[0]["crossing"] == "touch":
            continue
        shape = SOLIDS[case["solid"]["kind"]](case["solid"])
        hits = shape.nearest(np.array([case["origin"]], kind), np.array([case["direction"]], kind))
        # The horizon of the cases: there the rounding of the direction matters more.
        t = next(float(hit["t"]) for hit in case[name]["hits"] if float(hit["t"]) >= 0)
        if t > 1e7 and case["class"] == "parallel":
            continue
        assert hits.hit[0] and abs(float(hits.t[0]) - t) <= units * np.finfo(kind).eps * max(t, 1e-300), case["name"]
        asked += 1
    assert asked > 80
