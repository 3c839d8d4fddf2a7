"""What a session can do beside steps: bodies and their rules, changes, first contacts, geometry."""

import multiprocessing
import os
import pickle

import numpy as np
import pytest
from test_api import FACES, X0, X1

from meshccd import Bodies, BroadPhase, Kind, Mesh, Session, State, distance, edge_edge
from meshccd import read_mesh, read_positions, vertex_edge, vertex_vertex

BODIES = [0, 0, 0, 0, 1, 1, 1]


def pieces(n, seed=3):
    """Triangles in a crowd, a body each of two."""
    random = np.random.default_rng(seed)
    centre = np.repeat(0.3 * random.random((n, 3)), 3, axis=0)
    x0 = centre + 0.1 * random.random((3 * n, 3))
    x1 = x0 + 0.1 * np.repeat(random.random((n, 3)), 3, axis=0)
    return Mesh(np.arange(3 * n).reshape(n, 3)), np.arange(3 * n) // 6, x0, x1


def same(found, want):
    return np.array_equal(found.contacts, want.contacts)


def test_the_first_contact_has_a_point_and_a_normal():
    session = Session(Mesh(FACES), bodies=BODIES)
    hit = session.first_contact(X0, X1)
    assert (hit.kind, hit.state, hit.features) == (Kind.VERTEX_FACE, State.HIT, (4, 0))
    assert hit.bodies == (1, 0) and hit.vertices.tolist() == [4, 0, 1, 2]
    assert np.allclose(hit.point, [0.3, 0.0, 0.3], atol=1e-5) and 0.5 - 1e-6 < hit.toi <= 0.5
    assert np.allclose(hit.normal_towards(1), [0, 1, 0]) and hit.weights[0] == 1
    assert np.allclose(hit.normal_towards(0), [0, -1, 0]) and hit.distance < 1e-5
    assert session.first_contact(X0, X0) is None and "VertexFace 4 0" in repr(hit)
    assert np.allclose(hit.point + 2 * hit.normal, [0.3, 2, 0.3], atol=1e-5)
    copies = [pickle.loads(pickle.dumps(part)) for part in (hit, session.step(X0, X1))]
    copies.append(pickle.loads(pickle.dumps(copies[1].geometry(X0, X1))))
    assert repr(copies[0]) == repr(hit) and np.array_equal(copies[0].normal, hit.normal)
    assert np.array_equal(copies[2].normal[0], hit.normal)


def test_geometry_is_that_of_every_contact():
    mesh, _, x0, x1 = pieces(200)
    report = Session(mesh).step(x0, x1)
    at = report.geometry(x0, x1)
    n = len(report)
    assert n > 20 and at.point.shape == at.normal.shape == (n, 3) and at.weights.shape == (n, 4)
    # Another way: nearest points are the weights times the vertices at the time of impact.
    x = x0[report.vertices] + report.toi[:, None, None] * (x1 - x0)[report.vertices]
    first = np.where(report.kind == Kind.EDGE_EDGE, 2, 1)[:, None] > np.arange(4)
    for mask, of in ((first, at.on_a), (~first, at.on_b)):
        assert np.allclose(((at.weights * mask)[:, :, None] * x).sum(axis=1), of, atol=1e-12)
    assert np.allclose(np.linalg.norm(at.normal, axis=1), 1)
    assert np.allclose(np.linalg.norm(at.on_a - at.on_b, axis=1), at.distance, atol=1e-12)
    with pytest.raises(ValueError, match="x1 has"):
        report.geometry(x0, x1[1:])


def test_windows_are_parts_of_a_step():
    mesh, _, x0, x1 = pieces(200)
    session = Session(mesh)
    whole = session.step(x0, x1)
    early = session.step(x0, x1, (0.0, 0.5))
    pairs = {(c["kind"], c["a"], c["b"]) for c in whole.contacts if c["toi"] < 0.5 - 1e-5}
    found = {(c["kind"], c["a"], c["b"]) for c in early.contacts}
    assert pairs <= found and len(found) < len(whole)


def test_rules_select_pairs():
    mesh, of_vertex, x0, x1 = pieces(100)
    n = of_vertex.max() + 1
    found = lambda **rules: Session(mesh, bodies=Bodies(of_vertex, **rules)).step(x0, x1)
    everything = Session(mesh).step(x0, x1)
    assert same(found(), everything) and len(everything) > 10
    of = lambda report: of_vertex[report.vertices[:, [0, 3]]]
    apart = of(everything)[:, 0] != of(everything)[:, 1]
    assert len(found(self_contact=False)) == apart.sum() < len(everything)
    assert len(found(self_contact=np.zeros(n, bool))) == apart.sum()
    worlds = np.arange(n) % 2
    by_world = found(worlds=worlds)
    inside = worlds[of(everything)[:, 0]] == worlds[of(everything)[:, 1]]
    assert len(by_world) == inside.sum() < len(everything)
    # The earliest of each world, by another way.
    want = [by_world.toi[worlds[of(by_world)[:, 0]] == w].min(initial=np.inf) for w in (0, 1)]
    assert by_world.toi_of_worlds.tolist() == want and everything.toi_of_worlds is None
    groups = found(memberships=np.full(n, 1), filters=np.full(n, 2))
    assert len(groups) == (~apart).sum()
    first = of(everything)[apart][0]
    without = found(excluded_bodies=[first])
    mine = (np.sort(of(everything), axis=1) == np.sort(first)).all(axis=1)
    assert len(without) == len(everything) - mine.sum()
    vf = everything.contacts[everything.kind == Kind.VERTEX_FACE][:1]
    pairs = np.stack([vf["a"], vf["b"]], axis=1)
    assert len(found(excluded_vertex_face=pairs)) == len(everything) - 1
    asleep = found(sleeping=np.ones(n, bool), fixed_motion=True)
    assert len(asleep) == 0
    assert "50 of 300" in repr(Bodies(of_vertex))


def test_exclusions_are_near():
    mesh, _, x0, _ = pieces(40)
    vf, ee = mesh.near_at_rest(x0, 0.05)
    assert len(vf) and len(ee)
    least, greatest = distance(Kind.EDGE_EDGE, x0[mesh.edges[ee]].reshape(-1, 4, 3))
    assert (least <= 0.05).all() and (least <= greatest).all()
    strip = Mesh([[0, 1, 2], [2, 1, 3], [2, 3, 4]])
    assert strip.neighbours(1)[0][:2].tolist() == [[0, 1], [0, 2]]


def test_a_session_changes_between_steps():
    mesh, of_vertex, x0, x1 = pieces(100)
    session = Session(mesh)
    want = Session(mesh, min_distance=0.02, bodies=of_vertex, self_contact=False).step(x0, x1)
    session.set_min_distance(0.02)
    session.set_bodies(Bodies(of_vertex, self_contact=False))
    assert same(session.step(x0, x1), want)
    session.set_bodies()
    session.set_min_distance(0.0)
    assert same(session.step(x0, x1), Session(mesh).step(x0, x1))
    small = Mesh(FACES)
    session.set_mesh(small, BODIES)
    assert session.mesh is small and len(session.step(X0, X1)) == 1
    session.set_fixed(0, True)
    session.set_sleeping(1, True)
    with pytest.raises(ValueError, match="vertex 4 moves"):
        session.step(X0, X1)
    with pytest.raises(ValueError, match="no body 7|body 7"):
        session.set_sleeping(7, True)


def test_bodies_move_while_others_stand():
    mesh = Mesh(FACES)
    session = Session(mesh, bodies=Bodies(BODIES, fixed=[True, False]))
    session.set_positions(X0)
    motion = [(1, X0[4:], X1[4:])]
    assert session.earliest_toi_of_bodies([]) is None
    want = Session(mesh, bodies=BODIES).step(X0, X1)
    assert session.earliest_toi_of_bodies(motion) == want.earliest_toi
    assert same(session.step_bodies(motion), want)
    assert session.first_contact_of_bodies(motion).features == (4, 0)
    assert len(session.step_bodies([])) == 0
    with pytest.raises(ValueError, match="x1|3"):
        session.step_bodies([(1, X0[4:], X1)])
    # By poses, which move positions from where they were given.
    session.set_positions(X0)
    down = np.eye(4)
    down[:3, 3] = np.subtract(X1, X0)[4]
    assert same(session.step_bodies([(1, np.eye(4), down)]), want)
    with pytest.raises(ValueError, match="0, 0, 0, 1"):
        session.step_bodies([(1, np.eye(4), np.ones((4, 4)))])


def test_a_filter_says_which_pairs_count():
    mesh, _, x0, x1 = pieces(100)
    session, asked = Session(mesh), []
    want = session.step(x0, x1)

    def even(kind, pairs):
        asked.append((kind, len(pairs)))
        return (pairs[:, 0] + pairs[:, 1]) % 2 == 0

    session.set_filter(even)
    found = session.step(x0, x1)
    kept = want.contacts[(want.a + want.b) % 2 == 0]
    assert np.array_equal(found.contacts, kept) and 0 < len(kept) < len(want)
    assert [kind for kind, _ in asked] == [0, 1]
    assert session.earliest_toi(x0, x1) == kept["toi"].min()
    session.set_filter(lambda kind, pairs: np.ones(len(pairs) - 1, bool))
    with pytest.raises(ValueError, match="answers"):
        session.step(x0, x1)
    session.set_filter()
    assert same(session.step(x0, x1), want)


def everything(kind, pairs):
    return np.ones(len(pairs), bool)


def test_a_filter_does_not_answer_for_other_positions():
    bodies = Bodies(BODIES, fixed=[True, False])
    session = Session(Mesh(FACES), bodies=bodies)
    session.set_positions(X0)
    motion = [(1, X0[4:], X1[4:])]
    want = session.step_bodies(motion)
    assert len(want) > 0
    session.set_filter(everything)
    # Nothing is near anything else there.
    session.step(X0, X0)
    session.set_positions(X0)
    assert same(session.step_bodies(motion), want)
    session.set_positions(X0)
    assert session.earliest_toi_of_bodies(motion) == want.earliest_toi
    session.set_positions(X0)
    assert session.first_contact_of_bodies(motion).toi == want.earliest_toi


def test_frames_may_come_in_one_array_again_and_again():
    session = Session(Mesh(FACES))

    def frames():
        x = np.array(X0, float)
        yield x
        x[:] = X1
        yield x

    class Sized:
        def __len__(self):
            return 2

        def __iter__(self):
            return frames()

    for given in (frames(), Sized()):
        (found,) = session.step_many(given)
        assert len(found) > 0 and same(found, session.step(X0, X1))


def test_columns_that_were_written_to_are_refused():
    report = Session(Mesh(FACES)).step(X0, X1)
    report.a[0] = 99
    with pytest.raises(ValueError, match="99"):
        report.geometry(X0, X1)
    report.kind[0] = 9
    for ask in (lambda: report.n_contacts, lambda: report.geometry(X0, X1)):
        with pytest.raises(ValueError, match="kind is 9"):
            ask()


def test_errors_name_the_argument():
    session, bad = Session(Mesh(FACES)), X0.copy()
    bad[3, 1] = np.nan
    for call in (session.intersections, session.has_intersections, session.set_positions):
        with pytest.raises(ValueError, match=r"\bx\b"):
            call(X0[1:])
    for call in (session.intersections, lambda x: distance(Kind.VERTEX_FACE, x[:4])):
        with pytest.raises(ValueError, match=r"of x\b"):
            call(bad)


def test_rules_hold_in_any_order_of_their_names():
    rules = {"excluded_bodies": [[0, 0]], "self_contact": True}
    for given in (rules, dict(reversed(rules.items()))):
        assert not Bodies([0, 0, 0], **given).wants(0, 1)


def test_bodies_have_any_numbers():
    names = np.array([4294967295] * 7, "u4")
    assert Session(Mesh(FACES), bodies=Bodies(names, fixed=[True])).step(X0, X1)


def test_every_method_finds_the_same(catalogue):
    mesh, _, x0, x1 = pieces(100)
    want = Session(mesh).step(x0, x1)
    for options in (
        {"method": "sweep-and-prune"},
        {"builder": "ploc", "traversal": "simultaneous"},
        {"volume": "obb"},
        {"pipeline": "triangles"},
        {"scheduler": "stealing", "front": "on"},
        {"tolerance": 1e-6, "leave_contact": False, "threads": 2},
    ):
        assert same(Session(mesh, **options).step(x0, x1), want), options
    with pytest.raises(TypeError, match="metod"):
        Session(mesh, metod="tree")


def test_a_loose_tolerance_is_never_late():
    mesh, _, x0, x1 = pieces(100)
    fine, loose = (Session(mesh, tolerance=t).earliest_toi(x0, x1) for t in (1e-9, 1e-3))
    assert loose <= fine + 1e-9 and fine - loose <= 1e-3


def test_intersections_are_where_the_mesh_goes_through_itself():
    x = X0.copy()
    x[5] = [0.3, -0.5, 0.3]
    session = Session(Mesh(FACES))
    edges = [session.mesh.edges.tolist().index(edge) for edge in ([4, 5], [5, 6])]
    assert session.intersections(x).tolist() == [[edge, 0] for edge in edges]
    assert session.intersections(X0).shape == (0, 2)


def test_queries_of_particles_and_rods():
    x0 = np.array([[0.0, 1, 0], [-1, 0, 0], [1, 0, 0]])
    x1 = x0 - np.array([[0, 2, 0], [0, 0, 0], [0, 0, 0]])
    state, toi = vertex_edge(x0, x1, min_distance=0.1)
    assert state == State.HIT and 0.45 - 1e-6 < toi <= 0.45
    state, toi = vertex_vertex([[0.0, 0, 0], [3, 0, 0]], [[0.0, 0, 0], [-1, 0, 0]], 1.0)
    assert state == State.HIT and 0.5 - 1e-6 < toi <= 0.5
    assert edge_edge(np.zeros((0, 4, 3)), np.zeros((0, 4, 3)))[0].shape == (0,)
    least, greatest = distance(Kind.VERTEX_EDGE, np.stack([x0, x1]))
    assert np.allclose(least, 1) and np.allclose(greatest, 1) and (least <= 1).all()


def test_files_are_read(tmp_path):
    (tmp_path / "a.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    mesh, x = read_mesh(tmp_path / "a.obj")
    assert mesh.faces.tolist() == [[0, 1, 2]] and x.tolist() == [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
    np.save(tmp_path / "x.npy", np.stack([x, x + 1]).astype(np.float32))
    assert read_positions(tmp_path / "x.npy").tolist() == [x.tolist(), (x + 1).tolist()]


def test_copies_by_pickle():
    mesh, of_vertex, x0, x1 = pieces(60)
    bodies = Bodies(of_vertex, self_contact=False, worlds=of_vertex % 3)
    report = Session(mesh, bodies=bodies).step(x0, x1)
    mesh, bodies, copy = pickle.loads(pickle.dumps((mesh, bodies, report)))
    assert same(copy, report) and copy.times == report.times and len(report) > 0
    assert np.array_equal(copy.toi_of_worlds, report.toi_of_worlds)
    assert same(Session(mesh, bodies=bodies).step(x0, x1), report)
    assert np.array_equal(copy.geometry(x0, x1).point, report.geometry(x0, x1).point)


def in_child(queue, session, broad, mesh, x0, x1):
    for call in (
        lambda: len(session.step(x0, x1)),
        lambda: session.place,
        lambda: len(broad.self_pairs(boxes_of(x0))),
        lambda: len(Session(mesh).step(x0, x1)),
        lambda: len(BroadPhase().self_pairs(boxes_of(x0))),
        lambda: [len(pairs) for pairs in mesh.near_at_rest(x0, 0.01)],
    ):
        try:
            queue.put(call())
        except RuntimeError as why:
            queue.put(str(why))


def boxes_of(x):
    return np.stack([x, x + 0.1], axis=1)


@pytest.mark.skipif(not hasattr(os, "fork"), reason="there is no fork")
@pytest.mark.filterwarnings("ignore::DeprecationWarning")
def test_a_fork_is_told_apart():
    mesh, _, x0, x1 = pieces(60)
    session, broad = Session(mesh), BroadPhase()
    want = [len(session.step(x0, x1)), len(broad.self_pairs(boxes_of(x0)))]
    want.append([len(pairs) for pairs in mesh.near_at_rest(x0, 0.01)])
    context = multiprocessing.get_context("fork")
    queue = context.Queue()
    child = context.Process(target=in_child, args=(queue, session, broad, mesh, x0, x1))
    child.start()
    refused, found = ([queue.get(timeout=60) for _ in range(3)] for _ in range(2))
    child.join()
    assert found == want
    assert all("before a fork" in why for why in refused) and "broad phase" in refused[2]


def on_a_gpu(queue, inherited, mesh, x0, x1):
    with pytest.raises(RuntimeError, match="before a fork"):
        inherited[0].step(x0, x1)
    # The last reference here: it ends without its device.
    inherited.clear()
    queue.put(len(Session(mesh, device="gpu").step(x0, x1)))


@pytest.mark.skipif(not hasattr(os, "fork"), reason="there is no fork")
@pytest.mark.filterwarnings("ignore::DeprecationWarning")
def test_a_fork_opens_a_gpu_of_its_own():
    # So many vertices that several threads copy them.
    mesh, _, x0, x1 = pieces(1500)
    try:
        inherited = [Session(mesh, device="gpu")]
        want = len(inherited[0].step(x0, x1))
    except RuntimeError as why:
        pytest.skip(str(why))
    context = multiprocessing.get_context("fork")
    queue = context.Queue()
    child = context.Process(target=on_a_gpu, args=(queue, inherited, mesh, x0, x1))
    child.start()
    try:
        assert queue.get(timeout=60) == want > 0
    finally:
        child.kill()
        child.join()


def test_geometry_of_what_is_undecided_is_that_of_the_first_contact():
    x0 = np.array([[2, 0, 0], [1, 1, 1], [2, 0, 2], [1, 1, 1]], float)
    x1 = np.array([[2, 2, 0], [1, 1, 0], [1, 2, 2], [1, 1, 1]], float)
    session = Session(Mesh([[0, 1, 2]], n_vertices=4), min_distance=1e-300)
    hit, report = session.first_contact(x0, x1), session.step(x0, x1)
    assert list(report.state) == [State.UNDECIDED]
    assert np.array_equal(report.geometry(x0, x1).normal[0], hit.normal)


def test_a_body_moves_once_in_a_step():
    session = Session(Mesh(FACES), bodies=BODIES)
    session.set_positions(X0)
    motion = (1, X0[4:], X1[4:])
    with pytest.raises(ValueError, match="body 1 has two motions"):
        session.step_bodies([motion, motion])
    with pytest.raises(ValueError, match="body 1 of x1 has 2 positions, and 3 vertices"):
        session.step_bodies([(1, X0[4:], X1[5:])])
    assert len(session.step_bodies([motion])) > 0
