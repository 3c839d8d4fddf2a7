"""Exact queries against fractions, arrays of other libraries, batches, files of queries."""

import importlib.util
from fractions import Fraction
from multiprocessing import get_context

import numpy as np
import pytest
from test_api import FACES, X0, X1
from test_sessions import same

from meshccd import Kind, Mesh, Session, State, exact, read_mesh, read_positions, read_queries
from meshccd import edge_edge, vertex_face

FACE = np.array([[0.0, 0, 0], [1, 0, 0], [0, 0, 1]])
LEAST = 5e-324


def falling(x, from_y, to_y):
    """A vertex at (x, y, 0) that falls onto the edge of a face."""
    return [np.concatenate([[[x, y, 0.0]], FACE]) for y in (from_y, to_y)]


def test_a_vertex_hits_a_face_at_an_exact_time():
    random = np.random.default_rng(5)
    for from_y, to_y in random.random((50, 2)):
        x0, x1 = falling(0.25, from_y, -to_y)
        state, toi = exact.vertex_face(x0, x1)
        want = Fraction(from_y) / (Fraction(from_y) + Fraction(to_y))
        assert state == State.HIT and toi.shape == (2,)
        assert Fraction(toi[0]) <= want <= Fraction(toi[1]) and np.ptp(toi) < 1e-15
        assert exact.vertex_face(x0, x1, (0.0, toi[1]))[0] == State.HIT
        assert exact.vertex_face(x0, x1, (0.0, toi[0] * 0.99))[0] == State.MISS
        beside = exact.vertex_face(*falling(-LEAST, from_y, -to_y))
        assert beside[0] == State.MISS and np.isinf(beside[1]).all()
        # Which is not certain in floating point.
        assert vertex_face(*falling(-LEAST, from_y, -to_y))[0] == State.UNDECIDED


def test_other_kinds_and_shapes():
    x0 = np.array([[0.0, 1, 0], [-1, 0, 0], [1, 0, 0]])
    x1 = x0 - [[0, 3, 0], [0, 0, 0], [0, 0, 0]]
    state, toi = exact.vertex_edge(np.stack([x0, x0]), np.stack([x1, x0]))
    assert state.tolist() == [State.HIT, State.MISS] and toi.shape == (2, 2)
    assert toi[0, 0] <= Fraction(1, 3) <= toi[0, 1]
    state, toi = exact.vertex_vertex([[0.0, 0, 0], [3, 0, 0]], [[1.0, 0, 0], [1, 0, 0]])
    assert state == State.HIT and toi.tolist() == [1, 1]
    a = np.array([[0, 0, 0], [1, 0, 0], [0.5, 1, -1], [0.5, 1, 1]], np.float32)
    state, toi = exact.edge_edge(a, a - np.array([[0], [0], [2], [2]]) * [0, 1, 0])
    assert state == State.HIT and toi.tolist() == [0.5, 0.5]
    assert edge_edge(a, a)[0] == State.MISS == exact.edge_edge(a, a)[0]
    for window in [(0.5, 0.25), (-1, 1), (0, np.nan)]:
        with pytest.raises(ValueError, match="in order"):
            exact.vertex_face(*falling(0, 1, -1), window)
    with pytest.raises(ValueError, match="vertex 0 of x1 has y = NaN"):
        exact.vertex_face(*falling(0, 1, np.nan))


class OfAnotherLibrary:
    """An array as PyTorch or JAX hands it out; `device` 2 is CUDA."""

    def __init__(self, array, device=(1, 0)):
        self.array, self.device, self.n_asked = array, device, 0

    def __dlpack__(self, **how):
        self.n_asked += 1
        if self.device != (1, 0):
            raise BufferError("the tensor is not on the CPU")
        return self.array.__dlpack__(**how)

    def __dlpack_device__(self):
        return self.device


def test_arrays_of_other_libraries_are_read_by_dlpack():
    session = Session(Mesh(OfAnotherLibrary(np.array(FACES))))
    want = Session(Mesh(FACES)).step(X0, X1)
    x0, x1 = OfAnotherLibrary(X0.copy()), OfAnotherLibrary(X1.copy())
    assert same(session.step(x0, x1), want) and x0.n_asked == x1.n_asked == 1
    # Nothing is copied: NumPy shares the memory of C order.
    x1.array[:] = X0
    assert len(session.step(x0, x1)) == 0
    x0, x1 = (OfAnotherLibrary(np.asfortranarray(x, np.float32)) for x in (X0, X1))
    assert len(session.step(x0, x1)) == 1
    with pytest.raises(ValueError, match="x1 cannot be read by DLPack"):
        session.step(X0, OfAnotherLibrary(X1, (2, 0)))


def step_arrays_of(library, made_by):
    make = getattr(importlib.import_module(library), made_by)
    want = Session(Mesh(FACES)).step(X0.astype(np.float32), X1.astype(np.float32))
    x0, x1 = make(X0.tolist()), make(X1.tolist())
    session = Session(Mesh(make(FACES)))
    assert len(want) == 1 and same(session.step(x0, x1), want)
    assert same(session.step_many([x0, x1])[0], want)


@pytest.mark.parametrize("library, made_by", [("jax.numpy", "array"), ("torch", "tensor")])
def test_arrays_of_jax_and_pytorch(library, made_by):
    package = library.partition(".")[0]
    if importlib.util.find_spec(package) is None:
        pytest.skip(f"there is no package {package}")
    # In a process of its own: JAX has threads, and warns of every fork from then on.
    process = get_context("spawn").Process(target=step_arrays_of, args=(library, made_by))
    process.start()
    process.join()
    assert process.exitcode == 0


def test_many_steps_are_those_one_by_one():
    frames = np.stack([X0, X0, X1, X1 - 1])
    one = Session(Mesh(FACES))
    want = [one.step(a, b) for a, b in zip(frames, frames[1:])]
    assert len(want[1]) == 1 and len(want[0]) == 0
    for given in (frames, list(frames), (x for x in frames)):
        found = Session(Mesh(FACES)).step_many(given)
        assert len(found) == 3 and all(same(a, b) for a, b in zip(found, want))
    assert Session(Mesh(FACES)).step_many([]) == [] == one.step_many(frames[:1])
    with pytest.raises(ValueError, match="x1 has 6 vertices"):
        one.step_many([X0, X1[1:]])


def test_vertices_of_pairs():
    mesh = Mesh(FACES, n_vertices=8)
    assert mesh.isolated_vertices.tolist() == [7]
    assert mesh.vertices_of(Kind.VERTEX_FACE, [[7, 1]]).tolist() == [[7, 2, 1, 3]]
    edges = mesh.vertices_of(Kind.EDGE_EDGE, [[0, 4], [1, 2]])
    assert np.array_equal(edges, mesh.edges[[[0, 4], [1, 2]]].reshape(2, 4))
    with pytest.raises(ValueError, match=r"the entry \[7, 3\]; there are 8 and 3"):
        mesh.vertices_of(Kind.VERTEX_FACE, [[0, 2], [7, 3]])


def test_parts_of_files(tmp_path):
    x = np.random.default_rng(6).random((5, 4, 3))
    np.save(tmp_path / "x.npy", x)
    assert np.array_equal(read_positions(tmp_path / "x.npy", (1, 3)), x[1:3])
    with pytest.raises(ValueError, match="frames from 1 to 6 of 5"):
        read_positions(tmp_path / "x.npy", (1, 6))

    def stl(name, gap):
        """Two triangles at a distance."""
        lines = ["solid"]
        for z in (0, gap):
            lines += ["facet normal 0 0 1", "outer loop"]
            lines += [f"vertex {a} {b} {z}" for a, b in ((0, 0), (1, 0), (0, 1))]
            lines += ["endloop", "endfacet"]
        (tmp_path / name).write_text("\n".join([*lines, "endsolid"]))
        return tmp_path / name

    first, later = stl("0.stl", 1), stl("1.stl", 0)
    assert read_mesh(later)[0].n_vertices == 3
    mesh, x = read_mesh(later, first)
    assert mesh.n_vertices == 6 and np.array_equal(mesh.faces, read_mesh(first)[0].faces)


def test_queries_are_read(tmp_path):
    x0, x1 = falling(0.25, 1, -2)
    rows = [",".join(f"{int(4 * c)},4" for c in p) + ",1" for p in np.concatenate([x0, x1])]
    (tmp_path / "vf.csv").write_text("\n".join(rows) + "\n")
    kind, t0, t1, answers = read_queries(tmp_path / "vf.csv")
    assert kind.tolist() == [Kind.VERTEX_FACE] and answers.tolist() == [True]
    assert np.array_equal(t0[0], x0) and np.array_equal(t1[0], x1)
    assert exact.vertex_face(t0, t1)[0].tolist() == [State.HIT]
    assert read_queries(tmp_path / "vf.csv", Kind.EDGE_EDGE)[0].tolist() == [Kind.EDGE_EDGE]
    with pytest.raises(ValueError, match="nowhere"):
        read_queries("nowhere-vf.csv")
