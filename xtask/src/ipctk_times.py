"""Times of ipctk for one scene: python3 ipctk_times.py SCENE.bin THREADS RUNS, prints one JSON object.

SCENE.bin: three u32 (vertices, edges, faces), positions at t0 and t1 (f64 xyz), edges and faces (u32), all little-endian.
"""

import json
import statistics
import sys
import time

import ipctk
import numpy as np

path, threads, runs = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
ipctk.set_num_threads(threads)
with open(path, "rb") as file:
    data = file.read()
n_vertices, n_edges, n_faces = np.frombuffer(data, "<u4", 3)
at = 12


def take(kind, shape):
    global at
    array = np.frombuffer(data, kind, int(np.prod(shape)), at).reshape(shape)
    at += array.nbytes
    return array


x0 = np.asfortranarray(take("<f8", (n_vertices, 3)))
x1 = np.asfortranarray(take("<f8", (n_vertices, 3)))
edges = take("<u4", (n_edges, 2)).astype(np.int32)
faces = take("<u4", (n_faces, 3)).astype(np.int32)
mesh = ipctk.CollisionMesh(x0, edges, faces)


def timed(f, n):
    times, result = [], None
    for _ in range(n):
        start = time.perf_counter()
        result = f()
        times.append((time.perf_counter() - start) * 1e3)
    return statistics.median(times), result


def build():
    candidates = ipctk.Candidates()
    candidates.build(mesh, x0, x1, 0.0, ipctk.LBVH())
    return candidates


broad, candidates = timed(build, runs)


def narrow(ccd):
    return candidates.compute_collision_free_stepsize(mesh, x0, x1, 0.0, ccd)


tight, toi_tight = timed(lambda: narrow(ipctk.TightInclusionCCD()), max(1, runs // 3))
additive, toi_additive = timed(lambda: narrow(ipctk.AdditiveCCD()), max(1, runs // 3))
print(
    json.dumps(
        {
            "version": ipctk.__version__,
            "threads": ipctk.get_num_threads(),
            "candidates": [len(candidates.fv_candidates), len(candidates.ee_candidates)],
            "broad": broad,
            "tight": tight,
            "additive": additive,
            "toi": [toi_tight, toi_additive],
        }
    )
)
