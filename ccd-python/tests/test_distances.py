"""Every kind of pair that keeps a distance, particles and rods too, against ipctk's additive CCD.

Theirs stops a share of the way before the distance is reached, ours at most a millionth of the step
before: so the pairs are the same, theirs is never later, and the distance at our time, which numpy
measures, is the one asked for.
"""

import ipctk
import numpy as np
import pytest

from meshccd import Kind, Mesh, Session, State

DISTANCE = 0.05
# What theirs leaves of the distance, as a share of it.
LEFT = 1e-4


def scene(seed):
    """Particles, rods and triangles in a unit cube, which move by about a third of it."""
    random = np.random.default_rng(seed)
    count = {"particles": 120, "rods": 12, "triangles": 8}
    size = np.repeat([0, 1, 2], [count["particles"], 2 * count["rods"], 3 * count["triangles"]])
    centres = [random.random((n, 3)) for n in count.values()]
    x0 = np.concatenate([np.repeat(c, 1 + i, axis=0) for i, c in enumerate(centres)])
    x0 += 0.2 * (size > 0)[:, None] * random.standard_normal(x0.shape)
    x1 = x0 + 0.3 * random.standard_normal(x0.shape)
    ids = np.arange(len(x0))
    mesh = Mesh(ids[size == 2].reshape(-1, 3), edges=ids[size == 1].reshape(-1, 2))
    return mesh, x0, x1, count["particles"]


def pairs(mesh, particles):
    """All pairs of features without a vertex in common that can be in contact, with their vertices:
    particles with rods and with each other, vertices with faces, edges with edges."""
    faces, edges = mesh.faces.tolist(), mesh.edges.tolist()
    of_faces = {tuple(sorted(pair)) for a, b, c in faces for pair in ((a, b), (b, c), (c, a))}
    rods = [e for e, edge in enumerate(edges) if tuple(sorted(edge)) not in of_faces]
    assert len(rods) == 12
    for v in range(particles):
        yield from ((Kind.VERTEX_VERTEX, v, w, (v, w)) for w in range(v + 1, particles))
        yield from ((Kind.VERTEX_EDGE, v, e, (v, *edges[e])) for e in rods)
    for v in range(mesh.n_vertices):
        for f, face in enumerate(faces):
            if v not in face:
                yield Kind.VERTEX_FACE, v, f, (v, *face)
    for a, of_a in enumerate(edges):
        for b in range(a + 1, len(edges)):
            if not set(of_a) & set(edges[b]):
                yield Kind.EDGE_EDGE, a, b, (*of_a, *edges[b])


def theirs(kind, x0, x1):
    """Whether there is a contact, and when, by ipctk."""
    accd = ipctk.AdditiveCCD(conservative_rescaling=1 - LEFT)
    ask = {
        Kind.VERTEX_FACE: accd.point_triangle_ccd,
        Kind.EDGE_EDGE: accd.edge_edge_ccd,
        Kind.VERTEX_EDGE: accd.point_edge_ccd,
        Kind.VERTEX_VERTEX: accd.point_point_ccd,
    }
    return ask[kind](*x0, *x1, DISTANCE)


def distance(kind, x):
    """The distance of two features, by ipctk."""
    ask = {
        Kind.VERTEX_FACE: ipctk.point_triangle_distance,
        Kind.EDGE_EDGE: ipctk.edge_edge_distance,
        Kind.VERTEX_EDGE: ipctk.point_edge_distance,
        Kind.VERTEX_VERTEX: ipctk.point_point_distance,
    }
    return np.sqrt(ask[kind](*x))


def compare(report, mesh, x0, x1, particles):
    """Compares all pairs; returns contacts of each kind, and how many began in contact."""
    contacts = zip(report.kind, report.a, report.b, report.toi)
    ours = {(kind, a, b): toi for kind, a, b, toi in contacts}
    found, at_start = dict.fromkeys(Kind, 0), 0
    for kind, a, b, vertices in pairs(mesh, particles):
        of = list(vertices)
        hit, no_later_than = theirs(kind, x0[of], x1[of])
        toi = ours.pop((kind, a, b), None)
        assert (toi is not None) == hit, (kind, a, b, toi, no_later_than)
        if not hit:
            continue
        found[kind] += 1
        fastest = 2 * np.linalg.norm(x1[of] - x0[of], axis=1).max()
        at = distance(kind, x0[of] + toi * (x1[of] - x0[of]))
        if toi == 0:
            at_start += 1
            assert at <= DISTANCE + 1e-6 * fastest
        else:
            # Not later than the distance is reached, and not much before.
            assert DISTANCE - 1e-12 <= at <= DISTANCE + 1e-6 * fastest, (kind, a, b, toi, at)
            assert no_later_than <= toi + 1e-6, (kind, a, b, toi, no_later_than)
    assert not ours
    return found, at_start


@pytest.fixture(autouse=True)
def quiet():
    ipctk.set_logger_level(ipctk.LoggerLevel.error)


def test_contacts_at_a_distance_are_those_of_ipctk():
    total, started = dict.fromkeys(Kind, 0), 0
    for seed in range(8):
        mesh, x0, x1, particles = scene(seed)
        report = Session(mesh, min_distance=DISTANCE).step(x0, x1)
        assert (report.state == State.HIT).all()
        found, at_start = compare(report, mesh, x0, x1, particles)
        total = {kind: n + found[kind] for kind, n in total.items()}
        started += at_start
    assert min(total.values()) > 20 and 0 < started < sum(total.values()) / 2, (total, started)


def test_a_wrong_distance_is_seen():
    mesh, x0, x1, particles = scene(0)
    for wrong in (0.99 * DISTANCE, 1.01 * DISTANCE):
        with pytest.raises(AssertionError):
            compare(Session(mesh, min_distance=wrong).step(x0, x1), mesh, x0, x1, particles)
