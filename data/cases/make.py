"""Completes cases.jsonl: of every number its bits, and of inputs rounded to f64 and f32 the exact answers.

RAYLET_WRITE_EXPECTED=1 cargo test -p raylet-cases writes what the tables have; then python3 data/cases/make.py.
"""
import json, math, struct, sys
from decimal import Decimal
from check import ROUND, solve, value

def bits(numbers, form):
    kind = {"f64": ("d", "Q", 16), "f32": ("f", "I", 8)}[form]
    return [f"0x{struct.unpack('<' + kind[1], struct.pack('<' + kind[0], float(x)))[0]:0{kind[2]}x}" for x in numbers]

def valid(case, form):
    """Rounded, no number is infinite, and no size or direction is zero that was not."""
    try:
        rounded = lambda x: ROUND[form](x)
        sizes = [value(x) for k, x in case["solid"].items() if k not in ("kind", "vertices")]
        numbers = [*case["origin"], *case["direction"], *case["base"], *sizes]
        return all(math.isfinite(rounded(x)) and (rounded(x) != 0 or x == 0) for x in numbers)
    except OverflowError:
        return False

def main(path="data/cases/cases.jsonl"):
    lines = []
    for line in open(path):
        case = json.loads(line, parse_float=Decimal, parse_int=Decimal)
        text = line.split(", \"ray_bits\"")[0].rstrip("\n")
        text = text[:-1] if text.endswith("}") and "\"ray_bits\"" not in line else text
        ray = case["origin"] + case["direction"]
        more = {"ray_bits": {form: bits(ray, form) if valid(case, form) else None for form in ("f64", "f32")}}
        for form in ("f64", "f32"):
            more[form] = None
            if valid(case, form):
                hits, inside, lies = solve(case, ROUND[form])
                more[form] = {"hits": [{"t": f"{t:.20g}", "crossing": c, "part": p} for t, c, p in hits],
                              "starts_inside": inside, "lies_in_it": lies or None}
        lines.append(text + ", " + json.dumps(more)[1:])
    open(path, "w").write("\n".join(lines) + "\n")

if __name__ == "__main__":
    main(*sys.argv[1:])
