"""The module as a user meets it: answers, arrays, errors, threads."""

import os
import sys
import threading
import time
import tracemalloc

import numpy as np
import pytest

import meshccd
from meshccd import (
    Bodies,
    BroadPhase,
    Kind,
    Mesh,
    Session,
    State,
    distance,
    edge_edge,
    read_mesh,
    read_positions,
    vertex_edge,
    vertex_face,
    vertex_vertex,
)

FACES = [[0, 1, 2], [2, 1, 3], [4, 5, 6]]
X0 = np.array(
    [[0, 0, 0], [1, 0, 0], [0, 0, 1], [1, 0, 1], [0.3, 0.5, 0.3], [0.2, 2, 0.3], [0.4, 2, 0.3]]
)
X1 = X0 - np.where(X0[:, 1:2] > 0, [0.0, 1.0, 0.0], 0.0)


def soup(n, seed=1):
    """Triangles anywhere in a unit cube, with motion."""
    random = np.random.default_rng(seed)
    centre = np.repeat(random.random((n, 3)), 3, axis=0)
    x0 = centre + 0.1 * random.random((3 * n, 3))
    return np.arange(3 * n).reshape(n, 3), x0, x0 + 0.05 * random.random((3 * n, 3))


def test_a_vertex_falls_onto_a_square():
    session = Session(Mesh(FACES))
    report = session.step(X0, X1)
    assert len(report) == 1 and report.kind[0] == Kind.VERTEX_FACE
    assert (report.a[0], report.b[0], report.state[0]) == (4, 0, State.HIT)
    assert 0.5 - 1e-6 < report.toi[0] <= 0.5 and report.earliest_toi == report.toi[0]
    assert report.vertices.tolist() == [[4, 0, 1, 2]]
    assert report.contacts.dtype.names == ("kind", "a", "b", "toi", "state")
    assert report.contacts[0].item() == (0, 4, 0, report.toi[0], 1)
    assert report.times["total"] > 0 and report.n_candidates[0] >= 1 and report.n_undecided == 0
    assert session.collision_free_stepsize(X0, X1) == report.toi[0]
    assert not session.is_step_collision_free(X0, X1)
    assert session.is_step_collision_free(X0, X0) and session.earliest_toi(X0, X0) is None
    assert session.collision_free_stepsize(X0, X0) == 1.0
    assert len(session.step(X0, X0)) == 0 and repr(session.step(X0, X0)) == "<Report: no contact>"
    assert "1 contacts" in repr(report) and "7 vertices" in repr(session)


def test_a_mesh_has_edges_of_its_own():
    mesh = Mesh(np.array(FACES, np.int64), edges=[[7, 5]])
    assert mesh.n_vertices == 8
    assert mesh.edges.tolist() == [
        [0, 1], [0, 2], [1, 2], [1, 3], [2, 3], [4, 5], [4, 6], [5, 6], [5, 7],
    ]  # fmt: skip
    assert mesh.faces.tolist() == FACES and mesh.faces.dtype == np.uint32
    assert Mesh([], n_vertices=3).n_vertices == 3 and Mesh([]).faces.shape == (0, 3)
    assert repr(mesh) == "<Mesh of 8 vertices, 9 edges, 3 faces>"


def test_bodies_choose_pairs():
    mesh, bodies = Mesh(FACES), [0, 0, 0, 0, 1, 1, 1]
    found = lambda **options: len(Session(mesh, bodies=bodies, **options).step(X0, X1))
    assert found() == 1 and found(self_contact=False) == 1
    assert found(fixed=[True, False]) == 1
    with pytest.raises(ValueError, match="vertex 4 moves, and its body is fixed"):
        found(fixed=np.array([True, True]))
    one = Session(mesh, bodies=np.zeros(7, np.uint8), self_contact=False)
    assert one.is_step_collision_free(X0, X1)


def test_distance_is_kept():
    toi = Session(Mesh(FACES), min_distance=0.25).earliest_toi(X0, X1)
    assert 0.25 - 1e-6 < toi <= 0.25


def test_threads_give_one_result():
    faces, x0, x1 = soup(400)
    one, two = (Session(Mesh(faces), threads=n).step(x0, x1).contacts for n in (1, 2))
    assert len(one) > 20 and np.array_equal(one, two)
    assert Session(Mesh(faces), threads=2).place == "2 threads"


def test_candidates_are_of_every_kind():
    """Of triangles, rods and particles: every pair whose swept boxes overlap, by brute force."""
    random = np.random.default_rng(4)
    faces, rods = np.arange(90).reshape(30, 3), np.arange(90, 150).reshape(30, 2)
    x0 = random.random((200, 3))
    x0[:90] = np.repeat(x0[:90:3], 3, axis=0) + 0.2 * random.random((90, 3))
    x1 = x0 + 0.3 * random.random((200, 3))
    mesh = Mesh(faces, edges=rods, n_vertices=200)
    edges, particles = mesh.edges.tolist(), list(range(150, 200))

    def boxes(features):
        x = [np.concatenate([x0[list(of)], x1[list(of)]]) for of in features]
        return np.array([p.min(axis=0) for p in x]), np.array([p.max(axis=0) for p in x])

    def overlapping(a, b, of_a, of_b):
        (low, high), (low_b, high_b) = boxes(a), boxes(b)
        hit = (low[:, None] <= high_b[None]) & (low_b[None] <= high[:, None])
        pairs = np.argwhere(hit.all(axis=2)).tolist()
        return {(of_a[i], of_b[j]) for i, j in pairs if not set(a[i]) & set(b[j])}

    vertices, thin = [[v] for v in range(200)], [i for i, e in enumerate(edges) if e[0] >= 90]
    ids, rods, alone = range(len(edges)), [edges[i] for i in thin], vertices[150:]
    want = [
        overlapping(vertices, mesh.faces.tolist(), range(200), range(30)),
        {(i, j) for i, j in overlapping(edges, edges, ids, ids) if i < j},
        overlapping(alone, rods, particles, thin),
        {(i, j) for i, j in overlapping(alone, alone, particles, particles) if i < j},
    ]
    session = Session(mesh)
    found = session.candidates(x0, x1)
    assert len(found) == 4
    for pairs, of_kind in zip(found, want):
        assert len(pairs) == len(of_kind) > 2 and {tuple(p) for p in pairs.tolist()} == of_kind
    assert session.step(x0, x1).n_candidates == tuple(len(of_kind) for of_kind in want)


def check_boxes(*methods):
    low = np.random.default_rng(2).random((300, 3))
    boxes = np.stack([low, low + 0.1], axis=1)
    hit = ((low[:, None] <= boxes[None, :, 1]) & (low[None] <= boxes[:, None, 1])).all(axis=2)
    want = {(i, j) for i, j in np.argwhere(hit).tolist() if i < j}
    for method in methods:
        broad = BroadPhase(method=method)
        pairs = broad.self_pairs(boxes)
        assert len(pairs) == len(want) and {tuple(p) for p in pairs.tolist()} == want
        assert len(broad.pairs(boxes, boxes)) == hit.sum()
        single = boxes.astype(np.float32)
        assert {tuple(p) for p in broad.self_pairs(np.asfortranarray(single)).tolist()} == {
            tuple(p) for p in broad.self_pairs(single).tolist()
        }
    assert len(broad.self_pairs(boxes[:1])) == 0


def test_boxes_overlap():
    check_boxes("blocks", "tree")


def test_boxes_overlap_by_every_method(catalogue):
    check_boxes("sweep-and-prune", "brute-force")


def test_queries_keep_their_shape():
    v = X0[[4, 0, 1, 2]], X1[[4, 0, 1, 2]]
    state, toi = vertex_face(*v)
    assert state.shape == toi.shape == () and state == State.HIT and 0.5 - 1e-6 < toi <= 0.5
    many = [np.broadcast_to(x, (5, 2, 4, 3)) for x in v]
    state, toi = vertex_face(*many)
    assert state.shape == (5, 2) and (toi == toi[0, 0]).all() and (state == State.HIT).all()
    state, toi = vertex_face(v[0], v[0])
    assert state == State.MISS and np.isinf(toi)
    assert vertex_face(*v, min_distance=0.25)[1] < 0.251
    a = np.array([[0, 0, 0], [1, 0, 0], [0.5, 1, -1], [0.5, 1, 1]], np.float32)
    state, toi = edge_edge(a, a - np.array([[0], [0], [2], [2]]) * [0, 1, 0])
    assert state == State.HIT and 0.5 - 1e-6 < toi <= 0.5


NAN = X0.copy()
NAN[3, 1] = np.nan


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: Mesh([[0, 1, 7]], n_vertices=7), "face 0 refers to vertex 7"),
        (lambda: Mesh([[0, 1, -1]]), "faces has the entry -1"),
        (lambda: Mesh([[0.0, 1.0, 2.0]]), "faces is an array of float64, not of integers"),
        (lambda: Mesh([[0, 1]]), r"faces has the shape \(1, 2\); it must be \(n, 3\)"),
        (lambda: Session(Mesh(FACES), min_distance=-1.0), "-1"),
        (lambda: Session(Mesh(FACES), device="tpu"), "tpu"),
        (lambda: Session(Mesh(FACES), fixed=[True]), "give bodies"),
        (lambda: Session(Mesh(FACES), bodies=[0, 0]), "2"),
        (lambda: Session(Mesh(FACES), bodies=[0, 1, 0, 0, 0, 0, 0]), "face 0"),
        (lambda: Session(Mesh(FACES), threads=100_000), "100000"),
        (lambda: Session(Mesh(FACES)).step(X0, X1[1:]), "x1 has 6 vertices"),
        (lambda: Session(Mesh(FACES), method="magic"), "method is 'magic'|brute-force"),
        (lambda: Session(Mesh(FACES), method="blocks", builder="ploc"), "builder is for"),
        (lambda: Session(Mesh(FACES), tolerance=0.0), "tolerance"),
        (lambda: Session(Mesh(FACES)).step(X0, X1, (0.5, 0.25)), "0.5"),
        (lambda: Session(Mesh(FACES)).step_bodies([]), "positions"),
        (lambda: Bodies([0, 0, 1, 1], fixed=[0]), "fixed is not an array of bool"),
        (lambda: Bodies([0, 0, 1, 1], self_contact=0), "self_contact is not an array of bool"),
        (lambda: Bodies.of_obstacles([0, 1]), "is_static is not an array of bool"),
        (lambda: distance(4, X0[:4]), "kind is 4"),
        (lambda: distance(Kind.VERTEX_EDGE, X0[:4]), r"it must be \(\.\., 3, 3\)"),
        (lambda: read_mesh("nowhere.obj"), "nowhere.obj"),
        (lambda: Session(Mesh(FACES)).step(X0[:, :2], X1[:, :2]), r"it must be \(\.\., 3\)"),
        (lambda: Session(Mesh(FACES)).step(X0[0], X1[0]), r"it must be \(n, 3\)"),
        (lambda: Session(Mesh(FACES)).step(X0, NAN), "vertex 3 of x1 has y = NaN"),
        (lambda: Session(Mesh(FACES)).step(X0.astype(complex), X1), "complex128"),
        (lambda: Session(Mesh(FACES)).step("x", X1), "shape"),
        (lambda: Session(Mesh(FACES)).step(np.ma.masked_less(X0, 0), X1), "x0 is a masked array"),
        (lambda: BroadPhase(method="magic"), "brute-force"),
        (lambda: BroadPhase(device="auto"), "device"),
        (lambda: BroadPhase().self_pairs([[[1, 0, 0], [0, 1, 1]]]), "box 0"),
        (lambda: vertex_face(X0[:4], X1[:3]), "shape"),
        (lambda: vertex_face(X0[:4], NAN[:4]), "vertex 3 of x1 has y = NaN"),
        (lambda: vertex_face(X0[:4], X1[:4], -1.0), "-1"),
    ],
)
def test_refusals_say_what_and_where(call, words):
    with pytest.raises(ValueError, match=words):
        call()


def test_what_is_no_value_is_a_type_error():
    with pytest.raises(TypeError, match=r"Bodies\(\) got an unexpected .* 'fixd'"):
        Bodies([0, 0], fixd=[True])
    with pytest.raises(TypeError, match="filter must be a function"):
        Session(Mesh(FACES)).set_filter(3)


def test_a_session_survives_bad_input():
    session = Session(Mesh(FACES))
    want = session.step(X0, X1).contacts
    with pytest.raises(ValueError):
        session.step(X0, NAN)
    assert np.array_equal(session.step(X0, X1).contacts, want)


def test_memory_is_limited():
    faces, x0, x1 = soup(400)
    with pytest.raises(ValueError, match="the limit of 1000 bytes would be exceeded"):
        Session(Mesh(faces), max_memory=1000)
    want = Session(Mesh(faces), threads=1).step(x0, x1).contacts
    roomy = Session(Mesh(faces), threads=1, max_memory=2**31)
    assert np.array_equal(roomy.step(x0, x1).contacts, want)


def test_a_gpu_is_there_or_said_not_to_be():
    try:
        session = Session(Mesh(FACES), device="gpu")
    except RuntimeError as why:
        if os.environ.get("CCD_GPU") == "require":
            raise
        pytest.skip(str(why))
    assert session.step(X0, X1).contacts["a"].tolist() == [4]
    assert "threads" not in session.place
    boxes = np.array([[[0, 0, 0], [1, 1, 1]], [[1, 1, 1], [2, 2, 2]]], np.float32)
    broad = BroadPhase(device="gpu")
    assert broad.self_pairs(boxes).tolist() == [[0, 1]] and len(broad.pairs(boxes, boxes)) == 4
    with pytest.raises(ValueError, match="float32"):
        broad.self_pairs(boxes.astype(np.float64))


@pytest.mark.parametrize("kind", [np.float32, np.float64])
def test_c_order_is_not_copied_and_fortran_order_is(kind):
    """NumPy reports every array that it allocates, also those made for us. Points that stand still:
    nothing is found."""
    n = 100_000
    x = np.random.default_rng(3).random((n, 3)).astype(kind)
    session = Session(Mesh([], n_vertices=n), threads=1)

    def peak(*frames):
        tracemalloc.start()
        session.is_step_collision_free(*frames)
        _, peak = tracemalloc.get_traced_memory()
        tracemalloc.stop()
        return peak

    assert peak(x, x) < x.nbytes / 100
    column = np.asfortranarray(x)
    assert column.flags.contiguous is False and peak(x, column) >= x.nbytes
    every_other = np.repeat(x, 2, axis=0)[::2]
    assert np.array_equal(x, every_other) and peak(x, every_other) >= x.nbytes


def test_transposed_numbers_are_not_taken_for_rows():
    """Three vertices in Fortran order: the same buffer read by rows is another triangle."""
    faces, x0, x1 = soup(200)
    session = Session(Mesh(faces))
    want = session.step(x0, x1).contacts
    assert np.array_equal(session.step(*map(np.asfortranarray, (x0, x1))).contacts, want)
    as_if = [np.asfortranarray(x).ravel(order="K").reshape(-1, 3) for x in (x0, x1)]
    assert not np.array_equal(session.step(*as_if).contacts, want)


def longest_pause(work):
    """How long another thread stood still during the work, as a part of the time that it took."""
    stamps, done = [], threading.Event()

    def watch():
        while not done.is_set():
            stamps.append(time.perf_counter())

    watcher = threading.Thread(target=watch)
    watcher.start()
    while not stamps:
        time.sleep(0.001)
    start = time.perf_counter()
    work()
    end = time.perf_counter()
    done.set()
    watcher.join()
    inside = [start, *(t for t in stamps if start < t < end), end]
    return np.diff(inside).max() / (end - start)


def test_the_interpreter_is_released():
    faces, x0, x1 = soup(6_000)
    session = Session(Mesh(faces), threads=1)
    # A machine that is busy may stop any thread, and begin late; the least of several says more.
    least = lambda work: min(longest_pause(work) for _ in range(5))
    numbers = np.random.default_rng(4).random(300_000).tolist()
    released, held = least(lambda: session.step(x0, x1)), least(lambda: sorted(numbers))
    assert released < 0.5 < held, (released, held)


def test_threads_of_python_share_a_session():
    faces, x0, x1 = soup(300)
    session, found = Session(Mesh(faces)), []
    want = session.step(x0, x1).contacts
    call = lambda: found.append(session.step(x0, x1).contacts)
    threads = [threading.Thread(target=call) for _ in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(found) == 8 and all(np.array_equal(f, want) for f in found)


def test_arrays_outlive_what_made_them():
    faces, x0, x1 = soup(300)
    report = Session(Mesh(faces)).step(x0, x1)
    toi, before = report.toi, report.toi.copy()
    del report
    np.zeros(100_000)
    assert np.array_equal(toi, before) and sys.getrefcount(toi) <= 3


def test_everything_is_documented():
    for name in meshccd.__all__:
        thing = getattr(meshccd, name)
        if name != "__version__":
            assert thing.__doc__, name
    for of in (Mesh, Bodies, Session, meshccd.Report, meshccd.Geometry, meshccd.Hit, BroadPhase):
        for name, member in vars(of).items():
            assert name.startswith("__") or member.__doc__, f"{of.__name__}.{name}"


def test_integers_that_float64_rounds_are_refused():
    far = 2**53
    session, x = Session(Mesh(FACES)), np.zeros((7, 3), np.int64)
    for kind, n in [(np.int64, far + 1), (np.int64, -far - 1), (np.uint64, far + 1)]:
        x = x.astype(kind)
        x[3, 1] = n
        with pytest.raises(ValueError, match=r"x1 has integers beyond 2\*\*53"):
            session.step(X0, x)
        x[3, 1] = far if n > 0 else -far
        session.step(X0, x)
