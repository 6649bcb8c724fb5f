"""Prints MuJoCo's nearest hit of each case of the standard input: the name, a tab, and the distance, or `none`.

A ray beside one geom, in doubles (mju_rayGeom). Cases of solids that it does not have are left out, and planes seen
from below: its planes have one side.
"""
import json, sys
import mujoco, numpy

GEOM = mujoco.mjtGeom

def frame(axis):
    """Axes at right angles, the third along `axis`, as columns, row by row."""
    z = numpy.array(axis, float) / numpy.linalg.norm(axis)
    x = numpy.cross(z, [1.0, 0, 0] if abs(z[0]) < 0.8 else [0, 1.0, 0])
    x /= numpy.linalg.norm(x)
    return numpy.column_stack([x, numpy.cross(z, x), z])

for line in sys.stdin:
    case = json.loads(line)
    solid, base, axis = case["solid"], numpy.array(case["base"], float), case["axis"]
    along = numpy.array(axis["to"]) - base if isinstance(axis, dict) else numpy.array(axis)
    height = numpy.linalg.norm(along) if isinstance(axis, dict) else solid.get("height", 0.0)
    turn, unit = frame(along), along / numpy.linalg.norm(along)
    middle = base + unit * (height / 2)
    match solid["kind"]:
        case "sphere":
            kind, at, size = GEOM.mjGEOM_SPHERE, base, [solid["radius"], 0, 0]
        case "capsule":
            kind, at, size = GEOM.mjGEOM_CAPSULE, middle, [solid["radius"], height / 2, 0]
        case "cylinder":
            kind, at, size = GEOM.mjGEOM_CYLINDER, middle, [solid["radius"], height / 2, 0]
        case "box":
            kind, at, turn = GEOM.mjGEOM_BOX, base, numpy.eye(3)
            size = [solid["half_x"], solid["half_y"], solid["half_z"]]
        case "plane" if numpy.dot(along, case["direction"]) <= 0:
            kind, at, size = GEOM.mjGEOM_PLANE, base, [0, 0, 1]
        case _:
            continue
    direction = numpy.array(case["direction"], float)
    # The largest first, so that squares do not overflow.
    direction /= numpy.abs(direction).max()
    direction /= numpy.linalg.norm(direction)
    origin = numpy.array(case["origin"], float)
    t = mujoco.mju_rayGeom(at, turn.flatten(), numpy.array(size, float), origin, direction, kind, None)
    print(case["name"], "none" if t < 0 else repr(float(t)), sep="\t")
