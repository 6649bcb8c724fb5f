"""Prints POV-Ray's nearest hit of each case of the standard input: the name, a tab, and the distance, or `none`.

All cases are one scene without a picture: its function `trace` gives the point of the nearest hit, or a zero normal.
Cases of solids that it does not have are left out.
"""
import json, math, subprocess, sys, tempfile
from fractions import Fraction
from pathlib import Path

vector = lambda v: "<" + ", ".join(f"{x:.17g}" for x in v) + ">"

def solid(case):
    """The solid in POV-Ray's language, or nothing."""
    solid, base, axis = case["solid"], case["base"], case["axis"]
    along = [t - b for t, b in zip(axis["to"], base)] if isinstance(axis, dict) else axis
    height = math.hypot(*along) if isinstance(axis, dict) else solid.get("height", 0.0)
    top = axis["to"] if isinstance(axis, dict) else [b + height * a for b, a in zip(base, along)]
    r, m, kind = solid.get("radius"), solid.get("slope"), solid["kind"]
    m = float(Fraction(m)) if isinstance(m, str) else m
    hollow = " open" if kind.startswith("open") else ""
    if kind == "sphere":
        return f"sphere {{ {vector(base)}, {r:.17g} }}"
    if kind in ("cylinder", "open cylinder"):
        return f"cylinder {{ {vector(base)}, {vector(top)}, {r:.17g}{hollow} }}"
    if kind in ("cone", "open cone"):
        return f"cone {{ {vector(base)}, 0, {vector(top)}, {m * height:.17g}{hollow} }}"
    if kind in ("frustum", "open frustum"):
        low, high = solid["base_radius"], solid["top_radius"]
        return f"cone {{ {vector(base)}, {low:.17g}, {vector(top)}, {high:.17g}{hollow} }}"
    if kind == "plane":
        return f"plane {{ {vector(along)}, {sum(b * a for b, a in zip(base, along)):.17g} }}"
    if kind == "disc":
        return f"disc {{ {vector(base)}, {vector(along)}, {r:.17g} }}"
    if kind == "box":
        half = [solid["half_x"], solid["half_y"], solid["half_z"]]
        return f"box {{ {vector([b - h for b, h in zip(base, half)])}, {vector([b + h for b, h in zip(base, half)])} }}"
    if kind == "triangle":
        return f"triangle {{ {', '.join(vector([x + b for x, b in zip(v, base)]) for v in solid['vertices'])} }}"
    return None

def traced(cases):
    """The answers, as far as POV-Ray reads the scene of these cases."""
    scene = ["#version 3.7; global_settings { assumed_gamma 1 } camera { location <0, 0, -1> look_at 0 }",
             '#fopen Out "answers" write']
    for case, made in cases:
        scene.append(f"#declare S = {made} #declare N = <0, 0, 0>; #declare O = {vector(case['origin'])};\n"
                     f"#declare P = trace(S, O, {vector(case['direction'])}, N);\n"
                     '#if (vlength(N) = 0) #write(Out, "none\\n") #else'
                     ' #write(Out, str(P.x - O.x, 0, 17), " ", str(P.y - O.y, 0, 17), " ",'
                     ' str(P.z - O.z, 0, 17), "\\n") #end')
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "scene.pov").write_text("\n".join(scene + ["#fclose Out"]) + "\n")
        command = ["povray", "+Iscene.pov", "-D", "-F", "+W1", "+H1", "-V"]
        run = subprocess.run(command, cwd=folder, capture_output=True, text=True)
        written = Path(folder) / "answers"
        return written.read_text().splitlines() if written.exists() else [], run.stderr

cases = [(case, solid(case)) for case in map(json.loads, sys.stdin)]
cases = [(case, made) for case, made in cases if made is not None]
while cases:
    answers, told = traced(cases)
    for (case, _), answer in zip(cases, answers):
        print(case["name"], "none" if answer == "none" else repr(math.hypot(*map(float, answer.split()))), sep="\t")
    if len(answers) < len(cases) and "Fatal error" not in told:
        sys.exit(f"POV-Ray stopped:\n{told[-2000:]}")
    # It refuses the one at which it stopped, such as a cylinder of no height in its tolerance.
    cases = cases[len(answers) + 1:]
