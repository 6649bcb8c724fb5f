"""What MuJoCo's rangefinders measure of the scene of `rangefinders`, beside raylet's readings; the table of a page.

    compare.py READINGS [--renew]

A rangefinder measures along the z axis of its site, from the site's place; -1 is nothing.
"""

import sys
from dataclasses import dataclass
from pathlib import Path

import mujoco
import numpy

sys.path.insert(0, str(Path(__file__).parents[1] / "paths"))
from page import write_or_compare

# At a smaller cosine of incidence a change of a unit across the ray moves the hit by so many units along it.
GRAZING = 0.05


@dataclass
class Scene:
    """Of a number type."""

    number: str
    unit: float
    geoms: str
    rays: list[list[float]]


def read(path: Path) -> list[Scene]:
    """What the program printed."""
    scenes: list[Scene] = []
    for line in path.read_text().splitlines():
        if line.startswith("number "):
            _, number, unit = line.split()
            scenes.append(Scene(number, float(unit), "", []))
        elif line.startswith("ray "):
            scenes[-1].rays.append([float(part) for part in line.split()[1:]])
        else:
            scenes[-1].geoms = line
    return scenes


def rangefinders(scene: Scene) -> numpy.ndarray:
    """MuJoCo's distances, and the geom of each."""
    sites, sensors = [], []
    for index, (x, y, z, dx, dy, dz, *_) in enumerate(scene.rays):
        sites.append(f'<site name="s{index}" pos="{x:.17f} {y:.17f} {z:.17f}" zaxis="{dx:.17f} {dy:.17f} {dz:.17f}"/>')
        sensors.append(f'<rangefinder site="s{index}"/>')
    xml = (
        f'<mujoco><option gravity="0 0 0"/><worldbody>{scene.geoms}<body name="eye">{"".join(sites)}</body></worldbody>'
        f'<sensor>{"".join(sensors)}</sensor></mujoco>'
    )
    model = mujoco.MjModel.from_xml_string(xml)
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    return data.sensordata.copy()


def main() -> int:
    table = "| number | rays | that meet something | one misses | median difference | 99 % | not grazing | largest |\n"
    table += "|---|---:|---:|---:|---:|---:|---:|---:|\n"
    failed = 0
    for scene in read(Path(sys.argv[1])):
        theirs, rays = rangefinders(scene), numpy.array(scene.rays)
        ours, incidence = rays[:, 6], rays[:, 8]
        # A sensor beyond 50 m measures nothing here.
        theirs = numpy.where(theirs > 50.0, -1.0, theirs)
        both, one = (ours >= 0) & (theirs >= 0), (ours >= 0) != (theirs >= 0)
        off = numpy.abs(ours - theirs)[both] / scene.unit
        plain = off[incidence[both] > GRAZING]
        figures = [numpy.median(off), numpy.quantile(off, 0.99), plain.max(), off.max()]
        counts = [f"{count:,}" for count in (len(rays), int(both.sum()), int(one.sum()))]
        table += f"| `{scene.number}` | {' | '.join(counts + [f'{figure:,.2f}' for figure in figures])} |\n"
        for index in numpy.flatnonzero(one | (both & (numpy.abs(ours - theirs) > 40 * scene.unit)))[:10]:
            what = f"{ours[index]} and {theirs[index]}, incidence {incidence[index]}"
            print(f"{scene.number}: ray {index}: {what}", file=sys.stderr)
        failed |= int(plain.max() > 200)
    print(table)
    return write_or_compare("range-sensor.md", "mujoco", table, ".ci/mujoco", "--renew" in sys.argv) or failed


if __name__ == "__main__":
    sys.exit(main())
