"""Generated scenes and animations of tests, and what two runs of one animation must share."""

import os
import signal

import numpy as np

from meshccd import Mesh, Options
from meshccd.distributed import digest

N_STEPS = 10
OPTIONS = Options(min_distance=0.02, threads=1)


def crowd(n, seed, rods=0, particles=0, degenerate=0):
    """Pairs of triangles with a common edge, rods and particles in a crowd, all moving; numbers of
    vertices are in no order. Besides, so many degenerate faces [v, v, w] of a pair or a rod, and as
    many [v, v, v] of any vertex."""
    random = np.random.default_rng(seed)
    faces = np.arange(4 * n).reshape(n, 4)[:, [0, 1, 2, 2, 1, 3]].reshape(-1, 3)
    edges = 4 * n + np.arange(2 * rods).reshape(rods, 2)
    n_vertices = 4 * n + 2 * rods + particles
    of = np.concatenate([np.repeat(np.arange(n), 4), n + np.repeat(np.arange(rods), 2),
                         n + rods + np.arange(particles)])  # fmt: skip
    x0 = random.random((of.max() + 1, 3))[of] + 0.4 * random.random((n_vertices, 3))
    x1 = x0 + 0.4 * random.random((of.max() + 1, 3))[of] + 0.05 * random.random((n_vertices, 3))
    numbers = random.permutation(n_vertices)
    if degenerate:
        v = random.integers(4 * n + 2 * rods, size=degenerate)
        # Also the two corners of a pair that no side joins.
        w = v ^ np.where(v < 4 * n, random.integers(1, 4, size=degenerate), 1)
        sides = [np.roll(of, i) for i, of in enumerate(np.stack([v, v, w], axis=1))]
        points = np.repeat(random.integers(n_vertices, size=(degenerate, 1)), 3, axis=1)
        faces = np.concatenate([sides, points, faces])
    y0, y1 = np.empty_like(x0), np.empty_like(x1)
    y0[numbers], y1[numbers] = x0, x1
    return Mesh(numbers[faces], numbers[edges], n_vertices=n_vertices), y0, y1


def animation(seed=3):
    """A mesh, and frames of an animation that goes there and back."""
    mesh, x0, x1 = crowd(30, seed, particles=10)
    t = np.abs(np.linspace(-1, 1, N_STEPS + 1))[:, None, None]
    return mesh, x0 + t * (x1 - x0)


def write_frames(folder, mesh, frames):
    """A file a frame, with all digits; their paths."""
    faces = "".join("f {} {} {}\n".format(*face) for face in mesh.faces + 1)
    paths = []
    for at, x in enumerate(frames):
        path = folder / f"frame{at:03}.obj"
        path.write_text("".join("v {!r} {!r} {!r}\n".format(*p) for p in x.tolist()) + faces)
        paths.append(path)
    return paths


class Deadly:
    """Frames of which one kills the worker that reads it, as the system does for memory."""

    def __init__(self, frames, at):
        self.frames, self.at = frames, at

    def __len__(self):
        return len(self.frames)

    def part(self, begin, end):
        return Deadly(self.frames, self.at if begin <= self.at < end else -1)

    def read(self, at, mesh):
        if at == self.at:
            os.kill(os.getpid(), signal.SIGKILL)
        return self.frames[at]


def check(found, want):
    """Reports are those of one process, in their order."""
    assert len(found) == len(want) == N_STEPS and digest(found) == digest(want)
    for one, other in zip(found, want):
        assert np.array_equal(one.contacts, other.contacts)
        assert np.array_equal(one.vertices, other.vertices)
        assert np.array_equal(one.approach, other.approach)
        assert one.earliest_toi == other.earliest_toi and one.n_undecided == other.n_undecided
        assert one.n_candidates == other.n_candidates and one.n_filtered == other.n_filtered
    assert sum(map(len, want)) > 100 and digest(list(found)[::-1]) != digest(want)
