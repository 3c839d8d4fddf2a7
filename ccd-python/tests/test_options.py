"""Options as a value, changes of them between steps, methods by name, calls that are ended."""

import pickle

import numpy as np
import pytest
from test_api import FACES, X0, X1
from test_sessions import pieces, same

from meshccd import Approach, Bodies, BroadPhase, CancelToken, Kind, Mesh, Options, Session
from meshccd import gpus, instruction_set, methods, scaled_toi, toi_to_f32


def test_options_are_values():
    bodies = Bodies([0, 0, 1, 2], fixed=[True], worlds=[0, 0, 1], excluded_bodies=[[0, 1]])
    given = dict(min_distance=0.1, threads=1, max_memory=2**40, tolerance=1 / 3,
                 leave_contact=True, pipeline="triangles", front="on", scheduler="stealing")
    options = Options(bodies=bodies, builder="ploc", volume="obb", **given)
    for name, value in given.items():
        assert getattr(options, name) == value, name
    assert options.method.startswith("tree-ploc-") and options.method.endswith("-obb")
    assert options.bodies == bodies and options.mode == "auto"
    copy = pickle.loads(pickle.dumps(options))
    assert copy == options and copy.tolerance == 1 / 3 and copy.bodies.world(3) == 1
    assert copy != Options(**given) and copy != 1
    assert Options() == Options.from_json(Options().to_json()) and Options().mode != "exact"
    with pytest.raises(TypeError, match="Options.*sharpness"):
        Options(sharpness=1)
    with pytest.raises(ValueError, match="sharpness"):
        Options.from_json('{"sharpness": 1}')


def test_options_change_between_steps():
    """Each change finds what a new session does."""
    mesh, of_vertex, x0, x1 = pieces(100)
    options = Options(threads=1, min_distance=0.01)
    session = Session(mesh, options)
    assert session.options == options
    near = session.step(x0, x1)
    assert same(near, Session(mesh, min_distance=0.01).step(x0, x1))
    session.set_options(min_distance=0.0, bodies=of_vertex)
    assert session.options.threads == 1 and session.options.min_distance == 0
    found = session.step(x0, x1)
    assert same(found, Session(mesh, bodies=of_vertex).step(x0, x1)) and not same(found, near)
    session.set_options(self_contact=False)
    other = session.step(x0, x1)
    want = Session(mesh, bodies=of_vertex, self_contact=False).step(x0, x1)
    assert same(other, want) and len(other) < len(found)
    session.set_options(Options(mode="exact"), method="tree")
    exact = session.step(x0, x1)
    assert session.options.bodies is None and exact.n_undecided == 0
    assert same(exact, Session(mesh, mode="exact").step(x0, x1))
    with pytest.raises(ValueError, match="distance"):
        session.set_options(min_distance=1.0)
    assert same(session.step(x0, x1), exact)
    with pytest.raises(TypeError, match="set_options.*device"):
        session.set_options(device="cpu")


def test_fixed_bodies_may_move():
    mesh = Mesh(FACES)
    bodies = [0, 0, 0, 0, 1, 1, 1]
    session = Session(mesh, bodies=bodies, fixed=[False, True])
    with pytest.raises(ValueError):
        session.step(X0, X1)
    session.set_fixed_motion(True)
    assert len(session.step(X0, X1)) == 1 and session.options.bodies.fixed_motion
    session.set_fixed_motion(False)
    with pytest.raises(ValueError):
        session.step(X0, X1)


def test_bodies_say_their_rules():
    bodies = Bodies([0, 0, 1, 2], fixed=[True], worlds=[0, 0, 1], excluded_edge_edge=[[4, 3]])
    assert bodies.of_vertex.tolist() == [0, 0, 1, 2]
    assert bodies.is_fixed(1) and not bodies.is_fixed(2) and bodies.world(3) == 1
    assert bodies.wants(0, 2) and not bodies.wants(0, 3) and not bodies.wants(0, 1)
    assert bodies.excludes(Kind.EDGE_EDGE, 3, 4) and bodies.excludes(Kind.EDGE_EDGE, 4, 3)
    assert not bodies.excludes(Kind.VERTEX_FACE, 3, 4)
    assert bodies == Bodies.from_json(bodies.to_json()) and bodies != Bodies([0, 0, 1, 2])
    with pytest.raises(ValueError, match="vertex 4 of 4"):
        bodies.is_fixed(4)


def test_reports_have_all_figures():
    mesh, _, x0, x1 = pieces(200)
    session = Session(mesh, threads=1)
    report = session.step(x0, x1)
    of_kind = np.bincount(report.kind, minlength=4).tolist()
    assert list(report.n_contacts) == of_kind and sum(of_kind) == len(report) > 20
    for least, between, most in zip(of_kind, report.n_filtered, report.n_candidates):
        assert least <= between <= most
    assert sum(report.n_filtered) < sum(report.n_candidates)
    assert report.rebuilt and not session.step(x0, x1).rebuilt
    assert report.triangles is None and report.front is None
    report = Session(mesh, pipeline="triangles").step(x0, x1)
    assert report.triangles["pairs"] > 0
    copy = pickle.loads(pickle.dumps(report))
    assert copy.triangles == report.triangles and copy.n_filtered == report.n_filtered
    parts = report.__getnewargs_ex__()[1] | {"state": report.state[1:]}
    with pytest.raises(ValueError, match="different lengths"):
        type(report)(**parts).geometry(x0, x1)


def test_reports_tell_of_a_front(catalogue):
    mesh, _, x0, x1 = pieces(200)
    session = Session(mesh, traversal="simultaneous", pipeline="triangles", front="on")
    assert session.step(x0, x1).triangles["pairs"] > 0
    # It is kept from the second step on.
    report = session.step(x0, x1)
    assert report.front["pairs"] > 0
    assert pickle.loads(pickle.dumps(report)).front == report.front


@pytest.mark.parametrize(("dy", "want"), [(1.0, Approach.SEPARATING), (-1, Approach.APPROACHING)])
def test_contacts_come_nearer_or_separate(dy, want):
    x0 = np.array([[0.2, 0.1, 0.2], [0, 0, 0], [1, 0, 0], [0, 0, 1]])
    x1 = x0 + [[0, dy, 0]] + np.array([[0], [1], [1], [1]]) * [0, -dy, 0]
    report = Session(Mesh([[1, 2, 3]], n_vertices=4), min_distance=0.2).step(x0, x1)
    assert report.approach.tolist() == [want]


def test_calls_end_when_they_are_cancelled():
    session, token = Session(Mesh(FACES)), CancelToken()
    session.set_cancel_token(token)
    candidates = session.candidate_set(X0, X1)
    assert len(session.step(X0, X1)) == 1 and not token.is_cancelled

    def cancel(kind, pairs):
        token.cancel()
        return np.ones(len(pairs), bool)

    session.set_filter(cancel)
    with pytest.raises(RuntimeError, match="cancelled"):
        session.step(X0, X1)
    assert token.is_cancelled
    session.set_filter()
    with pytest.raises(RuntimeError, match="cancelled"):
        session.earliest_toi(X0, X1)
    with pytest.raises(RuntimeError, match="cancelled"):
        candidates.earliest_toi(X0, X1)
    session.set_cancel_token()
    assert len(session.step(X0, X1)) == 1


def test_methods_are_listed(catalogue):
    all_methods = methods()
    names = {row["name"] for row in all_methods if row["what"] == "method"}
    assert {"blocks", "tree", "brute-force", "sweep-and-prune"} <= names
    always = {row["name"] for row in all_methods if row["what"] == "method"
              and not row["catalogue"]}
    assert always == {"blocks", "tree"}
    mesh, _, x0, x1 = pieces(40)
    want, n_refused = Session(mesh).step(x0, x1), 0
    for row in all_methods:
        if "cpu" in row["backends"]:
            options = Options(**{"method": "tree", row["what"]: row["name"]})
            try:
                assert same(Session(mesh, options).step(x0, x1), want), row
            except ValueError as why:
                # Some need another choice besides, and say it.
                assert "must be one of" not in str(why), row
                n_refused += 1
    assert n_refused < len(all_methods) / 2
    low = np.random.default_rng(2).random((300, 3))
    boxes = np.stack([low, low + 0.1], axis=1)
    pairs = BroadPhase(threads=1).self_pairs(boxes)
    broad = BroadPhase(threads=1, builder="ploc", traversal="simultaneous", scheduler="static")
    found = broad.self_pairs(boxes)
    assert {tuple(p) for p in found.tolist()} == {tuple(p) for p in pairs.tolist()}
    assert broad.visits > 0 and broad.tree_statistics["nodes"] == 599 and broad.place == "1 thread"
    assert broad.times["search"] > 0 and BroadPhase().tree_statistics is None
    with pytest.raises(TypeError, match="pipeline"):
        BroadPhase(pipeline="triangles")


def test_times_are_never_later():
    toi = float(np.nextafter(0.1, 0))
    assert float(np.float32(toi)) > toi >= toi_to_f32(toi)
    assert float(np.float32(toi_to_f32(toi))) == toi_to_f32(toi)
    assert scaled_toi(toi, 0.5) < toi / 2 and scaled_toi(toi, 1) == toi


def test_the_machine_is_described():
    assert instruction_set() and all(isinstance(name, str) for name in gpus())
    with pytest.raises(RuntimeError, match="GPU"):
        Session(Mesh(FACES), device="gpu:no such device")
