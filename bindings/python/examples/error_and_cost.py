"""Error against cost, by number type and tier: error_and_cost.py PICTURE

A ball of radius 1 that rays meet from 100 away, some of them grazing. The reference is `float64`, of the same rounded
rays.
"""

import sys
import time

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
import raylet

COUNT = 200_000
generator = np.random.default_rng(1)
origins = generator.normal(size=(COUNT, 3))
origins *= 100 / np.linalg.norm(origins, axis=1, keepdims=True)
targets = generator.normal(size=(COUNT, 3))
targets *= generator.uniform(0, 1, (COUNT, 1)) ** 0.25 / np.linalg.norm(targets, axis=1, keepdims=True)
ball = raylet.sphere(1)

figure, axes = plt.subplots(figsize=(7, 4.5))
for kind, marker in ((np.float32, "o"), (np.int32, "s")):
    rounded = [raylet.to_i16f16(a) if kind is np.int32 else a.astype(kind) for a in (origins, targets - origins)]
    o, d = (raylet.from_i16f16(a) if kind is np.int32 else a.astype(np.float64) for a in rounded)
    exact = ball.nearest(o, d)
    for tier in ("plain", "fast", "stable", "exact"):
        times = []
        for _ in range(3):
            start = time.perf_counter()
            hits = ball.nearest(*rounded, tier=tier, threads=1)
            times.append(time.perf_counter() - start)
        both = hits.hit & exact.hit
        t = raylet.from_i16f16(hits.t) if kind is np.int32 else hits.t.astype(np.float64)
        error = np.quantile(np.abs(t - exact.t)[both], 0.99)
        cost = min(times) / COUNT * 1e9
        name = "I16F16" if kind is np.int32 else "float32"
        print(f"{name:8} {tier:7} 99 % error {error:.1e}, {cost:4.0f} ns a ray, "
              f"{(hits.hit != exact.hit).sum()} hits lost or invented")
        axes.scatter(cost, error, marker=marker, label=f"{name}, {tier}")
axes.set(xlabel="nanoseconds a ray, one core", ylabel="99 % error of the distance", yscale="log",
         title="A ball of radius 1 from 100 away")
axes.legend()
figure.tight_layout()
figure.savefig(sys.argv[1], dpi=120)
print(f"the picture is {sys.argv[1]}")
