"""Sessions that threads share, and filters, which may call their session."""

import gc
import sys
import threading
import weakref

import numpy as np
import pytest
from test_api import FACES, X0, X1
from test_sessions import everything, pieces, same

from meshccd import Mesh, Session


def test_threads_with_one_filter_do_not_mix_their_steps():
    session = Session(Mesh(FACES))
    session.set_filter(everything)
    want = [session.earliest_toi(*x) for x in ((X0, X1), (X1, X0))]
    assert None not in want
    wrong = []

    def call(x, toi):
        for _ in range(500):
            found = session.earliest_toi(*x)
            if found != toi:
                wrong.append(found)

    # One of them at rest: what is a candidate there is not enough for the others.
    steps = [((X0, X1), want[0]), ((X1, X0), want[1]), ((X0, X0), session.earliest_toi(X0, X0))]
    threads = [threading.Thread(target=call, args=step) for step in steps]
    interval = sys.getswitchinterval()
    sys.setswitchinterval(1e-6)
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    sys.setswitchinterval(interval)
    assert wrong == []


def test_a_filter_may_call_its_session_and_so_may_its_finalizer():
    session, ended = Session(Mesh(FACES)), []

    class Filter:
        def __call__(self, kind, pairs):
            session.set_min_distance(0.0)
            return np.ones(len(pairs), bool)

        def __del__(self):
            ended.append(session.place)

    session.set_filter(Filter())
    with pytest.raises(RuntimeError, match="changed each time"):
        session.step(X0, X1)
    session.set_filter(lambda kind, pairs: np.full(len(pairs), session.options.threads < 99))
    assert len(session.step(X0, X1)) > 0
    session.set_filter()
    assert len(ended) == 1


def test_a_set_that_a_thread_has_does_not_hold_the_others():
    mesh, _, x0, x1 = pieces(2000)
    candidates, done = Session(mesh).candidate_set(x0, x1), []

    def search():
        while not done:
            candidates.earliest_toi(x0, x1)

    thread = threading.Thread(target=search)
    thread.start()
    for _ in range(20):
        assert candidates.inflation == 0.0
    done.append(True)
    thread.join()


def test_reports_have_the_mesh_that_was_stepped():
    meshes = [Mesh(FACES), Mesh(np.asarray(FACES)[:, ::-1])]
    session, done = Session(meshes[0]), threading.Event()

    def exchange():
        while not done.is_set():
            for mesh in meshes:
                session.set_mesh(mesh)

    others = [threading.Thread(target=exchange) for _ in range(2)]
    interval = sys.getswitchinterval()
    sys.setswitchinterval(1e-6)
    for thread in others:
        thread.start()
    try:
        for _ in range(3000):
            report = session.step(X0, X1)
            assert report.vertices[0][1] == report.mesh.faces[0][0]
    finally:
        done.set()
        for thread in others:
            thread.join()
        sys.setswitchinterval(interval)
    report = session.step(X0, X1)
    assert report.mesh is session.mesh and report.vertices[0][1] == report.mesh.faces[0][0]


def test_a_session_that_its_filter_refers_to_is_collected():
    class Solver:
        def __init__(self):
            self.session = Session(Mesh(FACES))
            self.session.set_filter(self.want)

        def want(self, kind, pairs):
            return np.ones(len(pairs), bool)

    solver = Solver()
    assert len(solver.session.step(X0, X1)) > 0
    left = weakref.ref(solver)
    del solver
    gc.collect()
    assert left() is None


def test_a_filter_may_return_any_view_of_its_answers():
    session = Session(Mesh(FACES))
    want = session.step(X0, X1)
    for mask in (
        lambda n: np.broadcast_to(True, n),
        lambda n: np.ones((n, 2), bool)[:, 0],
        lambda n: np.ones(n, bool)[::-1],
    ):
        session.set_filter(lambda kind, pairs, mask=mask: mask(len(pairs)))
        assert same(session.step(X0, X1), want)
    session.set_filter(lambda kind, pairs: True)
    with pytest.raises(ValueError, match="one-dimensional"):
        session.step(X0, X1)
