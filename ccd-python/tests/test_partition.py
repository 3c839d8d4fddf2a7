"""Parts of a scene against one process: the same contacts to the last bit, none twice."""

import json
import pickle

import numpy as np
import pytest
from crowds import crowd

from meshccd import Bodies, Kind, Mesh, Options, Session
from meshccd._local import Rules, whole_numbers
from meshccd.partition import ELEMENT, merge, split


def locals_of(mesh, x0, x1, n_parts, d=0.0, drop=lambda to, sent: sent):
    """The local meshes of all parts, as a transport would make them."""
    parts = split(mesh, x0, n_parts)
    ends = [(x0[part.vertices], x1[part.vertices]) for part in parts]
    boxes = [part.boxes(*of, d) for part, of in zip(parts, ends)]
    sent = [part.outgoing(*of, boxes, d) for part, of in zip(parts, ends)]
    to = [[drop(i, of[i]) for of in sent] for i in range(n_parts)]
    return [part.local(*of, to[i]) for i, (part, of) in enumerate(zip(parts, ends))]


def in_parts(mesh, x0, x1, n_parts, options=Options(), drop=lambda to, sent: sent):
    found = []
    for local in locals_of(mesh, x0, x1, n_parts, options.min_distance, drop):
        session = Session(local.mesh, local.options(options))
        found.append(local.contacts(session.step(local.x0, local.x1)))
    return found


def earliest_in_parts(mesh, x0, x1, n_parts, options):
    times = []
    for local in locals_of(mesh, x0, x1, n_parts, options.min_distance):
        times.append(local.earliest_toi(Session(local.mesh, local.options(options))))
    return min((toi for toi in times if toi is not None), default=None)


def check(mesh, x0, x1, n_parts, options=Options()):
    report = Session(mesh, options).step(x0, x1)
    want = report.contacts
    assert earliest_in_parts(mesh, x0, x1, n_parts, options) == report.earliest_toi
    found = in_parts(mesh, x0, x1, n_parts, options)
    assert sum(map(len, found)) == len(want), "a contact is lost, or found twice"
    assert np.array_equal(merge(found), want)
    # Each part's array is sorted by itself.
    assert all(np.array_equal(merge([of]), of) for of in found)
    return want


@pytest.mark.parametrize("n_parts", range(1, 8))
@pytest.mark.parametrize("seed", range(4))
def test_contacts_are_those_of_one_process(n_parts, seed):
    d = [0.0, 0.1][seed % 2]
    mesh, x0, x1 = crowd(60, seed, rods=20 * (seed // 2), particles=30 * (seed // 2))
    want = check(mesh, x0, x1, n_parts, Options(min_distance=d))
    assert len(want) > 200
    # Only a distance makes particles touch.
    assert len(set(want["kind"])) == (4 if seed == 3 else 2)


@pytest.mark.parametrize("n_parts", [1, 2, 3, 5, 7])
@pytest.mark.parametrize("seed", range(4))
def test_degenerate_faces_lose_nothing(n_parts, seed):
    d = [0.0, 0.1][seed % 2]
    mesh, x0, x1 = crowd(40, seed, rods=20, particles=30, degenerate=15)
    want = check(mesh, x0, x1, n_parts, Options(min_distance=d))
    flat = (mesh.faces == np.roll(mesh.faces, 1, axis=1)).any(axis=1)
    assert flat.sum() == 30 and len(set(want["kind"])) == (4 if d else 2)


@pytest.mark.parametrize(
    "faces, edges", [([[0, 1, 2], [2, 2, 1], [5, 6, 7]], [[3, 4]]), ([[0, 1, 2], [3, 3, 1]], [])]
)
def test_a_side_with_equal_corners_is_no_edge(faces, edges):
    """Neither the one that is sorted behind it, a rod, nor one behind the last."""
    mesh = Mesh(faces, edges or None)
    x = np.random.default_rng(0).random((mesh.n_vertices, 3))
    for n_parts in (1, 2, 3):
        parts = split(mesh, x, n_parts)
        assert sum(map(len, parts)) == len(faces) + len(edges)
        assert {v for part in parts for v in part.vertices} == set(range(mesh.n_vertices))
        check(mesh, x, x, n_parts)


def test_a_vertex_of_a_degenerate_face_is_no_particle():
    """A rod swings around its end 1, over the other end of its neighbour, 0. The part 1 has of that
    neighbour the face [0, 0, 0] alone."""
    mesh = Mesh([[0, 0, 0]], [[0, 1], [1, 2]])
    x0, x1 = (np.array([[1, 0, 0], [0, 0, 0], [3, y, 0.0]]) for y in (1, -1))
    options = Options(min_distance=0.01)
    assert Session(mesh, options).earliest_toi(x0, x1) is None
    assert len(check(mesh, x0, x1, 2, options)) == 0
    low, high = locals_of(mesh, x0, x1, 2, 0.01)
    session = Session(high.mesh, options)
    assert high.mesh.isolated_vertices.tolist() == [0]
    assert 0.4 < session.earliest_toi(high.x0, high.x1) < 0.5, "the test shows nothing"
    assert high.earliest_toi(session) is None
    assert low.earliest_toi(Session(low.mesh, options)) is None


@pytest.mark.parametrize("n_parts", [2, 5])
@pytest.mark.parametrize("degenerate", [0, 20])
def test_candidates_are_those_of_one_process(n_parts, degenerate):
    mesh, x0, x1 = crowd(60, 9, rods=20, particles=40, degenerate=degenerate)
    locals_ = locals_of(mesh, x0, x1, n_parts)
    listed = [Session(of.mesh).candidates(of.x0, of.x1) for of in locals_]
    order = lambda pairs: pairs[np.lexsort((pairs[:, 1], pairs[:, 0]))]
    for kind, want in enumerate(Session(mesh).candidates(x0, x1)):
        found = np.concatenate([of.owned(kind, pairs[kind]) for of, pairs in zip(locals_, listed)])
        assert np.array_equal(order(found), order(want)), Kind(kind)


def test_a_lost_halo_is_seen():
    """The negative control: without what other parts send, or a tenth of it, contacts are lost."""
    mesh, x0, x1 = crowd(60, 1)
    want = Session(mesh).step(x0, x1).contacts
    for drop in (lambda to, sent: sent[:0], lambda to, sent: sent[len(sent) // 10 :]):
        found = merge(in_parts(mesh, x0, x1, 4, drop=drop))
        assert len(found) < len(want) and set(found.tolist()) < set(want.tolist())


def test_touching_boxes_are_sent():
    """Comparisons are closed: a vertex that ends exactly on a face of another part, and one that
    stays exactly the distance away."""
    faces = [[0, 1, 2], [3, 4, 5]]
    x0 = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0.2, 0.2, 1], [0.3, 0.2, 2], [0.2, 0.3, 2.0]])
    x1 = x0.copy()
    x1[3:] -= [0, 0, 1]
    want = check(Mesh(faces), x0, x1, 2)
    assert len(want) > 0 and want["toi"].min() > 1 - 1e-5
    far = x0.copy()
    far[3:] -= [0, 0, 0.75]
    assert len(check(Mesh(faces), far, far, 2, Options(min_distance=0.25))) > 0
    assert len(check(Mesh(faces), far, far, 2, Options(min_distance=0.2499999))) == 0


@pytest.mark.parametrize("scale", [1e-30, 1e30])
def test_units_do_not_matter(scale):
    mesh, x0, x1 = crowd(30, 5)
    assert len(check(mesh, scale * x0, scale * x1, 3, Options(min_distance=0.01 * scale))) > 50


def test_bodies_keep_their_rules():
    mesh, x0, x1 = crowd(60, 2)
    components = Bodies.of_components(mesh).of_vertex
    n = components.max() + 1
    everything = check(mesh, x0, x1, 3)
    first = {kind: everything[everything["kind"] == kind][::3] for kind in (0, 1)}
    pairs = {kind: np.stack([of["a"], of["b"]], axis=1) for kind, of in first.items()}
    for rules in (
        {"self_contact": False},
        {"worlds": np.arange(n) % 3, "excluded_bodies": [[0, 1], [3, 9]]},
        {"memberships": np.arange(n) % 4, "filters": np.arange(n) % 3},
        {"excluded_vertex_face": pairs[0], "excluded_edge_edge": pairs[1]},
    ):
        bodies = Bodies(components, **rules)
        want = check(mesh, x0, x1, 4, Options(bodies=bodies))
        assert 0 < len(want) < len(everything), rules


def test_rules_that_are_read_once_follow_the_halo():
    mesh, x0, x1 = crowd(60, 2)
    components = Bodies.of_components(mesh).of_vertex
    pairs = np.indices((mesh.n_vertices, len(mesh.faces))).reshape(2, -1).T
    bodies = Bodies(components, excluded_vertex_face=pairs[::3], excluded_bodies=[[0, 1]])
    rules, made = Rules(json.loads(bodies.to_json())), []
    for local in locals_of(mesh, x0, x1, 3) + locals_of(mesh, x0, x0, 3):
        made.append(rules.bodies(local))
        assert made[-1] is rules.bodies(local) and made[-1] == local.bodies(bodies)
        v, f = len(local.vertices) // 2, len(local.faces) // 2
        excluded = bodies.excludes(Kind.VERTEX_FACE, local.vertices[v], local.faces[f])
        assert made[-1].excludes(Kind.VERTEX_FACE, v, f) == excluded
    assert all(one != other for one, other in zip(made, made[1:]))


def test_exact_mode_is_the_same():
    mesh, x0, x1 = crowd(40, 6)
    assert len(check(mesh, x0, x1, 3, Options(mode="exact"))) > 50


def test_parts_may_be_empty():
    mesh, x0, x1 = crowd(2, 0)
    assert [len(part) for part in split(mesh, x0, 6)] == [0, 1, 1, 0, 1, 1]
    check(mesh, x0, x1, 6)
    check(Mesh([]), np.zeros((0, 3)), np.zeros((0, 3)), 3)


@pytest.mark.parametrize("degenerate", [0, 20])
def test_every_feature_has_one_owner(degenerate):
    mesh, x0, x1 = crowd(50, 3, rods=10, particles=10, degenerate=degenerate)
    parts = split(mesh, x0, 5)
    assert sorted(np.concatenate([part.vertices for part in parts]).tolist()) != list(
        range(mesh.n_vertices)
    ), "no vertex is in two parts: the test shows nothing"
    for kind, n in ((Kind.VERTEX_VERTEX, mesh.n_vertices), (Kind.EDGE_EDGE, len(mesh.edges))):
        owned = []
        for local in locals_of(mesh, x0, x1, 5):
            ids = np.arange(len(local.vertices if kind == Kind.VERTEX_VERTEX else local.edges))
            owned.append(local.owned(kind, np.stack([ids, ids], axis=1))[:, 0])
        assert np.array_equal(np.sort(np.concatenate(owned)), np.arange(n)), kind
    part = pickle.loads(pickle.dumps(parts[1]))
    assert np.array_equal(part.vertices, parts[1].vertices) and "1 of 5" in repr(part)


def test_refusals_say_what_and_where():
    mesh = Mesh([[0, 1, 2], [2, 1, 3]])
    x = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0.0]])
    with pytest.raises(ValueError, match="n_parts is 0"):
        split(mesh, x, 0)
    with pytest.raises(ValueError, match=r"x has the shape \(3, 3\); there are 4 vertices"):
        split(mesh, x[:3], 2)
    low, high = split(mesh, x, 2)
    mine, yours = x[low.vertices], x[high.vertices]
    bad = yours.copy()
    bad[2, 1] = np.nan
    with pytest.raises(ValueError, match=r"x0\[2\] is \[.*nan.*finite"):
        high.boxes(bad, yours)
    with pytest.raises(ValueError, match="min_distance is -1"):
        high.boxes(yours, yours, -1)
    for at_most in (0, -3):
        with pytest.raises(ValueError, match=f"at_most is {at_most}; it must be at least 1"):
            high.boxes(yours, yours, at_most=at_most)
    sent = high.outgoing(yours, yours, [low.boxes(mine, mine), np.zeros((0, 2, 3))])
    assert [of.dtype for of in sent] == [ELEMENT] * 2 and [len(of) for of in sent] == [1, 0]
    assert low.local(mine, mine, sent).vertices.tolist() == [0, 1, 2, 3]
    sent[0]["x1"] += 1
    with pytest.raises(ValueError, match="vertex .* has two positions x1, in two parts"):
        low.local(mine, mine, sent)


@pytest.mark.parametrize(
    "dtype", ["i8", "u8", "i4", "?", "f2", "f4", ">f8", "g", "c16", "U4", "O", "m8[s]"]
)
def test_positions_are_those_that_a_session_takes(dtype):
    mesh = Mesh([[0, 1, 2]])
    (part,) = split(mesh, np.eye(3), 1)
    x = np.random.default_rng(0).integers(5, size=(3, 3)).astype(dtype)
    # Also integers around the first ones that float64 has not.
    wide = [x + (1 << 53), x - 5 + (1 << 53), -x - (1 << 54)] if dtype in ("i8", "u8") else []
    for given in (x, *wide):
        calls = (lambda: part.boxes(given, given), lambda: split(mesh, given, 1))
        try:
            Session(mesh).step(given, given)
        except ValueError as why:
            for name, call in zip(("x0", "x"), calls):
                with pytest.raises(ValueError) as other:
                    call()
                assert str(other.value) == str(why).replace("x0", name)
        else:
            for call in calls:
                call()


def test_errors_name_features_of_the_whole_mesh():
    n = 20
    mesh = Mesh(np.arange(3 * n).reshape(n, 3)[::-1], np.arange(3 * n, 5 * n).reshape(n, 2))
    x = np.random.default_rng(0).random((5 * n, 3)) + np.arange(5 * n)[:, None] / 9
    low, high = locals_of(mesh, x, x, 2)
    session = Session(high.mesh)
    at = len(high.vertices) - 1
    high.x1[at, 1] = 2e100
    with pytest.raises(ValueError, match=f"^vertex {high.vertices[at]} of x1 has y = 2000"):
        high.earliest_toi(session)
    with pytest.raises(ValueError, match="^x0 has .* vertices, the mesh has 100") as why:
        low.earliest_toi(Session(mesh))
    assert why.value.__cause__ is None
    for local, element in ((high, "face"), (low, "face"), (high, "edge"), (low, "edge")):
        ids = getattr(local, element + "s")
        (of_element,) = np.flatnonzero(ids == ids.max())
        bodies = np.zeros(len(local.vertices), int)
        bodies[getattr(local.mesh, element + "s")[of_element][-1]] = 1
        with pytest.raises(ValueError, match=f"^{element} {ids.max()} joins vertices of bodies 0"):
            with whole_numbers(local):
                Session(local.mesh, bodies=bodies)


def test_a_real_scene_in_four_parts(cloth_ball):
    """The whole of a step that has over a hundred thousand contacts."""
    scene = cloth_ball
    assert len(check(scene.mesh, scene.x0, scene.x1, 4)) == 113_854
