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
        contacts, n_calls = counted(lambda: scene.step(before[mine], after[mine]))
        found = scene.gather(contacts)
        toi = scene.earliest_toi(before[mine], after[mine])
        if WORLD.rank == 0:
            want = Session(mesh, options).step(before, after)
            assert len(want) > 100 and toi == want.earliest_toi, (toi, want)
            assert digest(found) == digest(want.contacts) != digest(want.contacts[1:])
            n = len(want)
            print(f"{WORLD.size} ranks, {n} contacts: digest {digest(found)[:16]}, as one process")
        else:
            assert found is None
    # The first step also imports modules.
    assert n_calls < 4000, "a step makes a call for each rule"
    free = scene.collision_free_stepsize(x0[mine], x0[mine])
    assert free in (0.0, 1.0) and len(set(WORLD.allgather(free))) == 1


def counted(call):
    """What a call returns, and how many others it makes."""
    n = 0

    def count(frame, event, arg):
        nonlocal n
        n += event in ("call", "c_call")

    sys.setprofile(count)
    try:
        result = call()
    finally:
        sys.setprofile(None)
    return result, n


class Unpicklable(Exception):
    def __reduce__(self):
        raise TypeError("this error cannot be pickled")


def fails(*_):
    raise Unpicklable("out of bounds")


class NoArray:
    def __array__(self, *_, **__):
        raise TypeError("no array at all")


def check_refusals(mesh, x0, x1):
    """What the last rank refuses is an error of all, whatever it is."""
    scene = Scene.of_mesh(mesh, x0)
    mine, parts = scene.vertices, split(mesh, x0, WORLD.size)
    good, words, whole, broken = x1[mine], x1[mine], x0, Scene(scene.part)
    contacts = [scene.step(x0[mine], good)] * 3
    bad, root = good.copy(), 0
    # A body of which one vertex moves, with the last number of the last rank.
    moved = WORLD.bcast(int(mine[-1]), WORLD.size - 1)
    components, y = Bodies.of_components(mesh).of_vertex, x0.copy()
    fixed = np.arange(components.max() + 1) == components[moved]
    still = Scene.of_mesh(mesh, x0, Options(bodies=Bodies(components, fixed=fixed)))
    y[moved] += 0.1
    if WORLD.rank == WORLD.size - 1:
        bad[0, 0], words, whole, root = np.nan, NoArray(), x0[1:], 9
        contacts = [None, lambda: None, contacts[0]["toi"]]
        broken.part = copy.copy(scene.part)
        broken.part.outgoing = fails
    for call, kind, want in (
        (lambda: scene.step(x0[mine], bad), ValueError, "must be finite"),
        (lambda: Scene(parts[-1]), ValueError, "is not that of rank 0"),
        (lambda: Scene.of_mesh(mesh, whole), ValueError, "x has the shape"),
        (lambda: scene.step(x0[mine], words), TypeError, "no array at all"),
        (lambda: scene.gather(contacts[0]), ValueError, "contacts are an array of object"),
        (lambda: scene.gather(contacts[1]), ValueError, "contacts are an array of object"),
        (lambda: scene.gather(contacts[2]), ValueError, "contacts are an array of float64"),
        (lambda: scene.gather(scene.step(x0[mine], good), root), ValueError, "root is 9"),
        (lambda: still.step(x0[mine], y[mine]), ValueError, f"vertex {moved} moves"),
        (lambda: still.earliest_toi(x0[mine], y[mine]), ValueError, f"vertex {moved} moves"),
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
    vertex, face = np.indices((mesh.n_vertices, len(mesh.faces))).reshape(2, -1)
    excluded = np.stack([vertex, face], axis=1)[(vertex + face) % 3 == 0]
    assert len(excluded) > 10_000
    components = Bodies.of_components(mesh).of_vertex
    bodies = Bodies(components, self_contact=False, excluded_vertex_face=excluded)
    check(mesh, x0, x1, Options(min_distance=0.1, threads=1, bodies=bodies))
    check_refusals(mesh, x0, x1)
else:
    scene = named(sys.argv[1])
    check(scene.mesh, scene.x0, scene.x1, Options(threads=1))
