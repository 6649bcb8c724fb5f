"""Says what is wrong with answers to the cases, by class: judge.py FILE:NUMBERS:NAME... [--renew], from the repository.

An answer is a line: the name, a tab, and the distance of the nearest hit, or `none`. NUMBERS is f32 or f64: the answer
is held to the exact one of inputs rounded to that type.

- lost: there is a hit, and the answer is none. phantom: there is none, and the answer is a hit.
- off: more than a thousand units in the last place of the type from the exact hit; of a hit at the start, of the
  origin's largest coordinate.

Where libraries differ by convention, every convention is right: a touch may be a hit or none, a start on the surface
may be a hit or none, and a ray in a surface is left out.
"""
import json, sys
from collections import Counter
from pathlib import Path

EPSILON = {"f32": 2.0**-23, "f64": 2.0**-52}

def accepted(answer):
    """The distances that are right, and whether none is."""
    right = []
    for hit in answer["hits"]:
        t = float(hit["t"])
        if t >= 0:
            right.append(t)
            if t > 0 and hit["crossing"] != "touch":
                return right, False
    return right, True

def verdict(answer, given, numbers, origin):
    right, may_miss = accepted(answer)
    if given == "none":
        return "right" if may_miss else "lost"
    t = float(given)
    size = max(map(abs, origin))
    if any(abs(t - exact) <= 1000 * EPSILON[numbers] * (abs(exact) or size) for exact in right):
        return "right"
    return "off" if right else "phantom"

def main(arguments):
    cases = [json.loads(line) for line in open("data/cases/cases.jsonl")]
    classes = list(dict.fromkeys(case["class"] for case in cases))
    rows = []
    for argument in [a for a in arguments if a != "--renew"]:
        path, numbers, name = argument.split(":", 2)
        given = dict(line.rstrip("\n").split("\t") for line in open(path))
        tally = {c: Counter() for c in [*classes, "all"]}
        for case in cases:
            answer = case[numbers]
            if case["name"] in given and answer is not None and answer["lies_in_it"] is None:
                said = verdict(answer, given[case["name"]], numbers, case["origin"])
                for group in (case["class"], "all"):
                    tally[group][said] += 1
        wrong = lambda c: f"{c.total() - c['right']} of {c.total()}" if c.total() else "–"
        kinds = tally["all"]
        rows.append(f"| {name} | {wrong(kinds)} | {kinds['lost']} | {kinds['phantom']} | {kinds['off']} | "
                    + " | ".join(wrong(tally[c]) for c in classes) + " |")
    head = ["| library | wrong | lost | phantom | off | " + " | ".join(classes) + " |",
            "|---|---:|---:|---:|---:|" + "---:|" * len(classes)]
    page = Path("data/cases/README.md")
    old = page.read_text()
    before, _, rest = old.partition("<!-- table: written by `.ci/cases --renew` -->\n")
    _, _, after = rest.partition("<!-- /table -->")
    table = "\n".join(head + rows)
    new = f"{before}<!-- table: written by `.ci/cases --renew` -->\n\n{table}\n\n<!-- /table -->{after}"
    print(table)
    if "--renew" in arguments:
        page.write_text(new)
    elif new != old:
        sys.exit("data/cases/README.md has another table: .ci/cases --renew writes this one")

if __name__ == "__main__":
    main(sys.argv[1:])
