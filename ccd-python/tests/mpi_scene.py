"""A step of a scene on several ranks against one process, run by mpirun: `test_mpi.py`.

    mpirun -n 4 python mpi_scene.py cloth-ball
"""

import copy
import hashlib
import sys

import numpy as np
from conftest import named
from crowds import crowd
from mpi4py import MPI

from meshccd import Bodies, Options, Session
from meshccd.mpi import Scene
from meshccd.partition import split

WORLD = MPI.COMM_WORLD


def digest(contacts):
    return hashlib.sha256(contacts.tobytes()).hexdigest()


def check(mesh, x0, x1, options):
    """Contacts and the earliest time of all ranks are those of one process, in each of two steps;
    the second goes back, with another halo."""
    scene = Scene.of_mesh(mesh, x0, options)
    mine = scene.vertices
    for before, after in ((x0, x1), (x1, x0)):
        found = scene.gather(scene.step(before[mine], after[mine]))
        toi = scene.earliest_toi(before[mine], after[mine])
        if WORLD.rank == 0:
            want = Session(mesh, options).step(before, after)
            assert len(want) > 100 and toi == want.earliest_toi, (toi, want)
            assert digest(found) == digest(want.contacts) != digest(want.contacts[1:])
            n = len(want)
            print(f"{WORLD.size} ranks, {n} contacts: digest {digest(found)[:16]}, as one process")
        else:
            assert found is None
    free = scene.collision_free_stepsize(x0[mine], x0[mine])
    assert free in (0.0, 1.0) and len(set(WORLD.allgather(free))) == 1


class Unpicklable(Exception):
    def __reduce__(self):
        raise TypeError("this error cannot be pickled")


def fails(*_):
    raise Unpicklable("out of bounds")


def check_refusals(mesh, x0, x1):
    """What the last rank refuses is an error of all, whatever it is."""
    scene = Scene.of_mesh(mesh, x0)
    mine, parts = scene.vertices, split(mesh, x0, WORLD.size)
    good, words, whole, broken = x1[mine], x1[mine], x0, Scene(scene.part)
    bad = good.copy()
    if WORLD.rank == WORLD.size - 1:
        bad[0, 0], words, whole = np.nan, [{}] * len(mine), x0[1:]
        broken.part = copy.copy(scene.part)
        broken.part.outgoing = fails
    for call, kind, want in (
        (lambda: scene.step(x0[mine], bad), ValueError, "must be finite"),
        (lambda: Scene(parts[-1]), ValueError, "is not that of rank 0"),
        (lambda: Scene.of_mesh(mesh, whole), ValueError, "x has the shape"),
        (lambda: scene.step(x0[mine], words), TypeError, "'dict'"),
        (lambda: broken.step(x0[mine], good), Unpicklable, "out of bounds"),
    ):
        try:
            call()
        except (kind, RuntimeError) as why:
            said = WORLD.allgather(str(why))
            assert any(want in text for text in said), said
        else:
            raise AssertionError(f"rank {WORLD.rank} goes on")
    # The communicator still works.
    assert scene.earliest_toi(x0[mine], x1[mine]) is not None


if sys.argv[1:] == ["crowd"]:
    mesh, x0, x1 = crowd(60, 3, rods=20, particles=30, degenerate=15)
    bodies = Bodies.of_components(mesh, self_contact=False)
    check(mesh, x0, x1, Options(min_distance=0.1, threads=1, bodies=bodies))
    check_refusals(mesh, x0, x1)
else:
    scene = named(sys.argv[1])
    check(scene.mesh, scene.x0, scene.x1, Options(threads=1))
