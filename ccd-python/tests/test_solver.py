"""What a solver takes beside contacts, against ipctk: squared distances with derivatives, sets of
candidates and their step sizes, filters, and whether a mesh goes through itself."""

import ipctk
import numpy as np
import pytest

import meshccd
from meshccd import Bodies, EdgeEdgeType, Kind, Mesh, Session, VertexFaceType

THEIRS = {
    Kind.VERTEX_FACE: "point_triangle_distance",
    Kind.EDGE_EDGE: "edge_edge_distance",
}


def crumpled(seed, n=12):
    """A grid of n x n squares, which a step crumples, a second one above it, and their mesh."""
    random = np.random.default_rng(seed)
    corner = np.arange(n * (n + 1)).reshape(n, n + 1)[:, :n].ravel()
    right, up = corner + 1, corner + n + 1
    square = np.stack([corner, right, up, up, right, up + 1], axis=1).reshape(-1, 3)
    flat = np.stack(np.meshgrid(np.arange(n + 1), [0.0], np.arange(n + 1)), axis=-1)
    flat = flat.reshape(-1, 3) / n + 1e-3 * random.standard_normal(((n + 1) ** 2, 3))
    x0 = np.concatenate([flat, flat[:, [2, 1, 0]] + [0.03, 0.08, 0.01]])
    faces = np.concatenate([square, square[:, ::-1] + (n + 1) ** 2])
    x1 = x0 + 0.06 * random.standard_normal(x0.shape)
    return Mesh(faces), x0, x1


def theirs(mesh, x0, x1):
    x0, x1 = (np.asfortranarray(x) for x in (x0, x1))
    edges, faces = mesh.edges.astype(np.int32), mesh.faces.astype(np.int32)
    return ipctk.CollisionMesh(x0, edges, faces), x0, x1


def rows(pairs):
    return {tuple(pair) for pair in np.asarray(pairs).tolist()}


def listed(candidates):
    """Their pairs as ours: vertex and face; two edges, the lesser first."""
    vf = {(c.vertex_id, c.face_id) for c in candidates.fv_candidates}
    ee = {tuple(sorted((c.edge0_id, c.edge1_id))) for c in candidates.ee_candidates}
    return vf, ee


@pytest.mark.parametrize("kind", THEIRS)
def test_derivatives_are_those_of_ipctk(kind):
    random = np.random.default_rng(kind)
    x = random.standard_normal((4000, 4, 3))
    types = meshccd.distance_type(kind, x)
    name = THEIRS[kind]
    type_of = getattr(ipctk, f"{name}_type")
    seen = np.bincount(types)
    assert len(seen) == len((VertexFaceType, EdgeEdgeType)[kind]) and seen.min() > 20
    value = meshccd.squared_distance(kind, x)
    gradient = meshccd.squared_distance_gradient(kind, x)
    hessian = meshccd.squared_distance_hessian(kind, x)
    assert (value.shape, gradient.shape, hessian.shape) == ((4000,), (4000, 12), (4000, 12, 12))
    for i in range(len(x)):
        assert int(type_of(*x[i])) == types[i]
        for ours, suffix in ((value, ""), (gradient, "_gradient"), (hessian, "_hessian")):
            want = getattr(ipctk, name + suffix)(*x[i])
            scale = np.abs(want).max()
            assert np.abs(ours[i] - want).max() <= 1e-8 * max(scale, 1), (i, suffix, types[i])
    least, greatest = meshccd.distance(kind, x)
    root = np.sqrt(value)
    assert (root >= least - 1e-12).all() and (root <= greatest + 1e-12).all()


@pytest.mark.parametrize("kind", THEIRS)
def test_every_type_is_that_of_ipctk(kind):
    """A type that is asked for, also where it is not the nearest."""
    kinds = (VertexFaceType, EdgeEdgeType)[kind]
    enum = getattr(ipctk, ("PointTriangleDistanceType", "EdgeEdgeDistanceType")[kind])
    x = np.random.default_rng(9).standard_normal((20, 4, 3))
    for number in kinds:
        ours = meshccd.squared_distance_hessian(kind, x, number)
        assert np.array_equal(ours, meshccd.squared_distance_hessian(kind, x, [number] * 20))
        for i in range(len(x)):
            want = getattr(ipctk, f"{THEIRS[kind]}_hessian")(*x[i], enum(int(number)))
            assert np.allclose(ours[i], want, rtol=1e-6, atol=1e-6 * np.abs(want).max())
    for wrong in (len(kinds), -1):
        with pytest.raises(ValueError, match="types has the entry"):
            meshccd.squared_distance(kind, x, wrong)
    with pytest.raises(ValueError, match="kind is 2"):
        meshccd.squared_distance(2, x)
    with pytest.raises(ValueError):
        meshccd.squared_distance(kind, x, [0, 1])


@pytest.mark.parametrize("inflation", [0.0, 0.01, 0.1])
def test_sets_are_the_candidates_of_ipctk(inflation):
    mesh, x0, x1 = crumpled(1)
    ours = Session(mesh).candidate_set(x0, x1, inflation)
    collision_mesh, y0, y1 = theirs(mesh, x0, x1)
    candidates = ipctk.Candidates()
    candidates.build(collision_mesh, y0, y1, inflation, ipctk.LBVH())
    for found, want in zip((ours.vf, ours.ee), listed(candidates)):
        # Both round boxes outward, by different amounts.
        assert len(rows(found) ^ want) <= len(want) / 1000
        assert len(rows(found)) == len(found) > 500
    assert len(ours.ve) == len(ours.vv) == 0 and ours.inflation == inflation


def test_step_sizes_of_a_set_are_certified():
    mesh, x0, x1 = crumpled(2)
    session = Session(mesh)
    ours = session.candidate_set(x0, x1, 0.01)
    collision_mesh, y0, y1 = theirs(mesh, x0, x1)
    candidates = ipctk.Candidates()
    candidates.build(collision_mesh, y0, y1, 0.01, ipctk.LBVH())
    free, some = 0, 0
    for part in 0.5 ** np.arange(9):
        end = x0 + part * (x1 - x0)
        size = ours.collision_free_stepsize(x0, end)
        assert size == session.collision_free_stepsize(x0, end)
        y = np.asfortranarray(end)
        want = candidates.compute_collision_free_stepsize(collision_mesh, y0, y)
        assert want <= size + 1e-6
        if size < 1:
            # Theirs gives up early by a little.
            assert want > 0.7 * size
        assert ours.is_step_collision_free(x0, end) == (size == 1) == (
            ours.earliest_toi(x0, end) is None
        )
        free, some = free + (size == 1), some + (size < 1)
    assert free > 0 and some > 1
    with pytest.raises(ValueError, match="outside of the inflation"):
        ours.earliest_toi(x0, x1 + 0.02)
    with pytest.raises(ValueError):
        session.candidate_set(x0, x1, -1.0)


def test_filters_are_those_of_ipctk():
    mesh, x0, x1 = crumpled(3)
    n = mesh.n_vertices
    static = np.arange(n) >= n // 2
    parts = np.repeat([5, 2], n // 2)
    still = np.where(static[:, None], x0, x1)
    for bodies, their_filter, end in (
        (Bodies.of_obstacles(static), ipctk.make_static_obstacle_filter(n // 2), still),
        (Bodies.of_patches(parts), ipctk.make_vertex_patches_filter(parts.astype(np.int32)), x1),
        (
            Bodies.of_components(mesh, self_contact=False),
            ipctk.make_connected_components_filter(mesh.faces.astype(np.int32)),
            x1,
        ),
    ):
        collision_mesh, y0, y1 = theirs(mesh, x0, end)
        counts = []
        for chosen in (None, their_filter):
            if chosen is not None:
                collision_mesh.can_collide = chosen
            candidates = ipctk.Candidates()
            candidates.build(collision_mesh, y0, y1, 0.0, ipctk.LBVH())
            counts.append(listed(candidates))
        vf, ee, _, _ = Session(mesh, bodies=bodies).candidates(x0, end)
        for found, all_of_them, want in zip((vf, ee), *counts):
            assert len(rows(found) ^ want) <= len(want) / 1000
            assert 100 < len(want) < len(all_of_them)
    assert Bodies.of_components(mesh).of_vertex.tolist() == [0] * (n // 2) + [1] * (n // 2)


def test_a_filter_of_pairs_holds_for_a_set():
    """It is asked of all pairs of the set, those of its inflation too."""
    mesh, x0, x1 = crumpled(4)
    session = Session(mesh)
    every = session.candidate_set(x0, x0, 0.05)
    session.set_filter(lambda kind, pairs: pairs.sum(axis=1) % 2 == 0)
    some = session.candidate_set(x0, x0, 0.05)
    for found, whole in ((some.vf, every.vf), (some.ee, every.ee)):
        assert rows(found) == {pair for pair in rows(whole) if sum(pair) % 2 == 0}
        assert 100 < len(found) < len(whole)


@pytest.mark.parametrize("seed", range(4))
def test_intersections_are_there_where_ipctk_finds_some(seed):
    mesh, x0, x1 = crumpled(seed)
    session = Session(mesh)
    for x, want in ((x0, False), (x1, True), (x0, False)):
        collision_mesh, y, _ = theirs(mesh, x, x)
        assert session.has_intersections(x) == ipctk.has_intersections(collision_mesh, y) == want
        assert (len(session.intersections(x)) > 0) == want
