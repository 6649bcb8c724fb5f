"""How many rays a second meet a sphere, by number type and tier: rays_a_second.py"""

import time

import numpy as np
import raylet

COUNT = 1_000_000
generator = np.random.default_rng(1)
origins = generator.uniform(-1, 1, (COUNT, 3))
origins *= 5 / np.linalg.norm(origins, axis=1, keepdims=True)
directions = generator.uniform(-1.2, 1.2, (COUNT, 3)) - origins
ball = raylet.sphere(1)
for kind in (np.float32, np.float64, np.int32):
    o, d = (raylet.to_i16f16(a) if kind is np.int32 else a.astype(kind) for a in (origins, directions))
    for tier in ("plain", "fast", "stable", "exact"):
        if kind is np.float64 and tier == "exact":
            continue
        times = []
        for _ in range(5):
            start = time.perf_counter()
            hits = ball.nearest(o, d, tier=tier)
            times.append(time.perf_counter() - start)
        name = "I16F16" if kind is np.int32 else np.dtype(kind).name
        print(f"{name:8} {tier:7} {COUNT / min(times) / 1e6:6.1f} million rays a second, {hits.hit.mean():.0%} hit")
