"""A cloth falls onto a ball, in steps that are always free of collision: cells of a notebook, run
as a script.

    python ccd-python/examples/line_search.py [STEPS]
"""

# %% A cloth of n x n vertices above a ball
import sys
import time

import numpy as np

import meshccd


def grid(n, first=0):
    """Faces of n x n vertices in rows."""
    i = first + np.arange(n * n).reshape(n, n)
    a, b, c, d = i[:-1, :-1], i[:-1, 1:], i[1:, :-1], i[1:, 1:]
    return np.concatenate([np.stack(t, axis=-1).reshape(-1, 3) for t in ((a, b, c), (c, b, d))])


def ball(n, first):
    """Vertices and faces of a sphere of n rings and n sectors, without a seam."""
    ring, sector = np.arange(1, n) * np.pi / n, np.arange(n) * 2 * np.pi / n
    s, t = np.meshgrid(ring, sector, indexing="ij")
    rim = np.stack([np.sin(s) * np.cos(t), np.cos(s), np.sin(s) * np.sin(t)], axis=-1)
    x = np.concatenate([[[0, 1, 0]], rim.reshape(-1, 3), [[0, -1, 0]]])
    at = lambda r, k: first + 1 + r * n + k % n
    k = np.arange(n)
    faces = [np.stack([np.full(n, first), at(0, k + 1), at(0, k)], axis=1)]
    for r in range(n - 2):
        faces.append(np.stack([at(r, k), at(r, k + 1), at(r + 1, k)], axis=1))
        faces.append(np.stack([at(r + 1, k), at(r, k + 1), at(r + 1, k + 1)], axis=1))
    faces.append(np.stack([np.full(n, first + len(x) - 1), at(n - 2, k), at(n - 2, k + 1)], axis=1))
    return x, np.concatenate(faces)


n, n_steps = 40, int(sys.argv[1]) if len(sys.argv) > 1 else 30
u, v = np.meshgrid(np.linspace(-1, 1, n), np.linspace(-1, 1, n), indexing="ij")
cloth = np.stack([u, np.full_like(u, 1.05), v], axis=-1).reshape(-1, 3)
sphere, sphere_faces = ball(24, len(cloth))
x = np.concatenate([cloth, sphere])
mesh = meshccd.Mesh(np.concatenate([grid(n), sphere_faces]))
moves = np.arange(len(x)) < len(cloth)
print(mesh)

# %% A session knows the bodies: the ball does not move
session = meshccd.Session(mesh, bodies=(~moves).astype(np.uint32), fixed=[False, True])
print(session)

# %% Springs along the edges of the cloth
edges = mesh.edges[moves[mesh.edges].all(axis=1)]
rest = np.linalg.norm(x[edges[:, 0]] - x[edges[:, 1]], axis=1)


def proposal(x, velocity, dt=0.01, stiffness=4000.0):
    """Where the cloth would be after a step of symplectic Euler, without contact."""
    d = x[edges[:, 0]] - x[edges[:, 1]]
    length = np.linalg.norm(d, axis=1)
    pull = stiffness * ((length - rest) / length)[:, None] * d
    force = np.zeros_like(x)
    np.add.at(force, edges[:, 0], -pull)
    np.add.at(force, edges[:, 1], pull)
    velocity = 0.99 * (velocity + dt * (force + [0.0, -9.81, 0.0])) * moves[:, None]
    return velocity, x + dt * velocity


# %% Each step goes as far as is free, and a little less; what is stopped loses its speed
velocity, n_short = np.zeros_like(x), 0
start = time.perf_counter()
for step in range(n_steps):
    velocity, goal = proposal(x, velocity)
    report = session.step(x, goal)
    size = 1.0 if report.earliest_toi is None else report.earliest_toi
    n_short += size < 1.0
    touching = np.unique(report.vertices)
    velocity[touching] = 0.0
    after = x + 0.9 * size * (goal - x)
    assert session.is_step_collision_free(x, after)
    x = after
elapsed = time.perf_counter() - start
print(f"{n_steps} steps, {n_short} of them shortened, {1e3 * elapsed / n_steps:.1f} ms each")

# %% Nothing went through the ball
inside = np.linalg.norm(x[moves], axis=1).min()
print(f"the cloth is at least {inside:.4f} from the centre of the ball, whose facets are within 1")
assert n_short > 0 and inside > 0.97
